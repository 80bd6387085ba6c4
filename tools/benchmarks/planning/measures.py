"""What `evaluate.py` measures: one function for each kind of job, from files to plain JSON values.

No two jobs write the same file, so that any number can run at once; each says what it depends on in its name.
"""

import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.commands.learn import init
from neurosym.errors import NeurosymError
from neurosym.evaluation.comparison import Bench, compare, planner_of
from neurosym.execution.executor import execute
from neurosym.execution.rerun import summarise_run
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from neurosym.planners import PlanResult, PlanStatus, plan
from neurosym.planners.action_counts import fewest_steps
from neurosym.planners.bfs import branching_of, plan_bfs
from neurosym.problems import Problem
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import MODEL, PRIMITIVES, WORLD
from neurosym.stages.learning import distill_stage, explore_stage, train_stage
from neurosym.stages.pipeline import CELL
from neurosym.tasks.transition import validate
from tools.benchmarks.planning.tasks import draw_symbolic
from tools.benchmarks.planning.trials import PLANNER

TIME_LIMIT = 30.0  # of one plan for a drawn task [s]
CAP = 30.0  # of one plan for a scaling task [s]
REHEARSALS = 100
GIVE_UP = 2  # time-outs in one cell, after which its other tasks are not tried
REPEATS = 7


def learn(folder: Path, strategy: str, seed: int, steps: int) -> dict[str, Any]:
    """Explore, train, distil and compile, each unless it is done; the same as by the command line."""
    begin = time.perf_counter()
    if not (folder / WORLD).exists():
        init(folder)
    domain = DomainFolder(folder)
    for stage in (
        explore_stage(domain, strategy=strategy, steps=steps, seed=seed, regime="default", workers=1),
        train_stage(domain, seed=seed, regime="default"),
        distill_stage(domain, objects=REHEARSALS, seed=seed, workers=1),
        compile_stage(domain, cell=CELL),
    ):
        domain.perform(stage, again=False)
    bench = bench_of(folder)
    return {"seconds": time.perf_counter() - begin, "live": len(bench.setting.grounding.live)}


def prepare(folder: Path) -> bool:
    """Compile a domain that was distilled, unless it is done; say whether there is one."""
    if not all((folder / name).exists() for name in (MODEL, PRIMITIVES)):
        return False
    domain = DomainFolder(folder)
    domain.perform(compile_stage(domain, cell=CELL), again=False)
    return True


@cache
def bench_of(folder: Path) -> Bench:
    """Load a domain folder, once in each process."""
    return Bench(DomainFolder(folder))


def draw(folder: Path, objects: int, seeds: Sequence[int]) -> list[Any]:
    """Draw tasks as the paper does."""
    bench = bench_of(folder)
    return [msgspec.to_builtins(bench.draw(objects, seed, TOLERANCE)) for seed in seeds]


def judge(folder: Path, drawn: Path, *, tolerance: float, planners: Sequence[str]) -> list[Any]:
    """Have planners plan for tasks that were drawn, and execute their plans."""
    bench = bench_of(folder)
    return [
        msgspec.to_builtins(compare(bench.setting, task, planners, time_limit=TIME_LIMIT))
        for task in read_tasks(bench, drawn, tolerance)
    ]


def symbolic(folder: Path, objects: int, difficulty: str, seeds: Sequence[int]) -> list[Any]:
    """Have planners plan for symbolic tasks, and count the fewest steps there can be."""
    bench, found = bench_of(folder), []
    for seed in seeds:
        task = draw_symbolic(bench, objects, difficulty, seed)
        planners = ("bfs", "bfs-operators", PLANNER, "counting")
        record = compare(bench.setting, task, planners, time_limit=TIME_LIMIT, executed=False)
        fewest = fewest_steps(task, bench.setting.grounding)
        found.append({"record": msgspec.to_builtins(record), "fewest": fewest})
    return found


def disturbed(folder: Path, drawn: Path) -> list[Any]:
    """Execute plans while an object is nudged once, and replan."""
    bench, found = bench_of(folder), []
    setting = bench.setting
    solve = planner_of(setting, PLANNER, time_limit=TIME_LIMIT)
    for task in read_tasks(bench, drawn, TOLERANCE):
        result = solve(task, setting.grounding)
        entry: dict[str, Any] = {
            "task": task.name,
            "solvable": result.status is PlanStatus.SOLVED,
            "status": result.status.value,
        }
        if entry["solvable"]:
            run = execute(
                setting.world,
                task,
                setting.grounding,
                result.steps,
                replanner=solve,
                nudge_seed=int(task.name.rpartition("-")[2]),
            )
            entry["nudge"] = msgspec.to_builtins(run.nudge)
            entry["run"] = msgspec.to_builtins(summarise_run(run, setting.grounding))
        found.append(entry)
    return found


def without_costs(folder: Path, drawn: Path) -> list[Any]:
    """Plan as if every operator were as reliable as any other, and follow the plan blindly."""
    bench, found = bench_of(folder), []
    setting = bench.setting
    flat = flattened(setting.grounding)
    for task in read_tasks(bench, drawn, TOLERANCE):
        result = plan(task, flat, PLANNER, time_limit=TIME_LIMIT)
        entry: dict[str, Any] = {"task": task.name, "status": result.status.value}
        if result.status is PlanStatus.SOLVED:
            run = execute(setting.world, task, setting.grounding, result.steps)
            entry["valid"] = validate(result.steps, task, setting.grounding).valid
            entry["primitives"] = sum(not step.puts_down for step in result.steps)
            entry["run"] = msgspec.to_builtins(summarise_run(run, setting.grounding))
        found.append(entry)
    return found


