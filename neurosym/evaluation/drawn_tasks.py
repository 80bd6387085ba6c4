"""The tasks of a comparison: each drawn and measured once, and kept in a file, until the domain changes."""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, Generic, TypeVar, cast

import msgspec

from neurosym.choices import AnyTask
from neurosym.errors import InvalidFile
from neurosym.evaluation.comparison import Bench, TaskRecord
from neurosym.evaluation.value_comparison import ValueBench
from neurosym.files import check_writable, digest, locked, make_folder, read_json, write_json
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import COMPARISONS, GROUNDING, MODEL, WORLD
from neurosym.values.problem import ValueProblem
from neurosym.worlds.workers import in_order, worker_pool

_Asked = TypeVar("_Asked")
_AHEAD = 2  # tasks handed out for each worker
_Digests = dict[str, str]
"""SHA-256 of the files that a record depends on, by name."""


class _Kept(msgspec.Struct, Generic[_Asked], frozen=True, forbid_unknown_fields=True):
    """A record as it lies in its file, with the user's ceiling for each planner [s], if there was one."""

    made_from: _Digests
    time_limit: float | None
    record: TaskRecord[_Asked]


class Order(msgspec.Struct, frozen=True):
    """Which tasks to compare which planners on."""

    folder: Path  # the domain folder
    objects: int  # objects in each task
    planners: tuple[str, ...]  # whom to compare
    tolerance: float | None  # how near each object must come to its goal [m]; None with data of a user's own
    time_limit: float | None = None  # the user's ceiling for each planner [s]; its own if not given
    task: AnyTask | None = None  # what the tasks ask for; as the paper draws them, if not given

    @property
    def _kind(self) -> Any:
        return _Kept[ValueProblem] if self.tolerance is None else _Kept[Problem]

    @property
    def place(self) -> Path:
        """Folder of the records."""
        within = "" if self.tolerance is None else f"-{1000 * self.tolerance:g}-mm"
        kind = f"{self.objects}-objects{within}"
        return self.folder / COMPARISONS / (f"{self.task}-{kind}" if self.task else kind)

    def file(self, seed: int) -> Path:
        """Return where the record of a task lies."""
        return self.place / f"task-{seed:05d}.json"

    def kept(self, seed: int, made_from: _Digests) -> TaskRecord[Any] | None:
        """Read a record, unless there is none, or one of another domain."""
        try:
            kept = cast("_Kept[Any]", read_json(self.file(seed), self._kind))
        except InvalidFile:
            return None
        is_current = (kept.made_from, kept.time_limit) == (made_from, self.time_limit)
        return kept.record if is_current else None

    def planners_left(self, record: TaskRecord[Any] | None) -> tuple[str, ...]:
        """Name those whom a record does not tell of."""
        done = () if record is None else self.planners if record.met_at_start else record.attempts
        return tuple(name for name in self.planners if name not in done)


def compare_tasks(order: Order, seeds: Sequence[int], *, workers: int = 1) -> Iterator[TaskRecord[Any]]:
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
    named = (WORLD, MODEL, GROUNDING) if order.tolerance is not None else ValueBench.files(folder)
    made_from = {name: digest(folder.require(name)) for name in named}
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
) -> Iterator[TaskRecord[Any]]:
    if workers == 1 or not seeds:
        yield from (_measure(order, made_from, seed) for seed in seeds)
        return
    with worker_pool(min(workers, len(seeds))) as submit:
        yield from in_order(seeds, lambda seed: submit(_measure, order, made_from, seed), _AHEAD * workers)


@lru_cache(maxsize=1)
def _bench(folder: Path, is_of_values: bool, *_made_from: str) -> Bench | ValueBench:
    """Load a domain folder, once in each process as long as it does not change."""
    return (ValueBench if is_of_values else Bench)(DomainFolder(folder))


def _measure(order: Order, made_from: _Digests, seed: int) -> TaskRecord[Any]:
    """Do what is missing of a task, and write its record."""
    bench: Any = _bench(order.folder, order.tolerance is None, *made_from.values())
    known = order.kept(seed, made_from)
    problem = known.problem if known else bench.draw(order.objects, seed, order.tolerance, order.task)
    record: TaskRecord[Any] = bench.compare(problem, order.planners_left(known), time_limit=order.time_limit)
    with locked(order.place):  # another process may compare other planners on the same task
        if known := order.kept(seed, made_from) or known:
            record = msgspec.structs.replace(record, attempts={**known.attempts, **record.attempts})
        write_json(order.file(seed), _Kept(made_from, order.time_limit, record))
    return record
