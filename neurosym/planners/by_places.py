"""Planning with places: objects that can be carried are, and only the others are led over cells."""

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from collections.abc import Set as AbstractSet

import msgspec

from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.pddl.footprints import footprints_apart
from neurosym.pddl.place_domain import carriers_of
from neurosym.pddl.place_problem import carried_objects
from neurosym.pddl.places import PARK, blockers, with_places
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.validation import validate
from neurosym.planners.clearance import clearest_first
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem


def is_by_places(problem: Problem, grounding: Grounding) -> bool:
    """Say whether some object of a problem can be carried to its goal.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    if not (grounding.is_refined and carriers_of(grounding)):
        return False
    return any(name in problem.goals for name in carried_objects(problem, grounding))


def plan_by_places(
    problem: Problem, grounding: Grounding, solve: Callable[[Problem], PlanResult]
) -> PlanResult:
    """Plan for all objects at once, and believe the plan if its replay is right.

    Args:
        problem: The problem.
        grounding: The learned domain.
        solve: Gives it to a planner, in the encoding `places`.
    """
    problem = with_places(problem, grounding)
    result = solve(problem)
    if result.status is not PlanStatus.SOLVED:
        return result
    checked = validate(result.steps, problem, grounding)
    if checked.valid:
        return dataclasses.replace(result, steps=_clearest_first(result.steps, problem, grounding))
    reason = f"the plan with places is not true when replayed: {checked.reason}"
    return dataclasses.replace(result, status=PlanStatus.FAILED, steps=(), reason=reason)


def _clearest_first(
    steps: tuple[PlanStep, ...], problem: Problem, grounding: Grounding
) -> tuple[PlanStep, ...]:
    """Carry first what has most room, if nothing else is done and the plan stays true."""
    if not all(step.place for step in steps):
        return steps
    ordered = clearest_first(steps, problem)
    return ordered if validate(ordered, problem, grounding).valid else steps


def plan_in_turns(
    problem: Problem,
    grounding: Grounding,
    carry: Callable[[Problem], PlanResult],
    lead: Callable[[Problem], PlanResult],
) -> PlanResult:
    """Plan in turns for what can be carried and for what must be led over cells.

    What is led then keeps clear of what was carried, which a plan for all at once does not know. First all is
    carried to its goal, or put aside if something that must be led stands there; then that is led, and what
    was put aside is carried on. If that fails, what must be led is led first.

    Args:
        problem: The problem.
        grounding: The learned domain.
        carry: Plans for objects that can be carried.
        lead: Plans for others.
    """
    problem = with_places(problem, grounding)
    can_be = carried_objects(problem, grounding)
    carried = {name: goal for name, goal in problem.goals.items() if name in can_be}
    led = {name: goal for name, goal in problem.goals.items() if name not in can_be}
    aside = _aside(problem, carried, led.keys())
    first = {name: aside.get(name, goal) for name, goal in carried.items() if aside.get(name, goal)}
    result = PlanResult(PlanStatus.FAILED, (), 0.0, "everything that has a goal can be carried")
    if not led:
        return result
    for turns in (
        ((carry, first), (lead, led), (carry, carried)),
        ((lead, led), (carry, carried)),
    ):
        now, steps = problem, list[PlanStep]()
        for solve, goals in turns:
            if not goals:
                continue
            task = msgspec.structs.replace(now, goals=goals)
            if task.is_met(task.scene().positions):
                continue
            result = solve(task)
            if result.status is not PlanStatus.SOLVED:
                break
            steps += result.steps
            now = _after(result.steps, task, grounding)
        else:
            checked = validate(steps, problem, grounding)
            if checked.valid:
                return dataclasses.replace(result, status=PlanStatus.SOLVED, steps=tuple(steps))
            result = dataclasses.replace(result, status=PlanStatus.FAILED, steps=(), reason=checked.reason)
    return result


def _aside(
    problem: Problem, carried: Mapping[str, Vector], led: AbstractSet[str]
) -> dict[str, Vector | None]:
    """Say where objects are put whose goals are taken by what must be led: on a park, or nowhere."""
    apart = footprints_apart(problem)
    places = problem.places if isinstance(problem.places, dict) else {}
    parks = [spot for name, spot in places.items() if name.startswith(PARK)]
    taken = [
        name
        for name, (x, y, _) in carried.items()
        if not led.isdisjoint(blockers(name, (x, y), problem, apart))
    ]
    spots = dict(zip(taken, parks, strict=False))
    return {name: (*spots[name], carried[name][2]) if name in spots else None for name in taken}


def _after(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with the objects where a plan leads them."""
    ends = validate(steps, problem, grounding).positions[-1]
    moved = zip(problem.objects, map(vector, ends), strict=True)
    objects = tuple(msgspec.structs.replace(item, position=end) for item, end in moved)
    return msgspec.structs.replace(problem, objects=objects)


def not_proved(result: PlanResult) -> PlanResult:
    """Say of what has no plan over cells that it was not found: something could have been carried.

    Args:
        result: What planning over cells came to.
    """
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    reason = f"no plan with the places that were drawn; without: {result.reason or 'unsolvable'}"
    return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=reason)
