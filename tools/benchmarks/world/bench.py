"""How fast the tabletop world is; prints JSON.

Whole actions are compared with bare calls of `stepSimulation` on the same bodies in the same contacts:
the same interactions are performed once more, and now and then a bare step is made and timed. Longer
runs of bare steps would stall the motions and so change the contacts. Both are in CPU seconds and in
turns, so that other processes on the machine disturb the ratio little.
"""

import cProfile
import json
import multiprocessing
import pstats
import time
from collections import Counter
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.sim.simulation import Simulation
from neurosym.worlds.workers import Task, crew
from tools.benchmarks.world.measures import factory, random_tasks

BARE_STEP_EVERY = 20


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
    _perform_all(world, tasks[:5])
    raw, rate, seconds = stepping(world, tasks)
    one, two = (_rate_with(workers, time_step, tasks) for workers in (1, 2))
    return {
        "raw_steps_per_second": round(raw),
        "steps_per_second_in_actions": round(rate),
        "share_of_raw_stepping": round(rate / raw, 3),
        "cpu_ms_per_interaction": round(1000 * seconds, 1),
        "steps_per_interaction": round(rate * seconds),
        "interactions_per_second_1_worker": round(one, 2),
        "interactions_per_second_2_workers": round(two, 2),
        "speedup_2_workers": round(two / one, 3),
        "minutes_for_10000_with_2_workers": round(10_000 / two / 60, 2),
        "time_step": time_step,
        "profile": profile(world, tasks[:60]),
        **memory(growth, time_step),
    }


PARTS = {
    "stepping": ("step",),
    "building the scene": ("_reset", "_make_table", "_make_object", "loadURDF"),
    "inverse kinematics": ("joints_for",),
    "motor commands": ("drive_arm", "drive_fingers"),
    "looking": ("tool_point", "is_quiet", "half_opening", "touched_by", "observe"),
}  # where the time of an interaction goes: functions by what they are for


def profile(world: Any, tasks: list[Task]) -> dict[str, float]:
    """Share out the time of whole interactions over what it is spent on, as the profiler sees it."""
    profiler = cProfile.Profile()
    profiler.runcall(_perform_all, world, tasks)
    stats, spent = pstats.Stats(profiler), Counter[str]()
    for (_, _, function), row in stats.stats.items():
        spent[function.rstrip(">").split()[-1].split(".")[-1]] += row[3]  # also of `<built-in method f>`
    total = stats.total_tt
    shares = {name: round(sum(spent[part] for part in parts) / total, 3) for name, parts in PARTS.items()}
    return shares | {"rest": round(1 - sum(shares.values()), 3)}


def _perform_all(world: Any, tasks: list[Task]) -> float:
    """Perform tasks in this process and return the CPU time that took [s]."""
    begin = time.process_time()
    for task in tasks:
        world.interact(task.scene, task.action, task.target)
    return time.process_time() - begin


def stepping(world: Any, tasks: list[Task]) -> tuple[float, float, float]:
    """Return bare steps, and steps of whole actions, in a CPU second; and CPU seconds of an interaction."""
    whole = bare = 0.0
    steps = bare_steps = 0
    inner = Simulation.step

    def counted(simulation: Simulation) -> None:
        nonlocal steps
        inner(simulation)
        steps += 1

    def strewn_with_bare_steps(simulation: Simulation) -> None:
        nonlocal bare, bare_steps
        inner(simulation)
        if simulation.ticks % BARE_STEP_EVERY == 0:
            begin = time.process_time()
            simulation.client.stepSimulation()
            bare += time.process_time() - begin
            bare_steps += 1

    try:
        for task in tasks:
            Simulation.step = counted
            whole += _perform_all(world, [task])
            Simulation.step = strewn_with_bare_steps
            _perform_all(world, [task])
    finally:
        Simulation.step = inner
    return bare_steps / bare, steps / whole, whole / len(tasks)


def _rate_with(workers: int, time_step: float, tasks: list[Task]) -> float:
    """Return how many interactions so many worker processes make in a second of the clock."""
    with crew(factory(time_step=time_step), workers) as perform:
        list(perform(tasks[: 4 * workers]))  # until every worker has its world
        begin = time.perf_counter()
        list(perform(tasks))
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
    _perform_all(world, random_tasks(20, 12, world=world))  # until all is loaded
    before = _resident_mb()
    for first in range(0, interactions, 500):
        count = min(500, interactions - first)
        _perform_all(world, random_tasks(count, 13 + first, world=world))
    return before, _resident_mb()


def _resident_mb() -> float:
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 2**20


if __name__ == "__main__":
    tyro.cli(main)
