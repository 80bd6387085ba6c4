"""Performing interactions in worker processes, in order, whatever their number.

A world is a function without memory, so who performs an interaction does not matter. Workers build their own
world once from a factory that can be pickled (`functools.partial(make_world, config)`, for instance).
"""

import multiprocessing
import multiprocessing.connection
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, TypeVar

from jaxtyping import Float
from numpy import ndarray

from neurosym.errors import InvalidValue, NeurosymError
from neurosym.world import Outcome, Scene, World, WorldFactory

MOST_WORKERS = 256
"""Processes on one machine; a cluster may have more."""
AHEAD = 4
"""Tasks handed out for each worker, so that none waits for the next."""

Item = TypeVar("Item")
Pending = TypeVar("Pending")
Result = TypeVar("Result")


@dataclass(frozen=True, slots=True, eq=False)
class Task:
    """One interaction to perform; see `World.interact`."""

    scene: Scene
    action: Float[ndarray, "A"]
    target: int = 0
    put_down: bool = True


Perform = Callable[[Iterable[Task]], Iterator[Outcome]]


class WorkerDied(NeurosymError):
    """A worker process that ended before its work was done."""

    def __init__(self) -> None:
        super().__init__(
            "A worker process died (out of memory, or killed); start the command again to go on, "
            "with fewer workers if memory is short."
        )


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
    if not 1 <= workers <= MOST_WORKERS:
        raise InvalidValue(f"workers = {workers} must be at least 1 and at most {MOST_WORKERS}.")
    if workers == 1:
        world = world_factory()
        yield lambda tasks: (perform_task(world, task) for task in tasks)
        return
    pool = start_pool(workers, _start_worker, (world_factory,))
    try:
        yield lambda tasks: _outcomes(pool, tasks, workers * AHEAD)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


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
    tasks: Iterable[Item],
    *,
    submit: Callable[[Item], Pending],
    result: Callable[[Pending], Result],
    ahead: int,
) -> Iterator[Result]:
    """Hand out tasks, and give their outcomes in the order of the tasks.

    Args:
        tasks: What to perform; drawn only a little ahead of the outcomes.
        submit: Hands a task out.
        result: Waits for the outcome of one that was handed out.
        ahead: How many may be handed out at a time.
    """
    waiting: deque[Pending] = deque()
    for task in tasks:
        waiting.append(submit(task))
        if len(waiting) >= ahead:
            yield result(waiting.popleft())
    while waiting:
        yield result(waiting.popleft())


def start_pool(
    workers: int, initializer: Callable[..., None], arguments: tuple[Any, ...]
) -> ProcessPoolExecutor:
    """Start processes that ignore Ctrl-C, which the parent ends them at, and that end with it.

    Args:
        workers: How many.
        initializer: What each does first; must survive pickling.
        arguments: What it is given.
    """
    pool = ProcessPoolExecutor(
        workers,
        multiprocessing.get_context("spawn"),
        initializer=_start_process,
        initargs=(initializer, arguments),
    )
    in_main_thread = threading.current_thread() is threading.main_thread()
    before = signal.signal(signal.SIGINT, signal.SIG_IGN) if in_main_thread else None
    try:
        for _ in range(workers):
            pool.submit(int)  # a process is started for each task that finds none idle
    finally:
        if before is not None:
            signal.signal(signal.SIGINT, before)
    return pool


def _outcomes(pool: ProcessPoolExecutor, tasks: Iterable[Task], ahead: int) -> Iterator[Outcome]:
    def submit(task: Task) -> Future[Outcome]:
        return pool.submit(_perform_here, task)

    try:
        yield from in_order(tasks, submit=submit, result=lambda future: future.result(), ahead=ahead)
    except BrokenProcessPool as error:
        raise WorkerDied from error


_world_here: World | None = None


def _start_process(initializer: Callable[..., None], arguments: tuple[Any, ...]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    initializer(*arguments)


def _start_worker(world_factory: WorldFactory) -> None:
    global _world_here
    _world_here = world_factory()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        multiprocessing.connection.wait([parent.sentinel])
        os._exit(1)


def _perform_here(task: Task) -> Outcome:
    assert _world_here is not None, "the initializer ran"
    return perform_task(_world_here, task)


def perform_task(world: World, task: Task) -> Outcome:
    """Perform a task in this process."""
    return world.interact(task.scene, task.action, task.target, put_down=task.put_down)
