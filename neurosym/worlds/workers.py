"""Performing interactions in worker processes, in order, whatever their number.

A world is a function without memory, so who performs an interaction does not matter. Workers build their own
world once from a factory that can be pickled (`functools.partial(make_world, config)`, for instance).
"""

import pickle
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import cache, lru_cache, partial
from multiprocessing.spawn import get_preparation_data, prepare
from typing import Any, TypeVar

from numpy import ndarray

from neurosym.checks import Float
from neurosym.contract import made
from neurosym.errors import InvalidValue, NeurosymError
from neurosym.world import Outcome, Reference, Scene, World, WorldFactory, relative_to
from neurosym.worlds.own_world import OwnFactory
from neurosym.worlds.processes import Child, ChildEnded, crew_of

MOST_WORKERS = 256
AHEAD = 4
"""Tasks handed out for each worker, so that none waits for the next."""
Item = TypeVar("Item")
Result = TypeVar("Result")


class WorkerDied(NeurosymError):
    """A worker process that ended before its work was done."""

    def __init__(self) -> None:
        super().__init__(
            "A worker process died (out of memory, or killed); start the command again to go on, "
            "with fewer workers if memory is short."
        )


Submit = Callable[..., "Future[Any]"]
_kept: Callable[[int], Submit] | None = None
"""Starts so many workers, or gives those that were started; None if workers end with what they are for."""


@contextmanager
def kept_workers() -> Iterator[None]:
    """Keep workers until this ends, so that they are started once and not for each piece of work."""
    global _kept
    if _kept is not None:
        yield
        return
    with ExitStack() as stack:
        _kept = cache(lambda workers: stack.enter_context(_started(workers)))
        try:
            yield
        finally:
            _kept = None


@contextmanager
def worker_pool(workers: int) -> Iterator[Submit]:
    """Start processes, and yield what has one call a function with arguments; all must survive pickling.

    Within `kept_workers`, those are taken that were started.

    Raises:
        CannotStart: If the system does not let them be started.
        InvalidValue: If this process is a worker that imports the main program.
    """
    if _kept is not None:
        yield _kept(workers)
        return
    with _started(workers) as submit:
        yield submit


@contextmanager
def _started(workers: int) -> Iterator[Submit]:
    if _imports_main:
        raise InvalidValue(
            'Workers import the main program; call this under `if __name__ == "__main__":`, or with 1 worker.'
        )
    about = get_preparation_data("")
    del about["name"], about["authkey"]  # of `multiprocessing`, which is not used

    def do(child: Child, work: Callable[..., Any], given: tuple[Any, ...]) -> Any:
        try:
            child.ask(_do, pickle.dumps(about), pickle.dumps((work, given)))
            return child.answer()
        except ChildEnded as error:
            raise WorkerDied from error

    with crew_of(Child, workers) as submit:
        yield lambda work, *given: submit(partial(do, work=work, given=given))


_imports_main = False
"""Whether this worker process imports the main program."""


@cache
def _import_main(about: bytes) -> None:
    global _imports_main
    _imports_main = True
    prepare(pickle.loads(about))
    _imports_main = False


def _do(about: bytes, packed: bytes) -> Any:
    """Do something in a worker that has imported the main program: what it is given may be from there."""
    _import_main(about)
    work, given = pickle.loads(packed)
    return work(*given)


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
    ahead = workers * AHEAD
    if workers == 1:
        world = made(world_factory)
        yield lambda tasks: (_perform(world, task) for task in tasks)
    elif isinstance(world_factory, OwnFactory):
        with crew_of(world_factory.another, workers) as submit:
            yield lambda tasks: in_order(tasks, lambda task: submit(partial(_perform, task=task)), ahead)
    else:
        packed = pickle.dumps(world_factory)
        with worker_pool(workers) as submit_there:
            yield lambda tasks: in_order(
                tasks, lambda task: submit_there(_perform_there, packed, task), ahead
            )


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


@lru_cache(maxsize=1)
def _world_of(packed: bytes) -> World:
    """Make the world of a worker from its pickled factory, when the first task comes."""
    return made(pickle.loads(packed))


def _perform_there(packed: bytes, task: Task) -> Outcome:
    return _perform(_world_of(packed), task)


def _perform(world: World, task: Task) -> Outcome:
    aim = relative_to(world, task.reference)
    return world.interact(task.scene, task.action, task.target, put_down=task.put_down, **aim)
