"""Planning with places: objects that can be carried are, and only the others are led over cells."""

import dataclasses
from collections.abc import Callable

from neurosym.grounding import Grounding
from neurosym.planners.clearance import clearest_first
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.places import PARK
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import understand
from neurosym.tasks.transition import validate

MOST_LED = 4
"""Objects that could be carried are led over cells, where no plan carries them, if there are no more.

With eight, the search for such a plan took tens of seconds, though some of them had no goal.
"""


def is_by_places(problem: Problem, grounding: Grounding) -> bool:
    """Say whether some object of a problem can be carried to its goal.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    if not (grounding.is_refined and carriers_of(grounding)):
        return False
    return any(name in problem.goals for name in understand(problem, grounding).carried)


def plan_by_places(
    problem: Problem, grounding: Grounding, solve: Callable[[Problem], PlanResult]
) -> PlanResult:
    """Plan for all objects at once, and believe the plan if its replay is right.

    Args:
        problem: The problem.
        grounding: The learned domain.
        solve: Gives it to a planner, in the encoding `places`.
    """
    problem = understand(problem, grounding).flat
    result = solve(problem)
    if result.status is PlanStatus.UNSOLVABLE:
        return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=_why_none(problem))
    if result.status is not PlanStatus.SOLVED:
        return result
    checked = validate(result.steps, problem, grounding)
    if checked.valid:
        return dataclasses.replace(result, steps=_clearest_first(result.steps, problem, grounding))
    reason = f"the plan with places is not true when replayed: {checked.reason}"
    return dataclasses.replace(result, status=PlanStatus.FAILED, steps=(), reason=reason)


def _why_none(problem: Problem) -> str:
    """Say with which places there is no plan; with others there may be one."""
    places = problem.places if isinstance(problem.places, dict) else {}
    parks = sum(name.startswith(PARK) for name in places)
    return f"there is no plan with the places of the problem, of which {parks} are free to park on"


def _clearest_first(
    steps: tuple[PlanStep, ...], problem: Problem, grounding: Grounding
) -> tuple[PlanStep, ...]:
    """Carry first what has most room, if nothing else is done and the plan stays true."""
    if not all(step.place for step in steps):
        return steps
    ordered = clearest_first(steps, problem)
    return ordered if validate(ordered, problem, grounding).valid else steps


def not_proved(result: PlanResult) -> PlanResult:
    """Say of what has no plan over cells that it was not found: something could have been carried.

    Args:
        result: What planning over cells came to.
    """
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    reason = f"no plan with the places that were drawn; without: {result.reason or 'unsolvable'}"
    return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=reason)


def not_found(result: PlanResult) -> PlanResult:
    """Say that there is no plan with the places that were drawn, and none over cells was looked for.

    Args:
        result: What planning with places came to.
    """
    if result.status is PlanStatus.TIMEOUT:
        return result
    said = result.reason or "no plan with the places that were drawn"
    reason = f"{said}; among more than {MOST_LED} objects, none is led over cells that could be carried"
    return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, steps=(), reason=reason)
