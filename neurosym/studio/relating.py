"""Goals by relation on a page: which there can be, where their ghosts stand, and what dropping a ghost means.

All that is given here is a task as it is understood: its problem knows the kinds of its pairs.
"""

from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.operators import Vector, vector
from neurosym.pair_states import extent
from neurosym.related import Borne, carried_along, chain_below
from neurosym.relation_goals import RelationGoal
from neurosym.studio import setting
from neurosym.tasks.pair_goals import valid_relations, why_no_relation, why_too_many
from neurosym.tasks.puts import Put, puts_for
from neurosym.tasks.task import Task

OFF_TABLE = 0.005
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
        or task.problem.object_named(name).position[2] - setting.table_height(task.problem, name) > OFF_TABLE
    }


def supports_of(task: Task, stacks: Mapping[str, Borne]) -> dict[str, Borne]:
    """Return what bears each object in the end: as is asked, or as it is now where nothing is asked of it.

    Args:
        task: The task.
        stacks: What bears each object now that another one bears.
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
    puts = puts_for(task.problem, task.grounding, target, reference)
    return tuple(sorted(puts, key=lambda put: (-put.share, put.name)))


def goals_for(task: Task, name: str, others: Sequence[str] | None = None) -> tuple[RelationGoal, ...]:
    """List the goals by relation that an object can have besides what is asked already, the surest first.

    Args:
        task: The task.
        name: Name of the object.
        others: Names of the objects that it may be about, in that order; all, if not given.
    """
    found, borne = list[RelationGoal](), stacks_of(task).get(name)
    for other in task.names if others is None else others:
        if other != name:
            found += [(name, other, put.state.name) for put in _surest_first(task, name, other)]
        if borne and borne.by == other:
            found.append((name, other, borne.state.name))
    return tuple(goal for goal in dict.fromkeys(found) if not _why_not_besides(task, goal))


def why_no_goal(task: Task, goal: RelationGoal) -> str:
    """Say why an object cannot have a goal by relation besides what is asked already, or nothing.

    Args:
        task: The task.
        goal: The goal.
    """
    if why := _why_not_besides(task, goal):
        return why
    alone = setting.with_relation(task.problem, *goal)
    return why_no_relation(msgspec.structs.replace(alone, relations=(goal,)), task.grounding)


def _why_not_besides(task: Task, goal: RelationGoal) -> str:
    """Say why the other goals forbid one, or nothing."""
    try:
        asked = setting.with_relation(task.problem, *goal)
    except InvalidValue as error:
        return str(error).rstrip(".")
    shared = tuple(one for one in asked.related if one[1] == goal[1])
    return why_too_many(msgspec.structs.replace(asked, relations=shared), task.grounding)


def under(task: Task, name: str, spots: Mapping[str, Vector]) -> tuple[str, ...]:
    """Name the objects that a goal on the table lies over, the highest first.

    Args:
        task: The task.
        name: Name of the object that has the goal.
        spots: Where ghosts stand [m]; of other objects it is asked where they stand themselves.
    """
    problem, upon = task.problem, carried_along(name, supports_of(task, {}))
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

    Args:
        task: The task.
        name: Name of the object whose ghost was dropped.
    """
    return next(iter(goals_for(task, name, under(task, name, ghost_spots(task)))), None)


def why_no_drop(task: Task, name: str, other: str) -> str:
    """Say why the ghost of an object cannot be dropped on another one, and where it could.

    Args:
        task: The task.
        name: Name of the object whose ghost was dropped.
        other: Name of the object that it was dropped on.
    """
    goals = ((name, other, put.state.name) for put in _surest_first(task, name, other))
    said = f"nothing puts {name} on or into {other}; {valid_relations(task.problem, task.grounding, name)}"
    return next(filter(None, (_why_not_besides(task, goal) for goal in goals)), said)


def why_not_related(task: Task) -> dict[str, str]:
    """Say of each object whose goal by relation cannot be why not."""
    if not task.problem.related or not why_no_relation(task.problem, task.grounding):
        return {}
    whys = {goal[0]: why_no_goal(task, goal) for goal in task.problem.related}
    return {name: why for name, why in whys.items() if why}
