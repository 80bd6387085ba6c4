"""How many bits do the data carry? `python -m tools.benchmarks.planning.bits`, into docs/results/bits.*.

For each seed there is one exploration. Symbols of every width are learned from it, and once more with the
paper's choice of actions. All are tried on the same tasks, which nothing was chosen on. Goes on where it was
interrupted.
"""

import math
import shutil
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from neurosym.errors import counted
from neurosym.grounding import Grounding
from neurosym.stages.layout import GROUNDING, MANIFEST
from tools.benchmarks import domains
from tools.benchmarks.jobs import Evaluation, Found, Job, machine
from tools.benchmarks.options import (
    CORES,
    RESULTS,
    OnlyReport,
    Results,
    Seeds,
    Steps,
    Tasks,
    Work,
    Workers,
    begin,
)
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.jobs import SIZES, blocks
from tools.benchmarks.planning.measures import TIME_LIMIT
from tools.benchmarks.planning.trials import to_json, trials_of, try_task
from tools.benchmarks.tables import document, over_seeds, table

FIRST_TASK = 300_000
"""Seed of the first task, far from those of other evaluations."""
STRATEGY = "disagreement"
TOLERANCES = (50, 20)
"""How near objects must come to their goals [mm]."""
NAMES = ("categories", "primitives", "operators", "spread_median_mm", "spread_p90_mm")


Jobs = dict[tuple[str, int], dict[str, Job]]
"""Jobs by how many objects there are, and tolerance [mm]."""


class Learned(NamedTuple):
    """One way to learn from an exploration: bits of symbols, and which candidates stand for a symbol."""

    object_bits: int
    action_bits: int
    choice: str = "own"

    @property
    def name(self) -> str:
        """How it is called in tables."""
        return f"{self.object_bits}+{self.action_bits}" + (", the paper's choice" * (self.choice != "own"))

    @property
    def slug(self) -> str:
        """How it is called in names of files."""
        return f"{self.object_bits}+{self.action_bits}-{self.choice}"


EVERY = (Learned(2, 3, "lowest-error"), *(Learned(2, bits) for bits in (3, 4, 5, 6)))


def main(
    seeds: Seeds = 3,
    steps: Steps = 10_000,
    tasks: Tasks = 30,
    work: Work = Path("evaluation/bits"),
    results: Results = RESULTS,
    workers: Workers = CORES,
    only_report: OnlyReport = False,
) -> None:
    """Explore, learn, try, and write what came of it; a width is reported as soon as it is done."""
    evaluation = Evaluation("bits", work, results, workers)
    every_seed = range(1, seeds + 1)
    if not only_report:
        exploring = {f"explore-{seed}": partial(_explore, work, seed, steps) for seed in every_seed}
        evaluation.perform(exploring, "exploring")
    tried: dict[Learned, list[Jobs]] = {}
    for how in EVERY:
        names = {seed: f"{how.slug}-{seed}" for seed in every_seed}
        tried[how] = [_trying(work / name, name, tasks) for name in names.values()]
        if not only_report:
            learning = {
                f"learn-{name}": partial(_learn, work, name, how, seed, steps) for seed, name in names.items()
            }
            evaluation.perform(learning, how.name)
            every = {name: job for of in tried[how] for jobs in of.values() for name, job in jobs.items()}
            evaluation.perform(every, f"{how.name}, tasks")
        summary = summarise(evaluation.found(), tried, seeds=seeds, steps=steps, tasks=tasks)
        evaluation.write(summary, page(summary))


def _explore(work: Path, seed: int, steps: int) -> int:
    """Explore; return how many interactions there are."""
    domains.explored(work / f"explored-{seed}", STRATEGY, seed, steps)
    return steps


def _learn(work: Path, name: str, how: Learned, seed: int, steps: int) -> dict[str, Any]:
    """Learn from an exploration; return how many operators there are, and the spread of what they do."""
    folder = work / name
    if not (folder / MANIFEST).exists():
        shutil.copytree(work / f"explored-{seed}", folder)
    bits = {"object_bits": how.object_bits, "action_bits": how.action_bits}
    domains.learn(folder, STRATEGY, seed, steps, choice=how.choice, **bits)
    domains.compiled(folder)
    grounding = Grounding.load(folder / GROUNDING)
    scatters = [operator.promise.scatter for operator in grounding.live if operator.promise]
    spreads = [1000 * math.hypot(*scatter) for scatter in scatters]
    numbers = (
        len(grounding.operators.categories),
        len(grounding.operators.symbols),
        len(grounding.live),
        float(np.median(spreads)) if spreads else None,
        float(np.quantile(spreads, 0.9)) if spreads else None,
    )
    return dict(zip(NAMES, numbers, strict=True))


