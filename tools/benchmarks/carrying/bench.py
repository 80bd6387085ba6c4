"""How fast plans with places are found, beside what they may take; prints JSON.

Fast Downward plans for eight graspable objects with goals anywhere on the table, and for thirty small ones
on a lattice, which no robot is asked to carry. CPU seconds of all processes count, so that others on the
machine disturb little; the seconds of the clock stand beside them.
"""

import json
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from statistics import median
from typing import Annotated, Any

import numpy as np
import tyro

from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem, SceneObject
from neurosym.world import Table
from tools.benchmarks.carrying.tasks import far
from tools.benchmarks.jobs import machine
from tools.benchmarks.options import Output
from tools.benchmarks.planning.measures import bench_of
from tools.benchmarks.spent import cpu_seconds

SHIPPED = Path("domains/places")
FIRST = 920_000
"""Seed of the first task, far from those of the evaluation."""
EIGHT, THIRTY = 8, 30
MOST_SECONDS = {EIGHT: 1.0, THIRTY: 10.0}
SIDE = 6
"""The small objects stand on a lattice of so many rows and columns."""
SMALL = 0.07
"""No wider are the small objects [m]."""


def main(
    tasks: Annotated[int, tyro.conf.arg(help="How many tasks of each kind.")] = 10, output: Output = None
) -> None:
    """Measure, and print what was found as JSON."""
    seeds = range(FIRST, FIRST + tasks)
    bench = bench_of(SHIPPED)
    grounding = bench.setting.grounding
    eight = [far(bench, EIGHT, seed, graspable=True) for seed in seeds]
    small = [item for task in eight for item in task.objects if max(item.features[:2]) <= SMALL]
    parts = {
        "eight_objects": timed(eight, grounding, MOST_SECONDS[EIGHT]),
        "thirty_objects": timed(
            [lattice(small, grounding, seed) for seed in seeds], grounding, MOST_SECONDS[THIRTY]
        ),
    }
    tell(parts, output)


def tell(parts: Mapping[str, Mapping[str, Any]], output: Path | None) -> None:
    """Print what was found as JSON, or write it to a file."""
    passed = all(part["passed"] for part in parts.values())
    text = json.dumps({"passed": passed, "machine": machine(), **parts}, indent=2) + "\n"
    if output is None:
        print(text, end="")
    else:
        write_atomically(output, text)


def lattice_points(table: Table, rows: int, columns: int) -> list[tuple[float, float]]:
    """List the points of a lattice over a table [m]."""
    return [
        (float(x), float(y))
        for x in np.linspace(*table.x, rows + 2)[1:-1]
        for y in np.linspace(*table.y, columns + 2)[1:-1]
    ]


def lattice(kinds: Sequence[SceneObject], grounding: Grounding, seed: int) -> Problem:
    """Draw thirty objects on a lattice, each with another of its points as goal."""
    rng = np.random.default_rng(seed)
    points = lattice_points(grounding.table, SIDE, SIDE)
    starts, ends = (rng.permutation(len(points))[:THIRTY] for _ in range(2))
    items, goals = [], {}
    for number, (start, end, kind) in enumerate(
        zip(starts, ends, rng.integers(len(kinds), size=THIRTY), strict=True)
    ):
        like, name = kinds[kind], f"item-{number:02d}"
        height = like.position[2]
        items.append(SceneObject(name, like.category, like.features, (*points[start], height)))
        goals[name] = (*points[end], height)
    return Problem(f"lattice-{seed}", tuple(items), goals, TOLERANCE)


def timed(problems: Sequence[Problem], grounding: Grounding, limit: float) -> dict[str, Any]:
    """Plan for problems with as many objects each, and time it.

    Args:
        problems: The problems.
        grounding: The learned domain.
        limit: What the median may take [CPU s].
    """
    cpu, clock, solved, steps = [], [], 0, []
    for problem in problems:
        begin, cpu_begin = time.perf_counter(), cpu_seconds()
        found = plan(problem, grounding, "fast-downward")
        clock.append(time.perf_counter() - begin)
        cpu.append(cpu_seconds() - cpu_begin)
        solved += found.status is PlanStatus.SOLVED
        steps.append(len(found.steps))
    return {
        "tasks": len(problems),
        "solved": solved,
        "steps_median": median(steps),
        "cpu_seconds": {"median": round(median(cpu), 3), "most": round(max(cpu), 3)},
        "clock_seconds": {"median": round(median(clock), 3), "most": round(max(clock), 3)},
        "limit_seconds": limit,
        "passed": median(cpu) <= limit,
    }


if __name__ == "__main__":
    tyro.cli(main)
