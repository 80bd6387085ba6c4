"""The page with durations: objects are carried to places by an action that takes time, for PlanSys2.

It says what the page says of what can be carried, with nothing but types, positive conditions and durations:
no costs, no numbers, no constants. Its action is one motion of the robot, since PlanSys2 wants a performer
for each. So nothing is noted between them: what must be free beside the place itself, the starts of objects
that stand over it, is named by further parameters, and a goal is to stand at one place. What can only be
pushed is not in it.

Rehearsals do not record seconds, so durations follow from the waypoints and from how the hand moves
(`motion`): down beside the object, to where it is gripped, up, over the table, down with the object, and up
again. The way over the table counts as its diagonal, so that no carry takes much longer than it is said to.
"""

import math
from collections.abc import Iterator, Sequence

from neurosym.contract import (
    CLEARANCE,
    FINGER_SPEED,
    GRASP_TEST,
    LOWERING_SPEED,
    TRANSIT_CLEARANCE,
    way_seconds,
)
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl.compiler import check_object
from neurosym.pddl.strips import NOWHERE, common_head
from neurosym.pddl.syntax import DURATIVE, Atom, domain_name
from neurosym.problems import Problem
from neurosym.tasks.task import GOAL, START, Task, is_at, understand
from neurosym.tasks.transition import PlanStep

CARRY = "carry"
MOST_OVER = 3
"""Objects that may stand over a place at first, at most; a place with more is not carried to."""
LEAST_SECONDS = 0.001
"""What an action takes at least: durations are printed in whole milliseconds [s]."""
STROKE = 0.07
"""How far a finger travels at most; that of the UR10's hand [m]."""
_NUMBERS = 12  # three waypoints (x, y, z, g)
_HEIGHT = 2  # number of the feature that says how tall an object is
_DOMAIN = """\
{head}
; The hand carries one object at a time, to a free place. The places where other objects stood
; over it at first, up to 3, must be free, too; nowhere always is. What can only be
; pushed is not in it. The duration follows from the waypoints, and from how fast the hand moves in
; the simulator. It counts the way over the table as its diagonal, and not the way to the object.
(define (domain {name})
  (:requirements :strips :typing :durative-actions)
  (:types thing place - object {categories} - thing)
  (:predicates
    (hand-empty)
    (can-carry ?o - thing)
    (stands ?o - thing ?p - place)
    (free ?p - place)
    (room ?o - thing ?p ?over-1 ?over-2 ?over-3 - place))
  (:durative-action carry
    :parameters (?o - thing ?from ?to ?over-1 ?over-2 ?over-3 - place)
    :duration (= ?duration {seconds:.3f})
    :condition (and (at start (hand-empty)) (at start (can-carry ?o)) (at start (stands ?o ?from)) \
(at start (free ?to)) (at start (room ?o ?to ?over-1 ?over-2 ?over-3)) (at start (free ?over-1)) \
(at start (free ?over-2)) (at start (free ?over-3)))
    :effect (and (at start (not (hand-empty))) (at start (not (stands ?o ?from))) \
(at start (not (free ?to))) (at end (stands ?o ?to)) (at end (free ?from)) (at end (hand-empty)))))
"""


def durative_domain_text(grounding: Grounding, seconds: float | None = None) -> str:
    """Print the domain; a carry takes so long [s], or by default as long as the slowest, by the waypoints."""
    _check_carries(grounding)
    if seconds is None:
        seconds = max(carry_seconds(one, grounding) for one in grounding.live_on("place"))
    if not LEAST_SECONDS <= seconds < math.inf:
        raise InvalidValue(f"A carry takes {seconds:g} s; valid: at least {LEAST_SECONDS} s.")
    return _DOMAIN.format(
        head="\n".join(f"; {line}" for line in common_head(grounding)[:3]),
        name=domain_name(grounding, DURATIVE),
        categories=" ".join(sorted(category.name for category in grounding.objects.categories)),
        seconds=seconds,
    )


def _check_carries(grounding: Grounding) -> None:
    if not grounding.live_on("place"):
        raise InvalidValue(f"Nothing in the domain {grounding.name} carries objects to places.")


