"""Processes that we start: what one writes before it is up is caught, so that one sentence can tell of it.

A process that lacks memory, files or threads may end with a traceback before any code of ours runs. Until it
says that it is up, its standard error is a pipe to us; from then on it is ours, and whoever writes there is
seen. No process is a fork, and none needs semaphores or temporary files.
"""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
import weakref
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from queue import SimpleQueue
from typing import Any, TypeVar

from neurosym.errors import CannotStart

GRACE = 5.0
"""How long a process has to end by itself [s]."""
_UP = "up"
_START = """
import sys
sys.path[:] = {path!r}
from {module} import {function}
{function}({requests}, {lifeline}, {errors})
"""

Serve = Callable[[int, int, int], None]
"""What a process does, given descriptors of requests, a lifeline, and our standard error (-1 if closed)."""
Member = TypeVar("Member")
Result = TypeVar("Result")


class Child:
    """A process that is sent messages, and sends some back.

    Args:
        serve: What it does; a function of a module, which must call `say_up`.

    Raises:
        CannotStart: If the system does not let it be started; from `send`, if it ends before it is up.
    """

    def __init__(self, serve: Serve):
        self._connection, requests = Pipe()
        lifeline, held = Pipe(duplex=False)
        self._said, saying = Pipe(duplex=False)
        os.set_blocking(saying.fileno(), False)  # what is too much is of no use
        with requests, lifeline, saying, _standard_error() as errors:
            kept = [end for end in (requests.fileno(), lifeline.fileno(), errors) if end >= 0]
            code = _START.format(
                path=sys.path,
                module=serve.__module__,
                function=serve.__name__,
                requests=requests.fileno(),
                lifeline=lifeline.fileno(),
                errors=errors,
            )
            try:
                with _ctrl_c_held():
                    self.process = subprocess.Popen(
                        [sys.executable, "-c", code], pass_fds=kept, stderr=saying.fileno()
                    )
            except OSError as error:
                raise CannotStart("process", str(error.strerror)) from error
            except KeyboardInterrupt:
                if hasattr(self, "process"):  # heard right after it was started
                    self.process.kill()
                    self.process.wait()
                raise
        self._is_up = False
        self._end = weakref.finalize(self, _end, self.process, (self._connection, self._said, held))

    @property
    def is_open(self) -> bool:
        """Whether it can be asked."""
        return self._end.alive

    def send(self, message: Any) -> None:
        """Send a message, once it is up.

        Args:
            message: What can be pickled.
        """
        if not self._is_up:
            self._await_up()
        self._connection.send(message)

    def receive(self, patience: float | None = None) -> Any:
        """Wait for a message.

        Args:
            patience: How long [s]; for ever if not given.

        Raises:
            TimeoutError: If none comes.
            EOFError: If the process has ended.
        """
        if not self._connection.poll(patience):
            raise TimeoutError
        return self._connection.recv()

    def hang_up(self) -> None:
        """Close the way to it, which ends it once it has answered."""
        self._connection.close()

    def close(self, grace: float = GRACE) -> None:
        """Let it end by itself, or kill it.

        Args:
            grace: How long it has to end [s].
        """
        if self._end.alive and not grace:
            self.process.kill()
            self.process.wait()  # before its ways are closed, on which others may be waiting
        self._end()

    def _await_up(self) -> None:
        try:
            self._is_up = self.receive() == _UP
        except (EOFError, OSError) as error:
            raise CannotStart("process", self._last_words()) from error
        self._said.close()

    def _last_words(self) -> str:
        """Return the last line that it wrote before it ended, or else how it ended."""
        self.process.wait()
        os.set_blocking(self._said.fileno(), False)
        with suppress(OSError):
            lines = os.read(self._said.fileno(), 1 << 16).decode(errors="replace").split("\n")
            if words := " ".join(next(filter(str.strip, reversed(lines)), "").split()):
                return textwrap.shorten(words, 200).rstrip(".")
        code = self.process.returncode
        return f"killed by {signal.Signals(-code).name}" if code < 0 else f"exit code {code}"


def leave_signals_to_parent() -> None:
    """Be deaf to Ctrl-C and to closed terminals, of which the parent hears, too; it ends this process."""
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def say_up(requests: int, errors: int) -> Connection:
    """Say in a process that it is up, and return the way to its parent.

    Args:
        requests: As given to `Serve`.
        errors: As given to `Serve`.
    """
    if errors >= 0:
        os.dup2(errors, 2)
        os.close(errors)
    connection = Connection(requests)
    with suppress(OSError):  # else the parent has ended; the next to be received is its end
        connection.send(_UP)
    return connection


def end_with_parent(lifeline: int, end: Callable[[], None]) -> None:
    """Have a thread of a process end it with its parent.

    Args:
        lifeline: As given to `Serve`.
        end: Ends this process.
    """

    def wait() -> None:
        os.read(lifeline, 1)
        end()

    threading.Thread(target=wait, daemon=True).start()


def end_all(children: Sequence[Child], patience: float) -> None:
    """Ask processes to end, and kill those that do not soon; keepers of planners see to the rest.

    Args:
        children: The processes.
        patience: How long they have together [s].
    """
    for child in children:
        child.process.terminate()
    end = time.monotonic() + patience
    for child in children:
        with suppress(subprocess.TimeoutExpired):
            child.process.wait(max(0.0, end - time.monotonic()))
        child.process.kill()


@contextmanager
def at_hand(members: Sequence[Member]) -> Iterator[Callable[[Callable[[Member], Result]], "Future[Result]"]]:
    """Keep members at hand; yields what hands work out to whichever is free.

    Args:
        members: What work is done with.
    """
    free: SimpleQueue[Member] = SimpleQueue()
    for member in members:
        free.put(member)
    pool = ThreadPoolExecutor(len(members))

    def perform(work: Callable[[Member], Result]) -> Result:
        member = free.get()
        try:
            return work(member)
        finally:
            free.put(member)

    def submit(work: Callable[[Member], Result]) -> "Future[Result]":
        try:
            return pool.submit(perform, work)
        except RuntimeError as error:
            raise CannotStart("thread", str(error)) from error

    try:
        yield submit
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


@contextmanager
def _ctrl_c_held() -> Iterator[None]:
    """Let a process that is started be deaf to Ctrl-C, which ends it through us; we hear it right after."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _standard_error() -> Iterator[int]:
    """Yield another descriptor of our standard error, or -1 if it is closed."""
    try:
        errors = os.dup(2)
    except OSError:
        yield -1
        return
    try:
        yield errors
    finally:
        os.close(errors)


def _end(process: "subprocess.Popen[bytes]", ways: Sequence[Connection]) -> None:
    """End a process: close the way to it, wait a little, and kill it."""
    ways[0].close()
    try:
        process.wait(GRACE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    for way in ways:
        way.close()
