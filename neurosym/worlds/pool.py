"""Worker processes that do whatever they are given, each a function of a module with its arguments."""

import os
import pickle
import signal
import time
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from multiprocessing.spawn import get_preparation_data, prepare
from types import FrameType
from typing import Any, TypeVar

from neurosym.errors import InvalidValue, NeurosymError
from neurosym.worlds.children import (
    Child,
    at_hand,
    end_all,
    end_with_parent,
    leave_signals_to_parent,
    say_up,
)

_PATIENCE = 3.0  # for a worker to end in order [s]
_ENDED = 128 + signal.SIGTERM  # the exit code of a worker that was told to end

Result = TypeVar("Result")
Submit = Callable[..., Future[Any]]
"""Has a worker process call a function with arguments; all must survive pickling."""


class WorkerDied(NeurosymError):
    """A worker process that ended before its work was done."""

    def __init__(self) -> None:
        super().__init__(
            "A worker process died (out of memory, or killed); start the command again to go on, "
            "with fewer workers if memory is short."
        )


class Worker:
    """A worker process: it imports the main program, as what it is given may be from there.

    Args:
        initializer: What it does first; must survive pickling. An error in it is one of the first task.
        arguments: What that is given.

    Raises:
        CannotStart: If the system does not let it be started; from `do`, if it ends before it is up.
    """

    def __init__(self, initializer: Callable[..., None], arguments: tuple[Any, ...]):
        about = get_preparation_data("")
        del about["name"], about["authkey"]  # of `multiprocessing`, which is not used
        self._first: list[tuple[Callable[..., None], tuple[Any, ...]]] = [
            (_import_main, (about,)),
            (initializer, arguments),
        ]
        self.child = Child(serve)

    def do(self, work: Callable[..., Result], *given: Any) -> Result:
        """Have it do something.

        Args:
            work: A function, which must survive pickling.
            given: What it is given.

        Raises:
            WorkerDied: If it ends.
        """
        while self._first:
            self._ask(*self._first[0])
            del self._first[0]
        result: Result = self._ask(work, given)
        return result

    def _ask(self, work: Callable[..., Any], given: tuple[Any, ...]) -> Any:
        question = pickle.dumps((work, given))
        try:
            self.child.send(question)
            is_done, answer = pickle.loads(self.child.receive())
        except (EOFError, OSError) as error:
            raise WorkerDied from error
        if not is_done:
            raise answer
        return answer


@contextmanager
def worker_pool(
    workers: int, initializer: Callable[..., None], arguments: tuple[Any, ...]
) -> Iterator[Submit]:
    """Start processes, and yield the function that has them do something.

    They ignore Ctrl-C, which is for their parent, and end with it. If an error ends the work, they are ended
    whatever they are doing, in order if they can be.

    Args:
        workers: How many.
        initializer: What each does first; must survive pickling.
        arguments: What it is given.

    Raises:
        CannotStart: If the system does not let them be started.
        InvalidValue: If this process is a worker that imports the main program.
    """
    if _imports_main:
        raise InvalidValue(
            'Workers import the main program; call this under `if __name__ == "__main__":`, or with 1 worker.'
        )
    crew: list[Worker] = []
    try:
        for _ in range(workers):
            crew.append(Worker(initializer, arguments))
        with at_hand(crew) as submit:
            try:
                yield lambda work, *given: submit(lambda worker: worker.do(work, *given))
            except BaseException:
                end_all([worker.child for worker in crew], _PATIENCE)
                raise
    finally:
        for worker in crew:
            worker.child.hang_up()
        for worker in crew:
            worker.child.close()


_is_busy = False
"""Whether this worker process does something that must be left in order."""
_imports_main = False
"""Whether this worker process imports the main program."""


def serve(requests: int, lifeline: int, errors: int) -> None:
    """Do what is asked for, until nobody asks any more; see `Serve`."""
    leave_signals_to_parent()
    signal.signal(signal.SIGTERM, _hear)
    end_with_parent(lifeline, _end_soon)
    connection = say_up(requests, errors)
    try:
        with suppress(EOFError, OSError):
            while True:
                connection.send(_answer(connection.recv()))
    except KeyboardInterrupt:
        os._exit(_ENDED)


def _answer(question: bytes) -> bytes:
    """Do something, and pack whether it was done with what came of it."""
    global _is_busy
    _is_busy = True
    try:
        work, given = pickle.loads(question)
        return pickle.dumps((True, work(*given)))
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        error.add_note(traceback.format_exc())
        try:
            return pickle.dumps((False, error))
        except Exception:
            return pickle.dumps((False, RuntimeError(traceback.format_exc())))
    finally:
        _is_busy = False


def _import_main(about: dict[str, Any]) -> None:
    global _imports_main
    _imports_main = True
    prepare(about)
    _imports_main = False


def _hear(_: int, __: FrameType | None) -> None:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    if _is_busy:
        raise KeyboardInterrupt
    os._exit(_ENDED)


def _end_soon() -> None:
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(_PATIENCE)
    os._exit(_ENDED)
