"""The page with durations: objects are carried to places by an action that takes time, for PlanSys2.

It says what the page says of what can be carried, with nothing but types, positive conditions and durations:
no costs, no numbers, no constants. Its action is one motion of the robot, since PlanSys2 wants a performer
for each. So nothing is noted between them: what must be free beside the place itself, the starts of objects
that stand over it, is named by further parameters, and a goal is to stand at one place. What can only be
pushed is not in it.
"""

import math
from collections.abc import Mapping, Sequence
from itertools import chain

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl.durations import carry_seconds
from neurosym.pddl.encoding_names import DURATIVE, domain_name
from neurosym.pddl.problem import check_object
from neurosym.pddl.strips import NOWHERE, PLACE, THING, common_head
from neurosym.pddl.strips_plan import Misread
from neurosym.pddl.syntax import Atom
from neurosym.problems import Problem
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.places import GOAL, START, check_place, is_at
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import Task, understand

CARRY = "carry"
REQUIREMENTS = ":strips :typing :durative-actions"
MOST_OVER = 3
"""Objects that may stand over a place at first, at most; a place with more is not carried to."""
LEAST_SECONDS = 0.001
"""What an action takes at least: durations are printed in whole milliseconds [s]."""
_OVER = tuple(f"?over-{number}" for number in range(1, MOST_OVER + 1))


