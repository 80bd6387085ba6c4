"""What can be done with one object relative to another? `make evaluate-relations`, into docs/results/.

First by actions that a person wrote, and by random ones. Then for each seed what can be done with pairs is
learned, starting from what carries to places with that seed; it is judged by geometry, and tried on tasks
that a person can solve. Goes on where it was interrupted.
"""

import json
import os
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.console import progress_bar, say
from neurosym.files import make_folder, write_atomically
from neurosym.stages.layout import RELATIONS
from tools.benchmarks.carrying import keeping
from tools.benchmarks.jobs import Job, as_text, load_jobs, machine, pack, perform, unpack
from tools.benchmarks.options import CORES, Seeds, Workers
from tools.benchmarks.relations import by_hand, learned, protocols, tasks
from tools.benchmarks.relations.beginnings import found_after
from tools.benchmarks.relations.singly import one_by_one
from tools.benchmarks.relations.summary import CURIOUS, FIRST, RANDOM, SINGLY, Way, summarise
from tools.benchmarks.relations.tables import page
from tools.benchmarks.relations.trying import try_all
from tools.benchmarks.world.measures import Advance
from tools.relearn_towers import RELATIONS as STEPS

RESULTS, WORK = Path("docs/results"), Path("evaluation/relations")
RECORDS, DOMAINS = "relations-records.zip", "relations-domains.zip"
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
    hand = _by_hand(results / "relations.json", scale)
    make_folder(work / "jobs")
    unpack(results / RECORDS, work / "jobs")
    make_folder(work / "places")
    keeping.restore(results / PLACES, work / "places")
    keeping.take_shipped(work / "places")
    keeping.restore(results / DOMAINS, work, RELATIONS)
    if steps == STEPS:
        learned.take_shipped(work)

    def report() -> None:
        pack(work / "jobs", results / RECORDS)
        summary = summarise(hand, load_jobs(work / "jobs"), cells, seeds=seeds, steps=steps)
        write_atomically(results / "relations.json", as_text(summary))
        write_atomically(results / "relations.md", page(summary))

    report()

    def do(jobs: Mapping[str, Job], label: str) -> None:
        perform(work / "jobs", jobs, workers, report, label=label)

    every, some = range(1, seeds + 1), range(1, min(seeds, AT_RANDOM) + 1)
    do(_learning(work, CURIOUS, every, steps), "learning relations")
    learned.keep(work, results / DOMAINS)
    do(_tried(work, CURIOUS, every, cells), "trying tasks")
    do(_singly(work, every, tasks.cells(count)), "trying with single objects")
    do(_first(work, every), "learning from the first interactions")
    do(_learning(work, RANDOM, some, steps), "learning from random actions")
    do(_tried(work, RANDOM, some, cells), "trying what was learned from these")
    say(f"wrote {results / 'relations.md'}")


def _by_hand(path: Path, scale: float) -> dict[str, Any]:
    """Measure what needs no learning, unless the results have it."""
    known = json.loads(path.read_text()) if path.exists() else {}
    found: dict[str, Any] = {"scale": scale}
    if known.get("scale") == scale:
        found |= {name: known[name] for name in _parts(scale) if name in known}
    for name, measure in _parts(scale).items():
        if name not in found:
            with progress_bar(name.replace("_", " ")) as advance:
                found[name] = measure(advance)
    return {"command": "make evaluate-relations", "machine": machine("numpy", "pybullet"), **found}


def _parts(scale: float) -> dict[str, Callable[[Advance], Any]]:
    """List what is measured, each part over so many times the usual number of interactions."""

    def some(number: int) -> int:
        return max(4, round(number * scale))

    return {
        "put_over": partial(by_hand.put_over, some(50), 110, WORKERS),
        "towers_by_hand": partial(by_hand.towers, some(50), 111, WORKERS),
        "random": partial(by_hand.predictability, some(1000), 112, WORKERS),
    }


def _learning(work: Path, way: Way, seeds: Sequence[int], steps: int) -> dict[str, Job]:
    return {
        f"learn-{way.label(seed)}": partial(
            learned.learn, _places(work, seed), way.folder(work, seed), seed, steps, way.strategy
        )
        for seed in seeds
    }


def _tried(work: Path, way: Way, seeds: Sequence[int], cells: Sequence[tasks.Cell]) -> dict[str, Job]:
    """List the tasks of those seeds with which something was learned, some at a time."""
    known = load_jobs(work / "jobs")
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
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # for the jobs, of which there are several at once
    tyro.cli(main)
