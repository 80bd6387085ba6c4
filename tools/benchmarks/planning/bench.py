"""How fast planning is, beside what it may take; prints JSON.

Our own planners are told in CPU seconds of one core, so that other processes on the machine disturb them
little; `neurosym plan` is a process that starts others, and is told in the CPU seconds of all of them, with
the seconds of the clock beside. Everything plans with the shipped domain.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import msgspec
import numpy as np
import tyro

from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.planners import PlanStatus, fewest_steps, plan, plan_counting
from neurosym.planners.bfs import plan_bfs
from neurosym.planners.branching import branching_of
from neurosym.problems import Problem, SceneObject
from neurosym.table import Table
from tools.benchmarks.options import Output
from tools.benchmarks.places import SHIPPED
from tools.benchmarks.world.evaluate import machine

MOST_MS_BFS = 50.0
MOST_SECONDS_COUNTING = 1.0
MOST_SECONDS_PROCESS = 1.0
MOST_OF_TRANSLATED = 0.5
"""What a plan without Fast Downward's translator may cost, of one with it."""
CROWD, STEPS = 16, 4
"""How many objects counting plans for, and how many random steps lead each to its goal."""

Results = dict[str, Any]


def main(
    times: Annotated[int, tyro.conf.arg(help="How often each is timed; the least counts.")] = 20,
    output: Output = None,
) -> None:
    """Measure, and print what was found as JSON."""
    text = json.dumps(bench(times), indent=2) + "\n"
    if output is None:
        print(text, end="")
    else:
        write_atomically(output, text)


