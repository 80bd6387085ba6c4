"""How well are objects carried to places? `make evaluate-places`, into docs/results/places.*.

For each seed a domain is learned, with places; that of seed 1 is `domains/places`. It is tried on tasks that
nothing was chosen on: goals anywhere on the table for one to eight objects, swaps, rows and crowds. Goes on
where it was interrupted: what was tried, and what it takes to try more, is kept beside the results.
"""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from statistics import mean, median
from typing import Annotated, Any

import tyro

from tools.benchmarks.carrying import baselines, tasks
from tools.benchmarks.carrying.keeping import keep, restore, take_shipped
from tools.benchmarks.carrying.learned import learn, learn_at_random
from tools.benchmarks.carrying.tables import page
from tools.benchmarks.jobs import Evaluation, Job, machine
from tools.benchmarks.options import CORES, Results, Seeds, Steps, Work, Workers, begin
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.measures import bench_of
from tools.benchmarks.planning.trials import Trial, from_json, to_json, try_task
from tools.relearn_places import PLACES, STEPS

RESULTS, WORK = Path("docs/results"), Path("evaluation/places")
DOMAINS = "places-domains.zip"
FIRST_TASK = 700_000
"""Seed of the first task, far from those of other evaluations."""
AT_RANDOM = 2
"""Seeds with which what carries is learned from random actions, too."""
RIGHT = 0.9
"""A domain can carry if some action symbol ends graspable objects so often where it should."""


def main(
    seeds: Seeds = 5,
    steps: Steps = STEPS,
    places: Annotated[int, tyro.conf.arg(help="Interactions besides that are aimed at places.")] = PLACES,
    scale: Annotated[float, tyro.conf.arg(help="How many tasks, as a share of the full number.")] = 1.0,
    work: Work = WORK,
    results: Results = RESULTS,
    workers: Workers = CORES,
) -> None:
    """Learn, try, and write what came of it; a seed is reported as soon as it is done."""
    evaluation = Evaluation("places", work, results, workers)
    restore(results / DOMAINS, work)
    if (steps, places) == (STEPS, PLACES):
        take_shipped(work)
    tried: dict[int, dict[str, dict[str, Job]]] = {}
    every_cell = tasks.cells(scale)
    for seed in range(1, seeds + 1):
        folder = work / f"seed-{seed}"
        learning = {f"learn-{seed}": partial(learn, folder, seed, steps, places)}
        evaluation.perform(learning, f"seed {seed}, learning")
        keep(work, results / DOMAINS)
        tried[seed] = {cell[0]: _jobs(folder, seed, cell) for cell in every_cell}
        every = {name: job for jobs in tried[seed].values() for name, job in jobs.items()}
        report = partial(write_results, evaluation, tried, steps=steps, places=places)
        evaluation.perform(every, f"seed {seed}, tasks", report)
        report()
    compared = baselines.jobs(work / "seed-1", FIRST_TASK + 10_000, every_cell)
    evaluation.perform(compared, "baselines", report)
    at_random = {
        f"random-{seed}": partial(
            learn_at_random, work / f"seed-{seed}", work / f"random-{seed}", seed, places
        )
        for seed in range(1, min(seeds, AT_RANDOM) + 1)
    }
    evaluation.perform(at_random, "learning from random actions", report)
    report()


def write_results(
    evaluation: Evaluation, tried: Mapping[int, Mapping[str, Mapping[str, Job]]], *, steps: int, places: int
) -> None:
    """Write the tables, and what they are made from, of as much as was tried so far."""
    found = evaluation.found()
    names = next(iter(tried.values()))
    trials = {name: [_trials(found, of[name]) for of in tried.values()] for name in names}
    summary = summarise(found, trials, seeds=len(tried), steps=steps, places=places)
    evaluation.write(summary, page(summary))


def _jobs(folder: Path, seed: int, cell: tasks.Cell) -> dict[str, Job]:
    name, draw, count = cell
    slug = name.replace(", ", "-").replace(" ", "-")
    first = FIRST_TASK + 10_000 * seed
    return {
        f"try-{seed}-{slug}-{start}": partial(
            try_all, folder, draw, [first + n for n in range(start, start + tasks.BLOCK)]
        )
        for start in range(0, count, tasks.BLOCK)
    }


def try_all(folder: Path, draw: tasks.Draw, seeds: Sequence[int]) -> list[Any]:
    """Try tasks, blindly and with replanning; nothing depends on the clock."""
    bench = bench_of(folder)
    return to_json([try_task(bench.setting, draw(bench, seed), blind=True) for seed in seeds])


def _trials(found: Mapping[str, Any], jobs: Mapping[str, Job]) -> list[Trial]:
    return [trial for name in jobs for trial in from_json(found.get(name, []))]


def summarise(
    found: Mapping[str, Any],
    trials: Mapping[str, Sequence[Sequence[Trial]]],
    *,
    seeds: int,
    steps: int,
    places: int,
) -> dict[str, Any]:
    """Gather the shares of reached goals, for each seed and in the mean."""
    table = {
        name: {way: [figures.share(of_one, way) for of_one in of] for way in ("blind", "replanned")}
        | {"motions": _motions(of), "tasks": sum(map(len, of))}
        for name, of in trials.items()
    }

    def whole(name: str) -> float | None:
        known = [share for share in table[name]["replanned"] if share is not None]
        return mean(known) if known else None

    def sizes(kind: str, ending: str = "") -> dict[str, float | None]:
        return {str(n): whole(f"{kind} {n}{ending}") for n in (1, 2, 4, 8)}

    can, at_random = (
        [found.get(f"{how}-{seed}") for seed in range(1, seeds + 1)] for how in ("learn", "random")
    )
    return {
        "command": "make evaluate-places",
        "versions": machine("numpy", "pybullet", "torch", "up-fast-downward"),
        "seeds": seeds,
        "steps": steps,
        "places": places,
        "far_goals": sizes("graspable"),
        "far_goals_20mm": sizes("graspable", ", 20 mm"),
        "far_goals_all": sizes("all"),
        "swap": whole("swap"),
        "row": whole("row"),
        "crowded": whole("crowded"),
        "carry_seeds": sum(one is not None and one["right"] >= RIGHT for one in can),
        "carries": can,
        "carries_at_random": at_random,
        "baselines": baselines.summary(found, tasks.cells(1.0)),
        "table": table,
    }


def _motions(of_seeds: Sequence[Sequence[Trial]]) -> dict[str, float] | None:
    counts = [len(one.replanned.steps) for of_one in of_seeds for one in of_one if one.replanned]
    return {"median": median(counts), "most": max(counts)} if counts else None


if __name__ == "__main__":
    begin(main)
