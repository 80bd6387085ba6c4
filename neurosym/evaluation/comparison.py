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
from neurosym.execution.rerun import Execution, summarise_run
from neurosym.files import check_writable, digest, locked, make_folder, read_json, write_json
from neurosym.grounding import Grounding, at_rest, is_lift
from neurosym.operators import Symbol
from neurosym.planners.planner import PlanResult, PlanStatus, PredictEffects
from neurosym.planners.planner_table import PLANNERS
from neurosym.planners.registry import Replanner, plan, planner_named
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import COMPARISONS, GROUNDING, MODEL, WORLD
from neurosym.stages.problem_making import draw_any_task, sight_of_pairs
from neurosym.tasks.supports import is_reached, is_relational
from neurosym.tasks.task import with_places
from neurosym.tasks.transition import PlanStep, Steps, named_steps, primitives, validate
from neurosym.world import World
from neurosym.worlds.task_drawing import Fits, draw_problem
from neurosym.worlds.workers import in_order, worker_pool
from neurosym.worlds.world_file import read_world


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
    """Raise `UnknownChoice` unless all planners exist, and `InvalidValue` if there are none."""
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
        invalid="" if replayed.valid else "elsewhere" if replayed.possible else "impossible",
        replayed=replayed.reason,
        promised_miss=_worst(problem, replayed.positions[-1]) if replayed.possible else None,
        predicted_miss=_worst(problem, _predicted_end(setting, problem, steps)),
        left_out=any(step.base in setting.grounding.left_out for step in steps),
        open_loop=blind,
        replanned=replanned,
    )


def _predicted_end(setting: Setting, problem: Problem, steps: Sequence[PlanStep]) -> Float[np.ndarray, "M 3"]:
    """Follow a plan by the network's predictions; where a put-down lands is what the rehearsals saw.

    What is carried to a place is taken to stand there: the network of displacements knows nothing of places,
    and nothing of relations, of which the promises are taken. Returned are the centres at its end [m].
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


def _follow(
    setting: Setting, problem: Problem, steps: Sequence[PlanStep], solve: Replanner
) -> tuple[Execution, Execution]:
    """Execute a plan, blindly and with replanning."""
    world, grounding = setting.world, setting.grounding
    replanned = execute(world, problem, grounding, steps, replanner=solve)
    # A run in which nothing was planned anew is the one that follows the plan blindly.
    blind = execute(world, problem, grounding, steps) if replanned.replannings else replanned
    return summarise_run(blind, grounding), summarise_run(replanned, grounding)


# The tasks of a comparison: each drawn and measured once, and kept in a file, until the domain changes

_AHEAD = 2  # tasks handed out for each worker


class Kept(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A record as it lies in its file.

    Attributes:
        made_from: SHA-256 of the files that it depends on, by name.
        time_limit: The user's ceiling for each planner [s], if there was one.
        record: What became of the task.
    """

    made_from: dict[str, str]
    time_limit: float | None
    record: TaskRecord


class Order(msgspec.Struct, frozen=True):
    """Which tasks to compare which planners on.

    Attributes:
        folder: The domain folder.
        objects: Objects in each task.
        task: What the tasks ask for; as the paper draws them, if not given.
        planners: Whom to compare.
        tolerance: How near each object must come to its goal [m].
        time_limit: The user's ceiling for each planner [s]; its own if not given.
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
        symbols = grounding.operators.symbols
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
        """Draw a task, and set how near each object must come to its goal.

        Scene and goals do not depend on the tolerance, nor on what was learned.

        Args:
            objects: How many objects.
            seed: Same seed, same task.
            tolerance: How near they must come [m].
            task: What is asked for; a task as the paper draws them, if not given.
            fits: Says of the features of an object whether it may be drawn, if a task is asked for.
        """
        world, name = self.setting.world, f"{task or 'drawn'}-{seed:05d}"
        if task is None:
            drawn = draw_problem(world, self.categorise, name=name, objects=objects, seed=seed)
        else:
            known = self.setting.grounding
            options: dict[str, Any] = {"name": name, "objects": objects, "seed": seed, "fits": fits}
            drawn = draw_any_task(world, self.categorise, known, task, sight=self._sight, **options)
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
    kept = {seed: _load(order, seed, made_from) for seed in seeds}
    left = [seed for seed, record in kept.items() if _planners_left(order, record)]
    measured = _measure_all(order, made_from, [(seed, kept[seed]) for seed in left], workers)
    for seed in seeds:
        record = next(measured) if seed in left else kept[seed]
        assert record is not None, "measured now or before"
        yield record


def _path(order: Order, seed: int) -> Path:
    return order.place / f"task-{seed:05d}.json"


def _load(order: Order, seed: int, made_from: dict[str, str]) -> TaskRecord | None:
    """Read a record, unless there is none, or one of another domain."""
    try:
        kept = read_json(_path(order, seed), Kept)
    except InvalidFile:
        return None
    is_current = (kept.made_from, kept.time_limit) == (made_from, order.time_limit)
    return kept.record if is_current else None


def _planners_left(order: Order, record: TaskRecord | None) -> tuple[str, ...]:
    if record is None:
        return order.planners
    done = order.planners if record.met_at_start else record.attempts
    return tuple(name for name in order.planners if name not in done)


_Unfinished = tuple[int, TaskRecord | None]
"""A seed, and what is known of its task."""


def _measure_all(
    order: Order, made_from: dict[str, str], tasks: Sequence[_Unfinished], workers: int
) -> Iterator[TaskRecord]:
    if workers == 1 or not tasks:
        yield from (_measure(order, made_from, task) for task in tasks)
        return
    with worker_pool(min(workers, len(tasks)), _start, (order.folder, *made_from.values())) as submit:
        yield from in_order(tasks, lambda task: submit(_measure, order, made_from, task), _AHEAD * workers)


def _start(folder: Path, *made_from: str) -> None:
    _bench(folder, *made_from)


@lru_cache(maxsize=1)
def _bench(folder: Path, *_made_from: str) -> Bench:
    """Load a domain folder, once in each process as long as it does not change."""
    return Bench(DomainFolder(folder))


def _measure(order: Order, made_from: dict[str, str], task: _Unfinished) -> TaskRecord:
    """Do what is missing of a task, and write its record."""
    bench, (seed, known) = _bench(order.folder, *made_from.values()), task
    problem = known.problem if known else bench.draw(order.objects, seed, order.tolerance, order.task)
    missing = _planners_left(order, known)
    record = compare(bench.setting, problem, missing, time_limit=order.time_limit)
    with locked(order.place):  # another process may compare other planners on the same task
        if known := _load(order, seed, made_from) or known:
            record = msgspec.structs.replace(record, attempts={**known.attempts, **record.attempts})
        write_json(_path(order, seed), Kept(made_from, order.time_limit, record))
    return record
