"""Whether a problem that somebody wrote can be: its goals, its places, and its scene as the world tells."""

import math
import re
from collections.abc import Sequence
from itertools import combinations, product

import numpy as np

from neurosym.contract import ObjectLimits
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pair_operators import rotation
from neurosym.pddl.compiler import is_taken
from neurosym.pddl.strips import NOWHERE
from neurosym.problems import (
    NEAR_TABLE,
    SPOT,
    Problem,
    RelationGoal,
    SceneObject,
    check_goals,
    check_names,
    check_on_table,
    goal_heights,
)
from neurosym.tasks.conditions import options_of
from neurosym.tasks.supports import chain_below, known_bearers
from neurosym.tasks.task import GOAL, PARK, START, footprints_apart, is_at, why_no_relation

OFF_REST = 0.005
"""How far from the height it rests at an object's centre may be [m]; physics settles it within 0.1 mm."""
OFF_UNIT = 0.01
"""How far from 1 the length of a quaternion may be."""
_UPRIGHT = 0.999
_TAKEN = rf"{NOWHERE}|{START}.*|{SPOT.pattern}"


def check_problem(problem: Problem, grounding: Grounding | None, limits: ObjectLimits | None) -> None:
    """Raise `InvalidValue` or `UnknownChoice` unless the scene of a problem can be, and its goals too.

    Without a grounding, table and categories are not checked; without limits, how objects are and stand.
    """
    bearers = known_bearers(problem, grounding.relations) if grounding and grounding.relations else {}
    for item, unseen in zip(problem.objects, problem.scene().unseen.tolist(), strict=True):
        if limits:
            limits.check(item.name, item.features)
            limits.check_unseen(item.name, unseen)
            if not abs((length := math.hypot(*item.orientation)) - 1) <= OFF_UNIT:
                raise InvalidValue(
                    f"{item.name} has an orientation of length {length:g}; valid: a quaternion (x, y, z, w) "
                    "of length 1, as [0, 0, 0, 1]."
                )
        if grounding:
            wanted = len(grounding.category(item.category).feature_means)
            if wanted not in (0, found := len(item.features)):
                raise InvalidValue(
                    f"{item.name} has {found} features; this domain knows objects by {wanted}, as "
                    "`neurosym new-problem` draws them in it."
                )
            check_on_table(item, grounding.table, off=NEAR_TABLE)
        if limits and item.name not in bearers:
            _check_height(item)
    for one, other in combinations(problem.objects, 2) if limits else ():
        lowest = [chain_below(item.name, bearers)[-1] for item in (one, other)]
        if lowest[0] != lowest[1]:  # what bears one another may be one over the other
            _check_apart(one, other)
    if grounding:
        check_places(problem, grounding)
        check_relations(problem, grounding)
        for text in problem.conditions:
            options_of(text, problem, grounding)
        heights = goal_heights(problem, grounding.lift_height) if limits else (-math.inf, math.inf)
        check_goals(problem, grounding.table, heights)


def _check_height(item: SceneObject) -> None:
    """Refuse an object that floats or is sunk; one that leans on another may be at any height it can be."""
    half = np.array(item.features[:3]) / 2
    upwards = np.abs(rotation(np.array(item.orientation))[2])
    lowest = highest = float(upwards @ half)
    if upwards.max() < _UPRIGHT:
        lowest, highest = float(half.min()), float(np.linalg.norm(half))
    low, high, height = lowest - OFF_REST, highest + OFF_REST, item.position[2]
    if not low <= height <= high:
        raise InvalidValue(
            f"The centre of {item.name} is at z = {height:g} m, where it does not rest; valid: "
            f"{low:.3f} to {high:.3f} m."
        )


def _check_apart(one: SceneObject, other: SceneObject) -> None:
    """Refuse two objects of which one has its centre in the other; edges may seem to overlap."""
    for inner, outer in ((one, other), (other, one)):
        away = np.subtract(inner.position[:2], outer.position[:2])
        turned = rotation(np.array(outer.orientation))
        level = np.delete(np.arange(3), np.argmax(np.abs(turned[2])))
        # half the edges of its footprint [m], a row each: those of its most level side
        footprint = (turned[:2, level] * np.array(outer.features[:3])[level] / 2).T
        if np.all(np.abs(away @ np.linalg.inv(footprint)) < 1):
            raise InvalidValue(
                f"{one.name} and {other.name} stand in one place: the centre of {inner.name} lies within "
                f"{outer.name}; put them side by side."
            )


def check_places(problem: Problem, grounding: Grounding) -> None:
    """Raise `InvalidValue` unless objects can be carried to each place that a problem names."""
    if not problem.places:
        return
    if not grounding.live_on("place"):
        raise InvalidValue(
            f"The problem {problem.name} has places, and nothing in this domain carries objects to places; "
            "leave out `places`, or learn to with `neurosym run DIR --places N`."
        )
    check_names(tuple(problem.places))
    meant = dict[str, list[int]]()
    for name, (x, y) in problem.places.items():
        if name in problem.object_names or is_taken(name, grounding) or re.fullmatch(_TAKEN, name):
            raise InvalidValue(f"No place can be called {name}, the problem uses that; try shelf-01.")
        grounding.table.check(name, x, y)
        there = [thing for thing in problem.goals if is_at(thing, problem.place_named(name), problem)]
        thing = name.removeprefix(GOAL)
        if name.startswith(GOAL) and thing in problem.goals and thing not in there:
            goal_x, goal_y, _ = problem.goals[thing]
            raise InvalidValue(
                f"The place {name} lies at ({x:g}, {y:g}) m, and the goal of {thing} at "
                f"({goal_x:g}, {goal_y:g}) m; give it another name, or the place of the goal."
            )
        any_may = name.startswith(PARK)
        meant[name] = [row for row, one in enumerate(problem.object_names) if any_may or one in there]
    apart = footprints_apart(problem)
    for one, other in combinations(meant, 2):
        away = np.abs(np.subtract(problem.place_named(one), problem.place_named(other)))
        for mine, its in product(meant[one], meant[other]):
            if mine != its and np.all(away < apart[mine, its]):
                x, y = apart[mine, its]
                names = problem.object_names
                raise InvalidValue(
                    f"The places {one} and {other} are too near for {names[mine]} and {names[its]}; valid: "
                    f"at least {x:.3f} m apart in x, or {y:.3f} m in y."
                )


# Whether the goals by relation of a problem can be, by what was learned of its pairs.
def relations_meant(goals: Sequence[RelationGoal], grounding: Grounding) -> tuple[RelationGoal, ...]:
    """Return goals by relation with the names of the states that are meant by name, symbol or a beginning."""
    if not goals:
        return ()
    if grounding.relations is None:
        raise InvalidValue(
            "This domain has learned no relations; valid here: goals on the table, as item-01=0.60,0.10."
        )
    meant = grounding.relations.state_meant
    return tuple(dict.fromkeys((target, reference, meant(word).name) for target, reference, word in goals))


def check_relations(problem: Problem, grounding: Grounding) -> None:
    """Refuse unmet goals by relation that nothing leads to, and kinds of pairs that are no codes."""
    if grounding.relations and grounding.relations.pairs:
        one = grounding.relations.pairs[0].symbol
        for pair, code in sorted(problem.pairs.items()):
            if len(code) != len(one):
                said = f"pairs has the code {code!r} for {pair!r}"
                raise InvalidValue(f"{said}; valid: {len(one)} bits, like {one!r}, or no entry.")
    if problem.relations and (reason := why_no_relation(problem, grounding)):
        raise InvalidValue(f"{reason}.")
