"""The studio while it is open: its pages, and the processes that work for them."""

import os
import secrets
import threading

import viser

from neurosym.errors import InvalidValue
from neurosym.problems import Problem
from neurosym.studio.front import Front
from neurosym.studio.library import Library
from neurosym.studio.page import Page
from neurosym.studio.session import Session
from neurosym.studio.workers import Workers

MOST_PAGES = 64
"""So many pages are open at once; one that nobody looks at gives way to a new one."""
RUNS = 8
"""So many pages run at once; a run waits for its own clock most of the time."""


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
        self.front = Front(self.open_page, self._port_of, host, port)
        self._pages: dict[str, Page] = {}
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
            for page in self._pages.values():
                page.close()
            self._pages.clear()

    @property
    def pages(self) -> tuple[Page, ...]:
        """The pages that are open."""
        return tuple(self._pages.values())

    def open_page(self) -> str:
        """Make a page, and return what it is called, which cannot be guessed.

        Raises:
            InvalidValue: If too many pages are open.
        """
        with self._lock:
            server = self._freed_server() if len(self._pages) >= MOST_PAGES else None
            server = server or viser.ViserServer("127.0.0.1", 0, label="neurosym studio", verbose=False)
            session = Session(self.library, self.planners, self.runners, self._problem)
            name = secrets.token_urlsafe(12)
            self._pages[name] = Page(server, session)
        return name

    def _port_of(self, name: str) -> int | None:
        found = self._pages.get(name)
        return found.server.get_port() if found else None

    def _freed_server(self) -> viser.ViserServer:
        """Close the oldest page that nobody looks at, and return its server for the next one."""
        unseen = [name for name, page in self._pages.items() if not page.server.get_clients()]
        if not unseen:
            raise InvalidValue(f"{MOST_PAGES} pages are open, the most there can be; close one.")
        gone = self._pages.pop(unseen[0])
        gone.close()
        gone.server.scene.reset()
        gone.server.gui.reset()
        return gone.server
