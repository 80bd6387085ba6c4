"""Setting a scene: what a page changes of a problem, each change a function from one problem to the next.

And what can be: which goals by relation an object can have, where ghosts stand, and what is wrong where.
"""

from collections.abc import Collection, Mapping, Sequence
from itertools import count
from typing import Literal

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.operators import Categorise, Vector, vector
from neurosym.pair_operators import extent
from neurosym.problems import Problem, RelationGoal, SceneObject, goal_heights
from neurosym.tasks.options import Put
from neurosym.tasks.supports import Borne, carried_along, chain_below
from neurosym.tasks.task import Task, valid_relations, why_no_relation, why_too_many
from neurosym.world import Table


def table_height(problem: Problem, name: str) -> float:
    """Return the height of an object's centre where it stands on the table as it lies now [m]."""
    return float(extent(problem.scene(), problem.object_names.index(name))[2]) / 2


def moved(
    problem: Problem, name: str, x: float, y: float, z: float | None = None, along: Collection[str] = ()
) -> Problem:
    """Put the centre of an object elsewhere [m], at the same height unless one is given; others go along."""
    old = problem.object_named(name).position
    new = _at(x, y, old[2] if z is None else z)
    spots = {one: _at(*np.add(problem.object_named(one).position, np.subtract(new, old))) for one in along}
    spots[name] = new
    objects = (
        msgspec.structs.replace(one, position=spots.get(one.name, one.position)) for one in problem.objects
    )
    return _by_hand(problem, objects=tuple(objects), touching=None)


def with_goal(problem: Problem, name: str, x: float, y: float, z: float | None = None) -> Problem:
    """Give an object a goal for its centre instead [m], as high as the one it has, or else on the table."""
    problem.object_named(name)
    known = problem.goals.get(name)
    height = known[2] if known else table_height(problem, name)
    return _with_goal(problem, name, spot=_at(x, y, height if z is None else z))


def with_relation(problem: Problem, goal: RelationGoal) -> Problem:
    """Give an object a goal by relation instead; `InvalidValue` if others forbid it by their names."""
    return _with_goal(problem, goal[0], relation=goal)


def without_goal(problem: Problem, name: str) -> Problem:
    """Take the goal of an object away, on the table or by relation."""
    return _with_goal(problem, problem.object_named(name).name)


def resized(
    problem: Problem, name: str, features: Sequence[float], categorise: Categorise, under: float = 0.0
) -> Problem:
    """Make an object another one, which rests where the first one does, so high `under` it [m]."""
    x, y, z = problem.object_named(name).position
    changed = _resting(name, features, x, y, categorise, under)
    if (goal := problem.goals.get(name)) is not None:
        problem = with_goal(problem, name, goal[0], goal[1], goal[2] - z + changed.position[2])
    objects = tuple(changed if one.name == name else one for one in problem.objects)
    return _by_hand(problem, objects=objects, touching=None, pairs={}, foreseen={})


def with_object(
    problem: Problem | None, features: Sequence[float], x: float, y: float, categorise: Categorise
) -> Problem:
    """Add an object at rest on the table [m]; it is called `item-01` or the first such name that is free."""
    taken = problem.object_names if problem else ()
    name = next(one for number in count(1) if (one := f"item-{number:02d}") not in taken)
    item = _resting(name, features, x, y, categorise)
    if problem is None:
        return Problem("scene", (item,), {})
    return _by_hand(problem, objects=(*problem.objects, item), pairs={}, foreseen={})


def without_object(problem: Problem, name: str) -> Problem:
    """Take an object away and all goals that are about it; `InvalidValue` if it is the last object."""
    gone = problem.object_named(name)
    if len(problem.objects) == 1:
        raise InvalidValue(f"{name} is the only object; add another one before it is taken away.")
    seen = problem.touching
    return _by_hand(
        problem,
        objects=tuple(item for item in problem.objects if item is not gone),
        goals={one: goal for one, goal in problem.goals.items() if one != name},
        relations=tuple(goal for goal in problem.relations if name not in goal[:2]),
        touching=None if seen is None else tuple(pair for pair in seen if name not in pair),
        pairs={},
        foreseen={},
    )


