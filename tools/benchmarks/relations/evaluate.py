"""What can be done with one object relative to another? `make evaluate-relations`, into docs/results/.

First by actions that a person wrote, and by random ones. Then for each seed what can be done with pairs is
learned, starting from what carries to places with that seed; it is judged by geometry, and tried on tasks
that a person can solve. Goes on where it was interrupted.
"""

import json
import os
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.console import progress_bar, say
from neurosym.files import make_folder, write_atomically
from neurosym.stages.layout import RELATIONS
from tools.benchmarks.carrying import keeping
from tools.benchmarks.jobs import Job, as_text, load_jobs, machine, pack, perform, unpack
from tools.benchmarks.relations import by_hand, learned, protocols, tasks
from tools.benchmarks.relations.summary import summarise
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
    seeds: Annotated[int, tyro.conf.arg(help="Seeds of everything.")] = 5,
    steps: Annotated[int, tyro.conf.arg(help="Interactions that are aimed at other objects.")] = STEPS,
    count: Annotated[int, tyro.conf.arg(help="Tasks of each kind and seed, a multiple of 5.")] = 10,
    scale: Annotated[
        float, tyro.conf.arg(help="How many interactions by hand, as a share of the full number.")
    ] = 1.0,
    work: Annotated[Path, tyro.conf.arg(help="Folder for what was learned.")] = WORK,
    results: Annotated[Path, tyro.conf.arg(help="Folder for relations.json and relations.md.")] = RESULTS,
    workers: Annotated[int, tyro.conf.arg(help="Jobs at once.")] = os.cpu_count() or 1,
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
    every = range(1, seeds + 1)
    learning: dict[str, Job] = {
        f"learn-{seed}": partial(
            learned.learn, work / "places" / f"seed-{seed}", work / f"seed-{seed}", seed, steps
        )
        for seed in every
    }
    perform(work / "jobs", learning, workers, report, label="learning relations")
    learned.keep(work, results / DOMAINS)
    found = load_jobs(work / "jobs")
    trying = {
        name: job
        for seed in every
        if (known := found.get(f"learn-{seed}"))
        for name, job in _tried(work / f"seed-{seed}", seed, known["words"], cells).items()
    }
    perform(work / "jobs", trying, workers, report, label="trying tasks")
    at_random: dict[str, Job] = {
        f"random-{seed}": partial(
            learned.learn, work / "places" / f"seed-{seed}", work / f"random-{seed}", seed, steps, "random"
        )
        for seed in range(1, min(seeds, AT_RANDOM) + 1)
    }
    perform(work / "jobs", at_random, workers, report, label="learning from random actions")
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


def _tried(
    folder: Path, seed: int, words: Mapping[str, list[str]], cells: tuple[tasks.Cell, ...]
) -> dict[str, Job]:
    first = FIRST_TASK + 1000 * seed
    return {
        f"try-{seed}-{tasks.slug(name)}-{start}": partial(
            try_all, folder, words, draw, range(first + start, first + start + BLOCK)
        )
        for name, draw, count in cells
        for start in range(0, count, BLOCK)
    }


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # for the jobs, of which there are several at once
    tyro.cli(main)
