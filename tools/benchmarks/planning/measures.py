"""What `evaluate.py` measures: one function for each kind of job, from files to plain JSON values.

No two jobs write the same file, so that any number can run at once; each says what it depends on in its name.
"""

import os
import resource
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.data.origin import StrategyName
from neurosym.errors import NeurosymError
from neurosym.evaluation.comparison import Bench, compare, planner_of
from neurosym.execution.executor import execute
from neurosym.execution.performance import summarise_run
from neurosym.execution.record import Run
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from neurosym.planners import PlanResult, PlanStatus, plan
from neurosym.problems import Problem
from neurosym.tasks.transition import primitives, validate
from tools.benchmarks import domains
from tools.benchmarks.domains import bench_of
from tools.benchmarks.paper_tables import KINDS, LEAST_OBJECTS, LEAST_SHARE, kind_of
from tools.benchmarks.planning.tasks import draw_symbolic, fewest_steps
from tools.benchmarks.planning.trials import PLANNER, tried

TIME_LIMIT = 30.0  # of one plan for a drawn task [s]
CAP = 30.0  # of one plan for a scaling task [s]
GIVE_UP = 2  # time-outs in one cell, after which its other tasks are not tried


def learn(folder: Path, strategy: StrategyName, seed: int, steps: int) -> dict[str, Any]:
    """Explore, train, distil and compile, each unless it is done."""
    begin = time.perf_counter()
    domains.learn(folder, strategy, seed, steps)
    domains.compiled(folder)
    live = bench_of(folder).setting.grounding.live
    return {"seconds": time.perf_counter() - begin, "live": len(live)}


def draw(folder: Path, objects: int, seeds: Sequence[int]) -> list[Any]:
    """Draw tasks as the paper does."""
    bench = bench_of(folder)
    return [msgspec.to_builtins(bench.draw(objects, seed, TOLERANCE)) for seed in seeds]


def judge(folder: Path, drawn: Path, *, tolerance: float, planners: Sequence[str]) -> list[Any]:
    """Have planners plan for tasks that were drawn, and execute their plans."""
    bench = bench_of(folder)
    return [
        msgspec.to_builtins(compare(bench.setting, task, planners, time_limit=TIME_LIMIT))
        for task in _read_tasks(bench, drawn, tolerance)
    ]


def precise(folder: Path, drawn: Path, *, tolerance: float) -> list[Any]:
    """Try tasks that were drawn, blindly and with replanning."""
    bench = bench_of(folder)
    return tried(bench.setting, _read_tasks(bench, drawn, tolerance), time_limit=TIME_LIMIT)


def far(folder: Path, objects: int, seeds: Sequence[int]) -> list[Any]:
    """Try tasks with goals anywhere, with replanning."""
    bench = bench_of(folder)
    return tried(
        bench.setting, (bench.draw(objects, seed, TOLERANCE, "anywhere") for seed in seeds), blind=False
    )


def kinds(folder: Path) -> list[str] | None:
    """Say by the rule of `paper_tables` which kinds of primitive the operators of a domain are.

    None if the rehearsals are not kept.
    """
    grounding, found = bench_of(folder).setting.grounding, set[str]()
    telling = {one.symbol for one in grounding.objects.categories if one.share >= LEAST_OBJECTS}
    rehearsed = [op for op in grounding.objects.operators if op.subject in telling and op.rehearsals]
    for operator in rehearsed:
        told = [kind_of(one, grounding.lift_height) for one in operator.rehearsals[: operator.trials]]
        found |= {kind for kind in KINDS if told.count(kind) >= LEAST_SHARE * len(told)}
    return [kind for kind in KINDS if kind in found] if rehearsed else None


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
    world, grounding = bench.setting.world, bench.setting.grounding
    solve = planner_of(bench.setting, PLANNER, time_limit=TIME_LIMIT)
    for task in _read_tasks(bench, drawn, TOLERANCE):
        result, seed = solve(task, grounding), int(task.name.rpartition("-")[2])
        entry: dict[str, Any] = {"task": task.name, "solvable": False, "status": result.status.value}
        if result.status is PlanStatus.SOLVED:
            run = execute(world, task, grounding, result.steps, replanner=solve, nudge_seed=seed)
            entry |= {"solvable": True, "nudge": msgspec.to_builtins(run.nudge), "run": _in_short(run, bench)}
        found.append(entry)
    return found


