"""What is found beyond a planner's own answer: nearest points, what counting knows, the next-best plans."""

import dataclasses

from neurosym.grounding import Grounding
from neurosym.pddl.moves import Encoding
from neurosym.pddl.plan_text import PlanStep
from neurosym.planners.alternatives import alternatives
from neurosym.planners.counting import plan_counting
from neurosym.planners.no_plan import plan_nearest
from neurosym.planners.planner import Planner, PredictEffects
from neurosym.planners.registry import plan
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem

TIME_TO_COUNT = 5.0
"""How long to look for a plan by the rehearsed effects, where the planner has none [s]."""


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
    time_limit: float = 60.0,
    encoding: Encoding | None = None,
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
        time_limit: When to give up [s].
        encoding: For PDDL planners, the encoding of the domain, if not the usual one.
        whole: For PDDL planners, plan for all objects at once.
        costs: Whether steps cost the more the rarer they keep their promise.
        nearest: Whether to plan to the nearest points that can be reached, if there is no plan to the goals.
        more: How many of the next-best plans to look for, too.

    Raises:
        NeurosymError: As `plan` does.
    """
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
    if result.status in (PlanStatus.UNSOLVABLE, PlanStatus.FAILED):
        is_limited = planner.depth is not None or result.status is PlanStatus.FAILED
        if nearest:
            result = _nearest(result, problem, grounding, planner, time_limit)
        elif is_limited and not planner.is_exact:
            result = _with_rehearsed(result, problem, grounding, time_limit)
    count = more if result.status is PlanStatus.SOLVED else 0
    others = alternatives(problem, grounding, count, besides=result.steps, time_limit=time_limit)
    return Planned(result, tuple(others))


def _nearest(
    none: PlanResult, problem: Problem, grounding: Grounding, planner: Planner, time_limit: float
) -> PlanResult:
    """Plan as near to the goal as can be, and keep saying why the planner had no plan that comes nearer."""
    found = plan_nearest(problem, grounding, time_limit=time_limit)
    if not found.has_plan:
        reason = f"{none.reason}; {found.reason}"
        return dataclasses.replace(none, seconds=none.seconds + found.seconds, reason=reason)
    if found.status is PlanStatus.NEAREST:
        return dataclasses.replace(found, reason=f"{found.reason}; {none.reason}")
    over = ", over what the network predicts," if planner.reads == "network" else ""
    said = f"it meets the goal by the rehearsed effects; {planner.name}{over} found none"
    return dataclasses.replace(found, reason=said)


def _with_rehearsed(
    none: PlanResult, problem: Problem, grounding: Grounding, time_limit: float
) -> PlanResult:
    """Add to what a planner has no plan for whether exact counting has one."""
    found = plan_counting(problem, grounding, time_limit=min(time_limit, TIME_TO_COUNT))
    if found.status is not PlanStatus.SOLVED:
        return none
    count = sum(not step.puts_down for step in found.steps)
    known = f"by the rehearsed effects there is a plan of {count} primitive{'' if count == 1 else 's'}"
    return dataclasses.replace(none, reason=f"{none.reason}; {known}: try another planner, say counting")
