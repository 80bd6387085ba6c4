"""Planning for one object after another, and putting the plans together.

Objects do not interact but by standing in each other's way. So each gets a plan of its own, which is cheap
and makes every plan the cheapest; one that ends with its object held comes last. Where objects would end in
each other, or no order of the steps leads past one, ways around each other are looked for (see `around`).
If there are none, those in conflict are planned for again, with goals
narrowed to where counting, which looks at all objects together, would have them end. Those that are
still in conflict then are to end where there is room around them.
"""

import dataclasses
from collections import Counter
from collections.abc import Callable, Collection, Mapping
from functools import partial

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.planners.around import plan_around
from neurosym.planners.counting import plan_counting
from neurosym.planners.effort import PLACE, Effort
from neurosym.planners.joins import Join
from neurosym.planners.ordering import ends_held, mend
from neurosym.planners.parallel import plan_together
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.footprints import footprints_apart, overlapping
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import operator_for, validate

NARROWER = (3, 6)
"""By how much the goal of an object in conflict is narrowed, the first time and then."""
PARTINGS = 2
"""How often who is still in conflict then is sent to where there is room."""
WORK_TO_COUNT = 20_000
"""How much counting looks at to say where objects could end; see `Effort`."""
WORK_TO_PART = 2_000
"""How much is looked at to find room around objects; it is found at once, or there is little."""


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
    wanted = {name: _alone(problem, name, goal, problem.tolerance) for name, goal in problem.goals.items()}
    narrowed: Counter[str] = Counter()
    plans: dict[str, PlanResult] = {}
    aims: Float[np.ndarray, "M 3"] | None = None
    partings = 0
    while True:
        effort.check()
        parts = [effort.part for _ in wanted]
        tasks = zip(wanted.values(), parts, strict=True)
        results = plan_together([partial(believed, task, part) for task, part in tasks])
        effort.spend(sum(part.spent for part in parts[: len(results)]))
        last = results[-1].status
        if last is PlanStatus.TIMEOUT or (last is not PlanStatus.SOLVED and not plans):
            return results[-1]
        solved = [result for result in results if result.status is PlanStatus.SOLVED]
        plans |= zip(wanted, solved, strict=False)  # who has no plan for a narrower goal keeps the last one
        if sum(ends_held(plan.steps, grounding) for plan in plans.values()) > 1:
            return believed(problem, effort)
        steps, checked = mend(_joined(plans, problem, grounding), problem, grounding)
        if checked.valid:
            return PlanResult(PlanStatus.SOLVED, steps, 0.0, _remark(plans, narrowed))
        if not narrowed and not partings:
            around = plan_around(problem, grounding, deadline=effort.deadline)
            effort.spend(around.work)
            if around.status is PlanStatus.SOLVED:
                said = "objects would have stood in each other's way, so ways around each other were taken"
                return dataclasses.replace(around, reason=said)
        # Who is lifted last is on the table till then, and in the others' way.
        ends = _ends(steps[:-1] if ends_held(steps, grounding) else steps, problem, grounding)
        in_conflict = _in_conflict(ends, checked.concerned, problem)
        conflict = [name for name in in_conflict if narrowed[name] < len(NARROWER)]
        if conflict:
            aims = _aims(problem, grounding, effort) if aims is None else aims
            narrowed.update(conflict)
        elif partings < PARTINGS:
            partings, conflict = partings + 1, in_conflict
            aims = _aims_apart(problem, conflict, ends, grounding, effort)
        if aims is None or not conflict:
            reason = f"no plan was true when replayed; the last: {checked.reason}"
            return PlanResult(PlanStatus.FAILED, (), 0.0, reason)
        wanted = {
            name: _narrowed(problem, name, aims, problem.tolerance / NARROWER[narrowed[name] - 1])
            for name in conflict
        }