def without_costs(folder: Path, drawn: Path) -> list[Any]:
    """Plan as if every operator were as reliable as any other, and follow the plan blindly."""
    bench, found = bench_of(folder), []
    world, grounding = bench.setting.world, bench.setting.grounding
    flat = flattened(grounding)
    for task in _read_tasks(bench, drawn, TOLERANCE):
        result = plan(task, flat, PLANNER, time_limit=TIME_LIMIT)
        entry: dict[str, Any] = {"task": task.name, "status": result.status.value}
        if result.status is PlanStatus.SOLVED:
            entry |= _replayed(result, task, grounding)
            entry["run"] = _in_short(execute(world, task, grounding, result.steps), bench)
        found.append(entry)
    return found


def _replayed(result: PlanResult, task: Problem, grounding: Grounding) -> dict[str, Any]:
    valid = validate(result.steps, task, grounding).valid
    return {"valid": valid, "primitives": primitives(result.steps)}


def _in_short(run: Run, bench: Bench) -> Any:
    return msgspec.to_builtins(summarise_run(run, bench.setting.grounding))


def flattened(grounding: Grounding) -> Grounding:
    """Keep the live operators, and let each be as sure of its promise as any other: all cost alike."""
    table, replace = grounding.objects, msgspec.structs.replace
    operators = tuple(
        replace(one, trials=100, outcomes=(replace(one.promise, count=100, share=1.0, near_mean=100),))
        for one in table.operators
        if one in grounding.live and one.promise
    )
    return replace(grounding, objects=replace(table, operators=operators))


def draw_scaling(folder: Path, objects: int, difficulty: str, seeds: Sequence[int]) -> list[Any]:
    """Draw symbolic tasks, and count the fewest steps of each."""
    bench = bench_of(folder)
    tasks = [draw_symbolic(bench, objects, difficulty, seed) for seed in seeds]
    grounding = bench.setting.grounding
    return [{"task": msgspec.to_builtins(one), "fewest": fewest_steps(one, grounding)} for one in tasks]


def scaling(grounding_file: Path, drawn: Path, planner: str, options: Mapping[str, Any]) -> dict[str, Any]:
    """Let one planner plan for symbolic tasks, in a process of its own so that its memory can be told."""
    grounding, rows = Grounding.load(grounding_file), list[dict[str, Any]]()
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
            row |= _replayed(result, task, grounding)
        rows.append({**row, "reason": result.reason})
    own, children = _memory(resource.RUSAGE_SELF), _memory(resource.RUSAGE_CHILDREN)
    memory = {"children": children, "own": own, "own_before": before}
    return {"rows": rows, "megabytes": memory, "load": os.getloadavg()[0]}


def _read_tasks(bench: Bench, drawn: Path, tolerance: float) -> list[Problem]:
    """Read tasks that were drawn, and give their objects the symbols of this domain."""
    replace, read = msgspec.structs.replace, []
    for task in msgspec.json.decode(drawn.read_bytes(), type=list[Problem]):
        symbols = bench.categorise(np.array([item.features for item in task.objects]))
        named = zip(task.objects, symbols, strict=True)
        items = tuple(replace(item, category=symbol) for item, symbol in named)
        read.append(replace(task, objects=items, tolerance=tolerance))
    return read


def _memory(who: int) -> float:
    return round(resource.getrusage(who).ru_maxrss / 1024, 1)
