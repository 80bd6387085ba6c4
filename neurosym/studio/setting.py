"""Setting a scene: what a page changes of a problem, each change a function from one problem to the next."""

import math
from collections.abc import Sequence
from itertools import count

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.operators import Vector
from neurosym.problems import Problem, SceneObject
from neurosym.symbols import Categorise, symbols_of

GOAL_DISTANCE = 0.12
"""How far from its object a new goal is put, so that the two do not cover each other [m]."""
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def moved(problem: Problem, name: str, x: float, y: float) -> Problem:
    """Put an object elsewhere on the table; it keeps its height, and its goal.

    Args:
        problem: The problem.
        name: Name of the object.
        x: Where its centre shall be [m].
        y: The same for the other axis [m].
    """
    item = problem.object_named(name)
    return _with_item(problem, msgspec.structs.replace(item, position=_at(x, y, item.position[2])))


def with_goal(problem: Problem, name: str, x: float, y: float, z: float | None = None) -> Problem:
    """Give an object a goal.

    Args:
        problem: The problem.
        name: Name of the object.
        x: Where its centre shall come to be [m].
        y: The same for the other axis [m].
        z: Its height [m]; that of the goal it has, or else the height that it rests at, if not given.
    """
    known = problem.goals.get(name, problem.object_named(name).position)
    goal = _at(x, y, known[2] if z is None else z)
    goals = {one: goal if one == name else problem.goals.get(one) for one in problem.object_names}
    return _replaced(problem, goals={one: spot for one, spot in goals.items() if spot is not None})


def with_goal_beside(problem: Problem, name: str, middle: tuple[float, float]) -> Problem:
    """Give an object a goal a little nearer to the middle of the table, to be dragged from there.

    Args:
        problem: The problem.
        name: Name of the object.
        middle: The middle of the table [m].
    """
    x, y, z = problem.object_named(name).position
    away = math.dist((x, y), middle)
    step = (1.0, 0.0) if away < GOAL_DISTANCE else ((middle[0] - x) / away, (middle[1] - y) / away)
    return with_goal(problem, name, x + GOAL_DISTANCE * step[0], y + GOAL_DISTANCE * step[1], z)


def without_goal(problem: Problem, name: str) -> Problem:
    """Take the goal of an object away.

    Args:
        problem: The problem.
        name: Name of the object.
    """
    problem.object_named(name)
    return _replaced(problem, goals={one: goal for one, goal in problem.goals.items() if one != name})


def resized(problem: Problem, name: str, features: Sequence[float], categorise: Categorise) -> Problem:
    """Make an object another one, which rests where the first one does, and is of the category that it shows.

    Args:
        problem: The problem.
        name: Name of the object.
        features: What it shall be: sizes along x, y and z first [m].
        categorise: Gives objects their symbols.
    """
    item = problem.object_named(name)
    x, y, z = item.position
    height = float(features[2]) / 2
    changed = msgspec.structs.replace(
        item,
        category=_category(features, categorise),
        features=tuple(map(float, features)),
        position=_at(x, y, height),
        orientation=UPRIGHT,
    )
    if (goal := problem.goals.get(name)) is not None:
        problem = with_goal(problem, name, goal[0], goal[1], goal[2] - z + height)
    return _with_item(problem, changed)


def with_object(
    problem: Problem | None, features: Sequence[float], x: float, y: float, categorise: Categorise
) -> Problem:
    """Add an object at rest; it is called `item-01` or the first such name that is free.

    Args:
        problem: The problem; None for the first object of all.
        features: What it is: sizes along x, y and z first [m].
        x: Where its centre is [m].
        y: The same for the other axis [m].
        categorise: Gives objects their symbols.
    """
    taken = problem.object_names if problem else ()
    name = next(one for number in count(1) if (one := f"item-{number:02d}") not in taken)
    position = _at(x, y, float(features[2]) / 2)
    item = SceneObject(name, _category(features, categorise), tuple(map(float, features)), position)
    if problem is None:
        return Problem("scene", (item,), {})
    return _replaced(problem, objects=(*problem.objects, item))


def without_object(problem: Problem, name: str) -> Problem:
    """Take an object away, and its goal.

    Args:
        problem: The problem.
        name: Name of the object.

    Raises:
        InvalidValue: If it is the last one.
    """
    left = tuple(item for item in problem.objects if item.name != problem.object_named(name).name)
    if not left:
        raise InvalidValue(f"{name} is the only object; add another one before it is taken away.")
    goals = {one: goal for one, goal in problem.goals.items() if one != name}
    return _replaced(problem, objects=left, goals=goals)


def renamed(problem: Problem, name: str) -> Problem:
    """Call a problem otherwise.

    Args:
        problem: The problem.
        name: A legal PDDL name.

    Raises:
        InvalidValue: If it is none.
    """
    return msgspec.structs.replace(problem, name=name)


def _category(features: Sequence[float], categorise: Categorise) -> str:
    return symbols_of(categorise, np.array([features], dtype=float))[0]


def _at(x: float, y: float, z: float) -> Vector:
    """Return a point in tenths of a millimetre, so that what is written and sent is short [m]."""
    return round(float(x), 4), round(float(y), 4), round(float(z), 6)


def _with_item(problem: Problem, item: SceneObject) -> Problem:
    objects = tuple(item if one.name == item.name else one for one in problem.objects)
    return _replaced(problem, objects=objects)


def _replaced(problem: Problem, **changes: object) -> Problem:
    """Return a changed problem; its places were drawn for how it was, and it is by hand now."""
    return msgspec.structs.replace(problem, provenance="by hand", places=msgspec.UNSET, **changes)
