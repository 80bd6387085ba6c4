"""The whole way on the real simulator, from nothing, on a small budget."""

import os
import re
import signal
import subprocess
import sys
import time
import warnings
from functools import partial
from pathlib import Path

import pytest
from command_line import neurosym

from neurosym.exploration.curiosity import LearningConfig
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.files import read_json
from neurosym.planners import PlanStatus
from neurosym.planners.external import plan_fast_downward
from neurosym.stages.plan_records import PlanRecord
from neurosym.worlds.world_file import make_world

LEARN = ["--steps", "256", "--seed", "7", "--regime", "quick", "--rehearsals", "12", "--problems", "4"]
LEARN += ["--action-bits", "2"]  # half as many auditions
TABLETOP = partial(make_world, "tabletop", {})


def run(folder: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "neurosym", "run", str(folder), *LEARN]
    return subprocess.run(command, capture_output=True, text=True, timeout=1200)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A domain folder learned by a run that was killed in the middle and started again."""
    path = tmp_path_factory.mktemp("domains") / "small"
    assert neurosym("init", path) == 0
    world = path / "world.toml"
    coarse = re.sub(r"^time_step = .*$", "time_step = 0.00833", world.read_text(), flags=re.MULTILINE)
    world.write_text(coarse)  # half the physics; the default is simulated by all other tests
    command = [sys.executable, "-m", "neurosym", "run", str(path), *LEARN]
    first = subprocess.Popen(
        command, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    )
    deadline = time.monotonic() + 300
    while not (path / "interactions.npz").exists() and time.monotonic() < deadline:
        assert first.poll() is None, first.stderr.read() if first.stderr else ""
        time.sleep(0.05)
    os.killpg(first.pid, signal.SIGKILL)
    first.communicate()
    assert (path / "interactions.npz").exists()
    assert not (path / "effect_model.safetensors").exists()
    second = run(path)
    assert second.returncode == 0, second.stderr
    return path


def test_killed_run_goes_on_and_a_finished_one_does_nothing(folder):
    before = {path: path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}
    again = run(folder)
    assert again.returncode == 0, again.stderr
    assert ": done" not in again.stdout
    assert {path: path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()} == before


def test_some_plan_of_fast_downward_was_executed_in_the_simulator(folder):
    records = [read_json(path, PlanRecord) for path in sorted((folder / "plans").glob("*.json"))]
    assert len(records) >= 4
    executed = {path.name.split(".")[0] for path in (folder / "runs").glob("*.run.json")}
    assert executed == {record.problem for record in records if record.solved}
    assert any(record.steps for record in records)


def test_other_programs_read_and_solve_the_compiled_domain(folder):
    from unified_planning.engines import SequentialPlanValidator
    from unified_planning.io import PDDLReader
    from unified_planning.shortcuts import get_environment

    get_environment().credits_stream = None
    solved = next(
        record
        for record in (read_json(path, PlanRecord) for path in sorted((folder / "plans").glob("*.json")))
        if record.steps
    )
    domain, problem = folder / "domain.pddl", folder / f"problems/{solved.problem}.pddl"
    answer = plan_fast_downward(domain, problem, time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # unified-planning's own
        task = PDDLReader().parse_problem(str(domain), str(problem))
        plan = PDDLReader().parse_plan_string(task, answer.text)
        assert SequentialPlanValidator().validate(task, plan)


def test_one_and_two_workers_explore_to_the_same_bytes(tmp_path):
    config = ExplorationConfig(block=32, candidates=100, learning=LearningConfig(epochs=2))
    for workers in (1, 2):
        data = explore(TABLETOP, steps=72, seed=5, workers=workers, config=config)
        data.save(tmp_path / f"{workers}.npz")
    assert (tmp_path / "1.npz").read_bytes() == (tmp_path / "2.npz").read_bytes()
    other = explore(TABLETOP, steps=72, seed=6, workers=2, config=config)
    other.save(tmp_path / "other.npz")
    assert (tmp_path / "other.npz").read_bytes() != (tmp_path / "2.npz").read_bytes()
