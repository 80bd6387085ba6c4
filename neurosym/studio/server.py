"""The door of the studio: one address, behind which each browser finds its own page.

A page is served by viser on a port that only this machine can reach. The door reads the head of each request,
sees by its path whose page is meant, and passes everything on. What a page is called cannot be guessed, so
who knows the address of a page may use it. A request that another site sends is refused.
"""

import asyncio
import hmac
import os
import secrets
import threading
from collections.abc import Callable, Mapping, Sequence
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
from neurosym.studio.desk import Library
from neurosym.studio.page import Page
from neurosym.studio.session import Session
from neurosym.studio.studio_workers import Workers

_PAGE = "/page/"
"""What the path of a page begins with."""
_MOST_HEAD = 64_000
"""Bytes of the head of a request."""
PATIENCE = 20.0
"""How long a head may take to come [s]."""
_COOKIE, _TOKEN = "neurosym-page", "neurosym-token"
_CHUNK = 1 << 16


class Head:
    """The head of a request.

    Args:
        raw: Its bytes, with the empty line.

    Raises:
        ValueError: If it is none.
        HTTPException: The same, of its later lines.
    """

    def __init__(self, raw: bytes):
        first, _, rest = raw.partition(b"\r\n")
        self.method, target, self.version = first.decode("latin-1").split(" ")
        self.headers = parse_headers(BytesIO(rest))
        parts = urlsplit(target)
        self.path, self.query = parts.path, parse_qs(parts.query)

    def get(self, name: str) -> str:
        """Return a header, or nothing."""
        return self.headers.get(name, "")

    @property
    def is_upgrade(self) -> bool:
        """Whether a socket is asked for that stays open."""
        return "websocket" in self.get("upgrade").lower()

    @property
    def cookies(self) -> Mapping[str, str]:
        """The cookies."""
        jar: SimpleCookie = SimpleCookie()
        with suppress(CookieError):
            jar.load(self.get("cookie"))
        return {name: one.value for name, one in jar.items()}

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
    """The door, in a thread of its own.

    Args:
        open_page: Makes a page, and returns what it is called.
        port_of: Says where a page of some name is served on this machine; None if there is none.
        host: Whom it hears: 127.0.0.1 for this machine only.
        port: Its port; 0 for a free one.

    Attributes:
        token: What must be known to come in from other machines; empty for this machine only.
    """

    def __init__(
        self,
        open_page: Callable[[], str],
        port_of: Callable[[str], int | None],
        host: str = "127.0.0.1",
        port: int = 0,
    ):
        self._open_page, self._port_of, self._host, self._wanted = open_page, port_of, host, port
        self.is_local = is_loopback(host)
        self.token = "" if self.is_local else secrets.token_urlsafe(16)
        self.port = 0
        self._loop = asyncio.new_event_loop()
        self._ready, self._error = threading.Event(), ""
        self._thread = threading.Thread(target=self._run, daemon=True)

    @property
    def address(self) -> str:
        """Where the studio is, without the token."""
        host = "127.0.0.1" if self._host in ("", "0.0.0.0", "::") else self._host
        return f"http://{f'[{host}]' if ':' in host else host}:{self.port}"

    def start(self) -> None:
        """Open the door.

        Raises:
            CannotStart: If the port is taken, or there is no such host.
        """
        self._thread.start()
        self._ready.wait()
        if self._error:
            raise CannotStart("server", self._error)

    def close(self) -> None:
        """Shut the door."""
        with suppress(RuntimeError):
            self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(2.0)

    def _run(self) -> None:
        asyncio.set_event_loop(self._loop)
        try:
            server = self._loop.run_until_complete(
                asyncio.start_server(self._serve, self._host, self._wanted, limit=_MOST_HEAD)
            )
        except (OSError, ValueError) as error:
            why = error.strerror if isinstance(error, OSError) else "that is no host"
            self._error = f"{harmless(self._host)[:100]}:{self._wanted}: {why or error}"
            self._loop.close()
            self._ready.set()
            return
        self.port = server.sockets[0].getsockname()[1]
        self._ready.set()
        self._loop.run_forever()
        server.close()
        left = asyncio.all_tasks(self._loop)
        for task in left:
            task.cancel()
        self._loop.run_until_complete(asyncio.gather(*left, return_exceptions=True))
        self._loop.run_until_complete(self._loop.shutdown_default_executor())
        self._loop.close()

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with suppress(OSError, asyncio.TimeoutError, asyncio.IncompleteReadError, asyncio.CancelledError):
            try:
                raw = await asyncio.wait_for(reader.readuntil(b"\r\n\r\n"), PATIENCE)
                head = Head(raw)
            except (ValueError, HTTPException, asyncio.LimitOverrunError):
                await _answer(writer, HTTPStatus.BAD_REQUEST, "This is no request that a browser sends.")
            else:
                await self._route(head, reader, writer)
        with suppress(ConnectionError, OSError):
            writer.close()

    async def _route(self, head: Head, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if not self._is_ours(head):
            await _answer(writer, HTTPStatus.FORBIDDEN, "Another site sent this request; it is refused.")
        elif head.path.startswith(_PAGE):
            page, _, rest = head.path.removeprefix(_PAGE).partition("/")
            port = self._port_of(page)
            if port is None:
                await _answer(writer, HTTPStatus.NOT_FOUND, "This page is closed.")
            elif head.path == f"{_PAGE}{page}" and not head.is_upgrade:
                await _redirect(writer, f"{_PAGE}{page}/")
            else:
                await _pass_on(head.for_page(f"/{rest}"), port, reader, writer)
        elif head.path == "/":
            await self._admit(head, writer)
        else:
            await _answer(writer, HTTPStatus.NOT_FOUND, "There is nothing here.")

    async def _admit(self, head: Head, writer: asyncio.StreamWriter) -> None:
        """Show a browser its page, or make one."""
        given = next(iter(head.query.get("token", [])), head.cookies.get(_TOKEN, ""))
        if self.token and not hmac.compare_digest(given.encode(), self.token.encode()):
            await _answer(writer, HTTPStatus.FORBIDDEN, "The address must hold the token that was printed.")
            return
        cookies = [f"{_TOKEN}={self.token}; Path=/; HttpOnly; SameSite=Strict"] if self.token else []
        page = head.cookies.get(_COOKIE, "")
        if self._port_of(page) is None:
            try:
                page = await asyncio.get_running_loop().run_in_executor(None, self._open_page)
            except NeurosymError as error:
                await _answer(writer, HTTPStatus.BAD_REQUEST, str(error))
                return
            cookies.append(f"{_COOKIE}={page}; Path=/; HttpOnly; SameSite=Strict")
        await _redirect(writer, f"{_PAGE}{page}/", cookies)

    def _is_ours(self, head: Head) -> bool:
        """Say whether a request comes from a page of ours, and by a name that is ours."""
        host = urlsplit(f"//{head.get('host')}").hostname or ""
        if self.is_local and not (host == "localhost" or is_loopback(host)):
            return False  # another name was made to lead here
        origin = head.get("origin")
        return not origin or urlsplit(origin).netloc == head.get("host")


def is_loopback(host: str) -> bool:
    """Say whether a host is this machine, and heard by nobody else."""
    if host == "localhost":
        return True
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False


async def _pass_on(
    head: bytes, port: int, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
) -> None:
    """Pass a request on to a page, and all that is said from then on, both ways."""
    inner_reader, inner_writer = await asyncio.open_connection("127.0.0.1", port)
    inner_writer.write(head)
    ways = [
        asyncio.create_task(_pump(reader, inner_writer)),
        asyncio.create_task(_pump(inner_reader, writer)),
    ]
    try:
        await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for way in ways:
            way.cancel()
        inner_writer.close()


async def _pump(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    with suppress(ConnectionError, OSError):
        while chunk := await reader.read(_CHUNK):
            writer.write(chunk)
            await writer.drain()


async def _redirect(writer: asyncio.StreamWriter, to: str, cookies: Sequence[str] = ()) -> None:
    lines = [f"Location: {to}", *(f"Set-Cookie: {cookie}" for cookie in cookies)]
    await _send(writer, HTTPStatus.SEE_OTHER, lines, b"")


async def _answer(writer: asyncio.StreamWriter, status: HTTPStatus, sentence: str) -> None:
    style = "font-family:sans-serif;max-width:40em;margin:4em auto;padding:0 1em"
    text = (
        '<!doctype html><html lang="en"><meta charset="utf-8"><title>neurosym studio</title>'
        f'<body style="{style}"><p>{escape(sentence)}</p><p><a href="/">A new page</a></p></body></html>'
    )
    await _send(writer, status, ["Content-Type: text/html; charset=utf-8"], text.encode())


async def _send(writer: asyncio.StreamWriter, status: HTTPStatus, lines: list[str], body: bytes) -> None:
    head = [f"HTTP/1.1 {status.value} {status.phrase}", *lines, f"Content-Length: {len(body)}"]
    head += ["Cache-Control: no-store", "X-Content-Type-Options: nosniff", "Connection: close"]
    writer.write("\r\n".join([*head, "", ""]).encode("latin-1") + body)
    await writer.drain()


_MOST_PAGES = 64
"""So many pages are open at once; one that nobody looks at gives way to a new one."""
_RUNS = 8
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
        self.planners, self.runners = Workers(max(1, os.cpu_count() or 1)), Workers(_RUNS)
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
            server = self._freed_server() if len(self._pages) >= _MOST_PAGES else None
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
            raise InvalidValue(f"{_MOST_PAGES} pages are open, the most there can be; close one.")
        gone = self._pages.pop(unseen[0])
        gone.close()
        gone.server.scene.reset()
        gone.server.gui.reset()
        return gone.server
