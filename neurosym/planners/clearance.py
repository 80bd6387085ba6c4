"""Which object to carry first: the one with most room around it, so that the hand hits no other."""

from collections.abc import Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.problems import Problem
from neurosym.tasks.footprints import footprints_apart, overlapping
from neurosym.tasks.steps import PlanStep

ENOUGH = 0.08
"""Room beside an object along y, along which the fingers open, beyond which more makes no difference [m]."""
FINGER = 0.02
"""An object that leaves so much room along x is not in the way of the fingers [m]."""


def clearest_first(steps: Sequence[PlanStep], problem: Problem) -> tuple[PlanStep, ...]:
    """Put steps that carry in another order: first what has most room where it stands and where it goes.

    Steps with one object keep their order, and no object is carried to where another stands. If there is no
    such order, nothing is changed.

    Args:
        steps: A plan that is true when replayed and whose steps all carry.
        problem: The problem, with its places.
    """
    names, apart = problem.object_names, footprints_apart(problem)
    here = problem.scene().positions[:, :2].copy()
    left, ordered = list(steps), list[PlanStep]()
    while left:
        rooms: list[tuple[float, int]] = []
        for number, step in enumerate(left):
            row = names.index(step.object)
            if any(earlier.object == step.object for earlier in left[:number]):
                continue
            there = np.array(problem.place_named(step.place))
            others = np.arange(len(names)) != row
            if overlapping(there, here[others], apart[row, others]).any():
                continue
            gap = min(_gap(spot, here[others], apart[row, others]) for spot in (here[row], there))
            rooms.append((-min(gap, ENOUGH), number))
        if not rooms:
            return tuple(steps)
        step = left.pop(min(rooms)[1])
        here[names.index(step.object)] = problem.place_named(step.place)
        ordered.append(step)
    return tuple(ordered)


def _gap(
    spot: Float[np.ndarray, "2"], others: Float[np.ndarray, "M 2"], apart: Float[np.ndarray, "M 2"]
) -> float:
    """Return the room along y between the footprint of an object and the next in the fingers' way [m]."""
    room = np.abs(others - spot) - apart
    return float(room[room[:, 0] < FINGER, 1].min(initial=np.inf))
