"""What can plans do, by all interactions they cost? `make evaluate-budget`, into docs/results/budget.*.

A run is learned in rounds, and tried after some of them on tasks that nothing was chosen on. Ways to spend
the budget are compared (`ways.py`); what is most asked for comes first. Goes on where it was interrupted.
"""

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.choices import CELL
from neurosym.commands.learn import make_domain_folder
from neurosym.commands.pipeline import run
from neurosym.data.interactions import Interactions
from neurosym.files import read_json
from neurosym.learning.training_config import DEFAULT_BITS
from neurosym.learning.training_report import TrainingReport
from neurosym.stages import layout
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import AIMS, distill_stage, explore_stage, ledger_of, train_stage
from neurosym.stages.rounds import explored_in, perform
from tools.benchmarks import options
from tools.benchmarks.budget import codes, engines, heights, interaction
from tools.benchmarks.budget.curve import draw, draw_curiosity
from tools.benchmarks.budget.summary import page, summarise
from tools.benchmarks.budget.ways import STAGES, TOWERS, WAYS, Cell, domain_name, left_out
from tools.benchmarks.carrying.tasks import far
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Jobs, cpu_seconds
from tools.benchmarks.planning import measures
from tools.benchmarks.planning.jobs import blocks
from tools.benchmarks.planning.trials import tried
from tools.benchmarks.relations import symbols, tasks
from tools.benchmarks.relations.trying import Words, try_all

FIRST_TASK = 800_000  # seed of the first task, far from those of other evaluations
NEW_PAIRS = 780_000
"""Added to the seed of a domain, so that it is judged on pairs that it was not learned with."""
KEPT = (layout.WORLD, layout.MODEL, layout.TRAINING, layout.GROUNDING, layout.BUDGET)
_OF_PAIRS = (
    layout.RELATION_MODEL,
    layout.RELATION_CHANCES,
    layout.RELATION_STATES,
    layout.RELATION_OPERATORS,
    layout.PLACE_OPERATORS,
)
_OBJECTS = 30  # of each category, that stages rehearse each symbol on
_ENOUGH_FOR_FOUR_BITS = 4000
_LITTLE = 2000  # with a smaller budget a run is one of its own, and does not go on
_CURVE = ("one-budget", STAGES, "random", "entropy")
_PARTS = ("no-teaching", "no-prior", "evenly", "no-stopping")
_TURNS = (
    ((1000, 2000), _CURVE, 0),
    ((4000, 6000), ("one-budget",), 0),
    ((5000, 10_000), ("with-places",), 0),
    ((8000,), ("with-relations",), 0),
    ((2000, 6000), _PARTS, 0),
    ((4000, 8000), _CURVE, 0),
    ((2000,), _CURVE, 2),
    ((4000,), ("one-budget", "random"), 2),
    ((8000,), _CURVE, 2),
    ((16_000,), ("one-budget", "random", "entropy"), 0),
    ((6000,), ("mujoco",), 0),
)
"""After how many interactions what was learned is tried, which ways, with how many seeds more than usual."""
_HEIGHTS_AFTER = 5  # turns, it is asked when curiosity pays
_TIMED = {"default": (), "without_places": ("--places", "0"), "mujoco": ("--engine", "mujoco")}


