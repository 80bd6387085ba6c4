"""Commands that are ended from outside leave no process and no temporary folder, and say how they ended."""

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import contents
from processes import alive

HANGING = """
import sys
from functools import partial
from neurosym.planners import pddl_planner
from neurosym.planners.external import Program, plan_program

SCRIPT = '''
import os, subprocess, sys, tempfile, time
open(os.path.join(tempfile.gettempdir(), "left"), "w").write("x")
if os.fork() == 0:
    os.setsid()
    subprocess.Popen([sys.executable, "-c", "import time; time.sleep(120)", sys.argv[1]])
    open(sys.argv[3], "a").write("x")
    os._exit(0)
time.sleep(120)
'''

def make():
    command = ("{python}", "-c", SCRIPT, "{domain}", "{problem}", __file__ + ".started")
    call = partial(plan_program, program=Program("Hanging", "neurosym", command))
    return pddl_planner("hanging", "a planner that hangs", call, ("strips",))
"""
PLANNER = "hanging:make"
COMMANDS: dict[str, Callable[[Path], tuple[str, ...]]] = {
    "plan": lambda folder: (str(folder), "task-01", "--planner", PLANNER),
    "execute": lambda folder: (
        *(str(folder), "task-01", str(folder / "plans/task-01.fast-downward.plan")),
        *("--replanner", PLANNER, "--disturb", "3"),
    ),
    "compare": lambda folder: (str(folder), "--tasks", "4", "--workers", "2", "--planners", PLANNER),
}
EXIT = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129, signal.SIGKILL: -9}
SOON = 10.0  # on a busy machine [s]


def eventually(holds: Callable[[], bool], within: float = SOON) -> bool:
    """Whether something comes true."""
    end = time.monotonic() + within
    while not (true := holds()) and time.monotonic() < end:
        time.sleep(0.02)
    return true


@pytest.fixture
def here(tmp_path: Path, folder: Path) -> Path:
    """A folder with a planner that hangs, a domain, and a folder for temporary files."""
    (tmp_path / "hanging.py").write_text(HANGING)
    (tmp_path / "scratch").mkdir()
    return tmp_path


def start(here: Path, *command: str) -> "subprocess.Popen[str]":
    environment = {**os.environ, "TMPDIR": str(here / "scratch")}
    return subprocess.Popen(
        [sys.executable, "-m", "neurosym", *command],
        cwd=here,
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )


def start_hanging(here: Path, command: str) -> "subprocess.Popen[str]":
    """Start a command, and wait until its planner hangs."""
    process = start(here, command, *COMMANDS[command](here / "toy"))
    assert eventually((here / "hanging.py.started").exists, 60.0), process.communicate()
    assert list((here / "scratch").iterdir()) != []
    assert any("left" in str(path) for path in (here / "scratch").rglob("*"))
    orphan = "-c import time"
    assert eventually(lambda: any(orphan in line for line in alive(str(here))))
    return process


@pytest.mark.parametrize(
    ("command", "number"),
    [
        ("plan", signal.SIGINT),
        ("plan", signal.SIGHUP),
        ("execute", signal.SIGTERM),
        ("compare", signal.SIGKILL),
    ],
)
def test_a_command_that_is_ended_leaves_nothing(here: Path, command: str, number: signal.Signals):
    before = contents(here / "toy")
    process = start_hanging(here, command)
    begin = time.monotonic()
    process.send_signal(number)
    _, said = process.communicate(timeout=60)
    assert time.monotonic() - begin < SOON
    assert process.returncode == EXIT[number], said
    assert eventually(lambda: alive(str(here)) == []), alive(str(here))
    assert eventually(lambda: list((here / "scratch").iterdir()) == [])
    assert [name for name in contents(here / "toy").keys() - before if "comparison" not in name] == []
    if number != signal.SIGKILL:
        how = {signal.SIGINT: "interrupted"}.get(number, f"ended by {number.name}")
        assert said.strip().endswith(f"{how}; the same command goes on from what is written, or begins again")
        assert "Traceback" not in said
        assert list((here / "scratch").iterdir()) == []


def test_the_folder_and_the_planner_of_a_living_owner_are_let_alone(here: Path):
    process = start_hanging(here, "plan")
    before = set(alive(str(here))), contents(here / "scratch").keys()
    shutil.copytree(here / "toy", here / "other")
    plan = start(here, "plan", str(here / "other"), "task-01")
    _, said = plan.communicate(timeout=60)
    assert plan.returncode in (0, 3), said
    assert (set(alive(str(here))), contents(here / "scratch").keys()) == before
    process.terminate()
    process.communicate(timeout=60)
    assert alive(str(here)) == []


def test_a_second_interrupt_ends_at_once():
    code = """if True:
        import time
        from neurosym.commands.ending import raised_signals
        with raised_signals():
            try:
                print("ready", flush=True)
                time.sleep(60)
            finally:
                print("ending", flush=True)
                time.sleep(60)
    """
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    for line in ("ready", "ending"):
        assert process.stdout.readline().strip() == line
        time.sleep(0.7)  # less is the same Ctrl-C
        process.send_signal(signal.SIGINT)
    process.communicate(timeout=SOON)
    assert process.returncode == 130


def test_a_signal_that_is_ignored_stays_so():
    code = "import os, signal; signal.signal(signal.SIGHUP, signal.SIG_IGN);"
    code += "from neurosym.commands.ending import raised_signals\n"
    code += "with raised_signals(): os.kill(os.getpid(), signal.SIGHUP); print('still here')"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ended.stdout == "still here\n"
