"""How fast learning is, beside what it may take; prints JSON.

Everything learns on one thread, and is told in CPU seconds of one core, so that other processes on the
machine disturb it little; seconds of the clock stand beside where somebody waits for them. The data are those
of the shipped domain. With a scale below 1 the final fit is made smaller, too: good for a glance, no measure.
"""

import json
import time
from collections.abc import Callable
from dataclasses import replace
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import tyro

from neurosym.data.interactions import Interactions
from neurosym.exploration.choice import ExplorationConfig, make_curiosity
from neurosym.exploration.curiosity import Curiosity, LearningConfig
from neurosym.exploration.disagreement import Disagreement
from neurosym.exploration.loop import origin_of_world
from neurosym.files import write_atomically
from neurosym.learning.samples import dimensions_of
from neurosym.learning.training import Trained, train
from neurosym.learning.training_config import REGIMES, Regime
from neurosym.primitives.distillation import distill
from neurosym.sim.tabletop import Tabletop
from neurosym.strategies import DEFAULT_STRATEGY, STRATEGIES
from tools.benchmarks.options import Output
from tools.benchmarks.places import SHIPPED
from tools.benchmarks.world.evaluate import machine
from tools.benchmarks.world.measures import random_tasks

DATA = SHIPPED / "interactions.npz"
STEPS = 10_000
"""Interactions of the run whose training is set against its simulation."""
BLOCKS_MEASURED = (0.05, 0.25, 0.5, 1.0)
"""After which blocks exploration's update is timed, as shares of all; the rest is read off a line."""
MOST_MS_A_NETWORK = 5.0
MOST_DISTILLING = 30.0
"""Longest distillation of eight symbols [s]."""
MOST_SHARE = 0.25
"""Greatest share of all training of a run in the time of its simulation."""
_COUNTS = {
    "teacher": ("epochs",),
    "naming": ("table_actions", "table_restarts", "actions", "objects", "steps"),
    "coding": ("steps",),
    "decoder": ("imagined",),
}
"""What a smaller final fit has less of, by its part."""

Results = dict[str, Any]


def main(
    scale: Annotated[float, tyro.conf.arg(help="How much is measured, as a share of the full.")] = 1.0,
    output: Output = None,
) -> None:
    """Measure, and print what was found as JSON."""
    text = json.dumps(bench(scale), indent=2) + "\n"
    if output is None:
        print(text, end="")
    else:
        write_atomically(output, text)


def bench(scale: float) -> Results:
    """Measure choosing, distillation, and training beside simulation."""
    world = Tabletop()
    data = stored_data(world, scale)
    regime = scaled(REGIMES["default"], scale)
    simulated = max(4, round(150 * scale))
    simulation = simulation_seconds(world, simulated, seed=11)
    choosing_found = choosing(data, world, times=max(50, round(200 * scale)))
    fit, trained = fitted(data, regime)
    distilled = distillation(trained, data, world)
    updating = updates(data, world)
    simulation = (simulation + simulation_seconds(world, simulated, seed=12)) / 2  # before and after
    share = training_share(updating, fit, simulation)
    parts = [*choosing_found.values(), distilled, share]
    return {
        "passed": all(part["passed"] for part in parts),
        "scale": scale,
        "machine": machine() | {"torch": version("torch")},
        "choosing_among_2000": choosing_found,
        "distillation": distilled,
        "training": share,
    }


def stored_data(world: Tabletop, scale: float) -> Interactions:
    """Load the shipped interactions, with what is known of the world by now."""
    data = Interactions.load(DATA)[: max(60, round(STEPS * scale))]
    return replace(data, origin={**data.origin, **origin_of_world(world)})


def scaled(regime: Regime, scale: float) -> Regime:
    """Make the final fit smaller, if the scale is."""
    parts = {}
    for part, names in _COUNTS.items():
        whole = getattr(regime.training, part)
        parts[part] = replace(
            whole, **{name: max(2, round(getattr(whole, name) * min(scale, 1.0))) for name in names}
        )
    return replace(regime, training=replace(regime.training, **parts))


def cpu_seconds(work: Callable[[], Any]) -> float:
    """Return the CPU time that something takes [s]."""
    begin = time.process_time()
    work()
    return time.process_time() - begin


def simulation_seconds(world: Tabletop, count: int, seed: int) -> float:
    """Return the CPU time of an interaction [s], from random ones in this process."""
    tasks = random_tasks(count + 2, seed, world=world)

    def perform(first: int, last: int) -> None:
        for task in tasks[first:last]:
            world.interact(task.scene, task.action, task.target)

    perform(0, 2)
    return cpu_seconds(lambda: perform(2, count + 2)) / count


