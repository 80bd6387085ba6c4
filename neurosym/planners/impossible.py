"""What no number of primitives can do, proved; a search that was cut off proves nothing.

Two things bound where an object can come to be, however often it is moved. It stays in its room. And every
end at rest is the start plus a sum of displacements. If the goal lies beyond the cone of those sums, there
is a direction in which no displacement leads, and in which the goal is farther away than allowed (Farkas'
lemma). It is found by non-negative least squares, and then checked by itself.
"""

import numpy as np

from neurosym.arrays import Float
from neurosym.operators import Vector
from neurosym.planners.count_vectors import Choices

MOST_PRIMITIVES = 1_000_000
"""Rounding is reckoned with for so many primitives."""


def is_off_table(choices: Choices, goal: Vector, tolerance: float) -> bool:
    """Say whether an object would have to leave its room to come near enough to its goal.

    Args:
        choices: What can be done to the object.
        goal: Where its centre shall come to be [m].
        tolerance: How near it must come [m].
    """
    low, high = choices.room
    spot = np.array(goal[:2])
    away = spot - np.clip(spot, low, high)
    return bool(np.linalg.norm(away) > tolerance)


def is_out_of_reach(choices: Choices, goal: Vector, tolerance: float, *, at_rest: bool = False) -> bool:
    """Say whether it is proved that an object cannot come near enough to its goal, on the table or anywhere.

    Args:
        choices: What can be done to the object, which stands farther from its goal than allowed.
        goal: Where its centre shall come to be [m].
        tolerance: How near it must come [m].
        at_rest: Whether it may not end held.
    """
    away = np.array(goal) - choices.start
    lifts = np.zeros((0, 3)) if at_rest else choices.lifted[choices.held]
    return all(_is_beyond(choices.settled, away - lift, tolerance) for lift in (np.zeros(3), *lifts))


def _is_beyond(moves: Float[np.ndarray, "k 3"], away: Float[np.ndarray, "3"], tolerance: float) -> bool:
    """Say whether a point is farther than a tolerance from all sums of moves."""
    gap = away
    if len(moves):
        from scipy.optimize import nnls

        gap = away - moves.T @ nnls(moves.T, away)[0]
    distance = float(np.linalg.norm(gap))
    if distance <= tolerance:
        return False
    direction = gap / distance
    along = max(0.0, float(np.max(moves @ direction, initial=0.0)))
    return float(direction @ away) - MOST_PRIMITIVES * along > tolerance
