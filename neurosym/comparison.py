"""Comparing planners: each plans for the same drawn task, and its plan is replayed and executed.

The paper's search trusts the network's predictions, the PDDL planners trust the table of operators. So a plan
is judged three times: by the operators' promises, by the network's predictions, and by the world, where it is
once followed blindly and once with replanning by the planner that made it.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.execution import Run, execute
from neurosym.pddl.grounding import Grounding, at_rest, is_lift
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.replay import Replay, replay
from neurosym.planners import PLANNERS, PlanResult, PlanStatus, plan, predicted_branching
from neurosym.problems import Problem
from neurosym.world import World

Predict = Callable[[Float[np.ndarray, "M F"]], Float[np.ndarray, "M P 3"]]
"""Says what the network predicts each primitive to do to each object [m]."""
NETWORK_BFS, OPERATORS_BFS = "bfs", "bfs-operators"
COMPARED = {**PLANNERS, OPERATORS_BFS: "the same search over what the operators promise"}
"""The planners that can be compared."""
Replanner = Callable[[Problem, Grounding], PlanResult]
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
    predict: Predict


class Execution(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What became of a plan in the world, in short.

    Attributes:
        reached: Whether every goal was met at the end.
        reason: Why not, or empty.
        kind: The same in a few words, to be counted.
        distances: How far each object with a goal ended from it [m].
        interactions: How many primitives were performed.
        kept: In how many of them the object ended as promised.
        replans: How often it was planned again.
        touched: In how many the robot touched another object.
        disturbed: How many other objects were moved, toppled or lost in them.
        off_table: Names of the objects that were off the table after any of them.
    """

    reached: bool
    reason: str
    kind: str
    distances: dict[str, float]
    interactions: int
    kept: int
    replans: int
    touched: int
    disturbed: int
    off_table: tuple[str, ...]


