"""The panel `Take away`: files of what is on the page, and a link that brings it back."""

from typing import Any

from neurosym.studio.panel import Panel, set_content
from neurosym.studio.recording import recording_of
from neurosym.studio.session import Topic
from neurosym.studio.take_away import link_of, record_of, zip_of
from neurosym.studio.words import paragraph, safe


class TakePanel(Panel):
    """Hands out files to the window that asks for them."""

    def build(self) -> None:
        """Make the buttons."""
        self._zip = self._file("Domain, problem and plan (zip)", "scene.zip", lambda: zip_of(self.session))
        self._run = self._file("Record of the run", "run.json", lambda: record_of(self.session))
        self._film = self._file("The run as a page (HTML)", "run.html", lambda: recording_of(self.session))
        self._link = self.gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Offer what there is."""
        if topics & {"run", "status"}:
            running = self.session.running
            self._run.disabled = not running.file
            self._film.disabled = running.is_active or not running.seen
        if topics & {"scene", "place"}:
            set_content(self._link, self.text())

    def text(self) -> str:
        """Return the link that holds the scene, as HTML."""
        problem = self.session.problem
        if problem is None:
            return ""
        address = safe(self.page.address + link_of(problem))
        style = "font-size:12px;word-break:break-all"
        link = f'<a href="{address}" target="_blank" rel="noopener" style="{style}">this scene</a>'
        return paragraph("A link that holds", link, "and opens it on a page of its own.")

    def _file(self, label: str, name: str, content: Any) -> Any:
        made = self.gui.add_button(label)

        def hand_out(event: Any) -> None:
            given = content()
            if event.client is not None and given:
                event.client.send_file_download(name, given, save_immediately=True)

        made.on_click(hand_out)
        return made
