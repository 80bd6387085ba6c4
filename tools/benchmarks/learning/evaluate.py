"""Measure what docs/learning.md claims: Tables I and II, learning curves, bits and ablations, over seeds.

Everything that was explored or measured stays in a working folder, one file for each job, so that the run can
be interrupted and goes on where it was. The results go to docs/results/ (learning.json, learning.md,
learning.png), as far as they are known.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.commands.learn import init
from neurosym.data.interactions import Interactions
from neurosym.data.origin import DEFAULT_STRATEGY
from neurosym.learning.training_config import (
    REGIMES,
    CodingConfig,
    DecoderConfig,
    DirectConfig,
    ModelConfig,
    TeacherConfig,
    TrainingConfig,
)
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import INTERACTIONS, WORLD
from neurosym.stages.learning import explore_stage
from tools.benchmarks.jobs import Evaluation, Job, machine
from tools.benchmarks.learning import measures
from tools.benchmarks.learning.curves import draw
from tools.benchmarks.learning.measures import Data
from tools.benchmarks.learning.tables import page
from tools.benchmarks.options import CORES, OnlyReport, Results, Steps, Workers, begin, check_positive

RESULTS, WORK = Path("docs/results"), Path("evaluation")
FILTERED, FILTER = f"entropy{measures.FILTER_SUFFIX}", 0.1
"""Entropy among the candidates with this predicted effect only [m], as in the authors' code."""
STRATEGIES = ("random", "active", "entropy", FILTERED, "disagreement")
EXPLORED = {strategy: "random" if strategy == "active" else strategy for strategy in STRATEGIES}
TEST_SEED, TEST_STEPS = 1000, 11_000
CURVE = (1024, 2560, 5120, 10_000)
"""Interactions after which the learning curves have a point; there are none of a single seed."""
CURVED = tuple(strategy for strategy in STRATEGIES if strategy != FILTERED)
BITS = ((1, 3), (3, 3), (2, 2), (2, 4), (2, 5), (2, 6))
FEW_SEEDS = 3
"""Seeds of the parts that are not Tables I and II."""

OURS, PRINTED = TrainingConfig(), REGIMES["paper"].training
NORMED, DROPPED = ModelConfig(layer_norm=True), ModelConfig(layer_norm=True, dropout=0.1)
VARIANTS: Mapping[str, tuple[TrainingConfig, ModelConfig]] = {
    "signs after end-to-end training": (replace(OURS, recipe="joint"), ModelConfig(layer_norm=True)),
    "the same, decoder refitted": (replace(OURS, recipe="refit"), ModelConfig(layer_norm=True)),
    "the same, without eq. 8": (
        replace(OURS, recipe="refit", contrastive=False),
        ModelConfig(layer_norm=True),
    ),
    "effects in metres": (replace(OURS, standardise=False), ModelConfig()),
    "gripper values as they are": (
        replace(OURS, teacher=replace(OURS.teacher, network=DirectConfig(gripper_sharpness=None))),
        ModelConfig(gripper_sharpness=None),
    ),
    "no mirrors": (replace(OURS, mirrors=False), ModelConfig()),
    "decoder fitted to the chosen actions": (
        replace(OURS, decoder=DecoderConfig(learns_from="data")),
        ModelConfig(),
    ),
    "learning rate 1e-5": (
        replace(
            OURS,
            learning_rate=1e-5,
            teacher=TeacherConfig(rate=1e-5),
            coding=CodingConfig(rate=1e-5),
            decay=False,
        ),
        ModelConfig(),
    ),
    "LayerNorm before the decoder": (OURS, NORMED),
    "dropout of 0.1": (OURS, ModelConfig(dropout=0.1)),
    "everything as printed": (PRINTED, REGIMES["paper"].model),
}
"""What is changed against our defaults, one at a time; then all of it."""


def main(
    seeds: Annotated[int, tyro.conf.arg(help="Seeds of Tables I and II.")] = 5,
    steps: Steps = 5120,
    work: Annotated[Path, tyro.conf.arg(help="Folder for what was explored and measured.")] = WORK,
    results: Results = RESULTS,
    workers: Workers = CORES,
    only_report: OnlyReport = False,
) -> None:
    """Explore, do every job that was not done, and write the results."""
    check_positive(seeds=seeds, steps=steps, workers=workers)
    evaluation = Evaluation("learning", work, results, workers)
    report = partial(write_results, evaluation, seeds, steps)
    if not only_report:
        explore(work / "test", "random", TEST_SEED, TEST_STEPS, workers)
        for seed in range(1, seeds + 1):
            for strategy in dict.fromkeys(EXPLORED[strategy] for strategy in of_seed(seed, seeds)):
                explore(work / f"{strategy}-{seed}", strategy, seed, steps, workers)
        for few in jobs_in_turn(work, seeds, steps):
            evaluation.perform(few, "measuring", report)
    report()


def explore(folder: Path, strategy: str, seed: int, steps: int, workers: int) -> None:
    """Explore, unless there are as many interactions already."""
    if not (folder / WORLD).exists():
        init(folder)
    path = folder / INTERACTIONS
    if path.exists() and len(Interactions.load(path)) >= steps:
        return
    domain = DomainFolder(folder)
    stage = explore_stage(
        domain,
        strategy=strategy.removesuffix(measures.FILTER_SUFFIX),
        steps=steps,
        seed=seed,
        regime="default",
        workers=workers,
        min_predicted_effect=FILTER if strategy == FILTERED else 0.0,
    )
    domain.perform(stage, again=True)