def carry_seconds(operator: Operator, grounding: Grounding) -> float:
    """Estimate how long an operator takes to carry an object of its category, rounded up to 0.1 s [s].

    Objects count as tall as the mean of the tallest category, since they pass over one another.
    `InvalidValue` if its action is not three waypoints, or objects have no height.
    """
    action = grounding.primitive_of(operator).action
    means = (category.feature_means for category in grounding.objects.categories)
    tallest = max((features[_HEIGHT] for features in means if len(features) > _HEIGHT), default=0.0)
    if len(action) != _NUMBERS or not tallest:
        raise InvalidValue(
            f"How long {operator.name} takes cannot be known: its action is not three waypoints for objects "
            "with a height; give its seconds."
        )
    first, second = action[:4], action[4:8]
    above = max(GRASP_TEST, tallest + TRANSIT_CLEARANCE)
    (left, right), (near, far) = grounding.table.x, grounding.table.y
    ways = [
        max(0.0, tallest / 2 + CLEARANCE - first[2]),
        math.dist(first[:3], second[:3]),
        GRASP_TEST,
        above - GRASP_TEST,
        math.hypot(right - left, far - near),
        grounding.lift_height,
    ]
    seconds = sum(map(way_seconds, ways)) + way_seconds(above + tallest / 2, LOWERING_SPEED)
    changes = 1 + ((first[3] >= 0.5) != (second[3] >= 0.5))  # it lets go in the end
    return math.ceil(10 * (seconds + changes * STROKE / FINGER_SPEED) - 1e-9) / 10


def durative_problem_text(problem: Problem, grounding: Grounding) -> str:
    """Print a problem for that domain, or refuse one that needs more than carrying objects to places."""
    task = understand(problem, grounding)
    if task.relates:
        why = f"{problem.name} has goals by relation, or begins with one object on another, so it has"
        raise InvalidValue(f"{why} no durative form.")
    _check_carries(grounding)
    if task.lying:
        raise InvalidValue(f"{problem.name} sets things upright, so it has no durative form.")
    if task.led:
        why = f"{', '.join(task.led)} cannot be carried to where it shall be, so {problem.name} has"
        raise InvalidValue(f"{why} no durative form.")
    for item in problem.objects:
        check_object(item, grounding)
    starts = {name: f"{START}{name}" for name in task.names}
    facts = [
        f"(stands {name} {place})" + f" (can-carry {name})" * (name in task.carried)
        for name, place in starts.items()
    ]
    for place, spot in task.places.items():
        free = [f"(free {place})"]
        for name in task.occupants[place]:
            over = [starts[other] for other in task.blockers(name, spot)]
            if len(over) <= MOST_OVER:
                over += [NOWHERE] * (MOST_OVER - len(over))
                free.append(f"(room {name} {place} {' '.join(over)})")
        facts += [f"; {place} lies at ({spot[0]:.4f}, {spot[1]:.4f}) m", " ".join(free)]
    goals = " ".join(f"(stands {name} {_goal_place(name, task)})" for name in sorted(problem.goals))
    lines = [
        f"; Problem {problem.name} of the learned domain {grounding.name}, with a durative action.",
        f"; How it came about: {' '.join(problem.provenance.split())}.",
        f"(define (problem {problem.name})\n  (:domain {domain_name(grounding, DURATIVE)})\n  (:objects",
        *(f"    {item.name} - {grounding.category(item.category).name}" for item in problem.objects),
        f"    {' '.join([*starts.values(), *task.places, NOWHERE])} - place)",
        f"  (:init\n    (hand-empty) (free {NOWHERE})",
        *(f"    {line}" for line in facts),
        f"  )\n  (:goal (and {goals})))",
    ]
    return "\n".join(lines) + "\n"


def _goal_place(name: str, task: Task) -> str:
    """Choose where an object shall stand: where it starts, if that will do, or else the nearest place."""
    problem = task.flat
    x, y, _ = problem.object_named(name).position
    if is_at(name, (x, y), problem):
        return f"{START}{name}"
    goal, own = problem.goals[name][:2], f"{GOAL}{name}"
    near = {place: math.dist(spot, goal) for place, spot in task.places.items() if is_at(name, spot, problem)}
    return own if own in near else min(near, key=lambda place: (near[place], place))


def read_durative(actions: Sequence[Atom], task: Task) -> Iterator[PlanStep]:
    """Read ground actions with durations as steps; what they do is for the exact replay to judge."""
    for name, *arguments in actions:
        if name != CARRY or len(arguments) != 3 + MOST_OVER or arguments[0] not in task.carriers:
            raise InvalidValue(f"nothing carries that; valid: ({CARRY} object from to and what stood there)")
        thing, _, place = arguments[:3]
        task.grounding.table.check(place, *task.flat.place_named(place))
        yield PlanStep(task.carriers[thing][0].name, thing, place)
