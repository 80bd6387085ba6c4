"""Whether a problem that somebody wrote can be: its goals, its places, and its scene as the world tells."""

import math
import re
from itertools import combinations

import numpy as np

from neurosym.checks import Float
from neurosym.contract import ObjectLimits
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pair_operators import rotation
from neurosym.pddl.compiler import is_taken
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.strips import NOWHERE
from neurosym.problems import NEAR_TABLE, SPOT, Problem, SceneObject, check_goals, check_names, goal_heights
from neurosym.tasks.pair_goals import check_relations
from neurosym.tasks.supports import chain_below, known_bearers
from neurosym.tasks.task import GOAL, PARK, START, footprints_apart, is_at

OFF_REST = 0.005
"""How far from the height it rests at an object's centre may be [m]; physics settles it within 0.1 mm."""
OFF_UNIT = 0.01
"""How far from 1 the length of a quaternion may be."""
_UPRIGHT = 0.999
_TAKEN = rf"{NOWHERE}|{START}.*|{SPOT.pattern}"


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
    upwards = np.abs(rotation(np.array(item.orientation))[2])
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
    turned = rotation(np.array(item.orientation))
    level = np.delete(np.arange(3), np.argmax(np.abs(turned[2])))
    half = np.array(item.features[:3]) / 2
    return np.asarray((turned[:2, level] * half[level]).T)


def check_places(problem: Problem, grounding: Grounding) -> None:
    """Raise `InvalidValue` unless objects can be carried to each place of a problem.

    Args:
        problem: The problem; if it names no places, they are drawn, and nothing is wrong.
        grounding: The learned domain.
    """
    if not problem.places:
        return
    if not grounding.carriers:
        raise InvalidValue(
            f"The problem {problem.name} has places, and nothing in this domain carries objects to places; "
            "leave out `places`, or learn to with `neurosym run DIR --places N`."
        )
    names = tuple(problem.places)
    check_names(names)
    table = grounding.table
    for name, (x, y) in problem.places.items():
        if name in problem.object_names or is_taken(name, grounding) or re.fullmatch(_TAKEN, name):
            raise InvalidValue(f"No place can be called {name}, the problem uses that; try shelf-01.")
        table.check(name, x, y)
        _check_goal_place(name, problem)
    for one, other in combinations(names, 2):
        _check_places_apart(one, other, problem)


def _check_goal_place(place: str, problem: Problem) -> None:
    """Refuse a place that is called after the goal of an object and lies elsewhere."""
    thing = place.removeprefix(GOAL)
    if not place.startswith(GOAL) or thing not in problem.goals:
        return
    if not is_at(thing, problem.place_named(place), problem):
        (x, y), (goal_x, goal_y, _) = problem.place_named(place), problem.goals[thing]
        raise InvalidValue(
            f"The place {place} lies at ({x:g}, {y:g}) m, and the goal of {thing} at "
            f"({goal_x:g}, {goal_y:g}) m; give it another name, or the place of the goal."
        )


def _check_places_apart(one: str, other: str, problem: Problem) -> None:
    """Refuse two places if two objects that may be carried there would stand in each other."""
    away = np.abs(np.subtract(problem.place_named(one), problem.place_named(other)))
    apart = footprints_apart(problem)
    for row, mine in enumerate(problem.object_names):
        for column, its in enumerate(problem.object_names):
            if row == column or not (_is_meant(mine, one, problem) and _is_meant(its, other, problem)):
                continue
            if np.all(away < apart[row, column]):
                x, y = apart[row, column]
                raise InvalidValue(
                    f"The places {one} and {other} are too near for {mine} and {its}; valid: at least "
                    f"{x:.3f} m apart in x, or {y:.3f} m in y."
                )


def _is_meant(thing: str, place: str, problem: Problem) -> bool:
    """Say whether an object is to be carried to a place: one to park on, or one at its goal."""
    if place.startswith(PARK):
        return True
    return thing in problem.goals and is_at(thing, problem.place_named(place), problem)
