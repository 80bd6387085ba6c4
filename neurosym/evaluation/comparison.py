"""Comparing planners: each plans for the same drawn task, and its plan is replayed and executed.

The paper's search trusts the network's predictions, the PDDL planners trust the table of operators. So a plan
is judged three times: by the operators' promises, by the network's predictions, and by the world, where it is
once followed blindly and once with replanning by the planner that made it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.cells import at_rest
from neurosym.errors import InvalidPlanner, InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.execution.summary import Execution, summarise_run
from neurosym.grounding import Grounding, is_lift
from neurosym.planners.catalogue import PLANNERS
from neurosym.planners.planner import PredictEffects
from neurosym.planners.registry import Replanner, plan, planner_named
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.related import is_reached, is_relational
from neurosym.tasks.places import with_places
from neurosym.tasks.steps import PlanStep, Steps, named_steps, primitives
from neurosym.tasks.transition import Replay, validate
from neurosym.world import World

NOT_VALID = Literal["", "impossible", "elsewhere"]


@dataclass(frozen=True, slots=True)
class Setting:
    """What planners are compared in.

    Attributes:
        world: Where plans are executed.
        grounding: The learned domain.
        predict: What the network predicts.
    """

    world: World
    grounding: Grounding
    predict: PredictEffects


class Attempt(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One planner on one task.

    Attributes:
        status: How its search ended.
        reason: Why there is no plan, or what is to be said about the one found.
        steps: Operator and object of each step.
        seconds: How long it took [s].
        primitives: How many steps are primitives, and no put-downs.
        invalid: What the replay with the operators' promises finds: nothing, a step that is impossible, or an
            end elsewhere than at the goal.
        replayed: The same in a sentence.
        promised_miss: How far from its goal the worst object ends by the operators [m]; None if impossible.
        predicted_miss: The same by the network.
        left_out: Whether the plan uses an operator that the PDDL domain leaves out.
        depth: How many primitives were looked ahead, by a search that ended there.
        open_loop: What became of the plan followed blindly; None without one.
        replanned: What became of it with replanning; None without one.
    """

    status: PlanStatus
    reason: str
    steps: Steps = ()
    seconds: float = 0.0
    primitives: int = 0
    invalid: NOT_VALID = ""
    replayed: str = ""
    promised_miss: float | None = None
    predicted_miss: float | None = None
    left_out: bool = False
    depth: int | None = None
    open_loop: Execution | None = None
    replanned: Execution | None = None

    @property
    def found(self) -> bool:
        """Whether there is a plan."""
        return self.status is PlanStatus.SOLVED

    @property
    def valid(self) -> bool:
        """Whether there is a plan that the operators promise to reach the goal."""
        return self.found and not self.invalid


class TaskRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What each planner made of one task.

    Attributes:
        problem: The task.
        met_at_start: Whether there is nothing to plan; then there are no attempts.
        attempts: By the planner's name.
    """

    problem: Problem
    met_at_start: bool
    attempts: dict[str, Attempt] = {}


def check_planners(planners: Sequence[str], domain_folder: Path) -> None:
    """Raise `UnknownChoice` unless all planners exist, and `InvalidValue` if there are none.

    Args:
        planners: Their names.
        domain_folder: Where the domain lies, which must not bring code of its own.
    """
    if not planners:
        raise InvalidValue(f"Name at least one planner; valid: {', '.join(sorted(PLANNERS))}.")
    for name in planners:
        planner_named(name, domain_folder)


def compare(
    setting: Setting,
    problem: Problem,
    planners: Sequence[str],
    *,
    time_limit: float | None = None,
    executed: bool = True,
) -> TaskRecord:
    """Have each planner plan for a task, and judge its plan.

    Args:
        setting: What to compare in.
        problem: The task.
        planners: Names of planners; see `planner_named`.
        time_limit: The user's ceiling for each [s]; its own if not given.
        executed: Whether plans are executed in the world.
    """
    if is_reached(problem, setting.grounding):
        return TaskRecord(problem, met_at_start=True)
    attempts = {
        name: _attempt(setting, problem, name, time_limit=time_limit, executed=executed) for name in planners
    }
    return TaskRecord(problem, met_at_start=False, attempts=attempts)


def planner_of(setting: Setting, name: str, *, time_limit: float | None) -> Replanner:
    """Return a planner as a function from a problem to its result; it may read the network's predictions.

    Args:
        setting: What to plan in.
        name: Name of the planner.
        time_limit: The user's ceiling [s]; its own if not given.
    """
    planner = planner_named(name)

    def solve(problem: Problem, grounding: Grounding) -> PlanResult:
        try:
            return plan(problem, grounding, planner, predict=setting.predict, time_limit=time_limit)
        except InvalidPlanner:
            raise
        except (UnknownChoice, InvalidValue) as error:  # a category never rehearsed, an object off the table
            return PlanResult(PlanStatus.FAILED, (), 0.0, str(error))

    return solve


def _attempt(
    setting: Setting, problem: Problem, name: str, *, time_limit: float | None, executed: bool
) -> Attempt:
    solve = planner_of(setting, name, time_limit=time_limit)
    result = solve(problem, setting.grounding)
    steps = result.steps
    if result.status is not PlanStatus.SOLVED:
        return Attempt(result.status, result.reason, seconds=round(result.seconds, 4), depth=result.depth)
    replayed = validate(steps, problem, setting.grounding)
    blind, replanned = _follow(setting, problem, steps, solve) if executed else (None, None)
    return Attempt(
        status=result.status,
        reason=result.reason,
        steps=named_steps(steps),
        seconds=round(result.seconds, 4),
        primitives=primitives(steps),
        invalid=_invalid(replayed),
        replayed=replayed.reason,
        promised_miss=_worst(problem, replayed.positions[-1]) if replayed.possible else None,
        predicted_miss=_worst(problem, predicted_end(setting, problem, steps)),
        left_out=any(step.base in setting.grounding.left_out for step in steps),
        open_loop=blind,
        replanned=replanned,
    )


def predicted_end(setting: Setting, problem: Problem, steps: Sequence[PlanStep]) -> Float[np.ndarray, "M 3"]:
    """Follow a plan by the network's predictions; where a put-down lands is what the rehearsals saw.

    What is carried to a place is taken to stand there: the network of displacements knows nothing of places,
    and nothing of relations, of which the promises are taken.

    Args:
        setting: Where the network is.
        problem: What the plan is for.
        steps: The plan.

    Returns:
        Centres of the objects at its end [m].
    """
    grounding, positions = setting.grounding, problem.scene().positions
    if is_relational(problem, grounding):
        return np.asarray(validate(steps, problem, grounding).positions[-1])
    placed = with_places(problem, grounding)
    symbols = grounding.operators.symbols
    effects = setting.predict(problem.scene().features)  # (M, P, 3)
    for step, then in zip(steps, [*steps[1:], None], strict=True):
        if step.puts_down:
            continue
        operator, moved = grounding.operator_named(step.operator), problem.object_names.index(step.object)
        if step.place:
            positions[moved, :2] = placed.place_named(step.place)
            continue
        put_down = is_lift(operator) and then is not None and then.puts_down
        promise = operator.promise if put_down else None
        positions[moved] += at_rest(promise) if promise else effects[moved, symbols.index(operator.primitive)]
    return positions


def _worst(problem: Problem, positions: Float[np.ndarray, "M 3"]) -> float:
    return round(max(problem.distances(positions).values(), default=0.0), 6)


def _invalid(replayed: Replay) -> NOT_VALID:
    if replayed.valid:
        return ""
    return "elsewhere" if replayed.possible else "impossible"


def _follow(
    setting: Setting, problem: Problem, steps: Sequence[PlanStep], solve: Replanner
) -> tuple[Execution, Execution]:
    """Execute a plan, blindly and with replanning."""
    world, grounding = setting.world, setting.grounding
    replanned = execute(world, problem, grounding, steps, replanner=solve)
    # A run in which nothing was planned anew is the one that follows the plan blindly.
    blind = execute(world, problem, grounding, steps) if replanned.replannings else replanned
    return summarise_run(blind, grounding), summarise_run(replanned, grounding)
