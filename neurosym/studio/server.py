"""The door of the studio: one address, behind which each browser finds its own page.

A page is served by viser on a port that only this machine can reach. The door reads the head of each request,
sees by its path whose page is meant, and passes everything on. What a page is called cannot be guessed, so
who knows the address of a page may use it. A request that another site sends is refused.
"""

import asyncio
import gzip
import hmac
import os
import secrets
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from html import escape
from http import HTTPStatus
from http.client import HTTPException, parse_headers
from http.cookies import CookieError, SimpleCookie
from io import BytesIO
from ipaddress import ip_address
from urllib.parse import parse_qs, urlsplit

import viser

from neurosym.errors import CannotStart, InvalidValue, NeurosymError, harmless
from neurosym.problems import Problem
from neurosym.studio.library import Library
from neurosym.studio.page import Page
from neurosym.studio.panels import AboutPanel, PlanPanel, RunPanel, TablePanel
from neurosym.studio.session import Session
from neurosym.studio.shell import page_html
from neurosym.studio.studio_workers import Workers
from neurosym.studio.symbols_panel import SymbolsPanel
from neurosym.studio.tour import TourPanel

_PAGE = "/page/"  # what the path of a page begins with
_MOST_HEAD = 64_000  # bytes of the head of a request
_PATIENCE = 20.0  # how long a head may take to come [s]
_COOKIE, _TOKEN = "neurosym-page", "neurosym-token"
_CHUNK = 1 << 16
_STYLE = "font-family:sans-serif;max-width:40em;margin:4em auto;padding:0 1em"


class _Head:
    """The head of a request, from its bytes with the empty line; `ValueError` or `HTTPException` if none."""

    def __init__(self, raw: bytes):
        first, _, rest = raw.partition(b"\r\n")
        self.method, target, self.version = first.decode("latin-1").split(" ")
        self.headers = parse_headers(BytesIO(rest))
        parts = urlsplit(target)
        self.path, self.query = parts.path, parse_qs(parts.query)
        self.is_upgrade = "websocket" in self.get("upgrade").lower()  # to a socket that stays open

    def get(self, name: str) -> str:
        """Return a header, or nothing."""
        return self.headers.get(name, "")

    def cookie(self, name: str) -> str:
        """Return a cookie, or nothing."""
        jar: SimpleCookie = SimpleCookie()
        with suppress(CookieError):
            jar.load(self.get("cookie"))
        return jar[name].value if name in jar else ""

    def for_page(self, path: str) -> bytes:
        """Return the head as it is passed on: one request a connection, with the path that the page knows."""
        lines = [f"{self.method} {path} {self.version}"]
        for name, value in self.headers.items():
            if self.is_upgrade or name.lower() not in ("connection", "keep-alive"):
                lines.append(f"{name}: {value}")
        if not self.is_upgrade:
            lines.append("Connection: close")
        return ("\r\n".join(lines) + "\r\n\r\n").encode("latin-1")


