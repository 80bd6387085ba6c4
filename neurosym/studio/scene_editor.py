"""Setting a scene: what a page changes of a problem, each change a function from one problem to the next."""

from collections.abc import Collection, Mapping, Sequence
from itertools import count
from typing import Literal

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.operators import Categorise, Vector, vector
from neurosym.pair_operators import extent
from neurosym.problems import Problem, RelationGoal, SceneObject
from neurosym.tasks.options import Put
from neurosym.tasks.pair_goals import valid_relations, why_no_relation, why_too_many
from neurosym.tasks.supports import Borne, carried_along, chain_below
from neurosym.tasks.task import Task
from neurosym.world import Table

_UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def table_height(problem: Problem, name: str) -> float:
    """Return the height of an object's centre where it stands on the table as it lies now [m]."""
    return float(extent(problem.scene(), problem.object_names.index(name))[2]) / 2


def moved(
    problem: Problem, name: str, x: float, y: float, z: float | None = None, along: Collection[str] = ()
) -> Problem:
    """Put an object elsewhere on the table; it keeps its height unless one is given, and its goal.

    x, y and z are of its centre [m]; what it bears goes `along`.
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

    x, y and z are of its centre [m]. Without z it is as high as the goal it has, or else as the object lies.
    """
    known = problem.goals.get(name)
    height = known[2] if known else table_height(problem, problem.object_named(name).name)
    return _with_goal(problem, name, spot=_at(x, y, height if z is None else z))


def with_relation(problem: Problem, *goal: str) -> Problem:
    """Give an object a goal by relation, in the place of any other goal of it.

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

    Sizes along x, y and z come first in its features [m]; `under` is how high it stands above the table [m].
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

    Sizes along x, y and z come first in its features; x and y are of its centre [m].
    """
    taken = problem.object_names if problem else ()
    name = next(one for number in count(1) if (one := f"item-{number:02d}") not in taken)
    item = _resting(name, features, x, y, categorise)
    return _with_objects(problem, (*problem.objects, item)) if problem else Problem("scene", (item,), {})


