"""Performing interactions in worker processes, in order, whatever their number.

A world is a function without memory, so who performs an interaction does not matter. Workers build their own
world once from a factory that can be pickled (`functools.partial(make_world, config)`, for instance).
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, partial
from multiprocessing.spawn import get_preparation_data, prepare
from typing import Any, TypeVar

from numpy import ndarray

from neurosym.checks import Float
from neurosym.contract import made
from neurosym.errors import InvalidValue, NeurosymError
from neurosym.world import Outcome, Reference, Scene, World, WorldFactory, relative_to
from neurosym.worlds.own_world import OwnFactory
from neurosym.worlds.processes import Child, ChildEnded, crew_of

# Worker processes that do whatever they are given, each a function of a module with its arguments

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


MOST_WORKERS = 256
AHEAD = 4
"""Tasks handed out for each worker, so that none waits for the next."""
Item = TypeVar("Item")
Result = TypeVar("Result")


@dataclass(frozen=True, slots=True, eq=False)
class Task:
    """One interaction to perform; see `World.interact`."""

    scene: Scene
    action: Float[ndarray, "A"]
    target: int = 0
    put_down: bool = True
    reference: Reference | None = None


Perform = Callable[[Iterable[Task]], Iterator[Outcome]]


def check_workers(workers: int) -> None:
    """Raise `InvalidValue` unless there can be so many processes."""
    if not 1 <= workers <= MOST_WORKERS:
        raise InvalidValue(f"workers = {workers} must be at least 1 and at most {MOST_WORKERS}.")


@contextmanager
def crew(world_factory: WorldFactory, workers: int) -> Iterator[Perform]:
    """Keep workers at hand; yields the function that has tasks performed and gives outcomes in order.

    Args:
        world_factory: Builds a world; must survive pickling if there is more than one worker.
        workers: How many processes; 1 performs everything in this one.

    Raises:
        InvalidValue: If there are fewer than one.
        WorkerDied: From the outcomes, if a worker process ends.
    """
    check_workers(workers)
    if workers == 1:
        world = made(world_factory)
        yield lambda tasks: (_perform_task(world, task) for task in tasks)
        return
    if isinstance(world_factory, OwnFactory):
        with crew_of(world_factory.another, workers, lambda world: world.process.child) as submit:
            yield lambda tasks: in_order(
                tasks, lambda task: submit(partial(_perform_task, task=task)), workers * AHEAD
            )
        return
    with worker_pool(workers, _start_worker, (world_factory,)) as submit_there:
        yield lambda tasks: in_order(tasks, lambda task: submit_there(_perform_here, task), workers * AHEAD)


def perform_all(world_factory: WorldFactory, tasks: Iterable[Task], workers: int) -> Iterator[Outcome]:
    """Have tasks performed by workers of their own, and give the outcomes in order.

    Args:
        world_factory: Builds a world.
        tasks: What to perform; drawn only a little ahead of the outcomes.
        workers: How many processes.
    """
    with crew(world_factory, workers) as perform:
        yield from perform(tasks)


def in_order(
    tasks: Iterable[Item], submit: Callable[[Item], "Future[Result]"], ahead: int
) -> Iterator[Result]:
    """Hand out tasks, and give their outcomes in the order of the tasks.

    Args:
        tasks: What to perform; drawn only a little ahead of the outcomes.
        submit: Hands a task out.
        ahead: How many may be handed out at a time.
    """
    waiting: deque[Future[Result]] = deque()
    for task in tasks:
        waiting.append(submit(task))
        if len(waiting) >= ahead:
            yield waiting.popleft().result()
    while waiting:
        yield waiting.popleft().result()


_factory_here: WorldFactory | None = None


def _start_worker(world_factory: WorldFactory) -> None:
    global _factory_here
    _factory_here = world_factory


@cache
def _world_here() -> World:
    """Make the world when it is first needed, so that an error in making it is one of a task."""
    assert _factory_here is not None, "the initializer ran"
    return made(_factory_here)


def _perform_here(task: Task) -> Outcome:
    return _perform_task(_world_here(), task)


def _perform_task(world: World, task: Task) -> Outcome:
    aim = relative_to(world, task.reference)
    return world.interact(task.scene, task.action, task.target, put_down=task.put_down, **aim)
