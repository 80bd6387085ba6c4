"""Processes that we start, and that call functions for us: one layer for workers, worlds and the studio.

A process that lacks memory, files or threads may end with a traceback before any code of ours runs. Until it
says that it is up, its standard error is a pipe to us; from then on it is ours, and whoever writes there is
seen. No process is a fork, and none needs semaphores or temporary files. All have a process group of their
own, so Ctrl-C and closed terminals reach their parent alone; they end with it, in order if they can.
"""

import os
import pickle
import signal
import subprocess
import sys
import textwrap
import threading
import time
import traceback
import weakref
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from queue import SimpleQueue
from types import FrameType
from typing import Any, TypeVar

from neurosym.errors import CannotStart

GRACE = 5.0
"""How long a process has to end by itself [s]."""
PATIENCE = 3.0
"""How long those that work have to end in order, once they are told to [s]."""
_ENDED = 128 + signal.SIGTERM  # the exit code of one that was told to end
_START = """
import sys
sys.path[:] = {path!r}
import {module}
from neurosym.worlds.processes import serve
serve({requests}, {lifeline}, {errors})
"""


class ChildEnded(Exception):
    """A process that ended before it answered; it says how, as in `ends its process with exit code 7 in`."""


@dataclass(frozen=True, slots=True)
class _Answer:
    value: Any = None
    error: BaseException | None = None


class Child:
    """A process that calls functions, and may send words on the way.

    Args:
        module: What it imports before it is up.

    Raises:
        CannotStart: If the system does not let it be started; from `ask`, if it ends before it is up.
    """

    def __init__(self, module: str = __name__):
        try:
            self._connection, requests = Pipe()
            lifeline, held = Pipe(duplex=False)
            self._said, saying = Pipe(duplex=False)
            os.set_blocking(saying.fileno(), False)  # what is too much is of no use
            with requests, lifeline, saying:
                self.process = self._started(module, requests.fileno(), lifeline.fileno(), saying.fileno())
        except OSError as error:
            raise CannotStart("process", str(error.strerror)) from error
        self._is_up = False
        self._end = weakref.finalize(self, _end, self.process, (self._connection, self._said, held))

    @staticmethod
    def _started(module: str, requests: int, lifeline: int, saying: int) -> "subprocess.Popen[bytes]":
        """Start the process with its ends of the ways; if Ctrl-C comes meanwhile, its lifeline ends it."""
        try:
            errors = os.dup(2)
        except OSError:  # ours is closed
            errors = os.dup(saying)
        ends = {"requests": requests, "lifeline": lifeline, "errors": errors}
        code = _START.format(path=sys.path, module=module, **ends)
        try:
            return subprocess.Popen(
                [sys.executable, "-c", code], pass_fds=[*ends.values()], stderr=saying, process_group=0
            )
        finally:
            os.close(errors)

    @property
    def is_open(self) -> bool:
        """Whether it can be asked."""
        return self._end.alive

    def ask(self, function: Callable[..., Any], *arguments: Any) -> None:
        """Have a function called, once the process is up; the next is `answer`.

        Args:
            function: A function of a module.
            arguments: What can be pickled.

        Raises:
            ChildEnded: If the process has ended.
        """
        if not self._is_up:
            try:
                self._is_up = bool(self._connection.recv())
            except (EOFError, OSError) as error:
                raise CannotStart("process", self._last_words()) from error
            self._said.close()
        self.say(partial(function, *arguments))

    def say(self, word: Any) -> None:
        """Send a word to the function that is called; it comes too late once that has returned."""
        question = pickle.dumps(word)
        with self._telling_its_end():
            self._connection.send_bytes(question)

    def answer(self, patience: float | None = None, hear: Callable[[Any], None] | None = None) -> Any:
        """Wait for what the function returns, or raise what it raises.

        Args:
            patience: How long each message may take [s]; for ever if not given.
            hear: Takes the words that are sent on the way.

        Raises:
            ChildEnded: If the process has ended, nothing comes in time, or what comes cannot be unpickled.
        """
        try:
            while not isinstance(said := self._receive(patience), _Answer):
                assert hear is not None, "else no words are sent"
                hear(said)
        except BaseException:  # whatever it still sends belongs to no call any more
            self.close(grace=0.0)
            raise
        if said.error is not None:
            raise said.error
        return said.value

    def hang_up(self) -> None:
        """Close the way to it, which ends it once it has answered."""
        self._connection.close()

    def close(self, grace: float = GRACE) -> None:
        """Let it end by itself, or kill it.

        Args:
            grace: How long it has to end [s].
        """
        if self._end.alive and not grace:
            _code_of(self.process, 0.0)  # before its ways are closed, on which others may be waiting
        self._end()

    def _receive(self, patience: float | None) -> Any:
        with self._telling_its_end():
            if not self._connection.poll(patience):
                raise ChildEnded(f"has not come back for {patience:g} s from")
            content = self._connection.recv_bytes()
        try:
            return pickle.loads(content)
        except Exception as error:
            raise ChildEnded("gives what no other process can read from") from error

    @contextmanager
    def _telling_its_end(self) -> Iterator[None]:
        try:
            yield
        except (EOFError, OSError) as error:
            code = _code_of(self.process)
            because = " (by somebody, or for want of memory)" if -code == signal.SIGKILL else ""
            killed = f"has its process killed by {signal.Signals(-code).name}{because} in" if code < 0 else ""
            raise ChildEnded(killed or f"ends its process with exit code {code} in") from error

    def _last_words(self) -> str:
        """Return the last line that it wrote before it ended, or else how it ended."""
        code = self.process.wait()
        os.set_blocking(self._said.fileno(), False)
        with suppress(OSError):
            lines = os.read(self._said.fileno(), 1 << 16).decode(errors="replace").split("\n")
            if words := " ".join(next(filter(str.strip, reversed(lines)), "").split()):
                return textwrap.shorten(words, 200).rstrip(".")
        return f"killed by {signal.Signals(-code).name}" if code < 0 else f"exit code {code}"


