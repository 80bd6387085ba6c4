"""Cost to go: what it costs to bring an object near its goal from anywhere in its room, if it were alone.

Value iteration on a grid, whose cells are so small that A* among other objects hardly strays with it.
"""

import math
from collections.abc import Callable, Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.planners.count_vectors import Choices

CELL = 0.005
"""Edge of a cell [m]."""
_SWEEPS = 200
CostToGo = Callable[[Sequence[float]], float]
"""Estimates what it costs to go on from a place [m]."""


def cost_to_go(
    choices: Choices, goal: Float[np.ndarray, "3"], tolerance: float, *, may_hold: bool
) -> CostToGo:
    """Estimate the cost from every place of an object, to within what cells round off.

    Args:
        choices: What can be done to the object.
        goal: What it is to come near to [m].
        tolerance: How near [m].
        may_hold: Whether it may end held there.
    """
    low, high = choices.room
    shape = tuple(max(0, math.floor(extent / CELL)) + 1 for extent in (high - low).tolist())
    places = np.stack(np.meshgrid(*(np.arange(count) * CELL for count in shape), indexing="ij"), -1) + low
    at = np.concatenate([places, np.full((*shape, 1), choices.start[2])], -1)  # (X, Y, 3)
    costs = np.where(_is_near(at, goal, tolerance), 0.0, np.inf)
    for move in np.flatnonzero(choices.held) if may_hold else ():
        there = _is_near(at + choices.lifted[move], goal, tolerance)
        costs[there] = np.minimum(costs[there], choices.costs[move])
    moves = [
        (_window(shape[0], dx), _window(shape[1], dy), float(cost))
        for (dx, dy), cost in zip(_in_cells(choices.settled), choices.costs, strict=True)
    ]
    for _ in range(_SWEEPS):
        before = costs.copy()
        for (here_x, there_x), (here_y, there_y), cost in moves:
            part = costs[here_x, here_y]
            np.minimum(part, costs[there_x, there_y] + cost, out=part)
        if np.array_equal(costs, before):
            break

    x_low, y_low = low.tolist()
    known = np.where(np.isfinite(costs), costs, 0.0).tolist()

    def estimate(place: Sequence[float]) -> float:
        x, y = round((place[0] - x_low) / CELL), round((place[1] - y_low) / CELL)
        return known[x][y] if 0 <= x < shape[0] and 0 <= y < shape[1] else 0.0

    return estimate


def _is_near(at: Float[np.ndarray, "X Y 3"], goal: Float[np.ndarray, "3"], tolerance: float) -> np.ndarray:
    return np.asarray(np.linalg.norm(at - goal, axis=-1) <= tolerance)


def _in_cells(displacements: Float[np.ndarray, "k 3"]) -> list[tuple[int, int]]:
    return [(round(x / CELL), round(y / CELL)) for x, y, _ in displacements.tolist()]


def _window(count: int, by: int) -> tuple[slice, slice]:
    """Return the cells from which a move stays inside, and those where it leads."""
    first, last = max(0, -by), max(0, min(count, count - by))
    return slice(first, last), slice(first + by, max(first, last) + by)
