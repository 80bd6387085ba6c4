"""Whatever surroundings a command is started in, it ends with its own exit codes and no traceback."""

import errno
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import contents, refusal

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
def test_streams_that_are_closed_or_full_bring_no_traceback(kept: Path, line: str, code: int, said: str):
    ended = shell(line, "check", kept)
    assert (ended.returncode, ended.stderr) == (code, said)


@pytest.mark.parametrize("environment", [{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}])
def test_names_that_the_encoding_does_not_have_are_escaped_or_refused(folder: Path, environment):
    there = folder.with_name("h\u00f6lle")
    folder.rename(there)
    ended = shell('"$@"', "check", there, **environment)
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


def failing(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    """Have the command `planners` fail."""

    def planners() -> int:
        raise error

    monkeypatch.setattr("neurosym.commands.tasks.planners", planners)


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (OSError(errno.ENOSPC, "No space left"), "Something could not be read or written: No space left"),
        (PermissionError(errno.EACCES, "Permission denied", "a"), "a: Permission denied"),
        (OSError(), "Something could not be read or written: OSError"),
        (MemoryError(), "There is not enough memory"),
        (RuntimeError("DefaultCPUAllocator: can't allocate memory: you tried"), "There is not enough memory"),
        (ImportError("libtorch_cpu.so: failed to map segment from shared object"), "There is not enough mem"),
    ],
)
def test_errors_of_the_system_are_told_in_a_sentence(monkeypatch, capsys, error, said):
    failing(monkeypatch, error)
    told = refusal(capsys, "planners")
    assert said in told
    assert "None" not in told


def test_current_folder_that_is_gone_is_told(tmp_path: Path):
    line = 'mkdir "$0/gone" && cd "$0/gone" && rmdir "$0/gone" && "$@"'
    command = ["bash", "-c", line, str(tmp_path), *START, "check", "toy"]
    ended = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT)
    assert ended.returncode == 2
    assert "Traceback" not in ended.stderr
    assert len(ended.stderr.splitlines()) == 1


WRITERS: dict[str, Callable[[Path, Path], tuple[object, ...]]] = {
    "report": lambda folder, place: ("report", folder, "--output", place / "page.html"),
    "evaluate": lambda folder, place: ("evaluate", folder, "--output", place / "tables.md"),
    "strip": lambda folder, place: (
        *("execute", folder, "task-01", next((folder / "plans").glob("task-01.*.plan"))),
        *("--strip", place / "a.png"),
    ),
}


@pytest.mark.parametrize("command", WRITERS)
def test_output_that_cannot_be_written_is_noticed_before_the_work(
    folder: Path, tmp_path: Path, monkeypatch, capsys, command: str
):
    place = tmp_path / "full"
    place.mkdir()
    before = contents(folder)
    real = Path.open

    def full(path: Path, mode: str = "r", *options: object, **named: object) -> object:
        if path.parent == place and mode == "xb":
            raise OSError(errno.EROFS, "Read-only file system")
        return real(path, mode, *options, **named)

    monkeypatch.setattr(Path, "open", full)
    assert "Read-only file system" in refusal(capsys, *WRITERS[command](folder, place))
    assert contents(folder) == before
