"""Comparing planners: each plans for the same drawn task, and its plan is replayed and executed.

The paper's search trusts the network's predictions, the PDDL planners trust the table of operators. So a plan
is judged three times: by the operators' promises, by the network's predictions, and by the world, where it is
once followed blindly and once with replanning by the planner that made it.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, Literal, TypeVar

import msgspec
import numpy as np
from numpy import ndarray

from neurosym.checks import Float
from neurosym.choices import AnyTask
from neurosym.errors import InvalidPlanner, InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.execution.performance import Execution, summarise_run
from neurosym.grounding import Grounding, at_rest, is_lift
from neurosym.operators import Symbol
from neurosym.planners.planner import PlanResult, PlanStatus, PredictEffects
from neurosym.planners.registry import Replanner, plan, planner_named
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, WORLD
from neurosym.stages.problem_making import draw_any_task, sight_of_pairs
from neurosym.tasks.task import is_reached, is_relational, with_places
from neurosym.tasks.transition import PlanStep, Steps, named_steps, primitives, validate
from neurosym.world import World
from neurosym.worlds.task_drawing import Fits, draw_problem
from neurosym.worlds.world_file import read_world


@dataclass(frozen=True, slots=True)
class Setting:
    """What planners are compared in: a world, what was learned, and what the network predicts."""

    world: World
    grounding: Grounding
    predict: PredictEffects


class Attempt(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One planner on one task."""

    status: PlanStatus  # how its search ended
    reason: str  # why there is no plan, or what is to be said about the one found
    steps: Steps = ()  # operator and object of each step
    seconds: float = 0.0  # how long it took [s]
    primitives: int = 0  # how many steps are primitives, and no put-downs
    # what the replay with the operators' promises finds: nothing, a step that is impossible, or an end
    # elsewhere than at the goal
    invalid: Literal["", "impossible", "elsewhere"] = ""
    replayed: str = ""  # the same in a sentence
    # how far from its goal the worst object ends by the operators [m]; None if impossible
    promised_miss: float | None = None
    predicted_miss: float | None = None  # the same by the network
    left_out: bool = False  # whether the plan uses an operator that the PDDL domain leaves out
    depth: int | None = None  # how many primitives were looked ahead, by a search that ended there
    open_loop: Execution | None = None  # what became of the plan followed blindly; None without one
    replanned: Execution | None = None  # what became of it with replanning; None without one

    @property
    def found(self) -> bool:
        """Whether there is a plan."""
        return self.status is PlanStatus.SOLVED

    @property
    def valid(self) -> bool:
        """Whether there is a plan that the operators promise to reach the goal."""
        return self.found and not self.invalid


Asked = TypeVar("Asked")
"""A task: a `Problem`, or a `ValueProblem`."""


class TaskRecord(msgspec.Struct, Generic[Asked], frozen=True, forbid_unknown_fields=True):
    """What each planner made of one task: its attempts, by name; none if the goal is met at the start."""

    problem: Asked
    met_at_start: bool
    attempts: dict[str, Attempt] = {}


def compare(
    setting: Setting,
    problem: Problem,
    planners: Sequence[str],
    *,
    time_limit: float | None = None,
    executed: bool = True,
) -> TaskRecord[Problem]:
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
    solvers = {name: planner_of(setting, name, time_limit=time_limit) for name in planners}
    attempts = {name: _attempt(setting, problem, solve, executed) for name, solve in solvers.items()}
    return TaskRecord(problem, met_at_start=False, attempts=attempts)


def planner_of(setting: Setting, name: str, *, time_limit: float | None) -> Replanner:
    """Return a planner as a function from a problem to its result; it may read the network's predictions."""
    planner = planner_named(name)

    def solve(problem: Problem, grounding: Grounding) -> PlanResult:
        try:
            return plan(problem, grounding, planner, predict=setting.predict, time_limit=time_limit)
        except InvalidPlanner:
            raise
        except (UnknownChoice, InvalidValue) as error:  # a category never rehearsed, an object off the table
            return PlanResult(PlanStatus.FAILED, (), 0.0, str(error))

    return solve


