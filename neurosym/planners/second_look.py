"""What is found beyond a planner's own answer: nearest points, what counting knows, the next-best plans."""

import dataclasses
import math

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import EncodingName
from neurosym.planners.alternatives import alternatives
from neurosym.planners.counting import plan_counting
from neurosym.planners.no_plan import plan_nearest
from neurosym.planners.planner import Planner, PredictEffects
from neurosym.planners.registry import plan
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.related import is_relational
from neurosym.tasks.steps import PlanStep, primitives
from neurosym.wording import counted

WORK_TO_COUNT = 40_000
"""How much counting looks at for a plan by the rehearsed effects, where the planner has none."""


@dataclasses.dataclass(frozen=True, slots=True)
class Planned:
    """What was found for a problem.

    Attributes:
        result: What the planner says, or the plan to the nearest point.
        alternatives: The next-best plans, the best first.
    """

    result: PlanResult
    alternatives: tuple[tuple[PlanStep, ...], ...]


def plan_with_second_look(
    problem: Problem,
    grounding: Grounding,
    planner: Planner,
    *,
    predict: PredictEffects | None = None,
    time_limit: float | None = None,
    encoding: EncodingName | None = None,
    whole: bool = False,
    costs: bool = True,
    nearest: bool = False,
    more: int = 0,
) -> Planned:
    """Plan, and where there is no plan, say whether counting has one or go as near to the goal as can be.

    Args:
        problem: The problem.
        grounding: The learned domain.
        planner: The planner.
        predict: For planners that read the network, what it predicts.
        time_limit: The user's ceiling [s]; the planner's own if not given.
        encoding: For PDDL planners, the encoding of the domain, if not the usual one.
        whole: For PDDL planners, plan for all objects at once.
        costs: Whether steps cost the more the rarer they keep their promise.
        nearest: Whether to plan to the nearest points that can be reached, if there is no plan to the goals.
        more: How many of the next-best plans to look for, too.

    Raises:
        NeurosymError: As `plan` does.
        InvalidValue: If nearest points or next-best plans are asked for in a problem of relations.
    """
    by_relations = is_relational(problem, grounding)
    if by_relations and (nearest or more):
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, for which there are no nearest points and no "
            "next-best plans; leave these options out."
        )
    result = plan(
        problem,
        grounding,
        planner,
        predict=predict,
        time_limit=time_limit,
        encoding=encoding,
        whole=whole,
        costs=costs,
    )
    if by_relations:
        return Planned(result, ())
    if result.status in (PlanStatus.UNSOLVABLE, PlanStatus.NOT_FOUND, PlanStatus.FAILED):
        ceiling = math.inf if time_limit is None else time_limit
        if nearest:
            result = _nearest(result, problem, grounding, planner, ceiling)
        elif not planner.is_exact and (
            planner.reads == "network" or result.status is not PlanStatus.UNSOLVABLE
        ):
            result = _with_rehearsed(result, problem, grounding)
    if not more or result.status is not PlanStatus.SOLVED:
        return Planned(result, ())
    return Planned(result, alternatives(problem, grounding, more, besides=result.steps))


def _nearest(
    none: PlanResult, problem: Problem, grounding: Grounding, planner: Planner, time_limit: float
) -> PlanResult:
    """Plan as near to the goal as can be, and keep saying why the planner had no plan that comes nearer."""
    found = plan_nearest(problem, grounding, time_limit=time_limit)
    if not found.has_plan:
        status = found.status if found.status is PlanStatus.TIMEOUT else none.status
        reason = f"{none.reason}; {found.reason}"
        return PlanResult(status, (), none.seconds + found.seconds, reason)
    if found.status is PlanStatus.NEAREST:
        return dataclasses.replace(found, reason=f"{found.reason}; {none.reason}")
    over = ", over what the network predicts," if planner.reads == "network" else ""
    said = f"it meets the goal by the {grounding.operators.effects}; {planner.name}{over} found none"
    return dataclasses.replace(found, reason=said)


def _with_rehearsed(none: PlanResult, problem: Problem, grounding: Grounding) -> PlanResult:
    """Add to what a planner has no plan for whether counting has one."""
    found = plan_counting(problem, grounding, work=WORK_TO_COUNT)
    if found.status is not PlanStatus.SOLVED:
        return none
    count = counted(primitives(found.steps), "primitive")
    known = f"by the {grounding.operators.effects} there is a plan of {count}"
    return dataclasses.replace(none, reason=f"{none.reason}; {known}: try another planner, say counting")