def _resting(
    name: str, features: Sequence[float], x: float, y: float, categorise: Categorise, under: float = 0.0
) -> SceneObject:
    category = categorise(np.array([features], dtype=float))[0]
    return SceneObject(name, category, tuple(map(float, features)), _at(x, y, features[2] / 2 + under))


def _at(x: float, y: float, z: float) -> Vector:
    """Return a point in tenths of a millimetre, so that what is written and sent is short [m]."""
    return round(float(x), 4), round(float(y), 4), round(float(z), 6)


def _with_goal(
    problem: Problem, name: str, spot: Vector | None = None, relation: RelationGoal | None = None
) -> Problem:
    """Exchange the goal of one object; all stay in the order of the objects."""
    spots = {**problem.goals, name: spot}
    goals = {one: at for one in problem.object_names if (at := spots.get(one))}
    related = [one for one in problem.relations if one[0] != name] + ([relation] if relation else [])
    related.sort(key=lambda one: problem.object_names.index(one[0]))
    return _by_hand(problem, goals=goals, relations=tuple(related))


def _by_hand(problem: Problem, **changes: object) -> Problem:
    """Return a changed problem; its places were drawn for how it was."""
    return msgspec.structs.replace(problem, provenance="by hand", places={}, **changes)


# Of goals by relation: all tasks here are as they are understood, and know the kinds of their pairs.

_OFF_TABLE = 0.005
"""What is borne stands so far above the table at least, unless somebody saw what it touches [m]."""


def stacks_of(task: Task) -> dict[str, Borne]:
    """Return what bears each object; what was dragged into another one stands on the table still."""
    problem, is_seen = task.problem, task.problem.touching is not None
    return {
        name: borne
        for name, borne in task.supports.items()
        if is_seen or problem.object_named(name).position[2] - table_height(problem, name) > _OFF_TABLE
    }


def _supports_of(task: Task, stacks: Mapping[str, Borne]) -> dict[str, Borne]:
    """Return what bears each object in the end: as is asked, or else as it is now, in `stacks`."""
    related = task.problem.relations
    found = {target: Borne(reference, task.state_named(state)) for target, reference, state in related}
    for name, borne in stacks.items():
        if name not in (*found, *task.problem.goals) and name not in chain_below(borne.by, found):
            found[name] = borne
    return found


def ghost_spots(task: Task) -> dict[str, Vector]:
    """Return where ghosts of objects with goals stand [m], by relation as the surest operators promise."""
    problem, scene, names = task.problem, task.problem.scene(), task.problem.object_names
    spots, asked = dict(problem.goals), {goal[0]: goal for goal in problem.relations}

    def spot_of(name: str) -> Vector:
        if name not in spots and name in asked:
            _, reference, state_name = asked[name]
            state = task.state_named(state_name)
            puts = (put for put in _surest_first(task, name, reference) if put.state == state)
            offset = next((put.end.effect for put in puts), (0.0, 0.0, state.centre[1]))
            # promised in sums of the half sizes of both
            halves = (extent(scene, names.index(name)) + extent(scene, names.index(reference))) / 2
            spots[name] = vector(np.add(spot_of(reference), np.multiply(offset, halves)))
        return spots.get(name, problem.object_named(name).position)

    return {name: spot_of(name) for name in names if name in problem.goals or name in asked}


def _surest_first(task: Task, target: str, reference: str) -> list[Put]:
    return sorted(task.puts.get((target, reference), ()), key=lambda put: (-put.share, put.name))


def goals_for(task: Task, name: str, others: Sequence[str] | None = None) -> tuple[RelationGoal, ...]:
    """List the goals by relation that an object can have, about all `others` in turn, the surest first."""
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
    alone = msgspec.structs.replace(with_relation(task.problem, goal), relations=(goal,))
    return why_no_relation(alone, task.grounding)


def _why_not_besides(task: Task, goal: RelationGoal) -> str:
    """Say why the other goals forbid one, or nothing."""
    try:
        asked = with_relation(task.problem, goal)
    except InvalidValue as error:
        return str(error).rstrip(".")
    shared = tuple(one for one in asked.relations if one[1] == goal[1])
    return why_too_many(msgspec.structs.replace(asked, relations=shared), task.grounding)


