"""Processes that we start, and that call functions for us: one layer for workers, worlds and the studio.

A process that lacks memory, files or threads may end with a traceback before any code of ours runs. Until it
says that it is up, its standard error is a pipe to us; from then on it is ours, and whoever writes there is
seen. No process is a fork, and none needs semaphores or temporary files. All are deaf to Ctrl-C and to closed
terminals, of which their parent hears, too; they end with it, in order if they can.
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
_UP = "up"
_START = """
import sys
sys.path[:] = {path!r}
import {module}
from neurosym.worlds.processes import serve
serve({requests}, {lifeline}, {errors})
"""

Member = TypeVar("Member")
Result = TypeVar("Result")


class ChildEnded(Exception):
    """The process has ended; `code` is its exit code, or less than 0 for a signal."""

    def __init__(self, code: int):
        super().__init__(code)
        self.code = code


class Unreadable(Exception):
    """A process sent what cannot be unpickled here."""


@dataclass(frozen=True, slots=True)
class _Call:
    function: Callable[..., Any]
    arguments: tuple[Any, ...]


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
        self._connection, requests = Pipe()
        lifeline, held = Pipe(duplex=False)
        self._said, saying = Pipe(duplex=False)
        os.set_blocking(saying.fileno(), False)  # what is too much is of no use
        with requests, lifeline, saying, _standard_error() as errors:
            ends = {"requests": requests.fileno(), "lifeline": lifeline.fileno(), "errors": errors}
            code = _START.format(path=sys.path, module=module, **ends)
            try:
                with _ctrl_c_held():
                    self.process = subprocess.Popen(
                        [sys.executable, "-c", code],
                        pass_fds=[end for end in ends.values() if end >= 0],
                        stderr=saying.fileno(),
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

    def ask(self, function: Callable[..., Any], *arguments: Any) -> None:
        """Have a function called, once the process is up; the next is `answer`.

        Args:
            function: A function of a module.
            arguments: What can be pickled.

        Raises:
            ChildEnded: If the process has ended.
        """
        if not self._is_up:
            self._await_up()
        self.say(_Call(function, arguments))

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
            TimeoutError: If nothing comes.
            ChildEnded: If the process has ended.
            Unreadable: If what it sent cannot be unpickled.
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
            self.process.kill()
            self.process.wait()  # before its ways are closed, on which others may be waiting
        self._end()

    def _receive(self, patience: float | None = None) -> Any:
        with self._telling_its_end():
            has_come = self._connection.poll(patience)
            content = self._connection.recv_bytes() if has_come else b""
        if not has_come:
            raise TimeoutError
        try:
            return pickle.loads(content)
        except Exception as error:
            raise Unreadable from error

    @contextmanager
    def _telling_its_end(self) -> Iterator[None]:
        try:
            yield
        except (EOFError, OSError) as error:
            with suppress(subprocess.TimeoutExpired):
                self.process.wait(GRACE)
            self.process.kill()
            self.process.wait()
            raise ChildEnded(self.process.returncode) from error

    def _await_up(self) -> None:
        try:
            self._is_up = self._connection.recv() == _UP
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


_parent: Connection
_is_busy = False  # whether this process does something that must be left in order


def parent() -> Connection:
    """Return, in a process that was started here, the way to who started it, for words while it works."""
    return _parent


def serve(requests: int, lifeline: int, errors: int) -> None:
    """Call the functions that are asked for, until nobody asks any more.

    Args:
        requests: Descriptor of the way to the parent.
        lifeline: Descriptor of what ends with the parent.
        errors: Descriptor of the parent's standard error; -1 if it is closed.
    """
    global _parent
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    signal.signal(signal.SIGTERM, _hear_the_end)
    threading.Thread(target=_end_with_parent, args=(lifeline,), daemon=True).start()
    if errors >= 0:
        os.dup2(errors, 2)
        os.close(errors)
    _parent = Connection(requests)
    try:
        with suppress(EOFError, OSError):
            _parent.send(_UP)
            while True:
                if answer := _answer(_parent.recv_bytes()):
                    _parent.send_bytes(answer)
    except KeyboardInterrupt:
        os._exit(_ENDED)


def _answer(question: bytes) -> bytes | None:
    """Call a function, and pack what came of it; None for a word that comes too late."""
    global _is_busy
    _is_busy = True
    try:
        call = pickle.loads(question)
        if not isinstance(call, _Call):
            return None
        return pickle.dumps(_Answer(call.function(*call.arguments)))
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        error.add_note(traceback.format_exc())
        try:
            return pickle.dumps(_Answer(error=error))
        except Exception:
            return pickle.dumps(_Answer(error=RuntimeError(traceback.format_exc())))
    finally:
        _is_busy = False


def _hear_the_end(_: int, __: FrameType | None) -> None:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    if _is_busy:
        raise KeyboardInterrupt
    os._exit(_ENDED)


def _end_with_parent(lifeline: int) -> None:
    os.read(lifeline, 1)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(PATIENCE)
    os._exit(_ENDED)


@contextmanager
def crew_of(
    make: Callable[[], Member], count: int, child_of: Callable[[Member], Child]
) -> Iterator[Callable[[Callable[[Member], Result]], "Future[Result]"]]:
    """Keep members at hand, each with a process; yields what hands work out to whichever is free.

    If an error ends the work, the processes are ended whatever they are doing, in order if they can be.

    Args:
        make: Makes a member.
        count: How many.
        child_of: Says which process a member has.

    Raises:
        CannotStart: If the system does not let them be started.
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
            _end_all([child_of(member) for member in members])
            raise
        finally:
            threads.shutdown(wait=True, cancel_futures=True)
    finally:
        for member in members:
            child_of(member).hang_up()
        for member in members:
            child_of(member).close()


def _end_all(children: Sequence[Child]) -> None:
    """Ask processes to end, and kill those that do not soon; keepers of planners see to the rest."""
    for child in children:
        child.process.terminate()
    end = time.monotonic() + PATIENCE
    for child in children:
        with suppress(subprocess.TimeoutExpired):
            child.process.wait(max(0.0, end - time.monotonic()))
        child.process.kill()


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