def curiosity_about(about: str, data: Interactions, world: Tabletop) -> Curiosity:
    """Make the networks of a strategy, that know the scale of the data."""
    regime, mirrors = REGIMES["default"], world.action_box.mirrors
    learning = LearningConfig(learning_rate=regime.exploration_rate)
    found = make_curiosity(about, dimensions_of(data), regime.model, learning, mirrors, seed=0)
    found.learn(data[:512], 0)
    return found


def choosing(data: Interactions, world: Tabletop, times: int) -> dict[str, Results]:
    """Time how long it takes to choose among 2,000 candidates, the least of so many times.

    Whoever shares the caches and the core can only slow it down; the median stands beside it.
    """
    entropy, ensemble = (curiosity_about(about, data, world) for about in ("entropy", "disagreement"))
    member = Disagreement(ensemble.networks[:1], ensemble.config, (), 0)
    timed = {"entropy": entropy, "ensemble member": member, "ensemble": ensemble}
    return {name: _choices(curious, data, world, times) for name, curious in timed.items()}


def _choices(curious: Curiosity, data: Interactions, world: Tabletop, times: int) -> Results:
    rng, cpu, clock = np.random.default_rng(0), [], []
    for number in range(times + 3):
        candidates = world.action_box.sample(rng, ExplorationConfig().candidates).astype(np.float32)
        features = data.features[number % len(data)]
        begin, cpu_begin = time.perf_counter(), time.process_time()
        int(np.argmax(curious.uncertainties(features, candidates)))
        clock.append(time.perf_counter() - begin)
        cpu.append(time.process_time() - cpu_begin)
    best, limit = 1000 * min(cpu[3:]), MOST_MS_A_NETWORK * len(curious.networks)
    return {
        "networks": len(curious.networks),
        "times": times,
        "cpu_ms": round(best, 2),
        "median_cpu_ms": round(1000 * float(np.median(cpu[3:])), 2),
        "median_clock_ms": round(1000 * float(np.median(clock[3:])), 2),
        "limit_ms": limit,
        "passed": best <= limit,
    }


def fitted(data: Interactions, regime: Regime) -> tuple[float, Trained]:
    """Make the final fit; return the CPU time that took [s], too."""
    begin = time.process_time()
    trained = train(data, config=regime.training, model_config=regime.model, seed=0)
    return time.process_time() - begin, trained


def distillation(trained: Trained, data: Interactions, world: Tabletop) -> Results:
    """Time the distillation of all symbols that are used."""
    begin, cpu_begin = time.perf_counter(), time.process_time()
    candidates = distill(trained.model, data, world.action_box, seed=0)
    cpu, clock = time.process_time() - cpu_begin, time.perf_counter() - begin
    return {
        "symbols": len({candidate.symbol for candidate in candidates}),
        "candidates": len(candidates),
        "cpu_seconds": round(cpu, 2),
        "clock_seconds": round(clock, 2),
        "limit_seconds": MOST_DISTILLING,
        "passed": cpu <= MOST_DISTILLING,
    }


def updates(data: Interactions, world: Tabletop) -> Results:
    """Time what the default strategy learns after some blocks, and sum up all blocks of a run."""
    about = STRATEGIES[DEFAULT_STRATEGY].curious_about
    assert about is not None, "the default strategy learns while it explores"
    curious, block = curiosity_about(about, data, world), ExplorationConfig().block
    blocks = np.arange(1, STEPS // block + 1)
    measured = [max(1, round(share * blocks[-1])) * block for share in BLOCKS_MEASURED]
    rows = np.unique(np.minimum(measured, len(data)))
    seconds = [cpu_seconds(lambda n=n: curious.learn(data[:n], 1)) for n in rows]  # type: ignore[misc]
    slope, start = np.polyfit(rows, seconds, 1) if len(rows) > 1 else (0, seconds[0])
    return {
        "strategy": DEFAULT_STRATEGY,
        "updates": len(blocks),
        "measured": {int(n): round(s, 3) for n, s in zip(rows, seconds, strict=True)},
        "cpu_seconds": round(float((start + slope * blocks * block).sum()), 1),
    }


def training_share(updating: Results, fit: float, simulation: float) -> Results:
    """Set all training of a run beside its simulation."""
    share = (updating["cpu_seconds"] + fit) / (STEPS * simulation)
    return {
        "unit": "CPU seconds of one core",
        "steps": STEPS,
        "exploration": updating,
        "final_fit_cpu_seconds": round(fit, 1),
        "simulation_cpu_seconds": round(STEPS * simulation, 1),
        "cpu_ms_per_interaction": round(1000 * simulation, 1),
        "share": round(share, 4),
        "limit_share": MOST_SHARE,
        "passed": share <= MOST_SHARE,
    }


if __name__ == "__main__":
    tyro.cli(main)
