"""Whether a problem that somebody wrote can be: its goals, and its scene as far as the world tells."""

import math
from itertools import combinations

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.object_limits import ObjectLimits
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.place_check import check_places
from neurosym.problems import NEAR_TABLE, Problem, SceneObject, check_goals, goal_heights
from neurosym.related import chain_below, known_bearers
from neurosym.tasks.pair_goals import check_relations

OFF_REST = 0.005
"""How far from the height it rests at an object's centre may be [m]; physics settles it within 0.1 mm."""
OFF_UNIT = 0.01
"""How far from 1 the length of a quaternion may be."""
_UPRIGHT = 0.999


def check_problem(problem: Problem, grounding: Grounding | None, limits: ObjectLimits | None) -> None:
    """Raise unless the scene of a problem can be, and its goals too.

    Args:
        problem: The problem.
        grounding: The learned domain: its table and its categories; if None, these are not checked.
        limits: Which objects the world makes; if None, how objects are and stand is not checked.

    Raises:
        InvalidValue: If there is no goal, or something is or stands as it cannot.
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    bearers = known_bearers(problem, grounding.relations) if grounding and grounding.relations else {}
    for item in problem.objects:
        if limits:
            limits.check(item.name, item.features)
            _check_orientation(item)
        if grounding:
            grounding.category(item.category)
            check_on_table(item, grounding, off=NEAR_TABLE)
        if limits and item.name not in bearers:
            _check_height(item)
    if limits:
        for one, other in combinations(problem.objects, 2):
            chains = [chain_below(item.name, bearers) for item in (one, other)]
            if chains[0][-1] != chains[1][-1]:  # what bears one another may be one over the other
                _check_apart(one, other)
    if grounding:
        check_places(problem, grounding)
        check_relations(problem, grounding)
        heights = goal_heights(problem, grounding.lift_height) if limits else (-math.inf, math.inf)
        check_goals(problem, grounding.table, heights)


def _check_orientation(item: SceneObject) -> None:
    length = math.hypot(*item.orientation)
    if not abs(length - 1) <= OFF_UNIT:
        raise InvalidValue(
            f"{item.name} has an orientation of length {length:g}; valid: a quaternion (x, y, z, w) of "
            "length 1, as [0, 0, 0, 1]."
        )


def _check_height(item: SceneObject) -> None:
    """Refuse an object that floats or is sunk; one that leans on another may be at any height it can be."""
    half = np.array(item.features[:3]) / 2
    upwards = np.abs(_rotation(item)[2])
    lowest = highest = float(upwards @ half)
    if upwards.max() < _UPRIGHT:
        lowest, highest = float(half.min()), float(np.linalg.norm(half))
    height = item.position[2]
    if not lowest - OFF_REST <= height <= highest + OFF_REST:
        raise InvalidValue(
            f"The centre of {item.name} is at z = {height:g} m, where it does not rest; valid: "
            f"{lowest - OFF_REST:.3f} to {highest + OFF_REST:.3f} m."
        )


def _check_apart(one: SceneObject, other: SceneObject) -> None:
    """Refuse two objects of which one has its centre in the other; edges may seem to overlap."""
    for inner, outer in ((one, other), (other, one)):
        away = np.subtract(inner.position[:2], outer.position[:2])
        if np.all(np.abs(away @ np.linalg.inv(_footprint(outer))) < 1):
            raise InvalidValue(
                f"{one.name} and {other.name} stand in one place: the centre of {inner.name} lies within "
                f"{outer.name}; put them side by side."
            )


def _footprint(item: SceneObject) -> Float[np.ndarray, "2 2"]:
    """Return half the edges of an object's footprint [m], a row each: those of its most level side."""
    turned = _rotation(item)
    level = np.delete(np.arange(3), np.argmax(np.abs(turned[2])))
    half = np.array(item.features[:3]) / 2
    return np.asarray((turned[:2, level] * half[level]).T)


def _rotation(item: SceneObject) -> Float[np.ndarray, "3 3"]:
    x, y, z, w = np.array(item.orientation) / math.hypot(*item.orientation)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
