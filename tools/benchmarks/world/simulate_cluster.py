"""Exploration on a cluster, on paper: measure each part on this machine, and let a model add them up.

The model is the loop of `neurosym.exploration`. One driver chooses each action and hands it out, never more
than a few ahead of the workers; a block ends when its last interaction does; then the driver trains its
networks on all interactions so far. Not in it: the network's delays, workers that die, and workers slower
than this machine. Processor times are measured, so that whatever else this machine does counts little.
"""

import heapq
import json
import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass
from functools import partial
from typing import Annotated

import numpy as np
import tyro

from neurosym.data.dimensions import Dimensions
from neurosym.exploration.choice import ExplorationConfig, choose_action, make_curiosity
from neurosym.exploration.loop import explore
from neurosym.learning.model_config import ModelConfig
from neurosym.strategies import DEFAULT_STRATEGY
from neurosym.worlds.workers import AHEAD, Result, in_order, perform_task
from neurosym.worlds.world_file import make_world

WORKERS = (1, 2, 4, 8, 16, 32, 64, 100)
STEPS = 10_000
BLOCK = ExplorationConfig().block
HAND_OUT = 0.8e-3  # of the driver for each interaction, where Ray is not installed to measure it [s]


@dataclass(frozen=True, slots=True)
class Costs:
    """What each part takes, all [s].

    Attributes:
        choose: One choice among 2,000 candidates.
        hand_out: The driver's work to hand out one interaction and take its outcome back.
        perform: Interactions, as measured; the model draws from them.
        train: One update of the networks, before the first interaction it learns from.
        train_row: What each interaction adds to an update.
    """

    choose: float
    hand_out: float
    perform: tuple[float, ...]
    train: float
    train_row: float


@dataclass(frozen=True, slots=True)
class Design:
    """A way to organise exploration.

    Attributes:
        block: Interactions between two updates of the networks.
        workers_choose: Whether workers choose the actions, each the ones it performs.
        overlapped: Whether the networks train during the next block, which then chooses with older ones.
    """

    block: int = BLOCK
    workers_choose: bool = False
    overlapped: bool = False


DESIGNS = {
    "as it is": Design(),
    "blocks of 2048": Design(block=4 * BLOCK),
    "workers choose": Design(workers_choose=True),
    "workers choose, blocks of 2048": Design(block=4 * BLOCK, workers_choose=True),
    "workers choose, training overlapped": Design(workers_choose=True, overlapped=True),
}


@dataclass(frozen=True, slots=True)
class Forecast:
    """How exploration would go.

    Attributes:
        workers: How many simulate.
        hours: For all steps.
        rate: Interactions per second.
        efficiency: Share of the workers' time that goes into simulating.
        dominant: What alone would take longest: choosing, handing out, simulating or training.
    """

    workers: int
    hours: float
    rate: float
    efficiency: float
    dominant: str


def forecast(costs: Costs, design: Design, workers: int, steps: int = STEPS) -> Forecast:
    """Go through an exploration block by block, and add up its times."""
    work = np.random.default_rng(0).choice(costs.perform, steps)
    clock, training = 0.0, 0.0
    pending = 0.0  # an update that goes on during the next block
    for start in range(0, steps, design.block):
        block = work[start : start + design.block]
        update = costs.train + costs.train_row * (start + len(block)) if len(block) == design.block else 0.0
        clock += max(block_time(costs, design, workers, block), pending)
        pending = update if design.overlapped else 0.0
        clock += 0.0 if design.overlapped else update
        training += update
    clock += pending
    choosing = steps * costs.choose
    parts = {
        "choosing": choosing / workers if design.workers_choose else choosing,
        "handing out": steps * costs.hand_out,
        "simulating": float(work.sum()) / workers,
        "training": training,
    }
    efficiency = float(work.sum()) / workers / clock
    return Forecast(
        workers, clock / 3600, steps / clock, efficiency, max(parts, key=lambda name: parts[name])
    )


def block_time(costs: Costs, design: Design, workers: int, work: Iterable[float]) -> float:
    """Simulate one block, event by event; returns when its last interaction ends [s]."""
    of_driver = costs.hand_out + (0.0 if design.workers_choose else costs.choose)
    of_worker = costs.choose if design.workers_choose else 0.0
    free = [0.0] * workers  # when each worker will be
    ends: deque[float] = deque()
    now = 0.0
    last = 0.0
    for duration in work:
        now += of_driver
        end = max(now, heapq.heappop(free)) + of_worker + duration
        heapq.heappush(free, end)
        ends.append(end)
        last = max(last, end)
        if len(ends) >= AHEAD * workers:
            now = max(now, ends.popleft())  # outcomes are taken back in order
    return max(now, last)


