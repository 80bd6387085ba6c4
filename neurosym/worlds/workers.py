"""Performing interactions in worker processes, in order, whatever their number.

A world is a function without memory, so who performs an interaction does not matter. Workers build their own
world once from a factory that can be pickled (`functools.partial(make_world, config)`, for instance).
"""

import multiprocessing
import multiprocessing.connection
import os
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, partial
from multiprocessing.process import BaseProcess
from types import FrameType
from typing import Any, TypeVar

from jaxtyping import Float
from numpy import ndarray

from neurosym.errors import InvalidValue, NeurosymError
from neurosym.guarded import made
from neurosym.world import Outcome, Scene, World, WorldFactory
from neurosym.worlds.apart import ctrl_c_ignored
from neurosym.worlds.hosted import OwnFactory, hosts

MOST_WORKERS = 256
"""Processes on one machine; a cluster may have more."""
AHEAD = 4
"""Tasks handed out for each worker, so that none waits for the next."""
_PATIENCE = 3.0  # for a worker to end in order [s]
_ENDED = 128 + signal.SIGTERM  # the exit code of a worker that was told to end

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
Submit = Callable[..., Future[Any]]
"""Has a worker process call a function with arguments; all must survive pickling."""


class WorkerDied(NeurosymError):
    """A worker process that ended before its work was done."""

    def __init__(self) -> None:
        super().__init__(
            "A worker process died (out of memory, or killed); start the command again to go on, "
            "with fewer workers if memory is short."
        )


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
        yield lambda tasks: (perform_task(world, task) for task in tasks)
        return
    if isinstance(world_factory, OwnFactory):
        with hosts(world_factory, workers) as submit:
            yield lambda tasks: in_order(
                tasks,
                submit=lambda task: submit(partial(perform_task, task=task)),
                result=lambda future: future.result(),
                ahead=workers * AHEAD,
            )
        return
    with worker_pool(workers, _start_worker, (world_factory,)) as submit_there:
        yield lambda tasks: _outcomes(submit_there, tasks, workers * AHEAD)


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
    """
    before = multiprocessing.active_children()
    pool = ProcessPoolExecutor(
        workers,
        multiprocessing.get_context("spawn"),
        initializer=_start_process,
        initargs=(initializer, arguments),
    )
    started: list[BaseProcess] = []
    try:
        with ctrl_c_ignored():
            for _ in range(workers):
                pool.submit(int)  # a process is started for each task that finds none idle
            started = [child for child in multiprocessing.active_children() if child not in before]
        yield lambda work, *given: pool.submit(_do, work, *given)
    except BaseException:
        _end_all(started)
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _end_all(started: Sequence[BaseProcess]) -> None:
    """Ask processes to end, and kill those that do not soon; keepers of planners see to the rest."""
    for process in started:
        process.terminate()
    end = time.monotonic() + _PATIENCE
    for process in started:
        process.join(max(0.0, end - time.monotonic()))
        process.kill()


def _outcomes(submit: Submit, tasks: Iterable[Task], ahead: int) -> Iterator[Outcome]:
    try:
        yield from in_order(
            tasks,
            submit=lambda task: submit(_perform_here, task),
            result=lambda future: future.result(),
            ahead=ahead,
        )
    except BrokenProcessPool as error:
        raise WorkerDied from error


_is_busy = False
"""Whether this worker process does something that must be left in order."""


def _do(work: Callable[..., Result], *given: Any) -> Result:
    """Do something in a worker process, and end it if it is told to meanwhile."""
    global _is_busy
    _is_busy = True
    try:
        return work(*given)
    except KeyboardInterrupt:
        os._exit(_ENDED)
    finally:
        _is_busy = False


def _start_process(initializer: Callable[..., None], arguments: tuple[Any, ...]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _hear)
    signal.signal(signal.SIGHUP, signal.SIG_IGN)  # a closed terminal ends the parent
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _do(initializer, *arguments)


def _hear(_: int, __: FrameType | None) -> None:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    if _is_busy:
        raise KeyboardInterrupt
    os._exit(_ENDED)


_factory_here: WorldFactory | None = None


def _start_worker(world_factory: WorldFactory) -> None:
    global _factory_here
    _factory_here = world_factory


@cache
def _world_here() -> World:
    """Make the world when it is first needed, so that an error in making it is one of a task."""
    assert _factory_here is not None, "the initializer ran"
    return made(_factory_here)


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        multiprocessing.connection.wait([parent.sentinel])
        os.kill(os.getpid(), signal.SIGTERM)
        time.sleep(_PATIENCE)
        os._exit(_ENDED)


def _perform_here(task: Task) -> Outcome:
    return perform_task(_world_here(), task)


def perform_task(world: World, task: Task) -> Outcome:
    """Perform a task in this process."""
    return world.interact(task.scene, task.action, task.target, put_down=task.put_down)
