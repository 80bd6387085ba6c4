"""What a person would write without a planner: carry each object to its goal by hand-written actions.

An object whose goal is free is carried there, the first in order. Where none is free, the first object waits
on a free spot that is drawn. What is missed is tried again; there are three motions for each object.
"""

from typing import NamedTuple

import numpy as np
from jaxtyping import Float

from neurosym.problems import Problem
from neurosym.tasks.task import footprints_apart, overlapping
from neurosym.world import Scene, Table, World, relative_to
from tools.benchmarks.world.hand_written import carry_to

MOTIONS = 3  # motions for each object at most
ROOM = 0.03  # how far objects are kept apart where they are set down to wait [m]
_DRAWS = 500
Spots = Float[np.ndarray, "M 2"]


class ByHand(NamedTuple):
    """What became of a task: whether all goals were reached, and how many actions were performed."""

    reached: bool
    motions: int


def carry_by_hand(problem: Problem, world: World, seed: int) -> ByHand:
    """Carry the objects of a task to their goals."""
    rng, apart = np.random.default_rng(seed), footprints_apart(problem)
    goals = np.array([problem.goals[name][:2] for name in problem.object_names])
    scene, motions = problem.scene(), 0
    while True:
        away = np.linalg.norm(scene.positions[:, :2] - goals, axis=1)
        unmet = np.flatnonzero(away > problem.tolerance)
        if not len(unmet) or motions == MOTIONS * len(problem.objects):
            return ByHand(not len(unmet), motions)
        target, spot = _next(scene, unmet, goals, apart, world.table, rng)
        action = carry_to(scene.features[target])
        assert action is not None, "it can be grasped"
        place = world.table.nearest(*spot.tolist())
        scene = world.interact(scene, action, target, **relative_to(world, place)).end
        motions += 1


def _next(
    scene: Scene, unmet: np.ndarray, goals: Spots, apart: np.ndarray, table: Table, rng: np.random.Generator
) -> tuple[int, np.ndarray]:
    """Return which object is carried next, and where to; objects keep so far `apart` (M, M, 2) [m]."""

    def is_free(target: int, spot: np.ndarray, room: float) -> bool:
        others = np.arange(len(scene)) != target
        return not overlapping(spot, scene.positions[others, :2], apart[target, others] + room).any()

    for target in unmet.tolist():
        if is_free(target, goals[target], 0.0):
            return target, goals[target]
    first = int(unmet[0])
    low, high = np.array([table.x, table.y]).T
    spots = (rng.uniform(low, high) for _ in range(_DRAWS))
    return first, next((spot for spot in spots if is_free(first, spot, ROOM)), goals[first])
