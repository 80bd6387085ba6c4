"""Goals anywhere on the table, at least 15 cm away: how many are reached, and what ends the runs that miss.

`python -m tools.benchmarks.planning.anywhere` goes on where it was interrupted; same seeds, same tasks.
"""

import os
from collections import Counter
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import msgspec
import numpy as np
import tyro

from neurosym.console import say, show_table
from neurosym.evaluation.comparison import planner_of
from neurosym.evaluation.comparison_tasks import Bench
from neurosym.execution.executor import execute
from neurosym.operators import vector
from neurosym.pddl.validation import footprints_apart, overlapping
from neurosym.planners import PlanStatus
from neurosym.problems import Problem, SceneObject
from neurosym.worlds.problem_drawing import item_names
from tools.benchmarks.jobs import load_jobs, perform
from tools.benchmarks.planning.jobs import SHIPPED, stamp
from tools.benchmarks.planning.measures import PLANNER, bench_of

WORK = Path("evaluation/anywhere")
AWAY = 0.15
"""Least distance of a goal from where its object stands [m]."""
_STREAM = 0x616E7977  # keeps this randomness apart from any other
_TRIES = 10_000


def draw_anywhere(bench: Bench, objects: int, seed: int) -> Problem:
    """Draw a scene, and for each object a place on the table where it fits beside the other goals and starts.

    Args:
        bench: The world and the learned domain.
        objects: How many objects.
        seed: Same seed, same task.
    """
    world = bench.setting.world
    rng = np.random.default_rng([_STREAM, objects, seed])
    scene = world.sample_scene(rng, objects)
    names, symbols = item_names(objects), bench.categorise(scene.features)
    items = tuple(
        SceneObject(name, symbol, tuple(features.tolist()), vector(position), tuple(turn.tolist()))
        for name, symbol, features, position, turn in zip(
            names, symbols, scene.features, scene.positions, scene.orientations, strict=True
        )
    )
    task = Problem(f"anywhere-{objects:02d}-{seed:05d}", items, {}, provenance="anywhere on the table")
    apart, taken, goals = footprints_apart(task), scene.positions[:, :2].copy(), {}
    low, high = task.room(world.table)
    for row, item in enumerate(items):
        for _ in range(_TRIES):
            spot = rng.uniform(low[row], high[row])
            far = np.linalg.norm(spot - scene.positions[row, :2]) >= AWAY
            others = np.delete(np.arange(objects), row)
            if far and not overlapping(spot, taken[others], apart[row, others]).any():
                goals[item.name] = (float(spot[0]), float(spot[1]), item.position[2])
                taken[row] = spot
                break
    return msgspec.structs.replace(task, goals=goals)


def try_task(objects: int, seed: int, replans: int | None) -> dict[str, Any]:
    """Plan a task with the shipped domain, and execute the plan with replanning."""
    bench = bench_of(SHIPPED)
    task, setting = draw_anywhere(bench, objects, seed), bench.setting
    solve = planner_of(setting, PLANNER, time_limit=None)
    found = solve(task, setting.grounding)
    entry: dict[str, Any] = {"task": task.name, "status": found.status.value, "reason": found.reason}
    if found.status is PlanStatus.SOLVED:
        run = execute(setting.world, task, setting.grounding, found.steps, replanner=solve, replans=replans)
        entry |= {"reached": run.reached, "ended": run.ended, "why": run.reason, "replans": run.replans}
        entry |= {"primitives": len(run.steps)}
    return entry


def main(
    objects: Annotated[int, tyro.conf.arg(help="Objects in each task.")] = 2,
    tasks: Annotated[int, tyro.conf.arg(help="How many tasks.")] = 20,
    workers: Annotated[int, tyro.conf.arg(help="Jobs at once.")] = os.cpu_count() or 1,
    work: Annotated[Path, tyro.conf.arg(help="Folder for what was measured.")] = WORK,
) -> None:
    """Try each task with ten new plans at most, and with as many as a run may ask for by itself."""
    (work / "jobs").mkdir(parents=True, exist_ok=True)
    budgets = {"10": 10, "usual": None}
    prefix = f"anywhere-{stamp(SHIPPED)}-{objects}"
    names = {budget: [f"{prefix}-{budget}-{seed:03d}" for seed in range(tasks)] for budget in budgets}
    jobs = {
        name: partial(try_task, objects, seed, budgets[budget])
        for budget, row in names.items()
        for seed, name in enumerate(row)
    }
    perform(work / "jobs", jobs, workers, lambda: None, label="anywhere")
    known = load_jobs(work / "jobs")
    rows = []
    for budget, row in names.items():
        found = [known[name] for name in row if name in known]
        reached = sum(entry.get("reached", False) for entry in found)
        ended = Counter(entry.get("ended", entry["status"]) for entry in found if not entry.get("reached"))
        replans = sum(entry.get("replans", 0) for entry in found)
        why = ", ".join(f"{kind} {count}" for kind, count in ended.most_common())
        rows.append([budget, f"{reached} of {len(found)}", str(replans), why])
    show_table(
        f"{objects} objects, goals anywhere", ["new plans", "reached", "asked for", "else ended by"], rows
    )
    say(f"what was measured is in {work / 'jobs'}")


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # for the jobs, of which there are several at once
    tyro.cli(main)