def under(task: Task, name: str, spots: Mapping[str, Vector]) -> tuple[str, ...]:
    """Name the objects, or ghosts in `spots` [m], that a goal on the table lies over, the highest first."""
    if name not in task.problem.goals:
        return ()
    at, found = np.array(task.problem.goals[name][:2]), []
    upon = (name, *carried_along(name, _supports_of(task, {})))
    for other in task.problem.objects:
        x, y, z = spots.get(other.name, other.position)
        if other.name not in upon and np.all(np.abs(at - (x, y)) < np.array(other.features[:2]) / 2):
            found.append((-z, other.name))
    return tuple(other for _, other in sorted(found))


def relation_of_drop(task: Task, name: str) -> RelationGoal | None:
    """Return the goal that is meant where a ghost was dropped: the surest on the highest object under it."""
    return next(iter(goals_for(task, name, under(task, name, ghost_spots(task)))), None)


def why_no_drop(task: Task, name: str, other: str) -> str:
    """Say why the ghost of an object cannot be dropped on another one, and where it could."""
    goals = ((name, other, put.state.name) for put in _surest_first(task, name, other))
    said = f"nothing puts {name} on or into {other}; {valid_relations(task.problem, task.grounding, name)}"
    return next(filter(None, (_why_not_besides(task, goal) for goal in goals)), said)


_SPOTS = 0.02  # how far apart the places are where an object is tried to be added [m]


def why_not_there(
    problem: Problem,
    name: str,
    kind: Literal["object", "goal"],
    table: Table,
    *,
    ghosts: Mapping[str, Vector] | None = None,
    may_be_in: Collection[str] = (),
) -> str:
    """Say why an object or its goal cannot be where it is, among objects or `ghosts` [m], or nothing."""
    ghosts = {} if kind == "object" else problem.goals if ghosts is None else ghosts
    item = problem.object_named(name)
    at = np.array(item.position if kind == "object" else problem.goals[name])
    called = name if kind == "object" else f"the goal of {name}"
    if not table.contains(at):
        return f"{called} is off the table"
    for other in problem.objects:
        room = (np.array(item.features[:3]) + other.features[:3]) / 2 - (0.0, 0.0, 1e-6)
        is_in = np.all(np.abs(at - ghosts.get(other.name, other.position)) < room)
        if is_in and other.name not in (name, *may_be_in):
            return f"{called} is in {f'the goal of {other.name}' if other.name in ghosts else other.name}"
    return ""


def complaints_about(task: Task) -> dict[str, str]:
    """Say of each object or goal that cannot be where it is why not, by `object NAME` and `goal NAME`."""
    problem, table, ghosts, found = task.problem, task.grounding.table, ghost_spots(task), dict[str, str]()
    stacks = stacks_of(task)
    supports = _supports_of(task, stacks)
    for name in problem.object_names:
        lowest = chain_below(name, stacks)[-1]
        pile = (lowest, *carried_along(lowest, stacks))
        if why := why_not_there(problem, name, "object", table, may_be_in=pile):
            found[f"object {name}"] = why
        if name in problem.goals:
            upon = carried_along(name, supports)
            why = why_not_there(problem, name, "goal", table, ghosts=ghosts, may_be_in=upon)
            if why := _unless_dropped(why, task, name) or _too_high(task, name):
                found[f"goal {name}"] = why
    if problem.relations and why_no_relation(problem, task.grounding):
        found |= {f"goal {goal[0]}": why for goal in problem.relations if (why := why_no_goal(task, goal))}
    return found


def _too_high(task: Task, name: str) -> str:
    """Say that a goal is higher than anything is lifted, or nothing."""
    height, (_, highest) = task.problem.goals[name][2], goal_heights(task.problem, task.grounding.lift_height)
    return f"the goal of {name} is {height:g} m high; at most {highest:.3f} m" if height > highest else ""


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
    """Find room for an object, nearest to the middle of the table [m]; `InvalidValue` if there is none."""
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