def main(
    seeds: options.Seeds = 3,
    turns: Annotated[int, tyro.conf.arg(help="How many of the turns of ways are taken.")] = len(_TURNS),
    scale: options.Scale = 1.0,
    work: options.Work = Path("evaluation/budget"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Learn, try, and write what came of it."""
    evaluation = Evaluation("budget", work, results, workers)

    def report() -> None:
        summary = summarise(evaluation.found())
        draw(summary, results / "budget.png")
        draw_curiosity(summary["curiosity"], results / "curiosity.png")
        evaluation.write(summary, page(summary))

    evaluation.perform({"random-actions": partial(codes.test, work)}, "random actions")
    evaluation.perform({engines.JOB: engines.compare}, "both engines")
    drawing, widening = heights.jobs(work, seeds)
    for number, (points, ways, more) in enumerate(_TURNS[:turns]):
        if number == _HEIGHTS_AFTER:
            evaluation.perform(drawing, "higher action boxes")
            evaluation.perform(widening, "exploring in these", report)
        _take(evaluation, points, ways, range(1, seeds + more + 1), scale)
        report()
    alone = Evaluation("budget", work, results)
    alone.perform(
        {f"time-{name}": partial(_time, work, name) for name in _TIMED}, "timing one run", fresh=True
    )
    alone.perform({"ratio": partial(interaction.compare, work)}, "timing interactions", fresh=True)
    report()


def _take(
    evaluation: Evaluation, points: Sequence[int], ways: Sequence[str], seeds: Sequence[int], scale: float
) -> None:
    """Learn in some ways from so many interactions, and try what was learned."""
    for total in points:
        some = [(way, seed) for seed in seeds for way in ways if total in WAYS[way].points]
        learning = {
            f"learn-{domain_name(way, seed, total)}": partial(learn, evaluation.work, way, seed, total)
            for way, seed in some
        }
        evaluation.perform(learning, f"learning from {total:,}", fresh=True)
        trying, found = Jobs(), evaluation.found()
        for way, seed in some:
            if told := found.get(f"learn-{domain_name(way, seed, total)}"):
                trying |= _tasks(evaluation.work, way, seed, total, scale, told)
        evaluation.perform(trying, f"tasks after {total:,}")


def _time(work: Path, name: str) -> dict[str, float]:
    """Time one run with what is usual, and the machine by importing numpy."""
    folder, begin, cpu = work / f"time-{name}", time.perf_counter(), cpu_seconds()
    shutil.rmtree(folder, ignore_errors=True)
    called = [
        sys.executable,
        "-m",
        "neurosym",
        "run",
        folder,
        "--seed",
        "21",
        "--problems",
        "2",
        *_TIMED[name],
    ]
    environment = {key: value for key, value in os.environ.items() if key != "OMP_NUM_THREADS"}
    subprocess.run(called, check=True, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    minutes, cpu = (time.perf_counter() - begin) / 60, cpu_seconds() - cpu
    before = cpu_seconds()
    subprocess.run([sys.executable, "-c", "import numpy"], check=True)
    return {"minutes": minutes, "cpu_minutes": cpu / 60, "unit": cpu_seconds() - before}


def learn(work: Path, way: str, seed: int, total: int) -> dict[str, Any]:
    """Go on with a run until so many interactions, and keep what it takes to try it; say what that took.

    It goes through all checkpoints, though they are not asked for; so it is the same run where its folder is
    gone, as on another machine, or has grown beyond.
    """
    begin, known = cpu_seconds(), WAYS[way]
    folder = work / f"{way}-{seed}-{'little' if total < _LITTLE else 'run'}"
    chosen: dict[str, Any] = {"seed": seed, "workers": 1, "problems": 0, "places": 0, **known.options}
    if way == STAGES or ((folder / layout.BUDGET).exists() and _performed(folder) > total):
        shutil.rmtree(folder, ignore_errors=True)
    if way == STAGES:
        _learn_in_stages(folder, seed, total)
    else:
        before = [point for point in sorted(known.points) if _LITTLE <= point < total]
        with left_out(known.without):
            for point in [*before, total]:  # nothing is done twice
                begin = cpu_seconds()
                run(folder, interactions=point, **chosen)
    copy = work / domain_name(way, seed, total)
    for name in (*KEPT, *_OF_PAIRS):
        if (folder / name).exists():
            (copy / name).parent.mkdir(exist_ok=True, parents=True)
            shutil.copy(folder / name, copy / name)
    pairs = symbols.measure(copy, NEW_PAIRS + seed, workers=1) if "relations" in known.options else None
    return {
        "cpu": cpu_seconds() - begin,
        "interactions": _performed(folder),
        "explored": explored_in(DomainFolder(folder)),
        "moved": float(heights.moved(Interactions.load(folder / layout.INTERACTIONS)).mean()),
        "kinds": measures.kinds(copy) or [],
        "r2": read_json(copy / layout.TRAINING, TrainingReport).r2_through_codes,
        "pairs": pairs,
    }


def _performed(folder: Path) -> int:
    """Count all interactions of a domain folder, whatever they were for."""
    domain = DomainFolder(folder)
    return explored_in(domain).total() + sum(len(ledger_of(domain, aim)) for aim in AIMS)


def _learn_in_stages(folder: Path, seed: int, total: int) -> None:
    """Rehearse each symbol on thirty objects of each category, and explore with all that this leaves.

    With few interactions actions have three bits, as in the paper: sixteen symbols would take nearly all.
    """
    bits = 4 if total >= _ENOUGH_FOR_FOUR_BITS else 3
    rehearsed = _OBJECTS * 2 ** (bits + DEFAULT_BITS[0])
    make_domain_folder(folder, "tabletop")
    domain = DomainFolder(folder)
    learning: dict[str, Any] = {"seed": seed, "regime": "default", "action_bits": bits}
    exploring: dict[str, Any] = {"strategy": "disagreement", "steps": total - rehearsed, "workers": 1}
    distilling: dict[str, Any] = {"objects": _OBJECTS, "budget": rehearsed, "choice": "predictable"}
    perform(domain, explore_stage(domain, **exploring, **learning))
    perform(domain, train_stage(domain, **learning))
    perform(domain, distill_stage(domain, seed=seed, workers=1, **distilling))
    perform(domain, compile_stage(domain, cell=CELL))


def _tasks(work: Path, way: str, seed: int, total: int, scale: float, learned: Mapping[str, Any]) -> Jobs:
    """List the jobs that try what was learned, by their names; pairs were judged by geometry."""
    folder = work / domain_name(way, seed, total)
    found: Jobs = {f"{codes.PREFIX}{folder.name}": partial(codes.judge, work, folder)}
    for cell in WAYS[way].points[total]:
        for block in blocks(options.scaled(scale, cell.count), 10):
            name = f"try-{folder.name}-{cell.name}-{block.start}"
            if cell.name == TOWERS:
                found[name] = partial(_try_towers, folder, learned["pairs"]["words"], seed, block)
            else:
                found[name] = partial(_try, folder, cell, seed, block)
    return found


def _try(folder: Path, cell: Cell, seed: int, block: Sequence[int]) -> list[Any]:
    """Try tasks, blindly and with replanning."""
    folder = engines.moved_over(folder, cell.engine) if cell.engine else folder
    bench, first = bench_of(folder), FIRST_TASK + 1000 * seed
    drawn = (
        far(bench, cell.objects, first + number, graspable=True, tolerance=cell.tolerance)
        if cell.name.startswith("far")
        else bench.draw(cell.objects, first + number, cell.tolerance)
        for number in block
    )
    return tried(bench.setting, drawn, time_limit=measures.TIME_LIMIT)


def _try_towers(folder: Path, words: Words, seed: int, block: range) -> list[Any]:
    """Try to build towers; geometry says what words mean, and what was reached."""
    draws = {name: draw_task for name, draw_task, _ in tasks.cells(1)}
    first = FIRST_TASK + 1000 * seed
    return try_all(folder, words, draws[TOWERS], range(first + block.start, first + block.stop))


if __name__ == "__main__":
    options.begin(main)
