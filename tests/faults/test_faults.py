"""The campaign of faults, on a tiny budget; and that it would find what it looks for."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import neurosym
from places import ROOT

from neurosym.commands.arguments import read_arguments
from tools.faults.commands import MARK, Ending, Running, content, differences, left_by
from tools.faults.journal import Journal, Trial, page, summarise
from tools.faults.subjects import TASK, WORLDS, Bench, stages, subjects
from tools.faults.trials import HOOK, cannot_mount, disks, kills, limits, pairs

PLANNING = subjects("toy")[0]


@pytest.fixture(scope="module")
def bench(toy_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Bench:
    """Where trials take place, with a toy folder that has a problem to be planned for."""
    place = tmp_path_factory.mktemp("faults")
    shutil.copytree(toy_folder, place / "learned-toy")
    assert neurosym("new-problem", place / "learned-toy", "--name", TASK, "--seed", 1) == 0
    return Bench(place)


def test_what_is_disturbed_can_be_typed():
    for subject in (one for world in WORLDS for one in (*subjects(world), *stages(world))):
        assert callable(read_arguments(subject.arguments(Path("folder")))), subject.title


def test_kills_are_made_written_down_and_not_made_again(bench: Bench, tmp_path: Path):
    journal = Journal(tmp_path / "trials.jsonl")

    def campaign() -> list[str]:
        made = []
        for name, job in kills(bench, PLANNING, journal, wanted=2, seed=1):
            if name not in journal.trials:
                journal.add(job())
                made.append(name)
        return made

    assert campaign() == ["kills-plan-toy-000", "kills-plan-toy-001"]
    assert [trial.found for trial in journal.trials.values()] == [(), ()]
    with journal.path.open("a") as file:
        file.write('{"part": "kil')  # as a kill would leave it
    journal = Journal(journal.path)
    assert campaign() == []
    about = {"command": "make faults", "seed": 1, "minutes": 0.0, "left_out": ["full disks: no root"]}
    trial = Trial("kills", "n", "check", "toy", "SIGTERM at 1 s", "a finding", ("lost: domain.pddl",), 1)
    table = page(summarise([*journal.trials.values(), trial], about))
    assert "| plan | toy | 2 | 2 of 2 | 2 the same bytes |" in table
    assert "| check | toy | 1 | 0 of 1 | 1 a finding |" in table
    assert "- check, toy: SIGTERM at 1 s: lost: domain.pddl" in table
    assert "Left out: full disks: no root." in table


def test_low_limits_and_two_at_once_are_as_promised(bench: Bench):
    tight = dict(limits(bench, PLANNING))["limits-plan-toy-file-size-256"]()
    assert (tight.outcome, tight.found) == ("the same bytes", ())
    twice = next(pairs(bench, "toy", wanted=1, seed=1))[1]()
    assert twice.found == ()


def test_a_full_disk_is_as_promised(bench: Bench):
    if reason := cannot_mount(bench):
        pytest.skip(reason)
    full = dict(disks(bench))["disk-plan-toy-0%"]()
    assert (full.outcome, full.found) == ("refused, then the same bytes", ())


@pytest.mark.parametrize(
    ("ending", "found"),
    [
        (Ending(0, "a note", 1.0), ""),
        (Ending(2, "One sentence.", 1.0), ""),
        (Ending(2, "One.\nTwo.", 1.0), "not one sentence"),
        (Ending(2, "Traceback (most recent call last):", 1.0), "traceback"),
        (Ending(1, "", 1.0), "exit code 1"),
        (Ending(None, "", 1.0), "hangs"),
    ],
)
def test_an_ending_that_is_not_as_promised_is_found(ending: Ending, found: str):
    complaints = ending.complaints((0, 2))
    assert [complaint.partition(":")[0] for complaint in complaints] == ([found] if found else [])
    for path, is_before in (("<frozen site>", True), (f"{ROOT}/neurosym/a.py", False)):
        errors = (
            f'Traceback (most recent call last):\n  File "{path}", line 616, in <module>\nKeyboardInterrupt'
        )
        assert Ending(1, errors, 1.0).is_before_ours is is_before


def test_what_is_left_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("tools.faults.commands.SETTLE", 0.1)
    (tmp_path / "left").touch()
    sleeping = [sys.executable, "-c", "import time; time.sleep(60)"]
    process = subprocess.Popen(sleeping, env={**os.environ, MARK: "mine"})
    running = Running(process, "mine", tmp_path / "log")
    deadline = time.monotonic() + 10.0
    while not Path(f"/proc/{process.pid}/environ").read_bytes() and time.monotonic() < deadline:
        time.sleep(0.01)
    found = left_by(running, tmp_path)
    assert "temporary file left: left" in found
    assert any("time.sleep(60)" in one for one in found)
    assert process.wait(10.0) == -signal.SIGKILL


def test_other_bytes_are_found_and_other_seconds_are_not(tmp_path: Path):
    def made(seconds: float, steps: int) -> dict[str, str]:
        (tmp_path / "plan.json").write_text(json.dumps({"seconds": seconds, "steps": steps}))
        return content(tmp_path)

    assert differences(made(1.0, 3), made(2.0, 3)) == []
    assert differences(made(1.0, 3), made(1.0, 4)) == ["other bytes: plan.json"]
    assert differences({}, {"a": "0"}) == ["missing: a"]
    assert differences({".a.tmp": "0"}, {}) == ["too many: .a.tmp"]
    (tmp_path / "plan.json").write_text('{"half')
    assert content(tmp_path) == {"plan.json": "damaged"}


@pytest.mark.parametrize("kind", ["wall", "steady"])
def test_clocks_jump(tmp_path: Path, kind: str):
    (tmp_path / "sitecustomize.py").write_text(HOOK)
    code = """if True:
        import time
        wall, steady = [time.time()], [time.perf_counter()]
        for _ in range(99):
            wall.append(time.time())
            steady.append(time.perf_counter())
        jumps = [abs(b - a) > 2 for times in (wall, steady) for a, b in zip(times, times[1:])]
        print(any(jumps[:99]), any(jumps[99:]), steady == sorted(steady))
    """
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "NEUROSYM_FAULTS_CLOCK": kind}
    said = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert said.stdout.split() == [str(kind == "wall"), str(kind == "steady"), "True"], said.stderr
