"""The tasks of a comparison: each drawn and measured once, and kept in a file, until the domain changes."""

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

import msgspec
from numpy import ndarray

from neurosym.arrays import Float
from neurosym.choices import AnyTask
from neurosym.errors import InvalidFile
from neurosym.evaluation.comparison import Setting, TaskRecord, compare
from neurosym.files import check_writable, make_folder, write_json
from neurosym.grounding import Grounding
from neurosym.locks import locked
from neurosym.problems import Problem
from neurosym.reading import digest, read_json
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import COMPARISONS, GROUNDING, MODEL, WORLD
from neurosym.stages.task_drawing import draw_any_task, sight_of_pairs
from neurosym.symbols import Symbol
from neurosym.worlds.pool import worker_pool
from neurosym.worlds.problem_drawing import draw_problem
from neurosym.worlds.tasks import Fits
from neurosym.worlds.workers import in_order
from neurosym.worlds.world_file import read_world

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
        from neurosym.learning.effect_model import EffectModel

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


Unfinished = tuple[int, TaskRecord | None]
"""A seed, and what is known of its task."""


def _measure_all(
    order: Order, made_from: dict[str, str], tasks: Sequence[Unfinished], workers: int
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


def _measure(order: Order, made_from: dict[str, str], task: Unfinished) -> TaskRecord:
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
