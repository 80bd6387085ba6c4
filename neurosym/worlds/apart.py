"""A process apart that calls functions for us, so that whatever they do, ours can tell it.

It is no fork, and does not import the program that started it. A pipe that is closed then tells it so.
"""

import os
import signal
import socket
import subprocess
import sys
import threading
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from typing import Any

from neurosym.errors import InvalidWorld
from neurosym.world import FrameSink
from neurosym.worlds import host

_START = """
import sys
sys.path[:] = {path!r}
from neurosym.worlds.host import serve
serve({requests}, {lifeline})
"""


class Process:
    """A process that calls functions for us.

    Args:
        name: What messages call the world that is made there.

    Raises:
        InvalidWorld: From `call`, if the process ends, or does not answer in time.
    """

    def __init__(self, name: str):
        self._name, self.patience = name, host.PATIENCE
        ours, theirs = socket.socketpair()
        lifeline, held = os.pipe()
        with theirs:
            code = _START.format(path=sys.path, requests=theirs.fileno(), lifeline=lifeline)
            with ctrl_c_ignored():
                self._process = subprocess.Popen(
                    [sys.executable, "-c", code], pass_fds=(theirs.fileno(), lifeline)
                )
        os.close(lifeline)
        self._connection = Connection(ours.detach())
        self._lock = threading.Lock()
        self._end = weakref.finalize(self, _end, self._process, self._connection, held)

    @property
    def is_open(self) -> bool:
        """Whether it can be asked."""
        return self._end.alive

    @property
    def number(self) -> int:
        """Its number in the system."""
        return self._process.pid

    def close(self, grace: float = host.GRACE) -> None:
        """Let it end by itself, or kill it.

        Args:
            grace: How long it has to end [s].
        """
        if self._end.alive and not grace:
            self._process.kill()
            self._process.wait()  # before its ways are closed, on which others may be waiting
        self._end()

    def call(
        self, what: str, function: Callable[..., Any], *arguments: Any, on_frame: FrameSink | None = None
    ) -> Any:
        """Have a function called, and return what it returns.

        Args:
            what: What messages call it.
            function: A function of a module.
            arguments: Its arguments.
            on_frame: Takes the pictures that it sends on the way.
        """
        with self._lock:
            self._ask(what, lambda: self._connection.send((self._name, function, arguments)))
            try:
                while True:
                    kind, answer = self._ask(what, self._receive, what)
                    if kind != host.FRAME:
                        break
                    assert on_frame is not None, "else none is sent"
                    on_frame(*answer)
            except BaseException:  # whatever it still sends belongs to no call any more
                self.close(grace=0.0)
                raise
        if kind == host.REFUSAL:
            raise answer
        return answer

    def _receive(self, what: str) -> Any:
        if not self._connection.poll(self.patience):
            self.close(grace=0.0)
            raise InvalidWorld(self._name, f"has not come back from {what} for {self.patience:g} s")
        return self._connection.recv()

    def _ask(self, what: str, exchange: Callable[..., Any], *arguments: Any) -> Any:
        try:
            return exchange(*arguments)
        except (EOFError, OSError) as error:
            raise InvalidWorld(self._name, f"{self._how_it_ended()} in {what}") from error
        except InvalidWorld:
            raise
        except Exception as error:
            raise InvalidWorld(self._name, f"gives what no other process can read from {what}") from error

    def _how_it_ended(self) -> str:
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(host.GRACE)
        self.close(grace=0.0)
        code = self._process.returncode
        if code >= 0:
            return f"ends its process with exit code {code}"
        because = " (by somebody, or for want of memory)" if -code == signal.SIGKILL else ""
        return f"has its process killed by {signal.Signals(-code).name}{because}"


@contextmanager
def ctrl_c_ignored() -> Iterator[None]:
    """Let processes that are started be deaf to Ctrl-C, which ends them through us."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _end(process: "subprocess.Popen[bytes]", connection: Connection, held: int) -> None:
    """End a process: close its ways, wait a little, and kill it."""
    connection.close()
    try:
        process.wait(host.GRACE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    os.close(held)
