"""Planning for one object after another, and putting the plans together.

Objects do not interact but by standing in each other's way. So each gets a plan of its own, which is cheap
and makes every plan the cheapest; one that ends with its object held comes last. Where objects would end in
each other, or no order of the steps leads past one, ways around each other are looked for (see `around`), and
last the fewest primitives with which all objects end apart (see `counting`).
"""

import dataclasses
from collections.abc import Callable, Iterator, Mapping
from functools import partial

import msgspec

from neurosym.grounding import Grounding
from neurosym.planners.around import plan_around
from neurosym.planners.counting import plan_counting
from neurosym.planners.effort import Effort
from neurosym.planners.ordering import ends_held, mend
from neurosym.planners.parallel import plan_together
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.steps import PlanStep

WORK_TO_COUNT = 20_000
"""How much counting looks at; see `Effort`."""
JOINED = "joined from plans of single objects"
"""What is said of a plan that was made so."""


def plan_one_by_one(
    problem: Problem,
    grounding: Grounding,
    believed: Callable[[Problem, Effort], PlanResult],
    effort: Effort | None = None,
) -> PlanResult:
    """Solve a problem one object at a time; whole, if the hand would have to hold two in the end.

    Args:
        problem: The problem.
        grounding: The learned domain.
        believed: Solves a problem such that the replay of the plan is right, with what may be spent.
        effort: What may be spent [states], if not everything.

    Raises:
        TimeIsUp: If the deadline passes.
        WorkIsUp: If nothing may be spent any longer.
    """
    effort = effort or Effort()
    effort.check()
    parts = [effort.part for _ in problem.goals]
    tasks = zip(problem.goals, parts, strict=True)
    results = plan_together([partial(believed, _alone(problem, name), part) for name, part in tasks])
    effort.spend(sum(part.spent for part in parts[: len(results)]))
    if results[-1].status is not PlanStatus.SOLVED:
        return results[-1]
    plans = dict(zip(problem.goals, results, strict=True))
    if sum(ends_held(plan.steps, grounding) for plan in results) > 1:
        return believed(problem, effort)
    steps, checked = mend(_joined(plans, problem, grounding), problem, grounding)
    if checked.valid:
        said = "; ".join(dict.fromkeys((JOINED, *filter(None, (plan.reason for plan in results)))))
        return PlanResult(PlanStatus.SOLVED, steps, 0.0, said)
    for said, other in _other_ways(problem, grounding, effort):
        effort.spend(other.work)
        if other.status is PlanStatus.SOLVED:
            said = f"{JOINED}: they would have stood in each other's way, so {said}"
            return dataclasses.replace(other, reason=said)
    reason = f"no plan was true when replayed; the last: {checked.reason}"
    return PlanResult(PlanStatus.FAILED, (), 0.0, reason)


def _other_ways(problem: Problem, grounding: Grounding, effort: Effort) -> Iterator[tuple[str, PlanResult]]:
    """Plan for objects that stand in each other's way; say what that means, too."""
    yield "ways around each other were taken", plan_around(problem, grounding, deadline=effort.deadline)
    effort.check()
    yield "as few steps as possible were taken", plan_counting(problem, grounding, work=WORK_TO_COUNT)


def _joined(plans: Mapping[str, PlanResult], problem: Problem, grounding: Grounding) -> tuple[PlanStep, ...]:
    """Put the plans one after another, the one that ends with its object held last."""
    ordered = sorted(problem.goals, key=lambda name: ends_held(plans[name].steps, grounding))
    return tuple(step for name in ordered for step in plans[name].steps)


def _alone(problem: Problem, name: str) -> Problem:
    item, goal = problem.object_named(name), problem.goals[name]
    return msgspec.structs.replace(problem, objects=(item,), goals={name: goal})
