"""Trials: a task is planned once, and the plan is followed blindly and with replanning; kept in short."""

import math
from collections.abc import Iterable, Sequence
from typing import Any

import msgspec

from neurosym.evaluation.comparison import Setting, planner_of
from neurosym.execution.executor import execute
from neurosym.execution.performance import failure
from neurosym.execution.record import Run, StepRecord
from neurosym.grounding import Grounding, at_rest
from neurosym.operators import Vector
from neurosym.planners import PlanStatus
from neurosym.problems import Problem, SceneObject
from neurosym.stages.plan_records import MORE_MOTIONS
from neurosym.tasks.promises import promised
from neurosym.tasks.transition import expected_success, expected_within, primitives
from tools.benchmarks.jobs import Found, cpu_seconds

PLANNER = "fast-downward"


class Step(msgspec.Struct, frozen=True, array_like=True):
    """One step of a run, lengths in whole millimetres."""

    operator: str
    object: int  # its number, counted from 0
    category: str  # symbol of the category that it was taken for
    promised: int | None  # how far it was to move; None if the operator never promised anything
    moved: int
    error: float | None  # distance between the two displacements, in tenths of a millimetre
    kind_promised: str | None  # how it was to end, and how it did
    kind_seen: str
    others: tuple[str, ...] = ()  # how other objects ended that ended elsewhere


class Followed(msgspec.Struct, frozen=True, omit_defaults=True):
    """What became of a plan in the world."""

    reached: bool  # whether every goal was met at the end
    ended: str  # what ended the run
    kind: str  # why it missed, in a few words, to be counted
    reason: str  # the same in a sentence
    distances: tuple[float, ...]  # how far each object ended from its goal [m]
    steps: tuple[Step, ...]  # the primitives that were performed
    replans: tuple[int, ...] = ()  # before which steps a new plan was asked for, counted from 0


class Trial(msgspec.Struct, frozen=True, omit_defaults=True):
    """What became of one task."""

    task: str
    status: str  # how the search for a plan ended
    reason: str = ""  # why there is no plan
    primitives: int = 0  # of the first plan
    chance: float | None = None  # printed with the plan: that it comes true
    chance_replanned: float | None = None  # to be there within `MORE_MOTIONS` motions more than it has
    blind: Followed | None = None  # None if that was not asked for
    replanned: Followed | None = None  # None without a plan
    cpu: float = 0.0  # what all of it took [CPU s]


def try_task(setting: Setting, task: Problem, *, blind: bool, time_limit: float | None = None) -> Trial:
    """Plan for a task, in so many seconds, and execute the plan with replanning, and perhaps blindly."""
    begin, grounding = cpu_seconds(), setting.grounding
    solve = planner_of(setting, PLANNER, time_limit=time_limit)
    found = solve(task, grounding)
    if found.status is not PlanStatus.SOLVED:
        return Trial(task.name, found.status.value, found.reason, cpu=cpu_seconds() - begin)
    replanned = execute(setting.world, task, grounding, found.steps, replanner=solve)
    followed = None
    if blind:  # a run in which nothing was planned anew is the one that follows the plan blindly
        anew = bool(replanned.replannings)
        run = execute(setting.world, task, grounding, found.steps) if anew else replanned
        followed = shortened(run, task, grounding)
    count = primitives(found.steps)
    within = expected_within(found.steps, task, grounding, count + MORE_MOTIONS)
    return Trial(
        task=task.name,
        status=found.status.value,
        primitives=count,
        chance=round(expected_success(found.steps, task, grounding), 4),
        chance_replanned=round(within, 4),
        blind=followed,
        replanned=shortened(replanned, task, grounding),
        cpu=round(cpu_seconds() - begin, 2),
    )


def shortened(run: Run, task: Problem, grounding: Grounding) -> Followed:
    """Keep of a run what is counted."""
    before = {item.name: item.position for item in task.objects}
    steps = []
    for record in run.steps:
        steps.append(_step(record, task, grounding, before[record.object]))
        before = record.positions
    return Followed(
        reached=run.reached,
        ended=run.ended,
        kind="" if run.reached else failure(run),
        reason=run.reason,
        distances=tuple(round(distance, 4) for distance in run.distances.values()),
        steps=tuple(steps),
        replans=tuple(replanning.before_step - 1 for replanning in run.replannings),
    )


def _step(record: StepRecord, task: Problem, grounding: Grounding, before: Vector) -> Step:
    item = task.object_named(record.object)
    aim, moved, error = record.promised_effect, record.effect, record.deviation
    kinds = {record.promised, record.happened}
    if record.put_down and "held" in kinds <= {"held", "resting"}:  # what counts is where it was put down
        aim = resting_promise(record.operator, item, task.tolerance, grounding)
        after = record.positions[record.object]
        moved = (after[0] - before[0], after[1] - before[1], 0.0)
        error = math.dist(moved, aim)
    return Step(
        operator=record.operator,
        object=task.object_names.index(record.object),
        category=grounding.operator_named(record.operator).subject,
        promised=None if aim is None else round(1000 * math.hypot(*aim)),
        moved=round(1000 * math.hypot(*moved)),
        error=None if error is None else round(1000 * error, 1),
        kind_promised=record.promised,
        kind_seen=record.happened,
        others=tuple(record.disturbed.values()),
    )


def resting_promise(name: str, item: SceneObject, tolerance: float, grounding: Grounding) -> Vector:
    """Return where an operator promises to bring an object once nothing is held any more [m]."""
    learned = grounding.operator_named(name)
    one_of_these = msgspec.structs.replace(item, category=learned.subject)  # as it was when last seen
    operator = promised(grounding, one_of_these, tolerance).get(name, learned)
    assert operator.promise is not None, "it promised to end held, or at rest"
    return at_rest(operator.promise)


def tried(
    setting: Setting, tasks: Iterable[Problem], *, blind: bool = True, time_limit: float | None = None
) -> list[Any]:
    """Try tasks, see `try_task`; return what JSON can hold."""
    return to_json([try_task(setting, task, blind=blind, time_limit=time_limit) for task in tasks])


def to_json(trials: Sequence[Trial]) -> list[Any]:
    """Turn trials into what JSON can hold."""
    found: list[Any] = msgspec.to_builtins(list(trials))
    return found


def trials_of(found: Found, names: Iterable[str]) -> list[Trial]:
    """Read the trials of several jobs; those of jobs that are not done are missing."""
    return msgspec.convert([entry for name in names for entry in found.get(name, [])], list[Trial])
