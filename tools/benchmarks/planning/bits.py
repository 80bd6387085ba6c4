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
from statistics import mean, stdev
from typing import Annotated, Any, NamedTuple

import numpy as np
import tyro

from neurosym.commands.learn import init
from neurosym.errors import counted
from neurosym.evaluation.summary import markdown_table
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import CELL
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, MANIFEST, WORLD
from neurosym.stages.learning import distill_stage, explore_stage, train_stage
from tools.benchmarks.jobs import Evaluation, machine
from tools.benchmarks.options import CORES, OnlyReport, Results, Seeds, Steps, Work, Workers, begin
from tools.benchmarks.planning.measures import REHEARSALS
from tools.benchmarks.planning.trying import Jobs, in_millimetres, in_percent, promise_rms, shares, trying

RESULTS, WORK = Path("docs/results"), Path("evaluation/bits")
STRATEGY, REGIME = "disagreement", "default"
FIRST_TASK = 300_000
"""Seed of the first task, far from those of other evaluations."""


class Learned(NamedTuple):
    """One way to learn from an exploration.

    Attributes:
        object_bits: Of object symbols.
        action_bits: Of action symbols.
        choice: Which candidates stand for a symbol.
    """

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
    tasks: Annotated[int, tyro.conf.arg(help="Tasks with one object, and with two.")] = 30,
    work: Work = WORK,
    results: Results = RESULTS,
    workers: Workers = CORES,
    only_report: OnlyReport = False,
) -> None:
    """Explore, learn, try, and write what came of it; a width is reported as soon as it is done."""
    evaluation = Evaluation("bits", work, results, workers)
    every_seed = range(1, seeds + 1)
    if not only_report:
        exploring = {f"explore-{seed}": partial(explore, work, seed, steps) for seed in every_seed}
        evaluation.perform(exploring, "exploring")
    tried: dict[Learned, list[Jobs]] = {}
    for how in EVERY:
        tried[how] = [
            trying(work / f"{how.slug}-{seed}", f"{how.slug}-{seed}", tasks, FIRST_TASK)
            for seed in every_seed
        ]
        if not only_report:
            _learn_and_try(evaluation, how, tried[how])
        summary = summarise(evaluation.found(), tried, seeds=seeds, steps=steps, tasks=tasks)
        evaluation.write(summary, page(summary))


def _learn_and_try(evaluation: Evaluation, how: Learned, tried: Sequence[Jobs]) -> None:
    """Learn in one way with each seed, and try what was learned."""
    work = evaluation.work
    learning = {
        f"learn-{how.slug}-{seed}": partial(learn, work, work / f"{how.slug}-{seed}", how, seed)
        for seed in range(1, len(tried) + 1)
    }
    evaluation.perform(learning, how.name)
    trials = {name: job for of_one in tried for jobs in of_one.values() for name, job in jobs.items()}
    evaluation.perform(trials, f"{how.name}, tasks")


def explored(work: Path, seed: int) -> Path:
    """Return the folder of an exploration."""
    return work / f"explored-{seed}"


def explore(work: Path, seed: int, steps: int) -> int:
    """Explore; return how many interactions there are."""
    folder = explored(work, seed)
    if not (folder / WORLD).exists():
        init(folder)
    domain = DomainFolder(folder)
    stage = explore_stage(domain, strategy=STRATEGY, steps=steps, seed=seed, regime=REGIME, workers=1)
    domain.perform(stage, again=False)
    return steps


def learn(work: Path, folder: Path, how: Learned, seed: int) -> dict[str, Any]:
    """Learn from an exploration; what was done is not done again.

    Returns:
        How many operators there are, and the spread of what they do.
    """
    if not (folder / MANIFEST).exists():
        shutil.copytree(explored(work, seed), folder)
    domain = DomainFolder(folder)
    bits = {"object_bits": how.object_bits, "action_bits": how.action_bits}
    for stage in (
        train_stage(domain, seed=seed, regime=REGIME, **bits),
        distill_stage(domain, objects=REHEARSALS, seed=seed, workers=1, choice=how.choice),
        compile_stage(domain, cell=CELL),
    ):
        domain.perform(stage, again=False)
    return described(Grounding.load(folder / GROUNDING))


def described(grounding: Grounding) -> dict[str, Any]:
    """Count the symbols and operators of a domain, and say how exactly these do what they do."""
    promises = [operator.promise for operator in grounding.live if operator.promise]
    spreads = [1000 * math.hypot(*promise.scatter) for promise in promises]
    return {
        "categories": len(grounding.operators.categories),
        "primitives": len(grounding.operators.symbols),
        "operators": len(grounding.live),
        "spread_median_mm": float(np.median(spreads)) if spreads else None,
        "spread_p90_mm": float(np.quantile(spreads, 0.9)) if spreads else None,
    }


def summarise(
    found: Mapping[str, Any], tried: Mapping[Learned, Sequence[Jobs]], *, seeds: int, steps: int, tasks: int
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
        "reached": {how.name: shares(found, jobs) for how, jobs in tried.items()},
        "promise_rms_mm": {how.name: promise_rms(found, jobs) for how, jobs in tried.items()},
    }


def page(summary: Mapping[str, Any]) -> str:
    """Write the tables."""
    learned, reached = summary["learned"], summary["reached"]
    names = ("categories", "primitives", "operators", "spread_median_mm", "spread_p90_mm")
    known = {how: [one for one in ones if one] for how, ones in learned.items()}
    titles = {
        how: how if len(ones) == summary["seeds"] else f"{how} ({counted(len(ones), 'seed')})"
        for how, ones in known.items()
        if ones
    }
    rows = [
        [titles[how], *(_spread([one[name] for one in ones]) for name in names)]
        for how, ones in known.items()
        if ones
    ]
    what, missed, first = list(next(iter(reached.values()))), summary["promise_rms_mm"], next(iter(reached))
    sections = [
        "# How many bits the data carry",
        f"`{summary['command']}` wrote this page. {summary['seeds']} seeds; from {summary['steps']} "
        "interactions of each, chosen by disagreement, symbols of several widths were learned (bits of "
        "objects + bits of actions), and tried with Fast Downward on the same tasks, "
        f"{summary['tasks']} of each size for each seed, drawn as the paper draws them. *The paper's choice* "
        "has one action for a symbol in all categories, the one with the lowest error; the others have one "
        "for each category. Means and standard deviations of the seeds.",
        "## What was learned",
        markdown_table(
            ["bits", "categories", "action symbols", "operators", "median spread [mm]", "90 % [mm]"], rows
        ),
        "The spread of an operator is the length of the standard deviations of what it does to its category; "
        "what it promises for the object at hand is nearer.",
        "## Goals reached",
        markdown_table(
            ["tasks", *titles.values()],
            [[of, *(in_percent(reached[how][of]) for how in titles)] for of in what],
        ),
        "## Promises",
        "Distance between what the operator of a step promised for the object at hand and what came, with "
        "replanning; root mean square [mm].",
        markdown_table(
            ["tasks", *titles.values()],
            [[of, *(in_millimetres(missed[how][of]) for how in titles)] for of in missed[first]],
        ),
    ]
    return "\n\n".join(sections) + "\n"


def _spread(values: Sequence[float]) -> str:
    return f"{mean(values):.1f}" + (f" ± {stdev(values):.1f}" if len(values) > 1 else "")


if __name__ == "__main__":
    begin(main)
