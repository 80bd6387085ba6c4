"""Whether the places that somebody wrote into a problem can be."""

import re
from itertools import combinations

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.problem import is_taken
from neurosym.pddl.strips import NOWHERE
from neurosym.problems import Problem, check_names
from neurosym.spots import SPOT
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.footprints import footprints_apart
from neurosym.tasks.places import GOAL, PARK, START, is_at

_TAKEN = rf"{NOWHERE}|{START}.*|{SPOT.pattern}"


def check_places(problem: Problem, grounding: Grounding) -> None:
    """Raise `InvalidValue` unless objects can be carried to each place of a problem.

    Args:
        problem: The problem; if it names no places, they are drawn, and nothing is wrong.
        grounding: The learned domain.
    """
    if problem.places is msgspec.UNSET:
        return
    if not carriers_of(grounding):
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
        _check_apart(one, other, problem)


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


def _check_apart(one: str, other: str, problem: Problem) -> None:
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
