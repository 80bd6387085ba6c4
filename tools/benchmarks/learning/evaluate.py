"""Measure what docs/learning.md claims: Tables I and II, bits and ablations, over seeds.

Everything that was explored or measured stays in a working folder, one file for each job, so that the run can
be interrupted and goes on where it was. The results go to docs/results/ (learning.json, learning.md), as far
as they are known.
"""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.data.interactions import Interactions
from neurosym.data.origin import DEFAULT_STRATEGY, StrategyName
from neurosym.learning import training_config as configs
from neurosym.learning.training_config import REGIMES, ModelConfig, TeacherConfig, TrainingConfig
from neurosym.stages.layout import INTERACTIONS
from tools.benchmarks import domains, options
from tools.benchmarks.jobs import Evaluation, Found, Jobs, machine
from tools.benchmarks.learning import measures
from tools.benchmarks.learning.measures import Data
from tools.benchmarks.learning.tables import page

STRATEGIES: tuple[StrategyName, ...] = ("random", "active", "entropy", "disagreement")
EXPLORED: dict[StrategyName, StrategyName] = {"active": "random"}
"""What acts at random learns from the data of `random`."""
TEST_SEED, TEST_STEPS = 1000, 11_000
BITS = ((1, 3), (3, 3), (2, 2), (2, 4), (2, 5), (2, 6))
FEW_SEEDS = 3  # seeds of the parts that are not Tables I and II

OURS, PAPER, PLAIN = TrainingConfig(), REGIMES["paper"], ModelConfig()
NORMED = ModelConfig(layer_norm=True)
AS_THEY_ARE = TeacherConfig(network=configs.DirectConfig(gripper_sharpness=None))
SLOW = {"teacher": TeacherConfig(rate=1e-5), "coding": configs.CodingConfig(rate=1e-5)}
FROM_DATA = configs.DecoderConfig(learns_from="data")
VARIANTS: dict[str, tuple[TrainingConfig, ModelConfig]] = {
    "signs after end-to-end training": (replace(OURS, recipe="joint"), NORMED),
    "the same, decoder refitted": (replace(OURS, recipe="refit"), NORMED),
    "the same, without eq. 8": (replace(OURS, recipe="refit", contrastive=False), NORMED),
    "effects in metres": (replace(OURS, standardise=False), PLAIN),
    "gripper values as they are": (replace(OURS, teacher=AS_THEY_ARE), ModelConfig(gripper_sharpness=None)),
    "no mirrors": (replace(OURS, mirrors=False), PLAIN),
    "decoder fitted to the chosen actions": (replace(OURS, decoder=FROM_DATA), PLAIN),
    "learning rate 1e-5": (replace(OURS, learning_rate=1e-5, decay=False, **SLOW), PLAIN),
    "LayerNorm before the decoder": (OURS, NORMED),
    "dropout of 0.1": (OURS, ModelConfig(dropout=0.1)),
    "everything as printed": (PAPER.training, PAPER.model),
}  # what is changed against our defaults, one at a time; then all of it


