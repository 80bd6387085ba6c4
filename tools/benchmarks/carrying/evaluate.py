"""How well are objects carried to places? `make evaluate-places`, into docs/results/places.*.

For each seed a domain is learned, with places; that of seed 1 is `domains/places`. It is tried on tasks that
nothing was chosen on: goals anywhere on the table for one to eight objects, swaps, rows and crowds. They are
compared with actions written by hand, and with the same domain without places. Goes on where it was
interrupted: what was tried, and what it takes to try more, is kept beside the results.
"""

import filecmp
import math
import shutil
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import msgspec
import numpy as np
import tyro

from neurosym.evaluation.comparison import Setting
from neurosym.formats import PlaceFile
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable
from neurosym.stages.layout import GROUNDING, MODEL, PLACE_OPERATORS, WORLD
from neurosym.stages.learning import TO_PLACES
from tools.benchmarks import domains, options
from tools.benchmarks.carrying import tasks
from tools.benchmarks.carrying.by_hand import carry_by_hand
from tools.benchmarks.carrying.summary import BASELINES, page, slug, summarise
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Jobs
from tools.benchmarks.planning.jobs import blocks
from tools.benchmarks.planning.measures import TIME_LIMIT
from tools.benchmarks.planning.trials import trials_of, tried, try_task
from tools.relearn_places import FOLDER as SHIPPED
from tools.relearn_places import PLACES, SEED, STEPS

DOMAINS = "places-domains.zip"
KEPT = (WORLD, MODEL, GROUNDING)  # what is needed of a learned domain to try it
FIRST_TASK = 700_000  # seed of the first task, far from those of other evaluations
AT_RANDOM = 2  # seeds with which what carries is learned from random actions, too
LED = ("graspable 1", "graspable 2", "graspable 4")
"""What is tried without places; with eight objects a search takes too long."""
WITHIN = 0.015  # so near to what an operator does on average does a rehearsal end right [m]


