"""The robot's world gives the same bytes whoever asks, in whatever order, and after whatever else."""

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pybullet
import pytest

from neurosym.exploration.curiosity import LearningConfig
from neurosym.exploration.loop import STATE_FILE, ExplorationConfig, explore
from neurosym.learning.training_config import ModelConfig
from neurosym.sim.simulation import Simulation
from neurosym.sim.tabletop import Tabletop
from neurosym.worlds.workers import Task, perform_all

COUNT = 8


def some_tasks(count, seed=5, objects=3):
    world = Tabletop()
    generators = [np.random.default_rng([seed, number]) for number in range(count)]
    return [Task(world.sample_scene(rng, objects), world.action_box.sample(rng, 1)[0]) for rng in generators]


def performed(tasks, workers=1):
    """The bytes of where all ends, for each task."""
    triples = [(one.start, one.lifted, one.end) for one in perform_all(Tabletop, tasks, workers)]
    return [
        b"".join(scene.positions.tobytes() + scene.orientations.tobytes() for scene in triple)
        for triple in triples
    ]


def test_workers_and_order_do_not_matter_but_to_a_careless_set_up(monkeypatch):
    tasks = some_tasks(COUNT)
    forward = performed(tasks)
    assert performed(tasks[:6], workers=2) == performed(tasks[:6], workers=3) == forward[:6]
    assert performed(tasks[::-1])[::-1] == forward
    monkeypatch.setattr(Simulation, "_reset", reset_carelessly)
    tasks = some_tasks(20)
    assert performed(tasks) != performed(tasks[::-1])[::-1]


def reset_carelessly(simulation):
    """Make room by removing bodies one by one, and leave the pairs of touching objects in any order."""
    client = simulation.client.number
    for _ in range(pybullet.getNumBodies(physicsClientId=client)):
        pybullet.removeBody(pybullet.getBodyUniqueId(0, physicsClientId=client), physicsClientId=client)
    pybullet.setPhysicsEngineParameter(
        fixedTimeStep=simulation.config.time_step,
        numSolverIterations=50,
        deterministicOverlappingPairs=0,
        physicsClientId=client,
    )
    pybullet.setGravity(0, 0, -9.81, physicsClientId=client)


def elsewhere(body: str, *arguments: object) -> list[str]:
    """A command that runs lines of this module in a fresh process."""
    head = f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r})\nfrom test_determinism import *\n"
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    return [sys.executable, "-c", f"{head}if __name__ == '__main__':\n{lines}", *map(str, arguments)]


@pytest.mark.parametrize("others", [20, pytest.param(500, marks=pytest.mark.evaluation)])
def test_a_fresh_process_and_a_used_one_give_the_same_bytes(others):
    command = elsewhere("sys.stdout.buffer.write(b''.join(performed(some_tasks(3))))")
    fresh = subprocess.run(command, capture_output=True, check=True).stdout
    used = performed(some_tasks(others, seed=6, objects=1) + some_tasks(3))
    assert b"".join(used[others:]) == fresh


LEARNING = LearningConfig(epochs=1, ensemble=2, ensemble_hidden=16)
QUICK = ExplorationConfig(candidates=20, block=16, learning=LEARNING)


def explored(folder, steps, **options):
    small = ModelConfig(hidden=16)
    interactions = explore(Tabletop, steps=steps, seed=3, config=QUICK, model_config=small, **options)
    interactions.save(folder / "interactions.npz")
    return (folder / "interactions.npz").read_bytes()


def test_a_killed_exploration_of_the_tabletop_resumes_to_the_same_bytes(tmp_path):
    work = "explored(Path(sys.argv[1]), 10_000, workers=2, checkpoint=Path(sys.argv[1]))"
    command = elsewhere(work, tmp_path)
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 120
    while not (tmp_path / STATE_FILE).exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    process.kill()
    process.wait()
    done = len(np.load(tmp_path / "interactions.partial.npz")["features"])
    resumed = explored(tmp_path, done + 8, checkpoint=tmp_path)
    assert resumed == explored(tmp_path, done + 8)
