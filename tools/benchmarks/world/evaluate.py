"""Measure everything that docs/world.md claims, into docs/results/world.json (and world.md, to be read).

Finished parts are kept and not measured again, so that the run can be interrupted.
"""

import sys
import time
from functools import partial
from pathlib import Path
from typing import Any

import tyro

from neurosym.worlds.workers import perform_all
from tools.benchmarks.jobs import Evaluation, Job, machine
from tools.benchmarks.options import RESULTS, Results, Scale, Work, scaled
from tools.benchmarks.world import measures
from tools.benchmarks.world.bench import bench, memory
from tools.benchmarks.world.tables import page

COMMAND = "make evaluate-world"
WORKERS = 2


def parts(scale: float) -> dict[str, Job]:
    """List what is measured, each part over so many times the usual number of interactions."""
    some, chaos = partial(scaled, scale), measures.predictability
    return {
        "predictability": partial(chaos, some(1000), 101, WORKERS),
        "predictability_other_seed": partial(chaos, some(1000), 102, WORKERS),
        "predictability_at_1_120": partial(chaos, some(1000), 101, WORKERS, time_step=1 / 120),
        "object_matters": partial(measures.object_matters, some(200), 25, 103, WORKERS),
        "hand_written": partial(measures.hand_written, some(50), 104, WORKERS),
        "carrying": partial(measures.carrying, some(50), 108, WORKERS),
        "predictability_of_carrying": partial(measures.predictability_of_carrying, some(1000), 109, WORKERS),
        "two_objects": partial(measures.several_objects, some(300), 2, 105, WORKERS),
        "eight_objects": partial(measures.several_objects, some(300), 8, 106, WORKERS),
        "random": partial(ten_thousand, some(10_000)),
        "speed": partial(bench, some(400), 4, 1 / 240),
        "speed_at_1_120": partial(bench, some(400), 4, 1 / 120),
        "memory": partial(memory, some(10_000), 1 / 240),
    }


def main(scale: Scale = 1.0, work: Work = Path("evaluation/world"), results: Results = RESULTS) -> None:
    """Measure part after part, and write the results."""
    evaluation, names = Evaluation("world", work / f"{scale:g}", results), parts(scale)
    evaluation.perform(names, "measuring", fresh=True)
    found = evaluation.found()
    if missing := [name for name in names if name not in found]:
        sys.exit(f"not measured yet: {', '.join(missing)}; the same command goes on")
    summary = summarise({name: found[name] for name in names}, scale)
    evaluation.write(summary, page(summary), records=False)


def ten_thousand(count: int) -> measures.Results:
    """Make random interactions with all workers against the clock, and tell how they end."""
    tasks = measures.random_tasks(count, 107)
    begin = time.perf_counter()
    outcomes = [*perform_all(measures.factory(), tasks, WORKERS)]
    minutes = (time.perf_counter() - begin) / 60
    return measures.random_outcomes(outcomes) | {"minutes": round(minutes, 2), "workers": WORKERS}


def summarise(found: dict[str, Any], scale: float) -> dict[str, Any]:
    """Put the main figures on top, and the parts they come from below."""
    return {
        "command": COMMAND if scale == 1.0 else f"{COMMAND} SCALE={scale}",
        "machine": machine("pybullet", "numpy"),
        "predictability": found["predictability"]["share"],
        "share_of_raw_stepping": found["speed"]["share_of_raw_stepping"],
        "speedup_2_workers": found["speed"]["speedup_2_workers"],
        "put_down_within_1cm": found["random"]["put_down_within_1cm"],
        "variance_by_action_alone": found["object_matters"]["share_of_action_alone"],
        "minutes_for_10000_with_2_workers": found["random"]["minutes"],
        "memory_growth_mb": found["memory"]["memory_growth_mb"],
        "hand_written": found["hand_written"],
        "details": {name: part for name, part in found.items() if name != "hand_written"},
    }


if __name__ == "__main__":
    tyro.cli(main)