def without_object(problem: Problem, name: str) -> Problem:
    """Take an object away, its goal, and the goals of others that are about it.

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
    return SceneObject(name, category, tuple(map(float, features)), position, _UPRIGHT)


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


# Of goals by relation: all tasks here are as they are understood, and know the kinds of their pairs.

_OFF_TABLE = 0.005
"""What is borne stands so far above the table at least, unless somebody saw what it touches [m]."""


def stacks_of(task: Task) -> dict[str, Borne]:
    """Return what bears each object that another one bears; nothing where the domain knows no relations.

    An object that was dragged into another one stands on the table still, and is borne by nothing.
    """
    is_seen = task.problem.touching is not None
    return {
        name: borne
        for name, borne in task.supports.items()
        if is_seen
        or task.problem.object_named(name).position[2] - table_height(task.problem, name) > _OFF_TABLE
    }


def _supports_of(task: Task, stacks: Mapping[str, Borne]) -> dict[str, Borne]:
    """Return what bears each object in the end: as is asked, or as it is now where nothing is asked of it.

    `stacks` is what bears each object now.
    """
    found = {
        target: Borne(reference, task.state_named(state)) for target, reference, state in task.problem.related
    }
    for name, borne in stacks.items():
        if name not in (*found, *task.problem.goals) and name not in chain_below(borne.by, found):
            found[name] = borne
    return found


def ghost_spots(task: Task) -> dict[str, Vector]:
    """Return where the ghost of each object with a goal stands [m].

    For a goal by relation that is where the surest operator promises to bring it.
    """
    problem = task.problem
    spots, asked = dict(problem.goals), {goal[0]: goal for goal in problem.related}
    scene, names = problem.scene(), problem.object_names

    def spot_of(name: str) -> Vector:
        if name not in spots and name in asked:
            _, reference, state = asked[name]
            halves = (extent(scene, names.index(name)) + extent(scene, names.index(reference))) / 2
            offset = np.array(_offset(task, name, reference, state)) * halves
            spots[name] = vector(np.add(spot_of(reference), offset))
        return spots.get(name, problem.object_named(name).position)

    return {name: spot_of(name) for name in names if name in problem.goals or name in asked}


def _offset(task: Task, target: str, reference: str, state: str) -> tuple[float, float, float]:
    """Return where a target is promised to be, from its reference, in sums of their half sizes."""
    asked = task.state_named(state)
    promised = (put.end.offset for put in _surest_first(task, target, reference) if put.state == asked)
    return next(promised, (0.0, 0.0, asked.centre[1]))


def _surest_first(task: Task, target: str, reference: str) -> tuple[Put, ...]:
    puts = task.puts.get((target, reference), ())
    return tuple(sorted(puts, key=lambda put: (-put.share, put.name)))


def goals_for(task: Task, name: str, others: Sequence[str] | None = None) -> tuple[RelationGoal, ...]:
    """List the goals by relation that an object can have besides what is asked already, the surest first.

    They are about the `others` alone, in that order, if these are given.
    """
    found, borne = list[RelationGoal](), stacks_of(task).get(name)
    for other in task.names if others is None else others:
        if other != name:
            found += [(name, other, put.state.name) for put in _surest_first(task, name, other)]
        if borne and borne.by == other:
            found.append((name, other, borne.state.name))
    return tuple(goal for goal in dict.fromkeys(found) if not _why_not_besides(task, goal))


def why_no_goal(task: Task, goal: RelationGoal) -> str:
    """Say why an object cannot have a goal by relation besides what is asked already, or nothing."""
    if why := _why_not_besides(task, goal):
        return why
    alone = with_relation(task.problem, *goal)
    return why_no_relation(msgspec.structs.replace(alone, relations=(goal,)), task.grounding)


def _why_not_besides(task: Task, goal: RelationGoal) -> str:
    """Say why the other goals forbid one, or nothing."""
    try:
        asked = with_relation(task.problem, *goal)
    except InvalidValue as error:
        return str(error).rstrip(".")
    shared = tuple(one for one in asked.related if one[1] == goal[1])
    return why_too_many(msgspec.structs.replace(asked, relations=shared), task.grounding)


def under(task: Task, name: str, spots: Mapping[str, Vector]) -> tuple[str, ...]:
    """Name the objects that a goal on the table lies over, the highest first.

    `spots` is where ghosts stand [m]; of other objects it is asked where they stand themselves.
    """
    problem, upon = task.problem, carried_along(name, _supports_of(task, {}))
    if name not in problem.goals:
        return ()
    at, found = np.array(problem.goals[name][:2]), []
    for other in problem.objects:
        x, y, z = spots.get(other.name, other.position)
        is_over = np.all(np.abs(at - (x, y)) < np.array(other.features[:2]) / 2)
        if other.name not in (name, *upon) and is_over:
            found.append((-z, other.name))
    return tuple(other for _, other in sorted(found))


def relation_of_drop(task: Task, name: str) -> RelationGoal | None:
    """Return the goal by relation that is meant where a ghost was dropped; None if there is none.

    It is about the highest object under the ghost that something puts it on or into, and the state that the
    two are brought to most surely.
    """
    return next(iter(goals_for(task, name, under(task, name, ghost_spots(task)))), None)


def why_no_drop(task: Task, name: str, other: str) -> str:
    """Say why the ghost of an object cannot be dropped on another one, and where it could."""
    goals = ((name, other, put.state.name) for put in _surest_first(task, name, other))
    said = f"nothing puts {name} on or into {other}; {valid_relations(task.problem, task.grounding, name)}"
    return next(filter(None, (_why_not_besides(task, goal) for goal in goals)), said)


def why_not_related(task: Task) -> dict[str, str]:
    """Say of each object whose goal by relation cannot be why not."""
    if not task.problem.related or not why_no_relation(task.problem, task.grounding):
        return {}
    whys = {goal[0]: why_no_goal(task, goal) for goal in task.problem.related}
    return {name: why for name, why in whys.items() if why}


_SPOTS = 0.02  # how far apart the places are where an object is tried to be added [m]
Kind = Literal["object", "goal"]


def why_not_there(
    problem: Problem,
    name: str,
    kind: Kind,
    table: Table,
    *,
    ghosts: Mapping[str, Vector] | None = None,
    may_be_in: Collection[str] = (),
) -> str:
    """Say why an object or its goal cannot be where it is, or nothing.

    Two goals may not be in one place, nor a goal in an object that is to stay. A goal above the table is only
    asked to be over it.

    `ghosts` is where the ghosts of objects with goals stand [m], and `may_be_in` what it may touch.
    """
    ghosts = {} if kind == "object" else problem.goals if ghosts is None else ghosts
    item = problem.object_named(name)
    at = np.array(item.position if kind == "object" else problem.goals[name])
    called = name if kind == "object" else f"the goal of {name}"
    if not table.contains(at):
        return f"{called} is off the table"
    for other in problem.objects:
        if other.name == name or other.name in may_be_in:
            continue
        away = np.abs(at - ghosts.get(other.name, other.position))
        room = (np.array(item.features[:3]) + other.features[:3]) / 2 - (0.0, 0.0, 1e-6)
        if np.all(away < room):
            return f"{called} is in {f'the goal of {other.name}' if other.name in ghosts else other.name}"
    return ""


def complaints_about(task: Task) -> dict[str, str]:
    """Say of each object or goal that cannot be where it is why not, by `object NAME` and `goal NAME`."""
    problem, table, ghosts, found = task.problem, task.grounding.table, ghost_spots(task), dict[str, str]()
    stacks = stacks_of(task)
    supports = _supports_of(task, stacks)
    for name in problem.object_names:
        if why := why_not_there(problem, name, "object", table, may_be_in=_pile(name, stacks)):
            found[f"object {name}"] = why
        if name in problem.goals:
            upon = carried_along(name, supports)
            why = why_not_there(problem, name, "goal", table, ghosts=ghosts, may_be_in=upon)
            if why := _unless_dropped(why, task, name):
                found[f"goal {name}"] = why
    return found | {f"goal {name}": why for name, why in why_not_related(task).items()}


def _pile(name: str, stacks: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name all that stands in one pile with an object, itself included."""
    lowest = chain_below(name, stacks)[-1]
    return lowest, *carried_along(lowest, stacks)


