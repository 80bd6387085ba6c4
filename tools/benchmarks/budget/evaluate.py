"""What can plans do, by all interactions they cost? `make evaluate-budget`, into docs/results/budget.*.

A run is learned in rounds, and tried after some of them on tasks that nothing was chosen on. Ways to spend
the budget are compared: what explores is curious by disagreement or by entropy, or it is random; and *stages*
in a row explore with all that rehearsing leaves, and take the paper's candidates. Goes on where it was
interrupted.
"""

import shutil
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

from neurosym.commands.pipeline import run
from neurosym.data.interactions import Interactions
from neurosym.files import read_json
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import OBJECTS, ledger_of
from neurosym.stages.rounds import Budget
from tools.benchmarks import options
from tools.benchmarks.budget.summary import STAGES, TOTALS, WAYS, Cell, domain_name, page, summarise
from tools.benchmarks.carrying.tasks import far
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Jobs, cpu_seconds
from tools.benchmarks.planning.jobs import blocks
from tools.benchmarks.planning.measures import TIME_LIMIT
from tools.benchmarks.planning.trials import tried

FIRST_TASK = 800_000  # seed of the first task, far from those of other evaluations
KEPT = (layout.WORLD, layout.MODEL, layout.GROUNDING)
_REHEARSALS = 40  # objects that stages in a row rehearse each symbol on
_REHEARSED = 800  # interactions that this takes: thirty on each of four categories at least


def main(
    seeds: options.Seeds = 3,
    scale: options.Scale = 1.0,
    work: options.Work = Path("evaluation/budget"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Learn, try, and write what came of it, a seed after the other."""
    evaluation = Evaluation("budget", work, results, workers)

    def report() -> None:
        summary = summarise(evaluation.found())
        evaluation.write(summary, page(summary))

    for seed in range(1, seeds + 1):
        for total in TOTALS:
            ways = [way for way in WAYS if total in WAYS[way]]
            learning = {
                f"learn-{domain_name(way, seed, total)}": partial(learn, work, way, seed, total)
                for way in ways
            }
            evaluation.perform(learning, f"seed {seed}, learning from {total:,}")
            trying: Jobs = {}
            for way in ways:
                trying |= _tasks(work, way, seed, total, scale)
            evaluation.perform(trying, f"seed {seed}, tasks after {total:,}", report)
    report()


def learn(work: Path, way: str, seed: int, total: int) -> dict[str, Any]:
    """Go on with a run until so many interactions, and keep what it takes to try it; say what that took."""
    folder, begin = work / f"{way}-{seed}", cpu_seconds()
    common: dict[str, Any] = {"seed": seed, "workers": 1, "problems": 0}
    places = None if way.endswith("places") else 0
    if way == STAGES:
        folder = work / domain_name(way, seed, total)
        explored, few = total - _REHEARSED, {"choice": "lowest-error", "rehearsals": _REHEARSALS}
        run(folder, steps=explored, places=0, **few, **common)  # type: ignore[arg-type]
        return {"cpu": cpu_seconds() - begin, "interactions": _spent(folder)}
    strategy: Any = way if way in ("random", "entropy") else "disagreement"
    run(folder, interactions=total, strategy=strategy, places=places, **common)
    copy = work / domain_name(way, seed, total)
    copy.mkdir(exist_ok=True)
    for name in KEPT:
        shutil.copy(folder / name, copy / name)
    budget = read_json(folder / layout.BUDGET, Budget)
    return {"cpu": cpu_seconds() - begin, "interactions": budget.total, "idle": budget.is_idle}


def _spent(folder: Path) -> int:
    """Count what stages in a row explored and performed."""
    return len(Interactions.load(folder / layout.INTERACTIONS)) + len(
        ledger_of(DomainFolder(folder), OBJECTS)
    )


def _tasks(work: Path, way: str, seed: int, total: int, scale: float) -> Jobs:
    """List the jobs that try what was learned, by their names."""
    folder, found = work / domain_name(way, seed, total), dict[str, Any]()
    for cell in WAYS[way][total]:
        for block in blocks(options.scaled(scale, cell.count), 10):
            name = f"try-{folder.name}-{cell.name}-{block.start}"
            found[name] = partial(_try, folder, cell, seed, block)
    return found


def _try(folder: Path, cell: Cell, seed: int, block: Sequence[int]) -> list[Any]:
    """Try tasks, blindly and with replanning."""
    bench, first = bench_of(folder), FIRST_TASK + 1000 * seed
    drawn = (
        far(bench, cell.objects, first + number, graspable=True, tolerance=cell.tolerance)
        if cell.is_far
        else bench.draw(cell.objects, first + number, cell.tolerance)
        for number in block
    )
    return tried(bench.setting, drawn, time_limit=TIME_LIMIT)


if __name__ == "__main__":
    options.begin(main)
