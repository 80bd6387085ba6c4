"""Where exactly objects are carried to: near their goals, and apart from each other as far as goals allow.

A goal is met by whatever lies within its tolerance. Where objects would nearly touch at their goals, they are
carried a little beside them, so that the hand has room.
"""

from itertools import combinations

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.problems import Problem
from neurosym.table import Table

ROOM = (0.02, 0.05)
"""Room along x and y that is made between objects at their goals, if these allow it [m].

The fingers of the hand open along y, so there they need more.
"""
SHARE = 0.5
"""How far beside its goal an object may be set down by choice, as a share of the tolerance."""
_ROUNDS = 200
_DIGITS = 4


def goal_spots(problem: Problem, table: Table, names: tuple[str, ...]) -> dict[str, tuple[float, float]]:
    """Return where on the table each object is to be carried, at most half the tolerance beside its goal [m].

    What stands at its goal already, or has none, stays where it is, and the others keep away from it.

    Args:
        problem: The problem, with the objects as they stand now.
        table: Where objects may be set down.
        names: Objects with goals on the table.
    """
    if not names:
        return {}
    here = problem.scene().positions
    unmet = problem.unmet
    stays = [name not in unmet for name in problem.object_names]
    chosen = [row for row, name in enumerate(problem.object_names) if stays[row] or name in names]
    moves = np.array([not stays[row] for row in chosen], dtype=bool)  # (M,)
    goals = np.array(
        [here[row, :2] if stays[row] else problem.goals[problem.object_names[row]][:2] for row in chosen]
    )
    halves = np.array([problem.objects[row].features[:2] for row in chosen], dtype=float) / 2  # (M, 2)
    spots = _apart(goals, halves, moves, SHARE * problem.tolerance, table)
    found = {problem.object_names[row]: spot for row, spot in zip(chosen, spots.tolist(), strict=True)}
    return {name: (round(found[name][0], _DIGITS), round(found[name][1], _DIGITS)) for name in names}


def _apart(
    goals: Float[np.ndarray, "M 2"],
    halves: Float[np.ndarray, "M 2"],
    moves: Bool[np.ndarray, " M"],
    most: float,
    table: Table,
) -> Float[np.ndarray, "M 2"]:
    """Push boxes apart with less than `ROOM` between them, step by step, none too far from its goal."""
    low, high = np.array([table.x, table.y]).T
    pairs = [pair for pair in combinations(range(len(goals)), 2) if moves[[*pair]].any()]
    ones, others = np.array(pairs, dtype=int).reshape(-1, 2).T
    room = halves[ones] + halves[others]
    spots = goals.copy()
    for _ in range(_ROUNDS):
        push = np.zeros_like(spots)
        away = spots[others] - spots[ones]  # (pairs, 2)
        over = room - np.abs(away)
        lacking = over + np.array(ROOM)
        for number in np.flatnonzero((lacking > 0).all(1)):
            one, other = pairs[number]
            axis = int(over[number].argmin())
            step = np.sign(away[number, axis] or 1.0) * lacking[number, axis] / (moves[one] + moves[other])
            push[one, axis] -= step * moves[one]
            push[other, axis] += step * moves[other]
        if not push.any():
            break
        beside = spots + push / 2 - goals
        beside *= np.minimum(1.0, most / np.maximum(np.linalg.norm(beside, axis=1), 1e-12))[:, None]
        inside = np.clip(goals + beside, np.minimum(low, goals), np.maximum(high, goals))
        before, spots = spots, np.where(moves[:, None], inside, goals)
        if np.array_equal(before, spots):  # and so it would stay
            break
    return spots
