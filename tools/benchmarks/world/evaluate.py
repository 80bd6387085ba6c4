"""Measure everything that docs/world.md claims, into docs/results/world.json (and world.md, to be read).

Finished parts are kept beside it and not measured again, so that the run can be interrupted; `--fresh` begins
anew.
"""

import json
import os
import platform
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import tyro

from neurosym.console import progress_bar, say
from neurosym.distribution import version_of
from neurosym.files import write_atomically
from neurosym.worlds.workers import perform_all
from tools.benchmarks.world import measures
from tools.benchmarks.world.bench import bench, memory
from tools.benchmarks.world.tables import page

RESULTS = Path("docs/results")
COMMAND = "make evaluate-world"
WORKERS = 2

Part = Callable[[measures.Advance], Any]


def parts(scale: float) -> dict[str, Part]:
    """List what is measured, each part over so many times the usual number of interactions."""

    def some(count: int) -> int:
        return max(4, round(count * scale))

    return {
        "predictability": partial(measures.predictability, some(1000), 101, WORKERS),
        "predictability_other_seed": partial(measures.predictability, some(1000), 102, WORKERS),
        "predictability_at_1_120": partial(
            measures.predictability, some(1000), 101, WORKERS, time_step=1 / 120
        ),
        "object_matters": partial(measures.object_matters, some(200), 25, 103, WORKERS),
        "hand_written": partial(measures.hand_written, some(50), 104, WORKERS),
        "carrying": partial(measures.carrying, some(50), 108, WORKERS),
        "predictability_of_carrying": partial(measures.predictability_of_carrying, some(1000), 109, WORKERS),
        "two_objects": partial(measures.several_objects, some(300), 2, 105, WORKERS),
        "eight_objects": partial(measures.several_objects, some(300), 8, 106, WORKERS),
        "random": partial(ten_thousand, some(10_000)),
        "speed": lambda _: bench(some(400), 4, 1 / 240),
        "speed_at_1_120": lambda _: bench(some(400), 4, 1 / 120),
        "memory": lambda _: memory(some(10_000), 1 / 240),
    }


def main(
    scale: Annotated[
        float, tyro.conf.arg(help="How many interactions, as a share of the full number.")
    ] = 1.0,
    fresh: Annotated[bool, tyro.conf.arg(help="Measure everything again.")] = False,
    results: Annotated[Path, tyro.conf.arg(help="Folder for world.json and world.md.")] = RESULTS,
) -> None:
    """Measure part after part, and write the results."""
    results.mkdir(parents=True, exist_ok=True)
    unfinished = results / "world.partial.json"
    found = json.loads(unfinished.read_text()) if unfinished.exists() and not fresh else {}
    if found.get("scale") != scale:
        found = {"scale": scale}
    for name, measure in parts(scale).items():
        if name not in found:
            begin = time.perf_counter()
            with progress_bar(name.replace("_", " ")) as advance:
                found[name] = measure(advance)
            say(f"{name}: {time.perf_counter() - begin:.0f} s")
            write_atomically(unfinished, _text(found))
    summary = summarise(found)
    write_atomically(results / "world.json", _text(summary))
    write_atomically(results / "world.md", page(summary))
    unfinished.unlink()
    say(f"wrote {results / 'world.json'} and {results / 'world.md'}")


def ten_thousand(count: int, advance: measures.Advance) -> measures.Results:
    """Make random interactions with all workers against the clock, and tell how they end."""
    tasks = measures.random_tasks(count, 107)
    begin = time.perf_counter()
    outcomes = []
    for outcome in perform_all(measures.factory(), tasks, WORKERS):
        outcomes.append(outcome)
        advance(len(outcomes), count)
    minutes = (time.perf_counter() - begin) / 60
    return measures.random_outcomes(outcomes) | {"minutes": round(minutes, 2), "workers": WORKERS}


def summarise(found: dict[str, Any]) -> dict[str, Any]:
    """Put the main figures on top, and the parts they come from below."""
    details = {name: part for name, part in found.items() if name not in ("scale", "hand_written")}
    return {
        "command": COMMAND if found["scale"] == 1.0 else f"{COMMAND} SCALE={found['scale']}",
        "machine": machine(),
        "predictability": found["predictability"]["share"],
        "share_of_raw_stepping": found["speed"]["share_of_raw_stepping"],
        "speedup_2_workers": found["speed"]["speedup_2_workers"],
        "put_down_within_1cm": found["random"]["put_down_within_1cm"],
        "variance_by_action_alone": found["object_matters"]["share_of_action_alone"],
        "minutes_for_10000_with_2_workers": found["random"]["minutes"],
        "memory_growth_mb": found["memory"]["memory_growth_mb"],
        "hand_written": found["hand_written"],
        "details": details,
    }


def machine() -> dict[str, Any]:
    """Say what this was measured on."""
    model = [line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")]
    return {
        "cpu": model[0].partition(":")[2].strip() if model else platform.processor(),
        "cores": os.cpu_count(),
        "python": platform.python_version(),
        **{name: version_of(name) for name in ("pybullet", "numpy")},
    }


def _text(value: Any) -> str:
    return json.dumps(value, indent=2, default=lambda entry: np.asarray(entry).tolist()) + "\n"


if __name__ == "__main__":
    try:
        tyro.cli(main)
    except KeyboardInterrupt:
        say("interrupted; the same command goes on from what is written")
        sys.exit(130)
