"""What carrying is compared with: actions written by hand, and the same domain without places."""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import msgspec

from tools.benchmarks.carrying import tasks
from tools.benchmarks.carrying.by_hand import carry_by_hand
from tools.benchmarks.jobs import Job
from tools.benchmarks.planning.measures import TIME_LIMIT, bench_of
from tools.benchmarks.planning.trials import try_task

BY_HAND, WITHOUT = "by hand", "without places"
NAMES = (BY_HAND, WITHOUT)
LED = ("graspable 1", "graspable 2", "graspable 4")
"""What is tried without places; with eight objects a search takes too long."""


def jobs(folder: Path, first: int, cells: Sequence[tasks.Cell]) -> dict[str, Job]:
    """List what is to be tried, on the tasks that the domain of the first seed is tried on."""
    found: dict[str, Job] = {}
    for name, draw, count in cells:
        if name.startswith("all"):
            continue  # there is nothing written by hand for these
        seeds = range(first, first + count)
        found[_job(BY_HAND, name)] = partial(by_hand, folder, draw, seeds)
        if name in LED:
            found[_job(WITHOUT, name)] = partial(without_places, folder, draw, seeds)
    return found


def by_hand(folder: Path, draw: tasks.Draw, seeds: Sequence[int]) -> list[bool]:
    """Say of tasks whether they are reached by hand-written actions."""
    bench = bench_of(folder)
    return [carry_by_hand(draw(bench, seed), bench.setting.world, seed).reached for seed in seeds]


def without_places(folder: Path, draw: tasks.Draw, seeds: Sequence[int]) -> list[bool]:
    """Say of tasks whether they are reached, with replanning, by a domain that knows no places."""
    bench = bench_of(folder)
    grounding = msgspec.structs.replace(bench.setting.grounding, places=None)
    setting = bench.setting.__class__(bench.setting.world, grounding, bench.setting.predict)
    tried = [try_task(setting, draw(bench, seed), blind=False, time_limit=TIME_LIMIT) for seed in seeds]
    return [one.replanned is not None and one.replanned.reached for one in tried]


def summary(found: Mapping[str, Any], cells: Sequence[tasks.Cell]) -> dict[str, dict[str, float]]:
    """Gather the shares of reached goals, of as much as was tried."""
    return {
        baseline: {
            name: sum(reached) / len(reached)
            for name, *_ in cells
            if (reached := found.get(_job(baseline, name)))
        }
        for baseline in NAMES
    }


def _job(baseline: str, cell: str) -> str:
    return f"{baseline} {cell}".replace(", ", "-").replace(" ", "-")