def bench(times: int) -> Results:
    """Measure breadth-first search, counting, and the whole process of planning for one object."""
    grounding = Grounding.load(SHIPPED / "grounding.json")
    parts = {
        "bfs_two_objects": bfs(grounding, times),
        "counting_sixteen_objects": counting(grounding, times),
        "without_translation": without_translation(grounding, max(1, times // 4)),
        "plan_process": process(max(1, times // 4)),
    }
    return {"passed": all(part["passed"] for part in parts.values()), "machine": machine(), **parts}


def bfs(grounding: Grounding, times: int) -> Results:
    """Time a search that finds nothing, three primitives deep, with two of the richest category."""
    counts = {
        one.symbol: sum(op.category == one.symbol for op in grounding.live) for one in categories(grounding)
    }
    richest = max(counts, key=lambda symbol: counts[symbol])
    x, y = (sum(bounds) / 2 for bounds in (grounding.table.x, grounding.table.y))
    pair = tuple(thing(f"item-0{n}", richest, x + 0.1 * n, y) for n in range(2))
    nowhere = {item.name: (item.position[0], item.position[1] + 0.2, 0.5) for item in pair}
    task = Problem("nowhere", pair, nowhere)
    branching, names = branching_of(task, grounding)

    def search() -> None:
        found = plan_bfs(task, branching, names, grounding.table)
        assert found.status is PlanStatus.NOT_FOUND, "there is no plan to be found"

    best, clock = least(search, times)
    return {
        "choices": int(branching.held.size),
        "cpu_ms": round(1000 * best, 2),
        "clock_ms": round(1000 * clock, 2),
        "limit_ms": MOST_MS_BFS,
        "passed": 1000 * best <= MOST_MS_BFS,
    }


def counting(grounding: Grounding, times: int) -> Results:
    """Time the exact planner on many objects, far apart on a table that is large enough for them."""
    wide = msgspec.structs.replace(grounding, table=Table(x=(-4.0, 4.0), y=(-4.0, 4.0)))
    task = crowd(wide, np.random.default_rng(10_000))
    found = plan_counting(task, wide)
    best, clock = least(lambda: plan_counting(task, wide), times)
    return {
        "objects": CROWD,
        "primitives": sum(not step.puts_down for step in found.steps),
        "fewest": fewest_steps(task, wide),
        "cpu_seconds": round(best, 4),
        "clock_seconds": round(clock, 4),
        "limit_seconds": MOST_SECONDS_COUNTING,
        "passed": found.status is PlanStatus.SOLVED and best <= MOST_SECONDS_COUNTING,
    }


def crowd(grounding: Grounding, rng: np.random.Generator) -> Problem:
    """Draw objects of all categories, a metre apart, and where random steps would lead each."""
    items, goals = [], {}
    for number in range(CROWD):
        symbol = categories(grounding)[number % len(categories(grounding))].symbol
        item = thing(f"item-{number:02d}", symbol, -3.0 + 2 * (number % 4), -3.0 + 2 * (number // 4))
        moves = [grounding.displacement(one) for one in grounding.live if one.category == symbol]
        place = np.array(item.position)
        while np.linalg.norm(place - item.position) < 0.3:  # so that hardly fewer steps would do
            place = np.array(item.position)
            for index in rng.integers(len(moves), size=STEPS):
                place += [*moves[index][:2], 0.0]
        items.append(item)
        goals[item.name] = (float(place[0]), float(place[1]), float(place[2]))
    return Problem("crowd", tuple(items), goals, tolerance=0.02)


def without_translation(grounding: Grounding, times: int) -> Results:
    """Time Fast Downward on what we write for its search, and on PDDL, for a shipped problem."""
    task = Problem.load(SHIPPED / "problems" / "task-01.scene.json")
    spent = {}
    for encoding in ("sas", "strips"):

        def run(encoding: str = encoding) -> None:
            found = plan(task, grounding, encoding=encoding)
            assert found.status is PlanStatus.SOLVED, found.reason

        spent[encoding] = sum(least(run, times, children=among)[0] for among in (False, True))
    ratio = spent["sas"] / spent["strips"]
    return {
        "cpu_seconds": {encoding: round(seconds, 3) for encoding, seconds in spent.items()},
        "ratio": round(ratio, 3),
        "limit_ratio": MOST_OF_TRANSLATED,
        "passed": ratio <= MOST_OF_TRANSLATED,
    }


def process(times: int) -> Results:
    """Time `neurosym plan` as users start it, with Fast Downward, for the shipped problem of one object."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "tabletop"
        shutil.copytree(SHIPPED, folder, ignore=shutil.ignore_patterns("*.npz", "runs"))
        command = [sys.executable, "-m", "neurosym", "plan", str(folder), "task-01"]

        def run() -> None:
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

        best, clock = least(run, times, children=True)
    return {
        "cpu_seconds": round(best, 3),
        "clock_seconds": round(clock, 3),
        "limit_seconds": MOST_SECONDS_PROCESS,
        "passed": best <= MOST_SECONDS_PROCESS,
    }


def least(work: Callable[[], Any], times: int, *, children: bool = False) -> tuple[float, float]:
    """Return the least CPU time and the least time of the clock that something takes [s]."""
    cpu, clock = [], []
    for _ in range(times):
        begin, cpu_begin = time.perf_counter(), cpu_seconds(children)
        work()
        clock.append(time.perf_counter() - begin)
        cpu.append(cpu_seconds(children) - cpu_begin)
    return min(cpu), min(clock)


def cpu_seconds(children: bool) -> float:
    """Return the CPU time of this process so far, or that of those that it started [s]."""
    spent = os.times()
    return spent.children_user + spent.children_system if children else time.process_time()


def categories(grounding: Grounding) -> tuple[Any, ...]:
    """List the categories that anything can be done to."""
    used = {operator.category for operator in grounding.live}
    return tuple(one for one in grounding.operators.categories if one.symbol in used)


def thing(name: str, category: str, x: float, y: float) -> SceneObject:
    """Make a small object at rest."""
    return SceneObject(name, category, (0.05, 0.05, 0.05, 0.0), (x, y, 0.025))


if __name__ == "__main__":
    tyro.cli(main)
