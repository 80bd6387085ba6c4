"""Setting a scene: what a page changes of a problem, each change a function from one problem to the next."""

import math
from collections.abc import Collection, Sequence
from itertools import count

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.operators import Vector
from neurosym.problems import Problem, SceneObject
from neurosym.relation_goals import RelationGoal
from neurosym.symbols import Categorise, symbols_of

GOAL_DISTANCE = 0.12
"""How far from its object a new goal is put, so that the two do not cover each other [m]."""
UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def has_goals(problem: Problem) -> bool:
    """Say whether any object has a goal, on the table or by relation."""
    return bool(problem.goals or problem.related)


def moved(
    problem: Problem, name: str, x: float, y: float, z: float | None = None, along: Collection[str] = ()
) -> Problem:
    """Put an object elsewhere on the table; it keeps its height unless one is given, and its goal.

    Args:
        problem: The problem.
        name: Name of the object.
        x: Where its centre shall be [m].
        y: The same for the other axis [m].
        z: Its height [m], if another one.
        along: Names of the objects that go along, as what it bears.
    """
    old = problem.object_named(name).position
    new = _at(x, y, old[2] if z is None else z)
    spots = {one: _at(*np.add(problem.object_named(one).position, np.subtract(new, old))) for one in along}
    spots[name] = new
    objects = tuple(
        msgspec.structs.replace(one, position=spots.get(one.name, one.position)) for one in problem.objects
    )
    return _replaced(problem, objects=objects, touching=msgspec.UNSET)


def with_goal(problem: Problem, name: str, x: float, y: float, z: float | None = None) -> Problem:
    """Give an object a goal on the table or above it, in the place of any other goal of it.

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
    placed = {one: spot for one, spot in goals.items() if spot is not None}
    return _replaced(problem, goals=placed, relations=_related(problem, name))


def with_relation(problem: Problem, name: str, reference: str, state: str) -> Problem:
    """Give an object the goal to stand to another one in a state, in the place of any other goal of it.

    Args:
        problem: The problem.
        name: Name of the object.
        reference: Name of the other object.
        state: Name of the state of the two.

    Raises:
        InvalidValue: If the goals by relation could not all be met, as far as names tell.
    """
    goals = {one: goal for one, goal in problem.goals.items() if one != name}
    return _replaced(problem, goals=goals, relations=_related(problem, name, (name, reference, state)))


def with_goal_of(problem: Problem, name: str, other: Problem) -> Problem:
    """Give an object the goal that it has in another problem, or none if it has none there.

    Args:
        problem: The problem.
        name: Name of the object.
        other: The other problem.
    """
    for goal in other.related:
        if goal[0] == name:
            return with_relation(problem, *goal)
    goal_there = other.goals.get(name)
    return without_goal(problem, name) if goal_there is None else with_goal(problem, name, *goal_there)


def with_goal_beside(
    problem: Problem, name: str, middle: tuple[float, float], z: float | None = None
) -> Problem:
    """Give an object a goal a little nearer to the middle of the table, to be dragged from there.

    Args:
        problem: The problem.
        name: Name of the object.
        middle: The middle of the table [m].
        z: Height of the goal [m]; that of the object, if not given.
    """
    x, y, height = problem.object_named(name).position
    away = math.dist((x, y), middle)
    step = (1.0, 0.0) if away < GOAL_DISTANCE else ((middle[0] - x) / away, (middle[1] - y) / away)
    return with_goal(
        problem, name, x + GOAL_DISTANCE * step[0], y + GOAL_DISTANCE * step[1], height if z is None else z
    )


def without_goal(problem: Problem, name: str) -> Problem:
    """Take the goal of an object away, on the table or by relation.

    Args:
        problem: The problem.
        name: Name of the object.
    """
    problem.object_named(name)
    goals = {one: goal for one, goal in problem.goals.items() if one != name}
    return _replaced(problem, goals=goals, relations=_related(problem, name))


def resized(
    problem: Problem, name: str, features: Sequence[float], categorise: Categorise, under: float = 0.0
) -> Problem:
    """Make an object another one, which rests where the first one does, and is of the category that it shows.

    Args:
        problem: The problem.
        name: Name of the object.
        features: What it shall be: sizes along x, y and z first [m].
        categorise: Gives objects their symbols.
        under: How high it stands above the table [m].
    """
    item = problem.object_named(name)
    x, y, z = item.position
    height = float(features[2]) / 2 + under
    changed = msgspec.structs.replace(
        item,
        category=_category(features, categorise),
        features=tuple(map(float, features)),
        position=_at(x, y, height),
        orientation=UPRIGHT,
    )
    if (goal := problem.goals.get(name)) is not None:
        problem = with_goal(problem, name, goal[0], goal[1], goal[2] - z + height)
    objects = tuple(changed if one.name == name else one for one in problem.objects)
    return _replaced(
        problem, objects=objects, pairs=msgspec.UNSET, foreseen=msgspec.UNSET, touching=msgspec.UNSET
    )


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
    return _replaced(problem, objects=(*problem.objects, item), pairs=msgspec.UNSET, foreseen=msgspec.UNSET)


def without_object(problem: Problem, name: str) -> Problem:
    """Take an object away, its goal, and the goals of others that are about it.

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
    related = tuple(goal for goal in problem.related if name not in goal[:2]) or msgspec.UNSET
    seen = problem.touching
    touching = tuple(pair for pair in seen if name not in pair) if isinstance(seen, tuple) else seen
    return _replaced(
        problem,
        objects=left,
        goals=goals,
        relations=related,
        touching=touching,
        pairs=msgspec.UNSET,
        foreseen=msgspec.UNSET,
    )


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


def _related(
    problem: Problem, name: str, goal: RelationGoal | None = None
) -> tuple[RelationGoal, ...] | msgspec.UnsetType:
    """Return the goals by relation with that of one object exchanged, in the order of the objects."""
    asked = [one for one in problem.related if one[0] != name] + ([goal] if goal else [])
    return tuple(sorted(asked, key=lambda one: problem.object_names.index(one[0]))) or msgspec.UNSET


def _replaced(problem: Problem, **changes: object) -> Problem:
    """Return a changed problem; its places were drawn for how it was, and it is by hand now."""
    return msgspec.structs.replace(problem, provenance="by hand", places=msgspec.UNSET, **changes)
