"""From a problem to a plan that is believed: print PDDL, call a planner, read the plan, replay it.

Objects do not interact in our domains. So a problem with several goals is solved one object at a time, which
is cheap and makes every plan the cheapest, and the plans are put one after another; one that ends with its
object held comes last. A replay with exact displacements then says whether the plan is true. If it is not,
its steps are put in another order, and if that does not help, it is planned again with smaller goal regions.
"""

import dataclasses
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import msgspec

from neurosym.errors import UnknownChoice
from neurosym.pddl.domain import domain_text
from neurosym.pddl.grounding import Grounding
from neurosym.pddl.moves import Encoding
from neurosym.pddl.plan_text import PlanStep, parse_plan
from neurosym.pddl.problem import STEPS, problem_text
from neurosym.planners.bfs import explain_miss
from neurosym.planners.branching import branching_of
from neurosym.planners.fast_downward import plan_fast_downward
from neurosym.planners.ordering import ends_held, mend
from neurosym.planners.result import PlannerAnswer, PlanResult, PlanStatus
from neurosym.planners.unified_planning import plan_unified_planning
from neurosym.problems import Problem

PddlPlanner = Callable[..., PlannerAnswer]
PDDL_PLANNERS: dict[str, PddlPlanner] = {
    "fast-downward": plan_fast_downward,
    "up-fast-downward": plan_unified_planning,
}
ATTEMPTS = 3
"""How often a problem is solved before its replay must be right."""


@dataclasses.dataclass(frozen=True, slots=True)
class _Slack:
    """How far plans must keep from the edge of what is allowed.

    Attributes:
        steps: How many steps the rounding of is taken off the goal regions.
        margin: How many cells at the edges of the table are not used.
    """

    steps: int
    margin: int


def plan_pddl(
    problem: Problem,
    grounding: Grounding,
    planner: str = "fast-downward",
    *,
    time_limit: float = 60.0,
    encoding: Encoding = "stepwise",
) -> PlanResult:
    """Solve a problem with a PDDL planner, and believe the plan only if its exact replay is right.

    Args:
        problem: The problem.
        grounding: The learned domain.
        planner: Name of the planner, a key of `PDDL_PLANNERS`.
        time_limit: When to give up [s].
        encoding: The encoding of the domain.

    Raises:
        UnknownChoice: If there is no such planner or encoding, or an object's category is unknown.
        InvalidValue: If an object stands off the table, or its name means something else in the domain.
    """
    if planner not in PDDL_PLANNERS:
        raise UnknownChoice("planner", planner, PDDL_PLANNERS)
    begin = time.perf_counter()
    if problem.is_met(problem.scene().positions):
        return PlanResult(PlanStatus.SOLVED, (), 0.0, "the goal is met at the start")
    if len(in_the_air := _in_the_air(problem)) > 1:
        reason = f"{' and '.join(in_the_air)} would have to be held at the end, and there is one hand"
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)

    def solve(task: Problem, slack: _Slack) -> PlanResult:
        left = time_limit - (time.perf_counter() - begin)
        return _solve(task, grounding, PDDL_PLANNERS[planner], left, encoding, slack)

    result = _plan_and_replay(problem, grounding, solve)
    return dataclasses.replace(result, seconds=time.perf_counter() - begin)


def _in_the_air(problem: Problem) -> list[str]:
    """List the objects whose goal is too high, or too low, to be met at rest."""
    items = ((name, problem.object_named(name), goal) for name, goal in problem.goals.items())
    return [name for name, item, goal in items if abs(goal[2] - item.position[2]) > problem.tolerance]


def _plan_and_replay(
    problem: Problem, grounding: Grounding, solve: Callable[[Problem, _Slack], PlanResult]
) -> PlanResult:
    slack, said = _Slack(STEPS, 0), ""
    for attempt in range(1, ATTEMPTS + 1):
        result = _plan_once(problem, grounding, solve, slack)
        if result.status is PlanStatus.UNSOLVABLE and slack.steps:
            # The regions may have been shrunk too far: what has no plan without that has none at all.
            result = _plan_once(problem, grounding, solve, _Slack(0, slack.margin))
        if result.status is not PlanStatus.SOLVED:
            return _explained(result, problem, grounding)
        steps, checked = mend(result.steps, problem, grounding)
        if checked.valid:
            return dataclasses.replace(result, steps=steps, reason=said)
        said = f"attempt {attempt + 1}, after a replay that said: {checked.reason}"
        slack = _Slack(max(2 * slack.steps, len(steps)), slack.margin + 1)
    reason = f"no plan was true when replayed, in {ATTEMPTS} attempts; the last: {checked.reason}"
    return PlanResult(PlanStatus.FAILED, (), 0.0, reason)


def _plan_once(
    problem: Problem, grounding: Grounding, solve: Callable[[Problem, _Slack], PlanResult], slack: _Slack
) -> PlanResult:
    """Solve a problem one object at a time, or whole if the hand would have to hold two in the end."""
    if len(problem.goals) == 1:
        return solve(problem, slack)
    plans: list[tuple[PlanStep, ...]] = []
    for name, goal in problem.goals.items():
        alone = msgspec.structs.replace(problem, objects=(problem.object_named(name),), goals={name: goal})
        result = solve(alone, slack)
        if result.status is not PlanStatus.SOLVED:
            return result
        plans.append(result.steps)
    held = [plan for plan in plans if ends_held(plan, grounding)]
    if len(held) > 1:
        return solve(problem, slack)
    resting = [plan for plan in plans if not ends_held(plan, grounding)]
    return PlanResult(PlanStatus.SOLVED, tuple(step for plan in [*resting, *held] for step in plan), 0.0)


def _solve(
    problem: Problem,
    grounding: Grounding,
    planner: PddlPlanner,
    time_limit: float,
    encoding: Encoding,
    slack: _Slack,
) -> PlanResult:
    """Print domain and problem, call the planner, and read what it wrote."""
    if problem.is_met(problem.scene().positions):
        return PlanResult(PlanStatus.SOLVED, (), 0.0)
    narrowed = grounding.narrowed({item.category for item in problem.objects})
    with tempfile.TemporaryDirectory(prefix="neurosym-pddl-") as name:
        domain, task = Path(name) / "domain.pddl", Path(name) / "problem.pddl"
        domain.write_text(domain_text(narrowed, encoding))
        task.write_text(problem_text(problem, narrowed, encoding, steps=slack.steps, margin=slack.margin))
        answer = planner(domain, task, time_limit=time_limit)
        steps = parse_plan(answer.text, Path(name) / "plan", grounding, problem)
    return PlanResult(answer.status, steps, answer.seconds, answer.reason)


def _explained(result: PlanResult, problem: Problem, grounding: Grounding) -> PlanResult:
    """Add to a result without a plan which goal is out of reach, if it was proved that there is none."""
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    branching, _ = branching_of(problem, grounding)
    miss = explain_miss(problem, branching, grounding.table)
    return dataclasses.replace(result, reason="; ".join(filter(None, (result.reason, miss))))