class Front:
    """The door, in a thread of its own; where other machines are heard, they must know its token.

    `open_page` makes a page and names it, `port_of` says where a page of some name is served on this machine.
    `html` is what a browser is given there first, packed by gzip; all else is asked of the page.
    """

    def __init__(
        self,
        open_page: Callable[[], str],
        port_of: Callable[[str], int | None],
        host: str = "127.0.0.1",
        port: int = 0,
        html: bytes = b"",
    ):
        self._open_page, self._port_of, self._host, self.port = open_page, port_of, host, port
        self._html = html
        self.is_local = is_loopback(host)
        self.token = "" if self.is_local else secrets.token_urlsafe(16)
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)

    @property
    def address(self) -> str:
        """Where the studio is, without the token."""
        host = "127.0.0.1" if self._host in ("", "0.0.0.0", "::") else self._host
        return f"http://{f'[{host}]' if ':' in host else host}:{self.port}"

    def start(self) -> None:
        """Open the door; `CannotStart` if the port is taken, or there is no such host."""
        opening = asyncio.start_server(self._serve, self._host, self.port, limit=_MOST_HEAD)
        try:
            self._server = self._loop.run_until_complete(opening)
        except (OSError, ValueError) as error:
            why = error.strerror if isinstance(error, OSError) else "that is no host"
            self._loop.close()
            where = f"{harmless(self._host)[:100]}:{self.port}"
            advice = "name another --port (0 takes a free one), or a --host of this machine"
            raise CannotStart("server", f"{where}: {why or error}", advice) from error
        self.port = self._server.sockets[0].getsockname()[1]
        self._thread.start()

    def close(self) -> None:
        """Shut the door."""
        if not self._thread.is_alive():
            return

        async def end() -> None:
            self._server.close()
            left = asyncio.all_tasks() - {asyncio.current_task()}
            for task in left:
                task.cancel()
            await asyncio.gather(*left, return_exceptions=True)
            await self._loop.shutdown_default_executor()

        with suppress(TimeoutError):
            asyncio.run_coroutine_threadsafe(end(), self._loop).result(2.0)
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(2.0)
        if not self._thread.is_alive():
            self._loop.close()

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with suppress(OSError, asyncio.TimeoutError, asyncio.IncompleteReadError, asyncio.CancelledError):
            try:
                head = _Head(await asyncio.wait_for(reader.readuntil(b"\r\n\r\n"), _PATIENCE))
            except (ValueError, HTTPException, asyncio.LimitOverrunError):
                await _answer(writer, HTTPStatus.BAD_REQUEST, "This is no request that a browser sends.")
            else:
                await self._route(head, reader, writer)
        with suppress(OSError):
            writer.close()

    async def _route(self, head: _Head, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        page, _, rest = head.path.removeprefix(_PAGE).partition("/")
        if not self._is_ours(head):
            await _answer(writer, HTTPStatus.FORBIDDEN, "Another site sent this request; it is refused.")
        elif head.path == "/":
            await self._admit(head, writer)
        elif not head.path.startswith(_PAGE):
            await _answer(writer, HTTPStatus.NOT_FOUND, "There is nothing here.")
        elif (port := self._port_of(page)) is None:
            await _answer(writer, HTTPStatus.NOT_FOUND, "This page is closed.")
        elif head.path == f"{_PAGE}{page}" and not head.is_upgrade:
            await _answer(writer, HTTPStatus.SEE_OTHER, lines=[f"Location: {head.path}/"])
        elif self._html and not rest and not head.is_upgrade:
            is_packed = "gzip" in head.get("accept-encoding")
            lines = ["Content-Encoding: gzip"] if is_packed else []
            await _send(
                writer, HTTPStatus.OK, self._html if is_packed else gzip.decompress(self._html), lines
            )
        else:
            await _pass_on(head.for_page(f"/{rest}"), port, reader, writer)

    async def _admit(self, head: _Head, writer: asyncio.StreamWriter) -> None:
        """Show a browser its page, or make one."""
        given = next(iter(head.query.get("token", [])), head.cookie(_TOKEN))
        if self.token and not hmac.compare_digest(given.encode(), self.token.encode()):
            await _answer(writer, HTTPStatus.FORBIDDEN, "The address must hold the token that was printed.")
            return
        page, cookies = head.cookie(_COOKIE), {_TOKEN: self.token} if self.token else {}
        if self._port_of(page) is None:
            try:
                page = await asyncio.get_running_loop().run_in_executor(None, self._open_page)
            except NeurosymError as error:
                await _answer(writer, HTTPStatus.BAD_REQUEST, str(error))
                return
            cookies[_COOKIE] = page
        lines = [f"Location: {_PAGE}{page}/"]
        for name, value in cookies.items():
            lines.append(f"Set-Cookie: {name}={value}; Path=/; HttpOnly; SameSite=Strict")
        await _answer(writer, HTTPStatus.SEE_OTHER, lines=lines)

    def _is_ours(self, head: _Head) -> bool:
        """Say whether a request comes from a page of ours, and by a name that is ours."""
        host = urlsplit(f"//{head.get('host')}").hostname or ""
        if self.is_local and not is_loopback(host):
            return False  # another name was made to lead here
        origin = head.get("origin")
        return not origin or urlsplit(origin).netloc == head.get("host")


def is_loopback(host: str) -> bool:
    """Say whether a host is this machine, and heard by nobody else."""
    try:
        return host == "localhost" or ip_address(host).is_loopback
    except ValueError:
        return False


async def _pass_on(
    head: bytes, port: int, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
) -> None:
    """Pass a request on to a page, and all that is said from then on, both ways."""
    inner_reader, inner_writer = await asyncio.open_connection("127.0.0.1", port)
    inner_writer.write(head)

    async def pump(source: asyncio.StreamReader, sink: asyncio.StreamWriter) -> None:
        with suppress(OSError):
            while chunk := await source.read(_CHUNK):
                sink.write(chunk)
                await sink.drain()

    ways = [asyncio.create_task(pump(*way)) for way in ((reader, inner_writer), (inner_reader, writer))]
    try:
        await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for way in ways:
            way.cancel()
        inner_writer.close()


async def _answer(
    writer: asyncio.StreamWriter, status: HTTPStatus, sentence: str = "", lines: Sequence[str] = ()
) -> None:
    """Answer with a page that says a sentence, with more lines in the head."""
    text = (
        '<!doctype html><html lang="en"><meta charset="utf-8"><title>neurosym studio</title>'
        f'<body style="{_STYLE}"><p>{escape(sentence)}</p><p><a href="/">A new page</a></p></body></html>'
    ).encode()
    await _send(writer, status, text, lines)


async def _send(
    writer: asyncio.StreamWriter, status: HTTPStatus, text: bytes, lines: Sequence[str] = ()
) -> None:
    """Answer with a page, with more lines in the head."""
    head = [f"HTTP/1.1 {status.value} {status.phrase}", *lines, f"Content-Length: {len(text)}"]
    head += ["Content-Type: text/html; charset=utf-8", "Cache-Control: no-store", "Connection: close"]
    writer.write("\r\n".join([*head, "X-Content-Type-Options: nosniff", "", ""]).encode("latin-1") + text)
    await writer.drain()


_MOST_PAGES = 64  # so many pages are open at once; one that nobody looks at gives way to a new one
_RUNS = 8  # so many pages run at once; a run waits for its own clock most of the time
PANELS = {
    "": AboutPanel,
    "Table": TablePanel,
    "Plan": PlanPanel,
    "Run": RunPanel,
    "Symbols": SymbolsPanel,
    "Tour": TourPanel,
}
"""The panels of a page: its head, and the others by what stands on their tabs."""


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
        self._library, self._problem = library, problem
        self._planners, self._runners = Workers(max(1, os.cpu_count() or 1)), Workers(_RUNS)
        html = page_html(f"neurosym studio: {library.name}", library.grounding.table)
        self.front = Front(self.open_page, self._port_of, host, port, html)
        self._pages: dict[str, Page] = {}
        self._lock = threading.RLock()

    @property
    def address(self) -> str:
        """What is typed in a browser, with the token if there is one."""
        return self.front.address + (f"/?token={self.front.token}" if self.front.token else "/")

    def start(self) -> None:
        """Open the door, and have a process of each kind at hand."""
        self.front.start()
        for workers in (self._planners, self._runners):
            threading.Thread(target=workers.warm, daemon=True).start()

    def close(self) -> None:
        """End everything, and leave nothing behind."""
        self.front.close()
        for workers in (self._planners, self._runners):
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
        """Make a page, and return its name, which cannot be guessed; `InvalidValue` if too many are open."""
        with self._lock:
            server = self._freed_server() if len(self._pages) >= _MOST_PAGES else None
            server = server or viser.ViserServer("127.0.0.1", 0, label="neurosym studio", verbose=False)
            session = Session(self._library, self._planners, self._runners, self._problem)
            name = secrets.token_urlsafe(12)
            self._pages[name] = Page(server, session, PANELS)
        return name

    def _port_of(self, name: str) -> int | None:
        found = self._pages.get(name)
        return found.server.get_port() if found else None

    def _freed_server(self) -> viser.ViserServer:
        """Close the oldest page that nobody looks at, and return its server for the next one."""
        unseen = [name for name, page in self._pages.items() if not page.server.get_clients()]
        if not unseen:
            raise InvalidValue(f"{_MOST_PAGES} pages are open, the most there can be; close one.")
        gone = self._pages.pop(unseen[0])
        gone.close()
        gone.server.scene.reset()
        gone.server.gui.reset()
        return gone.server
