"""Goals by relation on a page: which there can be, where their ghosts stand, and what dropping a ghost means.

All that is given here is a problem that knows the kinds of its pairs, as `Library.paired` returns it.
"""

from collections.abc import Iterator, Mapping

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.pair_states import extent
from neurosym.problems import Problem
from neurosym.related import Borne, bearers_of, relations_of
from neurosym.relation_goals import RelationGoal
from neurosym.studio import setting
from neurosym.tasks.pair_goals import puts_for, valid_relations, why_no_relation, why_too_many
from neurosym.tasks.puts import Put

OFF_TABLE = 0.005
"""What is borne stands so far above the table at least, unless somebody saw what it touches [m]."""


def stacks_of(problem: Problem, grounding: Grounding) -> dict[str, Borne]:
    """Return what bears each object that another one bears; nothing where the domain knows no relations.

    An object that was dragged into another one stands on the table still, and is borne by nothing.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.
    """
    if grounding.relations is None:
        return {}
    is_seen = isinstance(problem.touching, tuple)
    return {
        name: borne
        for name, borne in bearers_of(problem, grounding.relations).items()
        if is_seen or problem.object_named(name).position[2] - table_height(problem, name) > OFF_TABLE
    }


def table_height(problem: Problem, name: str) -> float:
    """Return the height of an object's centre where it stands on the table as it lies now [m].

    Args:
        problem: The problem.
        name: Name of the object.
    """
    return float(extent(problem.scene(), problem.object_names.index(name))[2]) / 2


def supports_of(problem: Problem, stacks: Mapping[str, str]) -> dict[str, str]:
    """Name what bears each object in the end: as is asked, or as it is now where nothing is asked of it.

    Args:
        problem: The problem.
        stacks: What bears each object now that another one bears.
    """
    asked = {target: reference for target, reference, _ in problem.related}
    return {name: by for name, by in stacks.items() if name not in problem.goals} | asked


def above(name: str, supports: Mapping[str, str]) -> tuple[str, ...]:
    """Name all that an object bears, and what that bears.

    Args:
        name: The object.
        supports: What bears each object that another one bears.
    """
    found, below = list[str](), [name]
    while below:
        here = below.pop()
        more = [one for one, other in supports.items() if other == here and one not in (name, *found)]
        found += more
        below += more
    return tuple(found)


