"""When does curiosity pay? The higher the action box, the more random actions move nothing.

For each height, as many interactions are explored in each way. A network without a bottleneck learns from
them, and foresees random actions that do move their target: how much of their effects does it explain?
What of the last quarter moved its target says whether curiosity knows by then which actions do.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.data.origin import StrategyName
from neurosym.exploration.curiosity import LearningConfig
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.learning.losses import dimensions_of, samples_of
from neurosym.learning.recipes import fit_direct
from neurosym.learning.training import r_squared
from neurosym.learning.training_config import regime_named
from neurosym.sim.tabletop import Tabletop
from neurosym.worlds.workers import perform_all
from tools.benchmarks.jobs import Found, Jobs
from tools.benchmarks.tables import mean_of, over_seeds, percent, table
from tools.benchmarks.world.measures import random_tasks

HEIGHTS = (1, 2, 4, 8)
"""How many times as high above the target as usual waypoints may lie."""


@dataclass(frozen=True)
class Exploring:
    """A way to explore.

    Attributes:
        about: What it is, in words.
        strategy: How actions are chosen.
        steps: How many interactions.
        block: How many of them lie between two updates of the networks.
        heights: The boxes that it is tried in.
    """

    about: str
    strategy: StrategyName
    steps: int = 1024
    block: int = ExplorationConfig().block
    heights: tuple[int, ...] = HEIGHTS


_LONG: Mapping[str, Any] = {"steps": 4096, "heights": (1, 8)}
STRATEGIES: Mapping[str, Exploring] = {
    "random": Exploring("random", "random"),
    "entropy": Exploring("entropy", "entropy"),
    "disagreement": Exploring("disagreement", "disagreement"),
    "often": Exploring("disagreement, updated each 128", "disagreement", block=128),
    "long-random": Exploring("random", "random", **_LONG),
    "long-disagreement": Exploring("disagreement", "disagreement", **_LONG),
}
MOVED = 0.01  # what moves an object less far does nothing to it [m]
_TESTED, _DRAWN = 300, 6000  # random actions that move something, of so many drawn at most
_TEST_SEED = 791_000


class High(Tabletop):
    """A tabletop in which waypoints may lie higher above the target."""

    def __init__(self, height: float):
        super().__init__()
        box, high = self.action_box, self.action_box.high.copy()
        high[2::4] *= height
        self.action_box = replace(box, high=high)


def jobs(work: Path, seeds: int) -> tuple[Jobs, Jobs]:
    """List the jobs that draw what is foreseen, and those that explore and foresee it."""
    return {f"high-test-{height}": partial(_test, work, height) for height in HEIGHTS}, {
        f"high-{height}-{name}-{seed}": partial(_learn, work, height, way, seed)
        for seed in range(1, seeds + 1)
        for name, way in STRATEGIES.items()
        for height in way.heights
    }


def moved(interactions: Interactions) -> np.ndarray:
    """Tell of which interactions the target was moved, or picked up; (N,) of bool."""
    far: np.ndarray = (abs(interactions.effects[:, :3]) > MOVED).any(axis=1)
    return far | interactions.held


def _test(work: Path, height: int) -> dict[str, Any]:
    """Perform random actions until enough moved something, and keep these."""
    make, outcomes, actions = partial(High, height), list[Any](), list[Any]()
    drawn, found = random_tasks(_DRAWN, _TEST_SEED + height, world=make()), 0
    for count, outcome in enumerate(perform_all(make, drawn, 1), 1):
        outcomes.append(outcome)
        actions.append(drawn[count - 1].action)
        if count % 100 == 0:
            every = Interactions.from_outcomes(outcomes, np.array(actions), {})
            found = int(moved(every).sum())
            if found >= _TESTED:
                break
    kept = moved(every)
    work.mkdir(parents=True, exist_ok=True)
    every[np.flatnonzero(kept)].save(work / f"high-{height}.npz")
    return {"moved": float(kept.mean()), "of": len(every)}


def _learn(work: Path, height: int, way: Exploring, seed: int) -> dict[str, Any]:
    """Explore, learn from it, and foresee what moves something."""
    regime = regime_named("default")
    explored = explore(
        partial(High, height),
        steps=way.steps,
        strategy=way.strategy,
        seed=seed,
        config=ExplorationConfig(
            block=way.block,
            learning=LearningConfig(
                learning_rate=regime.exploration_rate, loss_coefficient=regime.training.loss_coefficient
            ),
        ),
        model_config=regime.exploration,
    )
    samples = samples_of(explored, mirrors=regime.training.mirrors)
    network = fit_direct(samples, dimensions_of(explored), regime.training, seed, lambda *_: None)
    if not (work / f"high-{height}.npz").exists():  # on another machine than the job that performed them
        _test(work, height)
    test = Interactions.load(work / f"high-{height}.npz")
    explained = r_squared(network.predict(test.features, test.actions), np.asarray(test.effects, dtype=float))
    last = explored[np.arange(way.steps - way.steps // 4, way.steps)]
    return {
        "moved": float(moved(explored).mean()),
        "moved_last": float(moved(last).mean()),
        "r2": float(explained.mean()),
    }


def summarise(found: Found) -> dict[str, Any]:
    """Gather what each way explains of what moves something, by the share of random actions that do."""
    summary = dict[str, Any]()
    for height in HEIGHTS:
        if drawn := found.get(f"high-test-{height}"):
            summary[str(height)] = {"moved": drawn["moved"]}
            for name in STRATEGIES:
                cells = [found[job] for job in found if job.startswith(f"high-{height}-{name}-")]
                if cells:
                    told = {key: [one[key] for one in cells] for key in ("moved", "moved_last", "r2")}
                    summary[str(height)][name] = told
    return summary


def tables(summary: Mapping[str, Any]) -> str:
    """Write a row for each height and way."""
    rows = [
        [
            height,
            percent(told["moved"]),
            f"{way.steps:,}",
            way.about,
            percent(mean_of(told[name]["moved"])),
            percent(mean_of(told[name]["moved_last"])),
            over_seeds(told[name]["r2"], "{:.2f}", 2),
        ]
        for height, told in summary.items()
        for name, way in STRATEGIES.items()
        if name in told
    ]
    heads = "height | random actions that move | explored | by | of these move | of the last quarter"
    return table(f"{heads} | R2 of what moves", rows)