def measure(hand_out: float | None) -> Costs:
    """Measure every part on this machine.

    Args:
        hand_out: The driver's work for one interaction [s], if it is known already.
    """
    choose, perform = measure_interactions(60)
    train, train_row = measure_training(4)
    return Costs(choose, measure_ray() if hand_out is None else hand_out, perform, train, train_row)


def measure_interactions(count: int) -> tuple[float, tuple[float, ...]]:
    """Time choices of the default strategy (the median) and the interactions chosen, on the tabletop [s]."""
    world, config = make_world("tabletop", {}), ExplorationConfig()
    curiosity = make_curiosity(
        DEFAULT_STRATEGY, Dimensions(), ModelConfig(), config.learning, world.action_box.mirrors, seed=0
    )
    choices, interactions = [], []
    for number in range(count + 1):
        choose = partial(choose_action, world, curiosity, config, 0, number)
        task, seconds = timed(choose)
        choices.append(seconds)
        interactions.append(timed(partial(perform_task, world, task))[1])
    return float(np.median(choices[1:])), tuple(interactions[1:])  # the first also warms up


def measure_training(blocks: int) -> tuple[float, float]:
    """Time the first updates of the networks, and fit a line; returns its start and its slope per row [s].

    An update is what passes between the last outcome of a block and the first of the next, where choosing
    among one candidate and interacting in the toy world take next to nothing.
    """
    moments: list[float] = []
    explore(
        partial(make_world, "toy", {}),
        steps=blocks * BLOCK + 1,
        seed=0,
        config=ExplorationConfig(candidates=1),
        progress=lambda *_: moments.append(time.process_time()),
    )
    rows = BLOCK * np.arange(1, blocks + 1)
    slope, start = np.polyfit(rows, [moments[row] - moments[row - 1] for row in rows], 1)
    return max(float(start), 0.0), float(slope)


def measure_ray(count: int = 1000) -> float:
    """Time what Ray costs the driver for each task (its processor time), or take an old figure [s]."""
    try:
        import ray
    except ModuleNotFoundError:
        return HAND_OUT
    ray.init(
        "local",
        num_cpus=1,
        include_dashboard=False,
        log_to_driver=False,
        logging_level="ERROR",
        object_store_memory=10**8,
    )
    nothing = ray.remote(num_cpus=1)(_echo)
    load = bytes(2000)  # a scene, an action, and where the world comes from
    ray.get(nothing.remote(load))
    start = time.process_time()
    for _ in in_order([load] * count, submit=nothing.remote, result=ray.get, ahead=AHEAD):
        pass
    seconds = (time.process_time() - start) / count
    ray.shutdown()
    return seconds


def _echo(load: bytes) -> bytes:
    return load[:500]


def timed(function: Callable[[], Result]) -> tuple[Result, float]:
    """Call a function; returns what it returned, and how long it took [s]."""
    start = time.process_time()
    result = function()
    return result, time.process_time() - start


def table(costs: Costs, forecasts: dict[str, list[Forecast]]) -> str:
    """Print the forecasts as a Markdown table: hours (efficiency, what dominates)."""
    lines = [
        f"choosing {1e3 * costs.choose:.1f} ms, handing out {1e3 * costs.hand_out:.2f} ms, interaction "
        f"{1e3 * np.mean(costs.perform):.0f} ms on average, training {costs.train:.2f} s + "
        f"{1e3 * costs.train_row:.2f} ms per interaction so far\n",
        "| workers | " + " | ".join(forecasts) + " |",
        "|" + " --- |" * (len(forecasts) + 1),
    ]
    for row in zip(*forecasts.values(), strict=True):
        cells = [f"{60 * f.hours:.1f} min, {f.rate:.0f}/s, {f.efficiency:.0%}, {f.dominant}" for f in row]
        lines.append(f"| {row[0].workers} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main(
    table_wanted: Annotated[
        bool, tyro.conf.arg(name="table", help="Print a table in place of JSON.")
    ] = False,
    ray_ms: Annotated[
        float | None, tyro.conf.arg(help="Of the driver per interaction, not measured [ms].")
    ] = None,
) -> None:
    """Measure, forecast, print."""
    costs = measure(None if ray_ms is None else ray_ms / 1e3)
    forecasts = {
        name: [forecast(costs, design, workers) for workers in WORKERS] for name, design in DESIGNS.items()
    }
    if table_wanted:
        print(table(costs, forecasts))
    else:
        rows = {name: [asdict(one) for one in found] for name, found in forecasts.items()}
        print(json.dumps({"costs [s]": asdict(costs), "steps": STEPS, "forecasts": rows}, indent=1))


if __name__ == "__main__":
    tyro.cli(main)
