"""The studio while it is open: its pages, and the processes that work for them."""

import os
import secrets
import threading
import time
from dataclasses import dataclass

import viser

from neurosym.errors import InvalidValue
from neurosym.problems import Problem
from neurosym.stages.planning import check_scene
from neurosym.studio.front import Front
from neurosym.studio.library import Library
from neurosym.studio.page import Page
from neurosym.studio.session import Session
from neurosym.studio.take_away import scene_of
from neurosym.studio.workers import Workers

MOST_PAGES = 64
"""So many pages are open at once; one that nobody looks at gives way to a new one."""
RUNS = 8
"""So many pages run at once; a run waits for its own clock most of the time."""


@dataclass(slots=True)
class _Open:
    """A page that is open."""

    page: Page
    session: Session
    server: viser.ViserServer
    since: float


class Studio:
    """All pages of one domain.

    Args:
        library: The domain.
        host: Whom it hears.
        port: Its port; 0 for a free one.
        problem: What pages begin with, if not with the first problem of the domain.
    """

    def __init__(
        self, library: Library, host: str = "127.0.0.1", port: int = 0, problem: Problem | None = None
    ):
        self.library, self._problem = library, problem
        self.planners, self.runners = Workers(max(1, os.cpu_count() or 1)), Workers(RUNS)
        self.front = Front(self, host, port)
        self._pages: dict[str, _Open] = {}
        self._servers: list[viser.ViserServer] = []
        self._lock = threading.RLock()

    @property
    def address(self) -> str:
        """What is typed in a browser, with the token if there is one."""
        token = f"/?token={self.front.token}" if self.front.token else "/"
        return self.front.address + token

    def start(self) -> None:
        """Open the door, and have a process of each kind at hand."""
        self.front.start()
        for workers in (self.planners, self.runners):
            threading.Thread(target=workers.warm, daemon=True).start()

    def close(self) -> None:
        """End everything, and leave nothing behind."""
        self.front.close()
        for workers in (self.planners, self.runners):
            workers.close()
        with self._lock:
            for one in self._pages.values():
                one.page.close()
                one.session.close()
            self._pages.clear()

    @property
    def pages(self) -> tuple[Page, ...]:
        """The pages that are open."""
        return tuple(one.page for one in self._pages.values())

    def port_of(self, page: str) -> int | None:
        """Return where a page is served on this machine; see `Doorman`."""
        found = self._pages.get(page)
        return found.server.get_port() if found else None

    def open_page(self, link: str = "") -> str:
        """Make a page, and return what it is called; see `Doorman`.

        Args:
            link: The path of a link that holds a scene, if there is one.

        Raises:
            NeurosymError: If the link holds no scene that can be here, or too many pages are open.
        """
        problem = self._problem
        if link:
            problem = scene_of(link)
            self._check(problem)
        with self._lock:
            if len(self._pages) >= MOST_PAGES:
                self._close_one()
            server = (
                self._servers.pop()
                if self._servers
                else viser.ViserServer("127.0.0.1", 0, label="neurosym studio", verbose=False)
            )
            session = Session(self.library, self.planners, self.runners, problem)
            name = secrets.token_urlsafe(12)
            page = Page(server, session, self.front.address)
            self._pages[name] = _Open(page, session, server, time.monotonic())
        return name

    def _check(self, problem: Problem) -> None:
        from pathlib import Path

        check_scene(self.library.folder, problem, Path("the link"), self.library.world)

    def _close_one(self) -> None:
        """Close the oldest page that nobody looks at, and keep its server for the next one."""
        unseen = [(one.since, name) for name, one in self._pages.items() if not one.server.get_clients()]
        if not unseen:
            raise InvalidValue(f"{MOST_PAGES} pages are open, the most there can be; close one.")
        gone = self._pages.pop(min(unseen)[1])
        gone.page.close()
        gone.session.close()
        gone.server.scene.reset()
        gone.server.gui.reset()
        self._servers.append(gone.server)