def _unless_dropped(why: str, task: Task, name: str) -> str:
    """Return why a goal cannot be on the table there, or nothing if it may be dropped on what is there."""
    goals, grounding = task.problem.goals, task.grounding
    if not why or not grounding.table.contains(np.array(goals[name])):
        return why
    if grounding.relations is None:
        on = under(task, name, goals)
        return f"{why}; this domain knows no goals like {name} on {on[0]}" if on else why
    return "" if relation_of_drop(task, name) else why


def free_spot(
    problem: Problem | None, features: tuple[float, ...], table: Table, middle: tuple[float, float]
) -> tuple[float, float]:
    """Find room for an object on the table, nearest to its middle [m].

    Raises:
        InvalidValue: If there is none.
    """
    if problem is None:
        return middle
    axes = [np.arange(low + _SPOTS, high - _SPOTS / 2, _SPOTS) for low, high in (table.x, table.y)]
    spots = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 2)
    sizes = np.array([item.features[:2] for item in problem.objects]) + features[:2]
    away = np.abs(spots[:, None] - problem.scene().positions[:, :2])  # (spots, M, 2)
    free = spots[np.all(np.any(away >= sizes / 2, axis=2), axis=1)]
    if not len(free):
        raise InvalidValue("There is no room for another object; take one away, or make one smaller.")
    x, y = free[np.argmin(np.linalg.norm(free - middle, axis=1))].tolist()
    return x, y