def _code_of(process: "subprocess.Popen[bytes]", seconds: float = GRACE) -> int:
    """Wait for a process to end, or kill it, and return its exit code, less than 0 for a signal."""
    with suppress(subprocess.TimeoutExpired):
        return process.wait(seconds)
    process.kill()
    return process.wait()


def _end(process: "subprocess.Popen[bytes]", ways: Sequence[Connection]) -> None:
    """End a process: close the way to it, wait a little, and kill it."""
    ways[0].close()
    _code_of(process)
    for way in ways:
        way.close()


# What the process does that was started

_parent: Connection


def parent() -> Connection:
    """Return, in a process that was started here, the way to who started it, for words while it works."""
    return _parent


def serve(requests: int, lifeline: int, errors: int) -> None:
    """Call the functions that are asked for until nobody asks; given are descriptors of the ways there."""
    global _parent
    os.dup2(errors, 2)
    os.close(errors)
    _parent = Connection(requests)
    with suppress(EOFError, OSError):
        try:
            signal.signal(signal.SIGTERM, _hear_the_end)
            threading.Thread(target=_end_with_parent, args=(lifeline,), daemon=True).start()
            _parent.send(True)
            while True:
                if answer := _answer(_parent.recv_bytes()):
                    _parent.send_bytes(answer)
        except KeyboardInterrupt:
            os._exit(_ENDED)


def _answer(question: bytes) -> bytes | None:
    """Call a function, and pack what came of it; None for a word that comes too late."""
    try:
        call = pickle.loads(question)
        return pickle.dumps(_Answer(call())) if isinstance(call, partial) else None
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        error.add_note(traceback.format_exc())
        try:
            return pickle.dumps(_Answer(error=error))
        except Exception:
            return pickle.dumps(_Answer(error=RuntimeError(traceback.format_exc())))


def _hear_the_end(_: int, __: FrameType | None) -> None:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise KeyboardInterrupt


def _end_with_parent(lifeline: int) -> None:
    os.read(lifeline, 1)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(PATIENCE)
    os._exit(_ENDED)


# Several processes at hand

Member = TypeVar("Member", bound=Child)
Result = TypeVar("Result")


@contextmanager
def crew_of(
    make: Callable[[], Member], count: int
) -> Iterator[Callable[[Callable[[Member], Result]], "Future[Result]"]]:
    """Start so many processes and keep them at hand; yields what hands work out to whichever is free.

    If an error ends the work, the processes are ended whatever they are doing, in order if they can be.
    Raises `CannotStart` if the system does not let them be started.
    """
    members: list[Member] = []
    free: SimpleQueue[Member] = SimpleQueue()
    threads = ThreadPoolExecutor(count)

    def perform(work: Callable[[Member], Result]) -> Result:
        member = free.get()
        try:
            return work(member)
        finally:
            free.put(member)

    def submit(work: Callable[[Member], Result]) -> "Future[Result]":
        try:
            return threads.submit(perform, work)
        except RuntimeError as error:
            raise CannotStart("thread", str(error)) from error

    try:
        for _ in range(count):
            members.append(make())
            free.put(members[-1])
        try:
            yield submit
        except BaseException:
            _end_all(members)
            raise
        finally:
            threads.shutdown(wait=True, cancel_futures=True)
    finally:
        for member in members:
            member.hang_up()
        for member in members:
            member.close()


def _end_all(children: Sequence[Child]) -> None:
    """Ask processes to end, and kill those that do not soon; keepers of planners see to the rest."""
    for child in children:
        child.process.terminate()
    end = time.monotonic() + PATIENCE
    for child in children:
        _code_of(child.process, max(0.0, end - time.monotonic()))
