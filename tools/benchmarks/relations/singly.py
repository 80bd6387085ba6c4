"""What learned relations are compared with: symbols of one object at a time.

A person says what to carry where to, one thing after another. What carries that object to places most surely,
as was learned of it alone, is aimed at the other object as if that were a place. Nothing is tried again, as
nothing that was learned of single objects tells what rests on what.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from neurosym.errors import InvalidValue
from neurosym.operators import TOLERANCE
from neurosym.tasks.options import carriers_for
from neurosym.world import relative_to
from neurosym.worlds.task_drawing import items_of
from tools.benchmarks.relations.tasks import Asked, Draw
from tools.benchmarks.relations.trying import bench_of


def one_by_one(folder: Path, draw: Draw, seeds: Sequence[int]) -> list[bool]:
    """Say of tasks whether they are reached with symbols of one object at a time."""
    world = bench_of(folder)[0].setting.world
    return [_is_reached(folder, draw(world, seed)) for seed in seeds]


def _is_reached(folder: Path, asked: Asked) -> bool:
    bench, _ = bench_of(folder)
    world, grounding = bench.setting.world, bench.setting.grounding
    items = items_of(asked.start, bench.categorise)
    scene, outcome = asked.start, None
    for target, reference in asked.deeds:
        carriers = carriers_for(items[target], grounding, TOLERANCE)
        if not carriers:
            return False
        action = np.array(grounding.primitive_of(carriers[0]).action)
        try:
            outcome = world.interact(scene, action, target, **relative_to(world, reference))
        except InvalidValue:  # the step before left an object where the arm cannot reach
            return False
        scene = outcome.end
    return outcome is not None and asked.is_met(outcome)
