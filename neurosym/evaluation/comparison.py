"""Comparing planners: each plans for the same drawn task, and its plan is replayed and executed.

The paper's search trusts the network's predictions, the PDDL planners trust the table of operators. So a plan
is judged three times: by the operators' promises, by the network's predictions, and by the world, where it is
once followed blindly and once with replanning by the planner that made it.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

import msgspec
import numpy as np
from numpy import ndarray

from neurosym.checks import Float
from neurosym.choices import AnyTask
from neurosym.errors import InvalidFile, InvalidPlanner, InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.execution.performance import Execution, summarise_run
from neurosym.files import check_writable, digest, locked, make_folder, read_json, write_json
from neurosym.grounding import Grounding, at_rest, is_lift
from neurosym.operators import Symbol
from neurosym.planners.planner import PlanResult, PlanStatus, PredictEffects
from neurosym.planners.registry import Replanner, plan, planner_named
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import COMPARISONS, GROUNDING, MODEL, WORLD
from neurosym.stages.problem_making import draw_any_task, sight_of_pairs
from neurosym.tasks.task import is_reached, is_relational, with_places
from neurosym.tasks.transition import PlanStep, Steps, named_steps, primitives, validate
from neurosym.world import World
from neurosym.worlds.task_drawing import Fits, draw_problem
from neurosym.worlds.workers import in_order, worker_pool
from neurosym.worlds.world_file import read_world


@dataclass(frozen=True, slots=True)
class Setting:
    """What planners are compared in: a world, what was learned, and what the network predicts."""

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
    invalid: Literal["", "impossible", "elsewhere"] = ""
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
    """What each planner made of one task: its attempts, by name; none if the goal is met at the start."""

    problem: Problem
    met_at_start: bool
    attempts: dict[str, Attempt] = {}


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


# The tasks of a comparison: each drawn and measured once, and kept in a file, until the domain changes

_AHEAD = 2  # tasks handed out for each worker
_Digests = dict[str, str]
"""SHA-256 of the files that a record depends on, by name."""


class _Kept(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A record as it lies in its file, with the user's ceiling for each planner [s], if there was one."""

    made_from: _Digests
    time_limit: float | None
    record: TaskRecord


class Order(msgspec.Struct, frozen=True):
    """Which tasks to compare which planners on.

    Attributes:
        folder: The domain folder.
        objects: Objects in each task.
        planners: Whom to compare.
        tolerance: How near each object must come to its goal [m].
        time_limit: The user's ceiling for each planner [s]; its own if not given.
        task: What the tasks ask for; as the paper draws them, if not given.
    """

    folder: Path
    objects: int
    planners: tuple[str, ...]
    tolerance: float
    time_limit: float | None = None
    task: AnyTask | None = None

    @property
    def place(self) -> Path:
        """Folder of the records."""
        kind = f"{self.objects}-objects-{1000 * self.tolerance:g}-mm"
        return self.folder / COMPARISONS / (f"{self.task}-{kind}" if self.task else kind)

    def file(self, seed: int) -> Path:
        """Return where the record of a task lies."""
        return self.place / f"task-{seed:05d}.json"

    def kept(self, seed: int, made_from: _Digests) -> TaskRecord | None:
        """Read a record, unless there is none, or one of another domain."""
        try:
            kept = read_json(self.file(seed), _Kept)
        except InvalidFile:
            return None
        is_current = (kept.made_from, kept.time_limit) == (made_from, self.time_limit)
        return kept.record if is_current else None

    def planners_left(self, record: TaskRecord | None) -> tuple[str, ...]:
        """Name those whom a record does not tell of."""
        done = () if record is None else self.planners if record.met_at_start else record.attempts
        return tuple(name for name in self.planners if name not in done)


class Bench:
    """A domain folder, loaded to draw tasks from and to compare planners in.

    Attributes:
        categorise: Gives objects their symbols.
        setting: What planners are compared in.

    Args:
        folder: The domain folder, with a world, a model and a grounding.
    """

    def __init__(self, folder: DomainFolder):
        from neurosym.learning.network import EffectModel

        grounding = Grounding.load(folder.require(GROUNDING))
        model = EffectModel.load(folder.require(MODEL))
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


def compare_tasks(order: Order, seeds: Sequence[int], *, workers: int = 1) -> Iterator[TaskRecord]:
    """Compare planners on drawn tasks, in any number of processes; what is on file is not done again.

    Args:
        order: What to compare.
        seeds: A task is drawn with each.
        workers: How many processes.

    Raises:
        StageMissing: If nothing was learned or compiled yet.
        WorkerDied: If a process ends.
    """
    folder = DomainFolder(order.folder)
    made_from = {name: digest(folder.require(name)) for name in (WORLD, MODEL, GROUNDING)}
    make_folder(order.place)
    check_writable(order.place / "comparison.json")
    kept = {seed: order.kept(seed, made_from) for seed in seeds}
    left = [seed for seed, record in kept.items() if order.planners_left(record)]
    measured = _measure_all(order, made_from, left, workers)
    for seed, record in kept.items():
        found = next(measured) if seed in left else record
        assert found is not None, "measured now or before"
        yield found


def _measure_all(
    order: Order, made_from: _Digests, seeds: Sequence[int], workers: int
) -> Iterator[TaskRecord]:
    if workers == 1 or not seeds:
        yield from (_measure(order, made_from, seed) for seed in seeds)
        return
    with worker_pool(min(workers, len(seeds))) as submit:
        yield from in_order(seeds, lambda seed: submit(_measure, order, made_from, seed), _AHEAD * workers)


@lru_cache(maxsize=1)
def _bench(folder: Path, *_made_from: str) -> Bench:
    """Load a domain folder, once in each process as long as it does not change."""
    return Bench(DomainFolder(folder))


def _measure(order: Order, made_from: _Digests, seed: int) -> TaskRecord:
    """Do what is missing of a task, and write its record."""
    bench, known = _bench(order.folder, *made_from.values()), order.kept(seed, made_from)
    problem = known.problem if known else bench.draw(order.objects, seed, order.tolerance, order.task)
    record = compare(bench.setting, problem, order.planners_left(known), time_limit=order.time_limit)
    with locked(order.place):  # another process may compare other planners on the same task
        if known := order.kept(seed, made_from) or known:
            record = msgspec.structs.replace(record, attempts={**known.attempts, **record.attempts})
        write_json(order.file(seed), _Kept(made_from, order.time_limit, record))
    return record
