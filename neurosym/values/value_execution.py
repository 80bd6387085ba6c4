"""Performing plans with values: step by step, and with a new plan where things did not go as promised."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidValue, InvalidWorld, one_called
from neurosym.planners.planner import PlanResult
from neurosym.tasks.transition import PlanStep
from neurosym.values.problem import ValueTask

FORMAT = "neurosym-value-run-1"
LEARNED = 5
"""A step that did not go as promised counts as so many trials that failed, when a new plan is made."""
Perform = Callable[[Float[np.ndarray, "S"], Float[np.ndarray, "A"]], Float[np.ndarray, "S"]]
"""What becomes of the state of a thing by an action; see `StateWorld`."""
Solve = Callable[[ValueTask], PlanResult]


class ValueStep(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What one step did: values along each axis as promised, and as they came."""

    operator: str
    thing: str
    promised: tuple[float, ...]
    happened: tuple[float, ...]
    as_promised: bool  # whether each axis came within its tolerance


class ValueRun(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What became of a plan."""

    format: str
    problem: str
    steps: tuple[ValueStep, ...]
    reached: bool
    reason: str  # why the goal was not reached; empty if it was
    replans: int  # how many new plans were made


def execute_values(
    task: ValueTask,
    steps: Sequence[PlanStep],
    perform: Perform,
    *,
    solve: Solve | None = None,
    replans: int = 0,
) -> ValueRun:
    """Perform a plan, and ask for a new one where what is left of it would miss the goal.

    Raises:
        InvalidWorld: If the world fails.
    """
    now, left, done, asked = task, [*steps], list[ValueStep](), 0
    failed, stuck = Counter[str](), ""

    def ended(reason: str) -> ValueRun:
        return ValueRun(FORMAT, task.problem.name, tuple(done), not reason, reason, asked)

    while True:
        reason = now.replay(left)[1] if left else now.strays()
        if reason and solve and asked < replans:
            asked += 1
            result = solve(_doubting(now, failed))
            left, reason = [*result.steps], "" if result.has_plan else result.reason
            stuck = reason
        if not left or (reason and solve):
            missed = now.strays()
            return ended(missed and (stuck or missed))
        step, *left = left
        try:
            told, now = _performed(now, step, perform)
        except InvalidWorld:
            raise
        except InvalidValue as error:
            return ended(f"{step.object} came to where nothing is known: {str(error).rstrip('.')}")
        done.append(told)
        failed[step.operator] += not told.as_promised


def _doubting(task: ValueTask, failed: Mapping[str, int]) -> ValueTask:
    """Return the task with operators that failed believed less."""
    operators = tuple(
        msgspec.structs.replace(one, trials=one.trials + LEARNED * failed.get(one.name, 0))
        for one in task.domain.operators
    )
    return ValueTask(task.problem, msgspec.structs.replace(task.domain, operators=operators))


def _performed(task: ValueTask, step: PlanStep, perform: Perform) -> tuple[ValueStep, ValueTask]:
    """Perform a step; return what came of it, and the task from there."""
    domain, operator = task.domain, task.domain.operator_named(step.operator)
    thing = one_called("thing", step.object, task.problem.things)
    hidden = (thing.values.get(name, 0.0) for name in domain.hidden)
    state = np.array([*thing.features, *hidden], dtype=float)
    after = perform(state, np.array(domain.primitive_of(operator).action, dtype=float)).tolist()
    features = after[: len(thing.features)]
    values = dict(zip(domain.hidden, after[len(thing.features) :], strict=True))
    promised, happened, is_near = list[float](), list[float](), True
    ends = domain.values_of(thing.features, thing.values), domain.values_of(features, values)
    for one, cells, before, came in zip(operator.outcome.steps, domain.cells, *ends, strict=True):
        led = cells.centre(one.to) if one.to is not None else before + one.by * cells.size
        promised.append(round(came + cells.axis.apart(led, came), 6))
        happened.append(round(came, 6))
        near = max(cells.axis.tolerance or 0.0, cells.size / 2)
        is_near = is_near and abs(cells.axis.apart(came, led)) <= near
    told = ValueStep(operator.name, thing.name, tuple(promised), tuple(happened), is_near)
    changed = msgspec.structs.replace(thing, features=tuple(features), values=values)
    return told, task.begun_from(changed)