def main(
    seeds: Annotated[int, tyro.conf.arg(help="Seeds of Tables I and II.")] = 5,
    steps: options.Steps = 5120,
    work: options.Work = Path("evaluation"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Explore, do every job that was not done, and write the results, also of what was there before."""
    options.check_positive(seeds=seeds, steps=steps, workers=workers)
    evaluation = Evaluation("learning", work, results, workers)
    report = partial(write_results, evaluation, seeds, steps)
    report()
    _explore(work / "test", "random", TEST_SEED, TEST_STEPS, workers)
    for seed in range(1, seeds + 1):
        for strategy in dict.fromkeys(EXPLORED.get(one, one) for one in STRATEGIES):
            _explore(work / f"{strategy}-{seed}", strategy, seed, steps, workers)
    for few in jobs_in_turn(work, seeds, steps):
        evaluation.perform(few, "measuring", report)


def _explore(folder: Path, strategy: StrategyName, seed: int, steps: int, workers: int) -> None:
    """Explore, unless there are as many interactions already."""
    path = folder / INTERACTIONS
    if not path.exists() or len(Interactions.load(path)) < steps:
        domains.explored(folder, strategy, seed, steps, workers=workers)


def _data_of(work: Path, strategy: StrategyName, seed: int, steps: int) -> Data:
    """Say where the data of a strategy lies."""
    return Data(work / f"{EXPLORED.get(strategy, strategy)}-{seed}", work / "test", strategy, seed, steps)


def jobs_in_turn(work: Path, seeds: int, steps: int) -> Iterator[Jobs]:
    """List the jobs, first those whose networks others need."""
    numbers = range(1, seeds + 1)
    cells = {
        f"{strategy}-{seed}-{steps}": _data_of(work, strategy, seed, steps)
        for seed in numbers
        for strategy in STRATEGIES
    }
    yield {f"learn-{name}": partial(measures.learn_and_keep, data) for name, data in cells.items()}
    yield {f"act-{name}": partial(measures.act_upon, data, "predictable") for name, data in cells.items()}
    yield {f"went-{name}": partial(measures.where_it_went, data) for name, data in cells.items()}
    yield {name: job for seed in numbers for name, job in _other_jobs(work, seed, steps).items()}


def _other_jobs(work: Path, seed: int, steps: int) -> Jobs:
    """List the job of another choice, and for the first seeds those of bits and ablations."""
    ours, end = _data_of(work, DEFAULT_STRATEGY, seed, steps), f"{seed}-{steps}"
    jobs: Jobs = {f"choice-{end}": partial(measures.act_upon, ours, "lowest-error")}
    if seed <= FEW_SEEDS:
        learn = partial(measures.variant, ours)
        jobs |= {f"bits-{o}-{a}-{end}": partial(learn, OURS, ModelConfig(o, a)) for o, a in BITS}
        jobs[f"clustered-{end}"] = partial(measures.clustered, ours, (*BITS, (2, 3)))
        jobs |= {f"{_named(name)}-{end}": partial(learn, *how) for name, how in VARIANTS.items()}
    return jobs


def _named(variant: str) -> str:
    return f"variant-{variant.replace(' ', '_')}"


def write_results(evaluation: Evaluation, seeds: int, steps: int) -> None:
    """Write JSON and Markdown from the jobs that are done."""
    summary = summarise(evaluation.found(), seeds, steps)
    evaluation.write(summary, page(summary), records=False)


def summarise(found: Found, seeds: int, steps: int) -> dict[str, Any]:
    """Gather jobs into tables; what is not done yet is missing."""
    few = min(FEW_SEEDS, seeds)

    def by_seed(name: str, most: int = seeds) -> dict[str, Any]:
        names = {str(seed): name.format(seed) for seed in range(1, most + 1)}
        return {seed: found[job] for seed, job in names.items() if job in found}

    learned, acted, went = (
        {strategy: by_seed(f"{job}-{strategy}-{{}}-{steps}") for strategy in STRATEGIES}
        for job in ("learn", "act", "went")
    )
    ours = learned[DEFAULT_STRATEGY]
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
                seed: [kind for kind, pairs in one["kinds"].items() if pairs] for seed, one in of.items()
            }
            for strategy, of in acted.items()
        },
        "rehearsals": acted,
        "went": went,
        "choice": {"predictable": acted[DEFAULT_STRATEGY], "lowest-error": by_seed(f"choice-{{}}-{steps}")},
        "bits": {f"{o}+{a}": by_seed(f"bits-{o}-{a}-{{}}-{steps}", few) for o, a in BITS},
        "clustered": by_seed(f"clustered-{{}}-{steps}", few),
        "variants": {name: by_seed(f"{_named(name)}-{{}}-{steps}", few) for name in VARIANTS},
    }


if __name__ == "__main__":
    options.begin(main)
