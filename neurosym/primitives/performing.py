"""Performing actions, in order, by any number of workers."""

from collections.abc import Iterator, Sequence

from neurosym.guarded import placed
from neurosym.progress import Progress
from neurosym.world import Outcome, WorldFactory
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
