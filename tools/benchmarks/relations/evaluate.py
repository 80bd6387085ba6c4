"""What can be done with one object relative to another? `make evaluate-relations`, into docs/results/.

First by actions that a person wrote, and by random ones. Then for each seed what can be done with pairs is
learned, starting from what carries to places with that seed; it is judged by geometry, and tried on tasks
that a person can solve. Goes on where it was interrupted.
"""

import json
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.files import make_folder
from neurosym.stages.layout import RELATIONS
from tools.benchmarks.carrying import keeping
from tools.benchmarks.jobs import Evaluation, Job, machine
from tools.benchmarks.options import CORES, Seeds, Workers, begin
from tools.benchmarks.relations import by_hand, learned, protocols, tasks
from tools.benchmarks.relations.beginnings import found_after
from tools.benchmarks.relations.singly import one_by_one
from tools.benchmarks.relations.summary import CURIOUS, FIRST, RANDOM, SINGLY, Way, summarise
from tools.benchmarks.relations.tables import page
from tools.benchmarks.relations.trying import try_all
from tools.relearn_towers import RELATIONS as STEPS

RESULTS, WORK = Path("docs/results"), Path("evaluation/relations")
DOMAINS = "relations-domains.zip"
PLACES = "places-domains.zip"
FIRST_TASK = 740_000
"""Seed of the first task, far from those of other evaluations."""
BLOCK = 5
"""Tasks that are tried together."""
AT_RANDOM = 1
"""Seeds with which relations are learned from random actions, too."""
WORKERS = 2


def main(
    seeds: Seeds = 5,
    steps: Annotated[int, tyro.conf.arg(help="Interactions that are aimed at other objects.")] = STEPS,
    count: Annotated[int, tyro.conf.arg(help="Tasks of each kind and seed, a multiple of 5.")] = 10,
    scale: Annotated[
        float, tyro.conf.arg(help="How many interactions by hand, as a share of the full number.")
    ] = 1.0,
    work: Annotated[Path, tyro.conf.arg(help="Folder for what was learned.")] = WORK,
    results: Annotated[Path, tyro.conf.arg(help="Folder for relations.json and relations.md.")] = RESULTS,
    workers: Workers = CORES,
) -> None:
    """Measure, learn and try, and write the results; what was done is not done again."""
    cells = (*tasks.cells(count), *protocols.cells(count))
    evaluation = Evaluation("relations", work, results, workers)
    hand = _by_hand(evaluation, scale)
    make_folder(work / "places")
    keeping.restore(results / PLACES, work / "places")
    keeping.take_shipped(work / "places")
    keeping.restore(results / DOMAINS, work, RELATIONS)
    if steps == STEPS:
        learned.take_shipped(work)

    def report() -> None:
        summary = summarise(hand, evaluation.found(), cells, seeds=seeds, steps=steps)
        evaluation.write(summary, page(summary))

    report()

    def do(jobs: Mapping[str, Job], label: str) -> None:
        evaluation.perform(jobs, label, report)

    every, some = range(1, seeds + 1), range(1, min(seeds, AT_RANDOM) + 1)
    do(_learning(work, CURIOUS, every, steps), "learning relations")
    learned.keep(work, results / DOMAINS)
    do(_tried(evaluation, CURIOUS, every, cells), "trying tasks")
    do(_singly(work, every, tasks.cells(count)), "trying with single objects")
    do(_first(work, every), "learning from the first interactions")
    do(_learning(work, RANDOM, some, steps), "learning from random actions")
    do(_tried(evaluation, RANDOM, some, cells), "trying what was learned from these")


def _by_hand(evaluation: Evaluation, scale: float) -> dict[str, Any]:
    """Measure what needs no learning, over a share of the usual interactions, unless the results have it."""

    def some(number: int) -> int:
        return max(4, round(number * scale))

    parts = {
        "put_over": partial(by_hand.put_over, some(50), 110, WORKERS),
        "towers_by_hand": partial(by_hand.towers, some(50), 111, WORKERS),
        "random": partial(by_hand.predictability, some(1000), 112, WORKERS),
    }
    path = evaluation.results / "relations.json"
    known = json.loads(path.read_text()) if path.exists() else {}
    if known.get("scale") != scale or not parts.keys() <= known.keys():
        evaluation.perform({f"hand-{name}-{scale:g}": job for name, job in parts.items()}, "by hand")
        found = evaluation.found()
        known = {name: found[f"hand-{name}-{scale:g}"] for name in parts}
    about = {"command": "make evaluate-relations", "machine": machine("numpy", "pybullet"), "scale": scale}
    return about | {name: known[name] for name in parts}


def _learning(work: Path, way: Way, seeds: Sequence[int], steps: int) -> dict[str, Job]:
    return {
        f"learn-{way.label(seed)}": partial(
            learned.learn, _places(work, seed), way.folder(work, seed), seed, steps, way.strategy
        )
        for seed in seeds
    }


def _tried(
    evaluation: Evaluation, way: Way, seeds: Sequence[int], cells: Sequence[tasks.Cell]
) -> dict[str, Job]:
    """List the tasks of those seeds with which something was learned, some at a time."""
    known, work = evaluation.found(), evaluation.work
    return {
        f"try-{way.label(seed)}-{tasks.slug(name)}-{start}": partial(
            try_all, way.folder(work, seed), learnt["words"], draw, _tasks(seed, start, BLOCK)
        )
        for seed in seeds
        if (learnt := known.get(f"learn-{way.label(seed)}"))
        for name, draw, count in cells
        for start in range(0, count, BLOCK)
    }


def _singly(work: Path, seeds: Sequence[int], cells: Sequence[tasks.Cell]) -> dict[str, Job]:
    return {
        f"{SINGLY}-{seed}-{tasks.slug(name)}-{start}": partial(
            one_by_one, CURIOUS.folder(work, seed), draw, _tasks(seed, start, BLOCK)
        )
        for seed in seeds
        for name, draw, count in cells
        for start in range(0, count, BLOCK)
    }


def _first(work: Path, seeds: Sequence[int]) -> dict[str, Job]:
    return {
        f"{FIRST}-{way.label(seed)}": partial(
            found_after,
            _places(work, seed),
            way.folder(work, seed),
            work / f"{FIRST}-{way.label(seed)}",
            seed,
            way.strategy,
        )
        for way in (CURIOUS, RANDOM)
        for seed in seeds
    }


def _places(work: Path, seed: int) -> Path:
    """Return the domain with places that relations are learned from with a seed."""
    return work / "places" / f"seed-{seed}"


def _tasks(seed: int, start: int, count: int) -> range:
    """Return the seeds of some tasks that the domain of a seed is tried on."""
    first = FIRST_TASK + 1000 * seed + start
    return range(first, first + count)


if __name__ == "__main__":
    begin(main)