def _attempt(setting: Setting, problem: Problem, solve: Replanner, executed: bool) -> Attempt:
    world, grounding = setting.world, setting.grounding
    result = solve(problem, grounding)
    steps, seconds = result.steps, round(result.seconds, 4)
    if result.status is not PlanStatus.SOLVED:
        return Attempt(result.status, result.reason, seconds=seconds, depth=result.depth)
    replayed, blind, replanned = validate(steps, problem, grounding), None, None
    if executed:
        run = execute(world, problem, grounding, steps, replanner=solve)
        replanned = summarise_run(run, grounding)
        # a run in which nothing was planned anew is the one that follows the plan blindly
        again = execute(world, problem, grounding, steps) if run.replannings else run
        blind = summarise_run(again, grounding)
    return Attempt(
        status=result.status,
        reason=result.reason,
        steps=named_steps(steps),
        seconds=seconds,
        primitives=primitives(steps),
        invalid="" if replayed.valid else "elsewhere" if replayed.possible else "impossible",
        replayed=replayed.reason,
        promised_miss=_worst(problem, replayed.positions[-1]) if replayed.possible else None,
        predicted_miss=_worst(problem, _predicted_end(setting, problem, steps)),
        left_out=any(step.base in grounding.left_out for step in steps),
        open_loop=blind,
        replanned=replanned,
    )


def _predicted_end(setting: Setting, problem: Problem, steps: Sequence[PlanStep]) -> Float[np.ndarray, "M 3"]:
    """Follow a plan by the network's predictions to the centres at its end [m].

    Where a put-down lands is what the rehearsals saw. What is carried to a place is taken to stand there: the
    network of displacements knows nothing of places, and nothing of relations, whose promises are taken.
    """
    grounding, positions = setting.grounding, problem.scene().positions
    if is_relational(problem, grounding):
        return np.asarray(validate(steps, problem, grounding).positions[-1])
    placed = with_places(problem, grounding)
    symbols = grounding.objects.symbols
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
        effect = effects[moved, symbols.index(operator.primitive)]
        positions[moved] += at_rest(promise) if promise else effect
    return positions


def _worst(problem: Problem, positions: Float[np.ndarray, "M 3"]) -> float:
    return round(max(problem.distances(positions).values(), default=0.0), 6)


class Bench:
    """A domain folder, loaded to draw tasks from and to compare planners in; `ValueBench` is another.

    Attributes:
        categorise: Gives objects their symbols.
        setting: What planners are compared in.

    Args:
        folder: The domain folder, with a world, a model and a grounding.
    """

    def __init__(self, folder: DomainFolder):
        grounding, model = Grounding.load(folder.require(GROUNDING)), folder.network()
        symbols = grounding.objects.symbols
        self._sight = sight_of_pairs(folder)
        self.categorise: Callable[[Float[ndarray, "N F"]], tuple[Symbol, ...]] = model.object_symbols
        self.setting = Setting(
            world=read_world(folder.require(WORLD))(),
            grounding=grounding,
            predict=lambda features: model.branching_table(features, symbols),
        )

    def draw(
        self, objects: int, seed: int, tolerance: float, task: AnyTask | None = None, fits: Fits | None = None
    ) -> Problem:
        """Draw a task whose scene and goals depend neither on the tolerance, nor on what was learned.

        Args:
            objects: How many objects.
            seed: Same seed, same task.
            tolerance: How near they must come to their goals [m].
            task: What is asked for; a task as the paper draws them, if not given.
            fits: Says of the features of an object whether it may be drawn, if a task is asked for.
        """
        world, name, of = self.setting.world, f"{task or 'drawn'}-{seed:05d}", self.categorise
        if task is None:
            drawn = draw_problem(world, of, name=name, objects=objects, seed=seed)
        else:
            asked: dict[str, Any] = {"name": name, "objects": objects, "seed": seed, "fits": fits}
            drawn = draw_any_task(world, of, self.setting.grounding, task, sight=self._sight, **asked)
        return msgspec.structs.replace(drawn, tolerance=tolerance)

    def compare(
        self, problem: Problem, planners: Sequence[str], *, time_limit: float | None
    ) -> TaskRecord[Problem]:
        """Have each planner plan for a task, and judge its plan; see `compare`."""
        return compare(self.setting, problem, planners, time_limit=time_limit)
