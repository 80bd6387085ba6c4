"""The robot's world gives the same bytes whoever asks, in whatever order, and after whatever else."""

import subprocess
import sys
import time

import numpy as np
import pybullet
import pytest

from neurosym.exploration.curiosity import LearningConfig
from neurosym.exploration.loop import STATE_FILE, ExplorationConfig, explore
from neurosym.learning.training_config import ModelConfig
from neurosym.sim.simulation import Simulation
from neurosym.sim.tabletop import Tabletop
from neurosym.worlds.workers import Task, perform_all

OBJECTS = 3


def some_tasks(count, seed=5, objects=OBJECTS):
    world = Tabletop()
    generators = [np.random.default_rng([seed, number]) for number in range(count)]
    return [Task(world.sample_scene(rng, objects), world.action_box.sample(rng, 1)[0]) for rng in generators]


def bytes_of(outcomes):
    scenes = [(outcome.start, outcome.lifted, outcome.end) for outcome in outcomes]
    return [
        b"".join(scene.positions.tobytes() + scene.orientations.tobytes() for scene in triple)
        for triple in scenes
    ]


def performed(tasks, workers=1):
    return bytes_of(perform_all(Tabletop, tasks, workers))


def test_workers_and_order_do_not_matter():
    tasks = some_tasks(20)
    forward = performed(tasks)
    assert performed(tasks[:12], workers=2) == performed(tasks[:12], workers=3) == forward[:12]
    assert performed(tasks[::-1])[::-1] == forward


def test_order_matters_once_the_deterministic_set_up_is_switched_off(monkeypatch):
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


FRESH = """
import sys
sys.path.insert(0, {tests!r})
from test_determinism import performed, some_tasks
sys.stdout.buffer.write(b"".join(performed(some_tasks(5))))
"""


@pytest.mark.parametrize("others", [40, pytest.param(500, marks=pytest.mark.evaluation)])
def test_a_fresh_process_and_a_used_one_give_the_same_bytes(others, request):
    script = FRESH.format(tests=str(request.path.parent))
    fresh = subprocess.run([sys.executable, "-c", script], capture_output=True, check=True).stdout
    used = performed(some_tasks(others, seed=6, objects=1) + some_tasks(5))
    assert b"".join(used[others:]) == fresh


QUICK = ExplorationConfig(
    candidates=20, block=16, learning=LearningConfig(epochs=1, ensemble=2, ensemble_hidden=16)
)


def explored(folder, steps, **options):
    small = ModelConfig(hidden=16)
    interactions = explore(Tabletop, steps=steps, seed=3, config=QUICK, model_config=small, **options)
    interactions.save(folder / "interactions.npz")
    return (folder / "interactions.npz").read_bytes()


KILLED = """
import sys
from pathlib import Path
sys.path.insert(0, {tests!r})
from test_determinism import explored
if __name__ == "__main__":
    explored(Path(sys.argv[1]), 10_000, workers=2, checkpoint=Path(sys.argv[1]))
"""


def test_a_killed_exploration_of_the_tabletop_resumes_to_the_same_bytes(tmp_path, request):
    script = tmp_path / "killed.py"
    script.write_text(KILLED.format(tests=str(request.path.parent)))
    process = subprocess.Popen([sys.executable, script, tmp_path], stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 60
    while not (tmp_path / STATE_FILE).exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    process.kill()
    process.wait()
    done = len(np.load(tmp_path / "interactions.partial.npz")["features"])
    resumed = explored(tmp_path, done + 20, checkpoint=tmp_path)
    assert resumed == explored(tmp_path, done + 20)