def _joined(plans: Mapping[str, PlanResult], problem: Problem, grounding: Grounding) -> tuple[PlanStep, ...]:
    """Put the plans one after another, the one that ends with its object held last."""
    ordered = sorted(problem.goals, key=lambda name: ends_held(plans[name].steps, grounding))
    return tuple(step for name in ordered for step in plans[name].steps)


def _remark(plans: Mapping[str, PlanResult], narrowed: Collection[str]) -> str:
    if narrowed:
        names = ", ".join(sorted(narrowed))
        return f"goals were narrowed ({names}), for objects would have stood in each other's way"
    return next((plan.reason for plan in plans.values() if plan.reason), "")


def _aims(problem: Problem, grounding: Grounding, effort: Effort) -> Float[np.ndarray, "M 3"] | None:
    """Return where objects can end together [m], or None if counting finds no plan."""
    effort.check()
    found = plan_counting(problem, grounding, work=WORK_TO_COUNT)
    effort.spend(found.work)
    if found.status is not PlanStatus.SOLVED:
        return None
    return np.asarray(validate(found.steps, problem, grounding).positions[-1])


def _aims_apart(
    problem: Problem,
    names: Collection[str],
    ends: Float[np.ndarray, "M 3"],
    grounding: Grounding,
    effort: Effort,
) -> Float[np.ndarray, "M 3"] | None:
    """Return where some objects can end [m], while the others end as planned, with room around them.

    Each may end anywhere in the smallest ball around its aim without standing in another.
    """
    room = problem.tolerance / NARROWER[-1]
    items = [
        _wider(item, 2 * room) if item.name in names else msgspec.structs.replace(item, position=vector(end))
        for item, end in zip(problem.objects, ends, strict=True)
    ]
    goals = {name: problem.goals[name] for name in names}
    task = msgspec.structs.replace(
        problem, objects=tuple(items), goals=goals, tolerance=problem.tolerance - room
    )
    part = Effort(WORK_TO_PART, effort.deadline)
    steps = next(Join(task, grounding, part).plans(), None)
    effort.spend(PLACE * part.spent)
    return None if steps is None else _ends(steps, task, grounding)


def _wider(item: SceneObject, by: float) -> SceneObject:
    width, depth, *others = item.features
    return msgspec.structs.replace(item, features=(width + by, depth + by, *others))


def _ends(steps: tuple[PlanStep, ...], problem: Problem, grounding: Grounding) -> Float[np.ndarray, "M 3"]:
    """Return where steps lead each object [m], possible or not."""
    ends = problem.scene().positions
    for step in steps:
        operator = operator_for(step, problem, grounding)
        by = grounding.put_down_displacement if step.puts_down else grounding.displacement
        ends[problem.object_names.index(step.object)] += by(operator)
    return ends


def _in_conflict(ends: Float[np.ndarray, "M 3"], concerned: Collection[str], problem: Problem) -> list[str]:
    """Name the objects with goals that end in another; if there are none, those that the replay concerns."""
    apart = footprints_apart(problem)
    hits = [overlapping(ends[row, :2], ends[:, :2], apart[row]).any() for row in range(len(ends))]
    ending = [
        name for name, hit in zip(problem.object_names, hits, strict=True) if hit and name in problem.goals
    ]
    concerned = [name for name in problem.goals if name in concerned]
    return ending or concerned or list(problem.goals)


def _narrowed(problem: Problem, name: str, aims: Float[np.ndarray, "M 3"], radius: float) -> Problem:
    """Make the goal of an object a ball of a radius that holds its aim and lies within what is allowed."""
    goal = np.array(problem.goals[name])
    away = aims[problem.object_names.index(name)] - goal
    shrunk = min(1.0, (problem.tolerance - radius) / max(float(np.linalg.norm(away)), radius))
    x, y, z = (goal + shrunk * away).tolist()
    return _alone(problem, name, (x, y, z), radius)


def _alone(problem: Problem, name: str, goal: Vector, tolerance: float) -> Problem:
    item = problem.object_named(name)
    return msgspec.structs.replace(problem, objects=(item,), goals={name: goal}, tolerance=tolerance)
