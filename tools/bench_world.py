"""How fast the tabletop world is; prints JSON.

Whole actions are compared with a bare loop of `stepSimulation` over the same bodies in the same contacts: the
same interactions are performed once more, and now and then interrupted for a few bare steps that are timed.
Both are in CPU seconds, so that other processes on the machine disturb the ratio little.
"""

import json
import multiprocessing
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import pybullet
import tyro
from world_measures import factory, random_tasks

from neurosym.sim.simulation import Simulation
from neurosym.workers import Task, crew

BURST_EVERY, BURST = 20, 10
"""A burst of so many bare steps after every so many steps."""
_PAGE_MB = 4096 / 2**20


def main(
    interactions: Annotated[int, tyro.conf.arg(help="Interactions that each speed is measured over.")] = 400,
    growth: Annotated[int, tyro.conf.arg(help="Interactions in one worker whose memory is watched.")] = 2000,
    time_step: Annotated[float, tyro.conf.arg(help="Step of the simulation [s].")] = 1 / 240,
) -> None:
    """Measure, and print what was found as JSON."""
    print(json.dumps(bench(interactions, growth, time_step), indent=2))


def bench(interactions: int, growth: int, time_step: float) -> dict[str, Any]:
    """Measure stepping, whole actions, workers and memory."""
    world = factory(time_step=time_step)()
    tasks = random_tasks(interactions, 11, world=world)
    perform = partial(_perform_all, world)
    perform(tasks[:5])
    with _counted_steps() as steps:
        seconds = perform(tasks)
    raw = _bare_rate(world, tasks[: max(20, interactions // 4)])
    rate = steps[0] / seconds
    one, two = (_rate_with(workers, time_step, tasks) for workers in (1, 2))
    return {
        "raw_steps_per_second": round(raw),
        "steps_per_second_in_actions": round(rate),
        "share_of_raw_stepping": round(rate / raw, 3),
        "cpu_ms_per_interaction": round(1000 * seconds / interactions, 1),
        "steps_per_interaction": round(steps[0] / interactions),
        "interactions_per_second_1_worker": round(one, 2),
        "interactions_per_second_2_workers": round(two, 2),
        "speedup_2_workers": round(two / one, 3),
        "minutes_for_10000_with_2_workers": round(10_000 / two / 60, 2),
        "time_step": time_step,
        **memory(growth, time_step),
    }


def _perform_all(world: Any, tasks: list[Task]) -> float:
    """Perform tasks in this process and return the CPU time that took [s]."""
    begin = time.process_time()
    for task in tasks:
        world.interact(task.scene, task.action, task.target)
    return time.process_time() - begin


@contextmanager
def _counted_steps() -> Iterator[list[int]]:
    """Count the steps of simulations made meanwhile."""
    count = [0]
    inner = Simulation.step

    def step(self: Simulation) -> None:
        inner(self)
        count[0] += 1

    Simulation.step = step  # type: ignore[method-assign]
    try:
        yield count
    finally:
        Simulation.step = inner  # type: ignore[method-assign]


def _bare_rate(world: Any, tasks: list[Task]) -> float:
    """Return how many bare steps fit in a CPU second, amid the contacts of real interactions [1/s]."""
    spent, steps = 0.0, 0
    inner = Simulation.step

    def step(self: Simulation) -> None:
        nonlocal spent, steps
        inner(self)
        if self.ticks % BURST_EVERY == 0:
            client = self.client
            begin = time.process_time()
            for _ in range(BURST):
                pybullet.stepSimulation(physicsClientId=client)
            spent += time.process_time() - begin
            steps += BURST

    Simulation.step = step  # type: ignore[method-assign]
    try:
        _perform_all(world, tasks)
    finally:
        Simulation.step = inner  # type: ignore[method-assign]
    return steps / spent


def _rate_with(workers: int, time_step: float, tasks: list[Task]) -> float:
    """Return how many interactions so many worker processes make in a second of the clock."""
    make = factory(time_step=time_step)
    with crew(make, workers) as perform:
        list(perform(tasks[: 4 * workers]))  # until every worker has its world
        begin = time.perf_counter()
        for _ in perform(tasks):
            pass
        return len(tasks) / (time.perf_counter() - begin)


def memory(interactions: int, time_step: float) -> dict[str, Any]:
    """Watch the memory of one fresh process over many interactions."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        before, after = pool.apply(_memory_over, (interactions, time_step))
    return {
        "memory_mb_a_worker": round(after, 1),
        "memory_growth_mb": round(after - before, 1),
        "memory_growth_over_interactions": interactions,
    }


def _memory_over(interactions: int, time_step: float) -> tuple[float, float]:
    world = factory(time_step=time_step)()
    warm_up = random_tasks(20, 12, world=world)
    _perform_all(world, warm_up)
    before = _resident_mb()
    for first in range(0, interactions, 500):
        count = min(500, interactions - first)
        _perform_all(world, random_tasks(count, 13 + first, world=world))
    return before, _resident_mb()


def _resident_mb() -> float:
    return int(Path("/proc/self/statm").read_text().split()[1]) * _PAGE_MB


if __name__ == "__main__":
    tyro.cli(main)
