"""`durative`: objects are carried to places by actions that take time, for PlanSys2 and its planners.

It says what `places` says of what can be carried, with nothing but types, positive conditions and durations:
no costs, no numbers, no constants. Each action is one motion of the robot, since PlanSys2 wants a performer
for each. So nothing is noted between them: what must be free beside the place itself, the starts of objects
that stand over it, is named by further parameters, and a goal is to stand at one place. What can only be
pushed is not in it.
"""

import math
from collections.abc import Mapping
from itertools import chain

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl.durations import carry_seconds
from neurosym.pddl.moves import DURATIVE, domain_name
from neurosym.pddl.place_domain import NOWHERE, about_carrier
from neurosym.pddl.place_problem import START, carried_objects, led_objects
from neurosym.pddl.printing import comment, guarantees, opening
from neurosym.pddl.problem import check_object
from neurosym.problems import Problem, SceneObject
from neurosym.related import is_relational
from neurosym.tasks.carriers import carriers_for, carriers_of
from neurosym.tasks.footprints import footprints_apart
from neurosym.tasks.occupants import occupants
from neurosym.tasks.places import GOAL, blockers, is_at, with_places

REQUIREMENTS = ":strips :typing :durative-actions"
MOST_OVER = 3
"""Objects that may stand over a place at first, at most; a place with more is not carried to."""
LEAST_SECONDS = 0.001
"""What an action takes at least: durations are printed in whole milliseconds [s]."""
_OVER = tuple(f"?over-{number}" for number in range(1, MOST_OVER + 1))


def durative_domain_text(grounding: Grounding, seconds: Mapping[str, float] | None = None) -> str:
    """Print the domain with durative actions.

    Args:
        grounding: The learned domain.
        seconds: How long operators take, by name [s]; what is not given follows from the waypoints.

    Raises:
        InvalidValue: If nothing carries objects to places, or it cannot be known how long that takes.
        UnknownChoice: If there are seconds for what carries nothing.
    """
    carriers = carriers_of(grounding)
    if not carriers:
        raise InvalidValue(f"Nothing in the domain {grounding.name} carries objects to places.")
    given, names = seconds or {}, [one.name for one in carriers]
    if unknown := sorted(set(given) - set(names)):
        raise UnknownChoice("operator", unknown[0], names)
    types = " ".join(sorted(category.name for category in grounding.operators.categories))
    blocks = [
        _header(grounding),
        opening(grounding, DURATIVE, REQUIREMENTS),
        f"  (:types\n    movable place - object\n    {types} - movable)",
        "\n".join(["  (:predicates", *(f"    {line}" for line in _predicates(grounding))]) + ")",
        *(_action(one, grounding, given.get(one.name)) for one in carriers),
    ]
    return "\n\n".join(blocks) + ")\n"


def durative_problem_text(problem: Problem, grounding: Grounding) -> str:
    """Print a problem for the domain with durative actions.

    Args:
        problem: The problem.
        grounding: The learned domain.

    Raises:
        InvalidValue: If an object with a goal cannot be carried to it, a goal is a relation, an object begins
            on another one, or an object's name is taken.
    """
    if is_relational(problem, grounding):
        raise InvalidValue(
            f"{problem.name} has goals by relation, or begins with one object on another, so it has no "
            "durative form."
        )
    for item in problem.objects:
        check_object(item, grounding)
    if not carriers_of(grounding):
        raise InvalidValue(f"Nothing in the domain {grounding.name} carries objects to places.")
    if led := led_objects(problem, grounding):
        raise InvalidValue(
            f"{', '.join(led)} cannot be carried to where it shall be, "
            f"so {problem.name} has no durative form."
        )
    problem = with_places(problem, grounding)
    types = ((item.name, grounding.category(item.category).name) for item in problem.objects)
    starts = [f"{START}{name}" for name in problem.object_names]
    goals = " ".join(f"(stands {name} {_goal_place(name, problem)})" for name in sorted(problem.goals))
    lines = [
        f"; Problem {problem.name} of the learned domain {grounding.name}, with durative actions.",
        f"; How it came about: {' '.join(problem.provenance.split())}.",
        f"(define (problem {problem.name})\n  (:domain {domain_name(grounding, DURATIVE)})\n  (:objects",
        *(f"    {name} - {kind}" for name, kind in types),
        f"    {' '.join([*starts, *_places(problem), NOWHERE])} - place)",
        f"  (:init\n    (hand-empty) (free {NOWHERE})",
        *(f"    {line}" for line in _facts(problem, grounding)),
        f"  )\n  (:goal (and {goals})))",
    ]
    return "\n".join(lines) + "\n"