def flattened(grounding: Grounding) -> Grounding:
    """Keep the live operators, and let each be as sure of its promise as any other: all cost alike."""
    table = grounding.operators
    operators = tuple(
        msgspec.structs.replace(
            operator,
            trials=100,
            modes=(msgspec.structs.replace(operator.promise, count=100, share=1.0, near_mean=100),),
        )
        for operator in table.operators
        if operator in grounding.live and operator.promise
    )
    return msgspec.structs.replace(grounding, operators=msgspec.structs.replace(table, operators=operators))


def draw_scaling(folder: Path, objects: int, difficulty: str, seeds: Sequence[int]) -> list[Any]:
    """Draw symbolic tasks, and count the fewest steps of each."""
    bench = bench_of(folder)
    tasks = [draw_symbolic(bench, objects, difficulty, seed) for seed in seeds]
    fewest = [fewest_steps(task, bench.setting.grounding) for task in tasks]
    return [{"task": msgspec.to_builtins(t), "fewest": f} for t, f in zip(tasks, fewest, strict=True)]


def scaling(grounding_file: Path, drawn: Path, planner: str, options: Mapping[str, Any]) -> dict[str, Any]:
    """Let one planner plan for symbolic tasks, in a process of its own so that its memory can be told."""
    grounding, rows = Grounding.load(grounding_file), []
    asked = {name: value for name, value in options.items() if name != "costs"}
    planned_in = grounding if options.get("costs", True) else flattened(grounding)
    before = _memory(resource.RUSAGE_SELF)
    for entry in msgspec.json.decode(drawn.read_bytes()):
        if sum(row["status"] == PlanStatus.TIMEOUT.value for row in rows) >= GIVE_UP:
            rows.append({"status": "not tried"})
            continue
        task = msgspec.convert(entry["task"], Problem)
        begin = time.perf_counter()
        try:
            result = plan(task, planned_in, planner, time_limit=CAP, **asked)
        except NeurosymError as error:  # a planner that is not installed
            result = PlanResult(PlanStatus.FAILED, (), 0.0, str(error))
        seconds = time.perf_counter() - begin
        row = {"status": result.status.value, "seconds": seconds, "fewest": entry["fewest"]}
        if result.status is PlanStatus.SOLVED:
            row["primitives"] = sum(not step.puts_down for step in result.steps)
            row["valid"] = validate(result.steps, task, grounding).valid
        rows.append({**row, "reason": result.reason})
    memory = {
        "children": _memory(resource.RUSAGE_CHILDREN),
        "own": _memory(resource.RUSAGE_SELF),
        "own_before": before,
    }
    return {"rows": rows, "megabytes": memory, "load": os.getloadavg()[0]}


def timings(folder: Path, double: Path) -> dict[str, Any]:
    """Time the whole process of `neurosym plan` for one object, and BFS three deep for two."""
    bench = bench_of(folder)
    problems = read_tasks(bench, double, TOLERANCE)
    tables = [branching_of(problem, bench.setting.grounding) for problem in problems]
    table = bench.setting.world.table
    searches = [
        _seconds(lambda p=p, b=b: plan_bfs(p, b, table)) for p, b in zip(problems, tables, strict=True)
    ]
    with tempfile.TemporaryDirectory(prefix="neurosym-timing-") as name:
        copy = Path(name) / "domain"
        shutil.copytree(folder, copy, ignore=shutil.ignore_patterns("interactions.npz", "plans", "runs"))
        ours = DomainFolder(copy)
        names = [n for n in ours.problem_names() if len(Problem.load(_scene_file(copy, n)).objects) == 1]
        command = [sys.executable, "-m", "neurosym", "plan", str(copy)]
        processes = [
            _seconds(lambda n=n: subprocess.run([*command, n], capture_output=True)) for n in names[:REPEATS]
        ]
    return {
        "plan_process_one_object": processes,
        "bfs_two_objects_depth_3": searches,
        "median_plan_process": statistics.median(processes),
        "median_bfs": statistics.median(searches),
        "load": os.getloadavg()[0],
    }


def _scene_file(folder: Path, name: str) -> Path:
    return folder / f"problems/{name}.scene.json"


def read_tasks(bench: Bench, drawn: Path, tolerance: float) -> list[Problem]:
    """Read tasks that were drawn, and give their objects the symbols of this domain."""
    tasks = msgspec.json.decode(drawn.read_bytes(), type=list[Problem])
    return [_symbolised(bench, task, tolerance) for task in tasks]


def _symbolised(bench: Bench, task: Problem, tolerance: float) -> Problem:
    symbols = bench.categorise(np.array([item.features for item in task.objects]))
    items = tuple(
        msgspec.structs.replace(item, category=symbol)
        for item, symbol in zip(task.objects, symbols, strict=True)
    )
    return msgspec.structs.replace(task, objects=items, tolerance=tolerance)


def _seconds(work: Any) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def _memory(who: int) -> float:
    return round(resource.getrusage(who).ru_maxrss / 1024, 1)
