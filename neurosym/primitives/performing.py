"""Performing actions, in order, by any number of workers."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from neurosym.guarded import placed
from neurosym.operators import Primitive
from neurosym.progress import Progress
from neurosym.world import Outcome, Scene, WorldFactory
from neurosym.worlds.workers import Task, perform_all


def perform(
    world_factory: WorldFactory, tasks: Sequence[Task], workers: int, progress: Progress | None
) -> Iterator[Outcome]:
    """Perform actions, and give the outcomes in order.

    Args:
        world_factory: Builds the world.
        tasks: What to perform.
        workers: How many processes; their number does not change the outcomes.
        progress: Called after each performance.
    """
    performed = perform_all(world_factory, tasks, workers)
    for number in range(1, len(tasks) + 1):
        with placed(f"rehearsal {number} of {len(tasks)}"):
            outcome = next(performed)
        if progress is not None:
            progress(number, len(tasks))
        yield outcome


def perform_each(
    world_factory: WorldFactory,
    tasks: Sequence[Sequence[Task]],
    workers: int,
    progress: Progress | None = None,
) -> list[list[Outcome]]:
    """Perform several lists of actions, and give the outcomes of each; see `perform`."""
    performed = perform(world_factory, [task for some in tasks for task in some], workers, progress)
    return [[next(performed) for _ in some] for some in tasks]


def tasks_of(primitive: Primitive, scenes: Iterable[Scene]) -> list[Task]:
    """Return what it takes to perform an action in each of some scenes."""
    return [Task(scene, np.array(primitive.action, dtype=np.float64)) for scene in scenes]