def _header(grounding: Grounding) -> str:
    return comment(
        [
            f"Learned domain {grounding.name}, encoding durative. Printed by neurosym; do not edit.",
            "An action carries an object from a place to another, which must be free. So must be the places "
            f"where other objects stood over it at first, up to {MOST_OVER}; {NOWHERE} is always free.",
            "What can only be pushed is not in it.",
            *guarantees(DURATIVE),
            "Durations follow from the waypoints, and from how fast the hand moves in the simulator. They "
            "count the way over the table as its diagonal, and leave out the way to the object.",
        ],
        "",
    )


def _predicates(grounding: Grounding) -> list[str]:
    """List the predicates; PlanSys2 wants each on a line of its own."""
    return [
        "(hand-empty)",
        "(stands ?o - movable ?p - place)",
        "(free ?p - place)",
        f"(room ?o - movable ?p {' '.join(_OVER)} - place)",
        *(f"(can-{one.name} ?o - {_type(one, grounding)})" for one in carriers_of(grounding)),
    ]


def _action(operator: Operator, grounding: Grounding, seconds: float | None) -> str:
    """Print the action of an operator, with a comment."""
    lasting = carry_seconds(operator, grounding) if seconds is None else seconds
    if not LEAST_SECONDS <= lasting < math.inf:
        raise InvalidValue(f"{operator.name} takes {lasting:g} s; valid: at least {LEAST_SECONDS} s.")
    needed = ["(hand-empty)", f"(can-{operator.name} ?o)", "(stands ?o ?from)", "(free ?to)"]
    needed += [f"(room ?o ?to {' '.join(_OVER)})", *(f"(free {place})" for place in _OVER)]
    taken = ["(not (hand-empty))", "(not (stands ?o ?from))", "(not (free ?to))"]
    left = ["(stands ?o ?to)", "(free ?from)", "(hand-empty)"]
    before = [f"(at start {fact})" for fact in needed]
    after = [f"(at start {fact})" for fact in taken] + [f"(at end {fact})" for fact in left]
    return "\n".join(
        [
            comment(about_carrier(operator, grounding), "  "),
            f"  (:durative-action {operator.name}",
            f"    :parameters (?o - {_type(operator, grounding)} ?from ?to {' '.join(_OVER)} - place)",
            f"    :duration (= ?duration {lasting:.3f})",
            f"    :condition (and {' '.join(before)})",
            f"    :effect (and {' '.join(after)}))",
        ]
    )


def _facts(problem: Problem, grounding: Grounding) -> list[str]:
    """List what holds at the start, a line for each object and each place."""
    places, apart = _places(problem), footprints_apart(problem)
    carried = carried_objects(problem, grounding)
    may_stand = occupants(problem, carried)
    lines = []
    for item in problem.objects:
        can = _can(item, problem, grounding) if item.name in carried else ""
        lines.append(f"(stands {item.name} {START}{item.name}){can}")
    for name, spot in places.items():
        lines.append(comment([f"{name} lies at ({spot[0]:.4f}, {spot[1]:.4f}) m"], "    ").lstrip())
        over = {thing: blockers(thing, spot, problem, apart) for thing in may_stand[name]}
        rooms = (_room(thing, name, over[thing]) for thing in over if len(over[thing]) <= MOST_OVER)
        lines.append(" ".join(chain([f"(free {name})"], rooms)))
    return lines


def _can(item: SceneObject, problem: Problem, grounding: Grounding) -> str:
    """Say which operator may carry an object: the surest, since all lead to the same."""
    return f" (can-{carriers_for(item, grounding, problem.tolerance)[0].name} {item.name})"


def _room(thing: str, place: str, over: tuple[str, ...]) -> str:
    """Say which places must be free for an object to have room at a place."""
    starts = [f"{START}{other}" for other in over]
    filled = starts + [NOWHERE] * (MOST_OVER - len(starts))
    return f"(room {thing} {place} {' '.join(filled)})"


def _goal_place(name: str, problem: Problem) -> str:
    """Choose where an object shall stand: where it starts, if that will do, or else the nearest place."""
    x, y, _ = problem.object_named(name).position
    if is_at(name, (x, y), problem):
        return f"{START}{name}"
    goal, own = problem.goals[name][:2], f"{GOAL}{name}"
    near = {
        place: math.dist(spot, goal) for place, spot in _places(problem).items() if is_at(name, spot, problem)
    }
    return own if own in near else min(near, key=lambda place: (near[place], place))


def _places(problem: Problem) -> dict[str, tuple[float, float]]:
    assert isinstance(problem.places, dict), "with_places gives them"
    return problem.places


def _type(operator: Operator, grounding: Grounding) -> str:
    return grounding.category(operator.category).name