def _trying(folder: Path, name: str, tasks: int) -> Jobs:
    """List the jobs that try tasks in a domain."""
    return {
        (kind, mm): {
            f"try-{name}-{kind}-{mm}mm-{block.start}": partial(
                _try_all, folder, objects, mm, [FIRST_TASK + number for number in block]
            )
            for block in blocks(tasks)
        }
        for kind, objects in SIZES.items()
        for mm in TOLERANCES
    }


def _try_all(folder: Path, objects: int, mm: int, seeds: Sequence[int]) -> list[Any]:
    """Try tasks drawn as the paper draws them, blindly and with replanning."""
    bench = domains.bench_of(folder)
    tasks = [bench.draw(objects, seed, mm / 1000) for seed in seeds]
    return to_json([try_task(bench.setting, task, blind=True, time_limit=TIME_LIMIT) for task in tasks])


def summarise(
    found: Found, tried: Mapping[Learned, Sequence[Jobs]], *, seeds: int, steps: int, tasks: int
) -> dict[str, Any]:
    """Gather what was learned, and the shares of reached goals."""
    return {
        "command": "python -m tools.benchmarks.planning.bits",
        "versions": machine("numpy", "pybullet", "torch", "up-fast-downward"),
        "seeds": seeds,
        "steps": steps,
        "tasks": tasks,
        "learned": {
            how.name: [found.get(f"learn-{how.slug}-{seed}") for seed in range(1, seeds + 1)] for how in tried
        },
        "reached": {
            how.name: {
                f"{kind}, {mm} mm, {way}": [figures.share(trials_of(found, of[kind, mm]), way) for of in jobs]
                for mm in TOLERANCES
                for kind in SIZES
                for way in figures.WAYS
            }
            for how, jobs in tried.items()
        },
        "promise_rms_mm": {
            how.name: {f"{mm} mm": [_missed(found, of, mm) for of in jobs] for mm in TOLERANCES}
            for how, jobs in tried.items()
        },
    }


def _missed(found: Found, jobs: Jobs, mm: int) -> float | None:
    """Say how far steps ended from their promises [mm], root mean square."""
    trials = [trial for kind in SIZES for trial in trials_of(found, jobs[kind, mm])]
    rms: float | None = figures.promise_errors(figures.steps_of(trials))["all"]
    return rms


def page(summary: Mapping[str, Any]) -> str:
    """Write the tables."""
    known = {how: [one for one in ones if one] for how, ones in summary["learned"].items()}
    titles = {
        how: how if len(ones) == summary["seeds"] else f"{how} ({counted(len(ones), 'seed')})"
        for how, ones in known.items()
        if ones
    }
    rows = [
        [title, *(over_seeds([one[name] for one in known[how]]) for name in NAMES)]
        for how, title in titles.items()
    ]
    reached, missed = (summary[name] for name in ("reached", "promise_rms_mm"))
    shares = [
        [what, *(over_seeds([s and 100 * s for s in reached[how][what]], "{:.1f} %") for how in titles)]
        for what in next(iter(reached.values()))
    ]
    misses = [[mm, *(over_seeds(missed[how][mm]) for how in titles)] for mm in next(iter(missed.values()))]
    return document(
        "# How many bits the data carry",
        f"`{summary['command']}` wrote this page. {summary['seeds']} seeds; from {summary['steps']} "
        "interactions of each, chosen by disagreement, symbols of several widths were learned (bits of "
        "objects + bits of actions), and tried with Fast Downward on the same tasks, "
        f"{summary['tasks']} of each size for each seed, drawn as the paper draws them. *The paper's choice* "
        "has one action for a symbol in all categories, the one with the lowest error; the others have one "
        "for each category. Means and standard deviations of the seeds.",
        "## What was learned",
        table(["bits", "categories", "action symbols", "operators", "median spread [mm]", "90 % [mm]"], rows),
        "The spread of an operator is the length of the standard deviations of what it does to its category; "
        "what it promises for the object at hand is nearer.",
        "## Goals reached",
        table(["tasks", *titles.values()], shares),
        "## Promises",
        "Distance between what the operator of a step promised for the object at hand and what came, with "
        "replanning; root mean square [mm].",
        table(["tasks", *titles.values()], misses),
    )


if __name__ == "__main__":
    begin(main)