def ghost_spots(problem: Problem, grounding: Grounding) -> dict[str, Vector]:
    """Return where the ghost of each object with a goal stands [m].

    For a goal by relation that is where the surest operator promises to bring it.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    spots, asked = dict(problem.goals), {goal[0]: goal for goal in problem.related}
    scene, names = problem.scene(), problem.object_names

    def spot_of(name: str) -> Vector:
        if name not in spots and name in asked:
            _, reference, state = asked[name]
            halves = (extent(scene, names.index(name)) + extent(scene, names.index(reference))) / 2
            offset = np.array(_offset(problem, grounding, name, reference, state)) * halves
            spots[name] = vector(np.add(spot_of(reference), offset))
        return spots.get(name, problem.object_named(name).position)

    return {name: spot_of(name) for name in names if name in problem.goals or name in asked}


def _offset(
    problem: Problem, grounding: Grounding, target: str, reference: str, state: str
) -> tuple[float, float, float]:
    """Return where a target is promised to be, from its reference, in sums of their half sizes."""
    asked = relations_of(grounding, problem).state_named(state)
    for put in _surest_first(problem, grounding, target, reference):
        if put.state == asked:
            return put.end.offset
    return 0.0, 0.0, asked.centre[1]


def _surest_first(problem: Problem, grounding: Grounding, target: str, reference: str) -> tuple[Put, ...]:
    puts = puts_for(problem, grounding, target, reference)
    return tuple(sorted(puts, key=lambda put: (-put.share, put.name)))


def goals_for(problem: Problem, grounding: Grounding, name: str) -> tuple[RelationGoal, ...]:
    """List the goals by relation that an object can have besides what is asked already.

    Args:
        problem: The problem.
        grounding: The learned domain.
        name: Name of the object.
    """
    borne, found = stacks_of(problem, grounding).get(name), list[RelationGoal]()
    for other in problem.object_names:
        found += _goals_on(problem, grounding, name, other) if other != name else ()
        held = (name, other, borne.state.name) if borne and borne.by == other else None
        if held and not _why_not_besides(problem, grounding, held):
            found.append(held)
    return tuple(dict.fromkeys(found))


def _goals_on(problem: Problem, grounding: Grounding, name: str, other: str) -> Iterator[RelationGoal]:
    """Yield the goals that an object can have on or in another one, the surest first."""
    for put in _surest_first(problem, grounding, name, other):
        goal = (name, other, put.state.name)
        if not _why_not_besides(problem, grounding, goal):
            yield goal


def why_no_goal(problem: Problem, grounding: Grounding, goal: RelationGoal) -> str:
    """Say why an object cannot have a goal by relation besides what is asked already, or nothing.

    Args:
        problem: The problem.
        grounding: The learned domain.
        goal: The goal.
    """
    if why := _why_not_besides(problem, grounding, goal):
        return why
    alone = setting.with_relation(problem, *goal)
    return why_no_relation(msgspec.structs.replace(alone, relations=(goal,)), grounding)


def _why_not_besides(problem: Problem, grounding: Grounding, goal: RelationGoal) -> str:
    """Say why the other goals forbid one, or nothing."""
    try:
        asked = setting.with_relation(problem, *goal)
    except InvalidValue as error:
        return str(error).rstrip(".")
    shared = tuple(one for one in asked.related if one[1] == goal[1])
    return why_too_many(msgspec.structs.replace(asked, relations=shared), grounding)


def under(problem: Problem, name: str, spots: Mapping[str, Vector]) -> tuple[str, ...]:
    """Name the objects that a goal lies over, the highest first: their ghosts, or those without one.

    Args:
        problem: The problem.
        name: Name of the object that has the goal.
        spots: Where the ghosts stand [m].
    """
    if name not in problem.goals:
        return ()
    at = np.array(problem.goals[name][:2])
    upon = above(name, {target: reference for target, reference, _ in problem.related})
    found = []
    for other in problem.objects:
        x, y, z = spots.get(other.name, other.position)
        is_over = np.all(np.abs(at - (x, y)) < np.array(other.features[:2]) / 2)
        if other.name not in (name, *upon) and is_over:
            found.append((-z, other.name))
    return tuple(other for _, other in sorted(found))


def relation_of_drop(problem: Problem, grounding: Grounding, name: str) -> RelationGoal | None:
    """Return the goal by relation that is meant where a ghost was dropped; None if there is none.

    It is about the highest object under the ghost that something puts it on or into, and the state that the
    two are brought to most surely.

    Args:
        problem: The problem.
        grounding: The learned domain.
        name: Name of the object whose ghost was dropped.
    """
    for other in under(problem, name, ghost_spots(problem, grounding)):
        for goal in _goals_on(problem, grounding, name, other):
            return goal
    return None


def why_no_drop(problem: Problem, grounding: Grounding, name: str, other: str) -> str:
    """Say why the ghost of an object cannot be dropped on another one, and where it could.

    Args:
        problem: The problem.
        grounding: The learned domain.
        name: Name of the object whose ghost was dropped.
        other: Name of the object that it was dropped on.
    """
    for put in _surest_first(problem, grounding, name, other):
        if why := _why_not_besides(problem, grounding, (name, other, put.state.name)):
            return why
    return f"nothing puts {name} on or into {other}; {valid_relations(problem, grounding, name)}"


def why_not_related(problem: Problem, grounding: Grounding) -> dict[str, str]:
    """Say of each object whose goal by relation cannot be why not.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    if not problem.related or not why_no_relation(problem, grounding):
        return {}
    whys = {goal[0]: why_no_goal(problem, grounding, goal) for goal in problem.related}
    return {name: why for name, why in whys.items() if why}