def of_seed(seed: int, seeds: int) -> tuple[str, ...]:
    """List the strategies that are tried with a seed; the short form leaves out the filter."""
    has_filter = seeds > 1 and seed <= FEW_SEEDS
    return tuple(strategy for strategy in STRATEGIES if strategy != FILTERED or has_filter)


def data_of(work: Path, strategy: str, seed: int, steps: int) -> Data:
    """Say where the data of a strategy lies."""
    return Data(work / f"{EXPLORED[strategy]}-{seed}", work / "test", strategy, seed, steps)


def jobs_in_turn(work: Path, seeds: int, steps: int) -> Iterator[dict[str, Job]]:
    """List the jobs: first those whose networks others need; all tables, and then the curves."""
    numbers = range(1, seeds + 1)
    for rows in [steps, *(rows for rows in CURVE if rows < steps and seeds > 1)]:
        cells = {
            f"{strategy}-{seed}-{rows}": data_of(work, strategy, seed, rows)
            for seed in numbers
            for strategy in (of_seed(seed, seeds) if rows == steps else CURVED)
        }
        yield {f"learn-{name}": partial(measures.learn_and_keep, data) for name, data in cells.items()}
        yield {f"act-{name}": partial(measures.act_upon, data, "predictable") for name, data in cells.items()}
        if rows == steps:
            yield {f"went-{name}": partial(measures.where_it_went, data) for name, data in cells.items()}
            yield {name: job for seed in numbers for name, job in other_jobs(work, seed, steps).items()}


def other_jobs(work: Path, seed: int, steps: int) -> dict[str, Job]:
    """List the job of another choice, and for the first seeds those of bits and ablations."""
    ours = data_of(work, DEFAULT_STRATEGY, seed, steps)
    jobs: dict[str, Job] = {f"choice-{seed}-{steps}": partial(measures.act_upon, ours, "lowest-error")}
    if seed <= FEW_SEEDS:
        for bits in BITS:
            jobs[f"bits-{bits[0]}-{bits[1]}-{seed}-{steps}"] = partial(measures.other_bits, ours, *bits)
        jobs[f"clustered-{seed}-{steps}"] = partial(measures.clustered, ours, (*BITS, (2, 3)))
        for name, (config, model_config) in VARIANTS.items():
            key = f"variant-{name.replace(' ', '_')}-{seed}-{steps}"
            jobs[key] = partial(measures.variant, ours, config, model_config)
    return jobs


def write_results(evaluation: Evaluation, seeds: int, steps: int) -> None:
    """Write JSON, Markdown and PNG from the jobs that are done."""
    summary = summarise(evaluation.found(), seeds, steps)
    evaluation.write(summary, page(summary), records=False)
    draw(summary, evaluation.results / "learning.png")


def summarise(found: Mapping[str, Any], seeds: int, steps: int) -> dict[str, Any]:
    """Gather jobs into tables; what is not done yet is missing."""
    learned, acted, went = (
        {strategy: dict(_by_seed(found, f"{job}-{strategy}-{{}}-{steps}", seeds)) for strategy in STRATEGIES}
        for job in ("learn", "act", "went")
    )
    ours, few = learned[DEFAULT_STRATEGY], min(FEW_SEEDS, seeds)
    return {
        "command": f"make evaluate-learning SEEDS={seeds} STEPS={steps}",
        "steps": steps,
        "missing": sum(name not in found for jobs in jobs_in_turn(Path(), seeds, steps) for name in jobs),
        "default_strategy": DEFAULT_STRATEGY,
        "machine": machine("torch", "numpy", "pybullet"),
        "through_code_share": [figures["share"] for figures in ours.values()],
        "r2_direct": [figures["r2_direct"] for figures in ours.values()],
        "table1": learned,
        "table2": {
            strategy: {
                seed: [kind for kind, pairs in figures["kinds"].items() if pairs]
                for seed, figures in by_seed.items()
            }
            for strategy, by_seed in acted.items()
        },
        "rehearsals": acted,
        "went": went,
        "choice": {
            "predictable": acted[DEFAULT_STRATEGY],
            "lowest-error": dict(_by_seed(found, f"choice-{{}}-{steps}", seeds)),
        },
        "bits": {f"{o}+{a}": dict(_by_seed(found, f"bits-{o}-{a}-{{}}-{steps}", few)) for o, a in BITS},
        "clustered": dict(_by_seed(found, f"clustered-{{}}-{steps}", few)),
        "variants": {
            name: dict(_by_seed(found, f"variant-{name.replace(' ', '_')}-{{}}-{steps}", few))
            for name in VARIANTS
        },
        "curves": {
            strategy: {
                str(rows): {
                    job: dict(_by_seed(found, f"{job}-{strategy}-{{}}-{rows}", seeds))
                    for job in ("learn", "act")
                }
                for rows in sorted({*CURVE, steps})
                if rows <= steps
            }
            for strategy in CURVED
        },
    }


def _by_seed(found: Mapping[str, Any], name: str, seeds: int) -> Iterator[tuple[str, Any]]:
    for seed in range(1, seeds + 1):
        if (key := name.format(seed)) in found:
            yield str(seed), found[key]


if __name__ == "__main__":
    begin(main)
