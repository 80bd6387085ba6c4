"""Setting a scene: what a page changes of a problem, each change a function from one problem to the next."""

from collections.abc import Collection, Sequence
from itertools import count

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.operators import Vector
from neurosym.pair_states import extent
from neurosym.problems import Problem, SceneObject
from neurosym.relation_goals import RelationGoal
from neurosym.symbols import Categorise

UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def table_height(problem: Problem, name: str) -> float:
    """Return the height of an object's centre where it stands on the table as it lies now [m]."""
    return float(extent(problem.scene(), problem.object_names.index(name))[2]) / 2


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
    return _replaced(problem, objects=objects, touching=None)


def with_goal(problem: Problem, name: str, x: float, y: float, z: float | None = None) -> Problem:
    """Give an object a goal on the table or above it, in the place of any other goal of it.

    Args:
        problem: The problem.
        name: Name of the object.
        x: Where its centre shall come to be [m].
        y: The same for the other axis [m].
        z: Its height [m]; that of the goal it has, or else the height that it lies at, if not given.
    """
    known = problem.goals.get(name)
    height = known[2] if known else table_height(problem, problem.object_named(name).name)
    return _with_goal(problem, name, spot=_at(x, y, height if z is None else z))


def with_relation(problem: Problem, *goal: str) -> Problem:
    """Give an object a goal by relation, in the place of any other goal of it.

    Args:
        problem: The problem.
        goal: Name of the object, of the other one, and of the state that the two shall come to.

    Raises:
        InvalidValue: If the goals by relation could not all be met, as far as names tell.
    """
    name, reference, state = goal
    return _with_goal(problem, name, relation=(name, reference, state))


def without_goal(problem: Problem, name: str) -> Problem:
    """Take the goal of an object away, on the table or by relation."""
    return _with_goal(problem, problem.object_named(name).name)


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
    x, y, z = problem.object_named(name).position
    changed = _resting(name, features, x, y, categorise, under)
    if (goal := problem.goals.get(name)) is not None:
        problem = with_goal(problem, name, goal[0], goal[1], goal[2] - z + changed.position[2])
    objects = tuple(changed if one.name == name else one for one in problem.objects)
    return _with_objects(problem, objects, touching=None)


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
    item = _resting(name, features, x, y, categorise)
    return _with_objects(problem, (*problem.objects, item)) if problem else Problem("scene", (item,), {})


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
    related = tuple(goal for goal in problem.related if name not in goal[:2])
    seen = problem.touching
    touching = None if seen is None else tuple(pair for pair in seen if name not in pair)
    return _with_objects(problem, left, goals=goals, relations=related, touching=touching)


def _resting(
    name: str, features: Sequence[float], x: float, y: float, categorise: Categorise, under: float = 0.0
) -> SceneObject:
    category = categorise(np.array([features], dtype=float))[0]
    position = _at(x, y, float(features[2]) / 2 + under)
    return SceneObject(name, category, tuple(map(float, features)), position, UPRIGHT)


def _at(x: float, y: float, z: float) -> Vector:
    """Return a point in tenths of a millimetre, so that what is written and sent is short [m]."""
    return round(float(x), 4), round(float(y), 4), round(float(z), 6)


def _with_goal(
    problem: Problem, name: str, spot: Vector | None = None, relation: RelationGoal | None = None
) -> Problem:
    """Exchange the goal of one object; all stay in the order of the objects."""
    spots = problem.goals | ({name: spot} if spot else {})
    goals = {one: spots[one] for one in problem.object_names if one in spots and (one != name or spot)}
    related = [one for one in problem.related if one[0] != name] + ([relation] if relation else [])
    related.sort(key=lambda one: problem.object_names.index(one[0]))
    return _replaced(problem, goals=goals, relations=tuple(related))


def _with_objects(problem: Problem, objects: tuple[SceneObject, ...], **changes: object) -> Problem:
    """Return a problem of other objects, of whose pairs nothing is known yet."""
    return _replaced(problem, objects=objects, pairs={}, foreseen={}, **changes)


def _replaced(problem: Problem, **changes: object) -> Problem:
    """Return a changed problem; its places were drawn for how it was, and it is by hand now."""
    return msgspec.structs.replace(problem, provenance="by hand", places={}, **changes)
