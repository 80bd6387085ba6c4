"""The whole way on the real simulator, from nothing, on a small budget."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import neurosym
from validators import unified_planning_accepts

from neurosym.files import read_json
from neurosym.planners import PlanStatus
from neurosym.planners.external import plan_fast_downward
from neurosym.stages.plan_records import PlanRecord

LEARN = ["--steps", "128", "--seed", "7", "--regime", "quick", "--rehearsals", "6", "--problems", "3"]
LEARN += ["--action-bits", "1", "--choice", "lowest-error", "--workers", "1"]  # and no auditions


def command(folder: Path) -> list[str]:
    return [sys.executable, "-m", "neurosym", "run", str(folder), *LEARN]


def run(folder: Path) -> subprocess.CompletedProcess[str]:
    (folder.parent / "temporary").mkdir(exist_ok=True)
    environment = {**os.environ, "TMPDIR": str(folder.parent / "temporary")}
    return subprocess.run(command(folder), capture_output=True, text=True, timeout=1200, env=environment)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A domain folder learned by a run that was killed in the middle and started again."""
    path = tmp_path_factory.mktemp("domains") / "small"
    assert neurosym("init", path) == 0
    world = path / "world.toml"
    coarse = re.sub(r"^time_step = .*$", "time_step = 0.00833", world.read_text(), flags=re.MULTILINE)
    world.write_text(coarse)  # half the physics; the default is simulated by all other tests
    pipes = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
    first = subprocess.Popen(command(path), start_new_session=True, **pipes)
    deadline, growing = time.monotonic() + 300, path / "growing"
    while not (growing / "interactions.npz").exists() and time.monotonic() < deadline:
        assert first.poll() is None, first.stderr.read() if first.stderr else ""
        time.sleep(0.05)
    os.killpg(first.pid, signal.SIGKILL)
    first.communicate()
    assert (growing / "interactions.npz").exists()
    assert not (growing / "effect_model.safetensors").exists()
    second = run(path)
    assert second.returncode == 0, second.stderr
    return path


def test_killed_run_goes_on_and_a_finished_one_does_nothing(folder):
    before = {path: path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}
    again = run(folder)
    assert again.returncode == 0, again.stderr
    assert ": done" not in again.stdout
    assert list((folder.parent / "temporary").iterdir()) == []
    assert {path: path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()} == before


def test_plans_of_fast_downward_were_executed_and_other_programs_accept_them(folder):
    records = [read_json(path, PlanRecord) for path in sorted((folder / "plans").glob("*.json"))]
    assert len(records) == 3
    executed = {path.name.split(".")[0] for path in (folder / "runs").glob("*.run.json")}
    assert executed == {record.problem for record in records if record.solved}
    assert any(record.steps for record in records)
    solved = next(record for record in records if record.steps)
    domain, problem = folder / "domain.pddl", folder / f"problems/{solved.problem}.pddl"
    answer = plan_fast_downward(domain, problem, time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED
    assert unified_planning_accepts(domain, problem, answer.text)
