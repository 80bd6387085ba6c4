"""Whatever surroundings a command is started in, it ends with its own exit codes and no traceback."""

import errno
import os
import subprocess
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from command_line import neurosym, refusal

from neurosym.commands import ending

START = (sys.executable, "-m", "neurosym")
ENVIRONMENT = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}


def shell(line: str, *arguments: object, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a line of the shell, in which "$@" is what starts the command line."""
    command = ["bash", "-c", line, "bash", *START, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT | environment, timeout=100)


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ('"$@" >&-', 0),
        ('"$@" 2>&-', 0),
        ('"$@" <&- >&- 2>&-', 0),
        ('"$@" 2>/dev/full', 0),
        ('set -o pipefail; "$@" | head -0', 141),
    ],
)
def test_streams_that_are_closed_or_full_bring_no_traceback(folder: Path, line: str, code: int):
    ended = shell(line, "check", folder)
    assert ended.returncode == code
    assert ended.stderr == ""


def test_output_that_cannot_be_written_is_told(folder: Path):
    ended = shell('"$@" >/dev/full', "check", folder)
    assert ended.returncode == 2
    assert ended.stderr == "standard output cannot be written: No space left on device.\n"


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
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    said = refusal(capsys, "execute", folder, "task-01", folder / name)
    assert "is no text in utf-8; rename the file" in said
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


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


def test_the_entry_imports_next_to_nothing():
    code = "import sys; from neurosym.commands.cli import main; print(*sys.modules)"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=ENVIRONMENT)
    loaded = ended.stdout.split()
    assert {name for name in loaded if name.startswith("neurosym")} == {
        "neurosym",
        "neurosym.commands",
        "neurosym.commands.cli",
    }
    assert not {"rich", "tyro", "numpy", "importlib.metadata"} & set(loaded)


def failing(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    """Have the command `planners` fail."""

    def planners() -> int:
        raise error

    monkeypatch.setattr("neurosym.commands.tasks.planners", planners)


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (
            OSError(errno.ENOSPC, "No space left on device"),
            "Something could not be read or written: No space",
        ),
        (PermissionError(errno.EACCES, "Permission denied", "a"), "a: Permission denied"),
        (OSError("odd"), "Something could not be read or written: odd"),
        (OSError(), "Something could not be read or written: OSError"),
        (MemoryError(), "There is not enough memory"),
        (RuntimeError("DefaultCPUAllocator: can't allocate memory: you tried"), "There is not enough memory"),
        (
            ImportError("libtorch_cpu.so: failed to map segment from shared object"),
            "There is not enough memory",
        ),
    ],
)
def test_errors_of_the_system_are_told_in_a_sentence(monkeypatch, capsys, error, said):
    failing(monkeypatch, error)
    told = refusal(capsys, "planners")
    assert said in told
    assert "None" not in told


@pytest.mark.parametrize("error", [RuntimeError("a bug"), ImportError("No module named 'bug'")])
def test_other_errors_are_not_taken_for_want_of_memory(monkeypatch, error):
    failing(monkeypatch, error)
    with pytest.raises(type(error), match="bug"):
        ending.perform(["planners"])


def test_current_folder_that_is_gone_is_told(tmp_path: Path):
    line = 'mkdir "$0/gone" && cd "$0/gone" && rmdir "$0/gone" && "$@"'
    command = ["bash", "-c", line, str(tmp_path), *START, "check", "toy"]
    ended = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT)
    assert ended.returncode == 2
    assert "Traceback" not in ended.stderr
    assert len(ended.stderr.splitlines()) == 1


WRITERS: dict[str, Callable[[Path, Path], tuple[object, ...]]] = {
    "report": lambda folder, place: ("report", folder, "--output", place / "page.html"),
    "explain": lambda folder, place: ("explain", folder, "--output", place / "words.md"),
    "evaluate": lambda folder, place: ("evaluate", folder, "--output", place / "tables.md"),
    "show": lambda folder, place: ("show", folder, "--interaction", 0, "--output", place / "a.png"),
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
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    real = Path.open

    def full(path: Path, mode: str = "r", *options: object, **named: object) -> object:
        if path.parent == place and mode == "xb":
            raise OSError(errno.EROFS, "Read-only file system")
        return real(path, mode, *options, **named)

    monkeypatch.setattr(Path, "open", full)
    assert "Read-only file system" in refusal(capsys, *WRITERS[command](folder, place))
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


def test_strip_that_the_disk_has_no_room_for_keeps_the_record(folder: Path, monkeypatch, capsys):
    from neurosym import files

    record = next((folder / "runs").glob("task-01.*.run.json"))
    record.write_text(record.read_text() + "\n")  # another record, of the same run
    before = record.read_bytes()
    real = files.draft

    def draft(place: Path, data: bytes) -> AbstractContextManager[Path]:
        if place.name == "a.png" and data.strip(b"\0"):
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(place, data)

    monkeypatch.setattr(files, "draft", draft)
    plan = next((folder / "plans").glob("task-01.*.plan"))
    said = refusal(capsys, "execute", folder, "task-01", plan, "--strip", folder / "a.png")
    assert "a.png cannot be written: No space left on device" in said
    assert record.read_bytes() == before


def test_training_leaves_nothing_in_the_temporary_folder(folder: Path, tmp_path: Path):
    place = tmp_path / "temporary"
    place.mkdir()
    ended = shell('"$@"', "train", folder, "--regime", "quick", TMPDIR=str(place))
    assert ended.returncode == 0
    assert list(place.iterdir()) == []


def test_exit_code_is_that_of_the_command(monkeypatch):
    monkeypatch.setattr("neurosym.commands.tasks.planners", lambda: 3)
    assert neurosym("planners") == 3
