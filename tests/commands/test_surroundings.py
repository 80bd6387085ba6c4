"""Whatever surroundings a command is started in, it ends with its own exit codes and no traceback."""

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import contents, neurosym, refusal

from neurosym.errors import InvalidValue

START = (sys.executable, "-m", "neurosym")
ENVIRONMENT = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}


def shell(line: str, *arguments: object, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a line of the shell, in which "$@" is what starts the command line."""
    command = ["bash", "-c", line, "bash", *START, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT | environment, timeout=100)


FULL = "standard output cannot be written: No space left on device.\n"


@pytest.mark.parametrize(
    ("line", "code", "said"),
    [
        ('"$@" <&- >&- 2>&-', 0, ""),
        ('"$@" 2>/dev/full', 0, ""),
        ('set -o pipefail; "$@" | head -0', 141, ""),
        ('"$@" >/dev/full', 2, FULL),
    ],
)
def test_streams_that_are_closed_or_full_bring_no_traceback(line: str, code: int, said: str):
    ended = shell(line, "planners")
    assert (ended.returncode, ended.stderr) == (code, said)


@pytest.mark.parametrize("environment", [{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}])
def test_names_that_the_encoding_does_not_have_are_escaped_or_refused(folder: Path, environment):
    there = folder.with_name("h\u00f6lle")
    folder.rename(there)
    ended = shell('"$@"', "plan", there, "task-01", "--planner", "counting", **environment)
    assert "Traceback" not in ended.stderr
    assert (ended.returncode, r"h\xf6lle" in ended.stdout) in {(0, True), (2, False)}


def test_argument_that_is_no_text_is_refused_before_anything_is_done(folder: Path, capsys):
    name = os.fsdecode(b"\xff.plan")
    (folder / name).write_bytes(next((folder / "plans").glob("*.plan")).read_bytes())
    before = contents(folder)
    said = refusal(capsys, "execute", folder, "task-01", folder / name)
    assert "is no text in utf-8; rename the file" in said
    assert contents(folder) == before


INTERRUPTED_IMPORT = """
import sys
class Interrupt:
    def find_spec(self, name, *_):
        if name == sys.argv[1]:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupt())
from neurosym.commands.cli import main
main(["planners"])
"""


@pytest.mark.parametrize(
    ("module", "said"), [("neurosym.commands.ending", ""), ("neurosym.commands.tasks", "interrupted; ")]
)
def test_interrupt_while_the_command_line_is_imported_brings_no_traceback(module, said):
    command = [sys.executable, "-c", INTERRUPTED_IMPORT, module]
    ended = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT)
    assert (ended.returncode, ended.stdout) == (130, "")
    assert ended.stderr.startswith(said)
    assert len(ended.stderr.splitlines()) == bool(said)


@pytest.mark.parametrize(
    ("error", "code", "said"),
    [
        (3, 3, ""),
        (KeyboardInterrupt(), 130, "interrupted; the same command goes on from what is written, or begins"),
        (InvalidValue("seed = -1 must be at least 0."), 2, "seed = -1 must be at least 0."),
        (OSError(errno.ENOSPC, "No space left"), 2, "Something could not be read or written: No space left"),
        (PermissionError(errno.EACCES, "Permission denied", "a"), 2, "a: Permission denied"),
        (OSError(), 2, "Something could not be read or written: OSError"),
        (MemoryError(), 2, "There is not enough memory"),
        (RuntimeError("DefaultCPUAllocator: can't allocate memory: you"), 2, "There is not enough memory"),
        (ImportError("a.so: failed to map segment from shared object"), 2, "There is not enough memory"),
    ],
)
def test_how_a_command_ends_decides_the_exit_code_and_what_is_told(monkeypatch, capsys, error, code, said):
    def planners() -> int:
        if isinstance(error, int):
            return error
        raise error

    monkeypatch.setattr("neurosym.commands.tasks.planners", planners)
    assert neurosym("planners") == code
    told = capsys.readouterr().err.strip()
    assert told.startswith(said)
    assert len(told.splitlines()) == bool(said)
    assert "None" not in told


def test_current_folder_that_is_gone_is_told(tmp_path: Path):
    line = 'mkdir "$0/gone" && cd "$0/gone" && rmdir "$0/gone" && "$@"'
    command = ["bash", "-c", line, str(tmp_path), *START, "check", "toy"]
    ended = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT)
    assert ended.returncode == 2
    assert "Traceback" not in ended.stderr
    assert len(ended.stderr.splitlines()) == 1