def durative_domain_text(grounding: Grounding, seconds: Mapping[str, float] | None = None) -> str:
    """Print the domain with a durative action; it takes as long as the slowest of what carries.

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
    lasting = {
        one.name: given[one.name] if one.name in given else carry_seconds(one, grounding) for one in carriers
    }
    for name, value in lasting.items():
        if not LEAST_SECONDS <= value < math.inf:
            raise InvalidValue(f"{name} takes {value:g} s; valid: at least {LEAST_SECONDS} s.")
    over = " ".join(_OVER)
    needed = ["(hand-empty)", "(can-carry ?o)", "(stands ?o ?from)", "(free ?to)", f"(room ?o ?to {over})"]
    needed += [f"(free {place})" for place in _OVER]
    taken = ["(not (hand-empty))", "(not (stands ?o ?from))", "(not (free ?to))"]
    left = ["(stands ?o ?to)", "(free ?from)", "(hand-empty)"]
    after = [f"(at start {fact})" for fact in taken] + [f"(at end {fact})" for fact in left]
    categories = " ".join(sorted(category.name for category in grounding.operators.categories))
    lines = [
        *(f"; {line}" for line in common_head(grounding)[:3]),
        "; The hand carries one object at a time, to a free place. The places where other objects stood",
        f"; over it at first, up to {MOST_OVER}, must be free, too; {NOWHERE} always is. What can only be",
        "; pushed is not in it. The duration follows from the waypoints, and from how fast the hand moves in",
        "; the simulator. It counts the way over the table as its diagonal, and not the way to the object.",
        f"(define (domain {domain_name(grounding, DURATIVE)})",
        f"  (:requirements {REQUIREMENTS})",
        f"  (:types {THING} {PLACE} - object {categories} - {THING})",
        "  (:predicates",
        "    (hand-empty)",
        f"    (can-carry ?o - {THING})",
        f"    (stands ?o - {THING} ?p - {PLACE})",
        f"    (free ?p - {PLACE})",
        f"    (room ?o - {THING} ?p {over} - {PLACE}))",
        f"  (:durative-action {CARRY}",
        f"    :parameters (?o - {THING} ?from ?to {over} - {PLACE})",
        f"    :duration (= ?duration {max(lasting.values()):.3f})",
        f"    :condition (and {' '.join(f'(at start {fact})' for fact in needed)})",
        f"    :effect (and {' '.join(after)})))",
    ]
    return "\n".join(lines) + "\n"


def durative_problem_text(problem: Problem, grounding: Grounding) -> str:
    """Print a problem for the domain with a durative action.

    Args:
        problem: The problem.
        grounding: The learned domain.

    Raises:
        InvalidValue: If an object with a goal cannot be carried to it, a goal is a relation, an object begins
            on another one, or an object's name is taken.
    """
    task = understand(problem, grounding)
    if task.relates:
        raise InvalidValue(
            f"{problem.name} has goals by relation, or begins with one object on another, so it has no "
            "durative form."
        )
    for item in problem.objects:
        check_object(item, grounding)
    if not carriers_of(grounding):
        raise InvalidValue(f"Nothing in the domain {grounding.name} carries objects to places.")
    if task.led:
        raise InvalidValue(
            f"{', '.join(task.led)} cannot be carried to where it shall be, "
            f"so {problem.name} has no durative form."
        )
    starts = [f"{START}{name}" for name in task.names]
    goals = " ".join(f"(stands {name} {_goal_place(name, task)})" for name in sorted(problem.goals))
    lines = [
        f"; Problem {problem.name} of the learned domain {grounding.name}, with a durative action.",
        f"; How it came about: {' '.join(problem.provenance.split())}.",
        f"(define (problem {problem.name})\n  (:domain {domain_name(grounding, DURATIVE)})\n  (:objects",
        *(f"    {item.name} - {grounding.category(item.category).name}" for item in problem.objects),
        f"    {' '.join([*starts, *task.places, NOWHERE])} - {PLACE})",
        f"  (:init\n    (hand-empty) (free {NOWHERE})",
        *(f"    {line}" for line in _facts(task)),
        f"  )\n  (:goal (and {goals})))",
    ]
    return "\n".join(lines) + "\n"


def read_durative(actions: Sequence[Atom], task: Task) -> tuple[PlanStep, ...]:
    """Read ground actions with durations as steps; what they do is for the exact replay to judge.

    Args:
        actions: The ground actions.
        task: The task.

    Raises:
        Misread: If an action names nothing that can be carried, or no place.
    """
    steps = []
    for number, (_, *arguments) in enumerate(actions):
        if len(arguments) != 3 + MOST_OVER or arguments[0] not in task.carriers:
            raise Misread(
                f"nothing carries that; valid: ({CARRY} object from to and what stood there)", number
            )
        thing, _, place = arguments[:3]
        try:
            check_place(place, task.flat, task.grounding)
        except (InvalidValue, UnknownChoice) as error:
            raise Misread(str(error).rstrip("."), number) from error
        steps.append(PlanStep(task.carriers[thing][0].name, thing, place))
    return tuple(steps)


def _facts(task: Task) -> list[str]:
    """List what holds at the start, a line for each object and each place."""
    lines = []
    for name in task.names:
        can = f" (can-carry {name})" if name in task.carried else ""
        lines.append(f"(stands {name} {START}{name}){can}")
    for name, (x, y) in task.places.items():
        lines.append(f"; {name} lies at ({x:.4f}, {y:.4f}) m")
        over = {thing: task.blockers(thing, (x, y)) for thing in task.occupants[name]}
        rooms = (_room(thing, name, over[thing]) for thing in over if len(over[thing]) <= MOST_OVER)
        lines.append(" ".join(chain([f"(free {name})"], rooms)))
    return lines


def _room(thing: str, place: str, over: tuple[str, ...]) -> str:
    """Say which places must be free for an object to have room at a place."""
    starts = [f"{START}{other}" for other in over]
    filled = starts + [NOWHERE] * (MOST_OVER - len(starts))
    return f"(room {thing} {place} {' '.join(filled)})"


def _goal_place(name: str, task: Task) -> str:
    """Choose where an object shall stand: where it starts, if that will do, or else the nearest place."""
    problem = task.flat
    x, y, _ = problem.object_named(name).position
    if is_at(name, (x, y), problem):
        return f"{START}{name}"
    goal, own = problem.goals[name][:2], f"{GOAL}{name}"
    near = {place: math.dist(spot, goal) for place, spot in task.places.items() if is_at(name, spot, problem)}
    return own if own in near else min(near, key=lambda place: (near[place], place))
