"""Domains that are tried on the same tasks, as the benchmarks of practice and of bits do."""

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from statistics import mean, stdev
from typing import Any

from tools.benchmarks.jobs import Job
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.jobs import SIZES, blocks
from tools.benchmarks.planning.measures import TIME_LIMIT, bench_of
from tools.benchmarks.planning.trials import Trial, from_json, to_json, try_task

TOLERANCES = (50, 20)
"""How near objects must come to their goals [mm]."""
WAYS = ("blind", "replanned")
BLOCK = 10
"""Tasks in one job."""

Jobs = dict[tuple[str, int], dict[str, Job]]
"""Jobs by how many objects there are, and tolerance [mm]."""


def trying(folder: Path, name: str, tasks: int, first: int) -> Jobs:
    """List the jobs that try tasks in a domain."""
    return {
        (kind, mm): {
            f"try-{name}-{kind}-{mm}mm-{block.start}": partial(
                try_all, folder, objects, mm, [first + number for number in block]
            )
            for block in blocks(tasks, BLOCK)
        }
        for kind, objects in SIZES.items()
        for mm in TOLERANCES
    }


def try_all(folder: Path, objects: int, mm: int, seeds: Sequence[int]) -> list[Any]:
    """Try tasks drawn as the paper draws them, blindly and with replanning."""
    bench = bench_of(folder)
    tasks = [bench.draw(objects, seed, mm / 1000) for seed in seeds]
    return to_json([try_task(bench.setting, task, blind=True, time_limit=TIME_LIMIT) for task in tasks])


def shares(found: Mapping[str, Any], jobs: Sequence[Jobs]) -> dict[str, list[float | None]]:
    """Gather which share of the goals was reached, for several domains each."""
    return {
        f"{kind}, {mm} mm, {way}": [figures.share(_trials(found, of_one[kind, mm]), way) for of_one in jobs]
        for mm in TOLERANCES
        for kind in SIZES
        for way in WAYS
    }


def promise_rms(found: Mapping[str, Any], jobs: Sequence[Jobs]) -> dict[str, list[float | None]]:
    """Gather how far steps ended from their promises, with replanning, for several domains each [mm, RMS]."""
    return {
        f"{mm} mm": [
            figures.promise_errors(
                figures.steps_of(trial for kind in SIZES for trial in _trials(found, of_one[kind, mm]))
            )["all"]
            for of_one in jobs
        ]
        for mm in TOLERANCES
    }


def _trials(found: Mapping[str, Any], names: Iterable[str]) -> list[Trial]:
    return [trial for name in names for trial in from_json(found.get(name, []))]


def in_millimetres(values: Sequence[float | None]) -> str:
    """Write mean and standard deviation of lengths in millimetres; those that are not known are left out."""
    return _with_spread([value for value in values if value is not None], "")


def in_percent(values: Sequence[float | None]) -> str:
    """Write mean and standard deviation of shares; those that are not known are left out."""
    return _with_spread([100 * share for share in values if share is not None], " %")


def _with_spread(known: Sequence[float], unit: str) -> str:
    if not known:
        return "-"
    return f"{mean(known):.1f}{unit}" + (f" ± {stdev(known):.1f}" if len(known) > 1 else "")
