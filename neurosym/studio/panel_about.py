"""The head of the page: what it says of itself, and what is wrong on the table."""

from neurosym.studio.panel import Panel, by_user, set_content
from neurosym.studio.session import Topic
from neurosym.studio.words import BAD, GOOD, coloured, paragraph, safe
from neurosym.wording import counted


class AboutPanel(Panel):
    """What stands above the tabs."""

    def build(self) -> None:
        """Make it."""
        self._said = self.gui.add_html("")
        dark = self.gui.add_checkbox("Dark", False)
        dark.on_update(by_user(self.page.set_dark))

    def refresh(self, topics: set[Topic]) -> None:
        """Say it anew."""
        if topics - {"pose"}:
            set_content(self._said, self.text())

    def text(self) -> str:
        """Return what is said, as HTML."""
        session = self.session
        word, library = session.word, session.library
        name = session.problem.name if session.problem else "no object yet"
        lines = [paragraph(f"<b>{safe(library.name)}</b> · {safe(name)}")]
        if not word.text:
            lines.append(paragraph("New here? The panel Tour shows in eight cards what this robot learned."))
        if word.text:
            said = coloured(word.text, BAD if word.is_bad else GOOD)
            lines.append(f'<div role="status" aria-live="polite">{paragraph(said)}</div>')
        for place, what in ((session.place, "plan"), (session.running.place, "run")):
            if place:
                lines.append(paragraph(safe(f"waiting in line: {counted(place, what)} with this one")))
        lines += [paragraph(coloured(why, BAD)) for why in session.complaints().values()]
        lines += [paragraph(coloured(f"damaged: {one}", BAD)) for one in library.damage.sentences]
        return "".join(lines)