class Attempt(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One planner on one task.

    Attributes:
        status: How its search ended, one of `PlanStatus`.
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
        open_loop: What became of the plan followed blindly; None without one.
        replanned: What became of it with replanning; None without one.
    """

    status: str
    reason: str
    steps: tuple[tuple[str, str], ...] = ()
    seconds: float = 0.0
    primitives: int = 0
    invalid: NOT_VALID = ""
    replayed: str = ""
    promised_miss: float | None = None
    predicted_miss: float | None = None
    left_out: bool = False
    open_loop: Execution | None = None
    replanned: Execution | None = None

    @property
    def found(self) -> bool:
        """Whether there is a plan."""
        return self.status == PlanStatus.SOLVED.value

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


def check_planners(planners: Sequence[str]) -> None:
    """Raise `UnknownChoice` unless all planners exist, and `InvalidValue` if there are none."""
    if not planners:
        raise InvalidValue(f"Name at least one planner; valid: {', '.join(sorted(COMPARED))}.")
    for name in planners:
        if name not in COMPARED:
            raise UnknownChoice("planner", name, COMPARED)


def compare(
    setting: Setting,
    problem: Problem,
    planners: Sequence[str],
    *,
    time_limit: float = 60.0,
    executed: bool = True,
) -> TaskRecord:
    """Have each planner plan for a task, and judge its plan.

    Args:
        setting: What to compare in.
        problem: The task.
        planners: Names out of `COMPARED`.
        time_limit: When each gives up [s].
        executed: Whether plans are executed in the world.
    """
    if problem.is_met(problem.scene().positions):
        return TaskRecord(problem, met_at_start=True)
    attempts = {
        name: _attempt(setting, problem, name, time_limit=time_limit, executed=executed) for name in planners
    }
    return TaskRecord(problem, met_at_start=False, attempts=attempts)


def planner_of(setting: Setting, name: str, *, time_limit: float) -> Replanner:
    """Return a planner as a function from a problem to its result; BFS reads the network's predictions.

    Args:
        setting: What to plan in.
        name: One of `COMPARED`.
        time_limit: When it gives up [s].
    """

    def solve(problem: Problem, grounding: Grounding) -> PlanResult:
        branching = None
        if name == NETWORK_BFS:
            effects = setting.predict(problem.scene().features)
            branching = predicted_branching(problem, grounding, effects)
        registered = NETWORK_BFS if name == OPERATORS_BFS else name
        try:
            return plan(problem, grounding, registered, branching=branching, time_limit=time_limit)
        except (UnknownChoice, InvalidValue) as error:  # a category never rehearsed, an object off the table
            return PlanResult(PlanStatus.FAILED, (), 0.0, str(error))

    return solve


def _attempt(setting: Setting, problem: Problem, name: str, *, time_limit: float, executed: bool) -> Attempt:
    solve = planner_of(setting, name, time_limit=time_limit)
    result = solve(problem, setting.grounding)
    steps = result.steps
    if result.status is not PlanStatus.SOLVED:
        return Attempt(result.status.value, result.reason, seconds=round(result.seconds, 4))
    replayed = replay(steps, problem, setting.grounding)
    return Attempt(
        status=result.status.value,
        reason=result.reason,
        steps=tuple((step.operator, step.object) for step in steps),
        seconds=round(result.seconds, 4),
        primitives=sum(not step.puts_down for step in steps),
        invalid=_invalid(replayed),
        replayed=replayed.reason,
        promised_miss=_worst(problem, replayed.positions[-1]) if replayed.possible else None,
        predicted_miss=_worst(problem, predicted_end(setting, problem, steps)),
        left_out=any(step.base in setting.grounding.left_out for step in steps),
        open_loop=_follow(setting, problem, steps) if executed else None,
        replanned=_follow(setting, problem, steps, solve) if executed else None,
    )


def predicted_end(setting: Setting, problem: Problem, steps: Sequence[PlanStep]) -> Float[np.ndarray, "M 3"]:
    """Follow a plan by the network's predictions; where a put-down lands is what the rehearsals saw.

    Args:
        setting: Where the network is.
        problem: What the plan is for.
        steps: The plan.

    Returns:
        Centres of the objects at its end [m].
    """
    grounding, positions = setting.grounding, problem.scene().positions
    symbols = [primitive.symbol for primitive in grounding.operators.primitives]
    effects = setting.predict(problem.scene().features)  # (M, P, 3)
    for step, then in zip(steps, [*steps[1:], None], strict=True):
        if step.puts_down:
            continue
        operator, moved = grounding.operator_named(step.operator), problem.object_names.index(step.object)
        put_down = is_lift(operator) and then is not None and then.puts_down
        promise = operator.promise if put_down else None
        positions[moved] += at_rest(promise) if promise else effects[moved, symbols.index(operator.primitive)]
    return positions


def _worst(problem: Problem, positions: Float[np.ndarray, "M 3"]) -> float:
    return round(max(problem.distances(positions).values()), 6)


def _invalid(replayed: Replay) -> NOT_VALID:
    if replayed.valid:
        return ""
    return "elsewhere" if replayed.possible else "impossible"


def _follow(
    setting: Setting, problem: Problem, steps: Sequence[PlanStep], solve: Replanner | None = None
) -> Execution | None:
    """Execute a plan, blindly or with replanning."""
    answers: list[PlanStatus] = []
    if solve:
        return None

    def replanner(rest: Problem, grounding: Grounding) -> PlanResult:
        assert solve is not None, "asked for with replanning only"
        result = solve(rest, grounding)
        answers.append(result.status)
        return result

    run = execute(setting.world, problem, setting.grounding, steps)
    stuck = bool(answers) and answers[-1] is not PlanStatus.SOLVED
    return shortened(run, setting.grounding, stuck=stuck)


def shortened(run: Run, grounding: Grounding, *, stuck: bool = False) -> Execution:
    """Keep of a run what is counted.

    Args:
        run: The run.
        grounding: The learned domain, which knows the table.
        stuck: Whether the planner found no way on when it was asked last.
    """
    places = ((name, place) for record in run.steps for name, place in record.positions.items())
    off = {name for name, place in places if not grounding.table.contains(np.array(place))}
    return Execution(
        reached=run.reached,
        reason=run.reason,
        kind="" if run.reached else failure(run, stuck=stuck),
        distances={name: round(distance, 6) for name, distance in run.distances.items()},
        interactions=sum(record.happened != "not performed" for record in run.steps),
        kept=sum(record.as_promised for record in run.steps),
        replans=0,
        touched=sum(bool(record.touched) for record in run.steps),
        disturbed=sum(len(record.disturbed) for record in run.steps),
        off_table=tuple(sorted(off)),
    )


def failure(run: Run, *, stuck: bool = False) -> str:
    """Say in a few words why a run missed its goal: the worst thing that happened in it.

    Args:
        run: A run that did not reach its goal.
        stuck: Whether the planner found no way on when it was asked last.
    """
    ends = {record.happened for record in run.steps}
    bystanders = {how for record in run.steps for how in record.disturbed.values()}
    if "lost" in ends | bystanders:
        return "an object fell off the table"
    if "not performed" in ends:
        return "out of the arm's reach"
    if "toppled" in ends | bystanders:
        return "an object toppled"
    if stuck:
        return "no plan from where things ended"
    if bystanders:
        return "another object was moved"
    if any(record.promised == "held" and record.happened != "held" for record in run.steps):
        return "a grasp failed"
    if not all(record.as_promised for record in run.steps):
        return "an object went elsewhere"
    return "small errors added up"
