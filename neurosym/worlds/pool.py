"""Worker processes that do whatever they are given, each a function of a module with its arguments."""

from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from multiprocessing.spawn import get_preparation_data, prepare
from typing import Any

from neurosym.errors import InvalidValue, NeurosymError
from neurosym.worlds.children import Child, ChildEnded, crew_of

Submit = Callable[..., Future[Any]]
"""Has a worker process call a function with arguments; all must survive pickling."""


class WorkerDied(NeurosymError):
    """A worker process that ended before its work was done."""

    def __init__(self) -> None:
        super().__init__(
            "A worker process died (out of memory, or killed); start the command again to go on, "
            "with fewer workers if memory is short."
        )


class _Worker:
    """A worker process: it imports the main program, as what it is given may be from there."""

    def __init__(self, *first: Any):
        about = get_preparation_data("")
        del about["name"], about["authkey"]  # of `multiprocessing`, which is not used
        self._first = [(_import_main, about), *([first] if first else [])]
        self.child = Child()

    def do(self, work: Callable[..., Any], *given: Any) -> Any:
        """Have it do something; an error in what it does first is one of the first task."""
        try:
            while self._first:
                self.child.ask(*self._first[0])
                self.child.answer()
                del self._first[0]
            self.child.ask(work, *given)
            return self.child.answer()
        except ChildEnded as error:
            raise WorkerDied from error


@contextmanager
def worker_pool(
    workers: int, initializer: Callable[..., None] | None = None, arguments: tuple[Any, ...] = ()
) -> Iterator[Submit]:
    """Start processes, and yield the function that has them do something.

    Args:
        workers: How many.
        initializer: What each does first, if anything; must survive pickling.
        arguments: What it is given.

    Raises:
        CannotStart: If the system does not let them be started.
        InvalidValue: If this process is a worker that imports the main program.
    """
    if _imports_main:
        raise InvalidValue(
            'Workers import the main program; call this under `if __name__ == "__main__":`, or with 1 worker.'
        )
    first = (initializer, *arguments) if initializer else ()
    with crew_of(lambda: _Worker(*first), workers, lambda worker: worker.child) as submit:
        yield lambda work, *given: submit(lambda worker: worker.do(work, *given))


_imports_main = False
"""Whether this worker process imports the main program."""


def _import_main(about: dict[str, Any]) -> None:
    global _imports_main
    _imports_main = True
    prepare(about)
    _imports_main = False