def main(
    seeds: options.Seeds = 5,
    steps: options.Steps = STEPS,
    places: Annotated[int, tyro.conf.arg(help="Interactions besides that are aimed at places.")] = PLACES,
    scale: options.Scale = 1.0,
    work: options.Work = Path("evaluation/places"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Learn, try, and write what came of it; a seed is reported as soon as it is done."""
    evaluation, cells = Evaluation("places", work, results, workers), tasks.cells(scale)
    domains.restore(results / DOMAINS, work)
    if (steps, places) == (STEPS, PLACES):
        take_shipped(work)
    of_seeds: dict[int, dict[str, Jobs]] = {}

    def report() -> None:
        found = evaluation.found()
        trials = {name: [trials_of(found, of[name]) for of in of_seeds.values()] for name, *_ in cells}
        summary = summarise(found, trials, seeds=len(of_seeds), steps=steps, places=places)
        evaluation.write(summary, page(summary))

    for seed in range(1, seeds + 1):
        folder = work / f"seed-{seed}"
        learning = {f"learn-{seed}": partial(learn, folder, seed, steps, places)}
        evaluation.perform(learning, f"seed {seed}, learning")
        domains.keep(work, results / DOMAINS, kept)
        of_seeds[seed] = {cell[0]: _jobs(folder, seed, cell) for cell in cells}
        every = {name: job for jobs in of_seeds[seed].values() for name, job in jobs.items()}
        evaluation.perform(every, f"seed {seed}, tasks", report)
        report()
    evaluation.perform(_baselines(work / "seed-1", cells), "baselines", report)
    some = range(1, min(seeds, AT_RANDOM) + 1)
    at_random = {f"random-{seed}": partial(_learn_at_random, work, seed, places) for seed in some}
    evaluation.perform(at_random, "learning from random actions", report)
    report()


def take_shipped(work: Path) -> None:
    """Copy the shipped domain, which is that of its seed, unless it is there."""
    if SHIPPED.exists() and not (work / f"seed-{SEED}").exists():
        shutil.copytree(SHIPPED, work / f"seed-{SEED}")


def kept(folder: Path) -> Iterator[str]:
    """List what is kept of a domain that was learned, and is not the shipped one."""
    own, shipped = folder / GROUNDING, SHIPPED / GROUNDING
    if own.exists() and not (shipped.exists() and filecmp.cmp(own, shipped, shallow=False)):
        yield from (name for name in KEPT if (folder / name).exists())


def learn(folder: Path, seed: int, steps: int, places: int) -> dict[str, Any]:
    """Learn a domain with places, unless that was done; say how well it carries, see `carries`."""
    if not (folder / GROUNDING).exists():
        domains.learn(folder, "disagreement", seed, steps)
        domains.learn(folder, "disagreement", seed, places, TO_PLACES)
        domains.compiled(folder)
    learned = Grounding.load(folder / GROUNDING).places
    assert learned is not None, "places were learned"
    return carries(learned)


def _learn_at_random(work: Path, seed: int, places: int) -> dict[str, Any]:
    """Learn once more what carries, from as many actions at random."""
    learned, folder = work / f"seed-{seed}", work / f"random-{seed}"
    folder.mkdir(exist_ok=True)
    for name in (WORLD, MODEL):
        shutil.copy(learned / name, folder / name)
    domains.learn(folder, "random", seed, places, TO_PLACES)
    return carries(PlaceFile.load(folder / PLACE_OPERATORS).table())


def carries(table: OperatorTable) -> dict[str, Any]:
    """Say how often the best action symbol carries graspable objects, and how nearly alike.

    Returns:
        Of that symbol: the share of rehearsals on graspable objects, drawn as the world draws them, that end
        within 15 mm of what the operator does on average; and the median distance from it [mm].
    """
    best: dict[str, Any] = {"symbol": "", "right": 0.0, "median_mm": math.nan}
    objects = {category.symbol: category.objects for category in table.categories}
    for symbol in table.symbols:
        away = []
        for one in (one for one in table.operators if one.primitive == symbol):
            rows = zip(one.rehearsals[: one.trials], one.objects or objects[one.subject], strict=False)
            centre = one.promise.outcome if one.promise and one.promise.kind == "carried" else None
            for row in [row for row, features in rows if tasks.is_graspable(np.array(features))]:
                carried = centre is not None and row.kind == "carried"
                away.append(math.dist(row.outcome, centre) if carried else math.inf)
        right = float(np.mean([distance <= WITHIN for distance in away])) if away else 0.0
        if right > best["right"]:
            best = {"symbol": symbol, "right": right, "median_mm": 1000 * float(np.median(away))}
    return best


def _jobs(folder: Path, seed: int, cell: tasks.Cell) -> Jobs:
    name, draw, count = cell
    return {
        f"try-{seed}-{slug(name)}-{block.start}": partial(_try_all, folder, draw, seed, block)
        for block in blocks(count, tasks.BLOCK)
    }


def _try_all(folder: Path, draw: tasks.Draw, seed: int, block: Sequence[int]) -> list[Any]:
    """Try tasks, blindly and with replanning; nothing depends on the clock."""
    bench, first = bench_of(folder), FIRST_TASK + 10_000 * seed
    return tried(bench.setting, (draw(bench, first + number) for number in block))


def _baselines(folder: Path, cells: Sequence[tasks.Cell]) -> Jobs:
    """List what is compared, on the tasks that the domain of the first seed is tried on."""
    by_hand, without = BASELINES
    found: Jobs = {}
    for name, draw, count in cells:
        seeds = range(FIRST_TASK + 10_000, FIRST_TASK + 10_000 + count)
        if not name.startswith("all"):  # there is nothing written by hand for these
            found[slug(f"{by_hand} {name}")] = partial(_by_hand, folder, draw, seeds)
        if name in LED:
            found[slug(f"{without} {name}")] = partial(_without_places, folder, draw, seeds)
    return found


def _by_hand(folder: Path, draw: tasks.Draw, seeds: Sequence[int]) -> list[bool]:
    """Say of tasks whether they are reached by hand-written actions."""
    bench = bench_of(folder)
    return [carry_by_hand(draw(bench, seed), bench.setting.world, seed).reached for seed in seeds]


def _without_places(folder: Path, draw: tasks.Draw, seeds: Sequence[int]) -> list[bool]:
    """Say of tasks whether they are reached, with replanning, by a domain that knows no places."""
    bench = bench_of(folder)
    grounding = msgspec.structs.replace(bench.setting.grounding, places=None)
    setting = Setting(bench.setting.world, grounding, bench.setting.predict)
    drawn = [draw(bench, seed) for seed in seeds]
    trials = [try_task(setting, task, blind=False, time_limit=TIME_LIMIT) for task in drawn]
    return [one.replanned is not None and one.replanned.reached for one in trials]


if __name__ == "__main__":
    options.begin(main)
