"""The door leads each browser to its page, passes all on, and refuses what other sites send."""

import http.client
import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer

import pytest

from neurosym.errors import CannotStart, InvalidValue
from neurosym.studio.server import Front, is_loopback
from neurosym.studio.shell import page_html
from neurosym.world import Table


class Inner(BaseHTTPRequestHandler):
    """A page that says which path it was asked for."""

    protocol_version = "HTTP/1.1"

    def do_GET(self) -> None:
        """Answer."""
        body = f"{self.path} {self.headers.get('Connection')} {self.headers.get('X-Mine')}".encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@contextmanager
def door(
    host: str = "127.0.0.1", most: int = 9, port: int = 0, html: bytes = b""
) -> Iterator[tuple[Front, list[str]]]:
    """A door, and the pages behind it, which are all served in one place, so many at most."""
    inner, pages = HTTPServer(("127.0.0.1", 0), Inner), list[str]()

    def open_page() -> str:
        if len(pages) == most:
            raise InvalidValue("There is no room for <another> page.")
        pages.append(f"page{len(pages) + 1}")
        return pages[-1]

    threading.Thread(target=inner.serve_forever, daemon=True).start()
    front = Front(open_page, lambda page: inner.server_port if page in pages else None, host, port, html)
    try:
        front.start()
        yield front, pages
    finally:
        front.close()
        inner.shutdown()
        inner.server_close()


def asked(front: Front, path: str, **headers: str) -> tuple[int, dict[str, str], str]:
    """What is answered to a request: status, headers, text."""
    connection = http.client.HTTPConnection("127.0.0.1", front.port, timeout=10)
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.request("GET", path, headers=named)
    answer = connection.getresponse()
    found = {name.lower(): value for name, value in answer.getheaders()}
    text = answer.read().decode()
    connection.close()
    return answer.status, found, text


def test_new_browser_gets_a_page_and_the_same_one_again():
    with door() as (front, pages):
        status, headers, _ = asked(front, "/")
        assert (status, headers["location"]) == (303, "/page/page1/")
        cookie = headers["set-cookie"].split(";")[0]
        assert "HttpOnly" in headers["set-cookie"]
        assert asked(front, "/", Cookie=cookie)[1]["location"] == "/page/page1/"
        assert asked(front, "/")[1]["location"] == "/page/page2/"
        assert len(pages) == 2


def test_page_is_asked_for_what_stands_after_its_name_and_others_are_said_with_a_way_back():
    with door(most=1) as (front, _):
        asked(front, "/")
        status, _, text = asked(front, "/page/page1/some/file.js?x=1", X_Mine="kept")
        assert (status, text) == (200, "/some/file.js close kept")
        assert asked(front, "/page/page1")[1]["location"] == "/page/page1/"
        status, _, text = asked(front, "/page/none/")
        assert status == 404
        assert 'href="/"' in text
        status, _, text = asked(front, "/")
        assert status == 400
        assert "&lt;another&gt;" in text


def test_page_begins_with_our_own_html_and_asks_the_page_for_all_else():
    with door(html=page_html("neurosym studio: <towers>", Table((0.3, 0.9), (-0.4, 0.4)))) as (front, _):
        asked(front, "/")
        status, headers, text = asked(front, "/page/page1/")
        assert (status, headers["content-type"]) == (200, "text/html; charset=utf-8")
        assert "<title>neurosym studio: &lt;towers&gt;</title>" in text
        assert "Viser client" not in text
        assert '<div id="cover" role="status">' in text
        assert '<main id="root"></main>' in text
        assert '{"Stands at x, y": [[0.3, 0.9], [-0.4, 0.4]]' in text
        assert asked(front, "/page/page1/", Origin="http://evil.example")[0] == 403
        assert asked(front, "/page/page1/", Upgrade="websocket")[2].startswith("/ ")
        assert asked(front, "/page/page1/a.js")[2].startswith("/a.js ")


def test_requests_of_other_sites_and_what_is_no_request_are_refused():
    with door() as (front, pages):
        for headers in ({"Host": "evil.example"}, {"Origin": "http://evil.example"}, {"Origin": "null"}):
            assert asked(front, "/", **headers)[0] == 403
        for raw in (b"\r\n\r\n", b"GET\r\n\r\n", b"\x16\x03\x01\r\n\r\n", b"A" * 70_000):
            with socket.create_connection(("127.0.0.1", front.port), timeout=10) as way:
                way.sendall(raw)
                way.shutdown(socket.SHUT_WR)
                answer = way.makefile("rb").read()
            assert answer == b"" or answer.startswith(b"HTTP/1.1 400")
        assert pages == []
        assert asked(front, "/")[0] == 303
        with pytest.raises(CannotStart, match="in use"), door(port=front.port):
            pass


def test_other_machines_must_know_the_token():
    assert all(map(is_loopback, ("127.0.0.1", "localhost", "::1", "127.9.9.9")))
    assert not any(map(is_loopback, ("0.0.0.0", "192.168.0.2", "example.org", "")))
    with door("0.0.0.0") as (front, pages):
        assert asked(front, "/")[0] == 403
        assert asked(front, "/?token=wrong")[0] == 403
        status, headers, _ = asked(front, f"/?token={front.token}")
        assert (status, headers["location"]) == (303, "/page/page1/")
        assert asked(front, "/", Cookie=f"neurosym-token={front.token}")[0] == 303
        assert len(pages) == 2
