"""The panel `Tour`: eight cards, from an experience to what went otherwise."""

from neurosym.studio.guide import Guide
from neurosym.studio.panel import Panel, set_content
from neurosym.studio.session import Topic
from neurosym.studio.tour import CARDS, numbers_of
from neurosym.studio.words import paragraph, safe

BEFORE, NEXT = "Card before", "Next card"


class TourPanel(Panel):
    """Shows one card at a time, and does what it speaks of."""

    def build(self) -> None:
        """Make the card and its buttons; what turns cards stays at one place."""
        self.guide = Guide(self.session, lambda: item.name if (item := self.page.item) else "")
        turn = self.gui.add_button_group("Card", (BEFORE, NEXT))
        turn.on_click(lambda event: self.turn(1 if event.target.value == NEXT else -1))
        self._text = self.gui.add_html("")
        self._do = self.button("Show me", self.act, color="green")
        self._stop = self.button("Stop", self.guide.stop, color="red", disabled=True)
        self._told = self.gui.add_html("")
        self._show()

    def turn(self, by: int) -> None:
        """Show another card, as soon as the page is drawn: two threads that draw would cross each other."""
        self.guide.turn(by)
        self.page.hear("status")

    def act(self) -> None:
        """Do what the card speaks of."""
        self.guide.act()
        self.page.hear("status")

    def text(self) -> str:
        """Return the card, as HTML."""
        card, values = self.guide.card, numbers_of(self.session.library)
        head = f"{self.guide.number + 1} of {len(CARDS)}: {card.title}"
        parts = [f'<h3 style="margin:4px 0">{safe(head)}</h3>']
        parts += [paragraph(safe(text.format(**values))) for text in card.sentences]
        return "".join(parts)

    def refresh(self, topics: set[Topic]) -> None:
        """Let nothing be begun while something runs, and say what came of it."""
        if topics & {"run", "status", "plan", "step", "scene"}:
            self._show()

    def _show(self) -> None:
        self._do.label = self.guide.card.button
        self._do.disabled, self._stop.disabled = not self.guide.can_act, not self.guide.is_busy
        set_content(self._text, self.text())
        set_content(self._told, self.guide.told())
