"""Files are written whole or not at all, drafts are put in place together, and one process holds a lock."""

import errno
import inspect
import io
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from contextvars import copy_context
from pathlib import Path
from types import FrameType

import pytest

from neurosym import files
from neurosym.errors import CannotWrite, InvalidFile
from neurosym.files import Drafts, check_writable, remove, write_atomically, write_new


def test_a_file_that_cannot_be_put_in_place_leaves_nothing_behind(tmp_path: Path):
    (tmp_path / "taken").mkdir()
    with pytest.raises(OSError, match="taken"):
        write_atomically(tmp_path / "taken", "text")
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]


def test_an_interrupted_write_keeps_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "a.json"
    write_atomically(path, "old")

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_atomically(path, "new")
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.json"]


FULL = OSError(errno.ENOSPC, "No space left on device")


class Full(io.FileIO):
    """A file into which nothing can be written."""

    def write(self, _: object) -> int:  # noqa: D102
        raise FULL


@pytest.fixture
def full_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """A disk on which a file can be made, and nothing can be written into it."""
    real = Path.open

    def opened(path: Path, mode: str = "r", *options: object, **named: object) -> object:
        return Full(path, mode) if mode == "xb" else real(path, mode, *options, **named)

    monkeypatch.setattr(Path, "open", opened)


@pytest.mark.usefixtures("full_disk")
def test_full_disk_is_noticed_before_the_work_and_leaves_nothing(tmp_path: Path):
    for act in (check_writable, lambda path: write_atomically(path, "text")):
        with pytest.raises(CannotWrite, match=r"/a\.json cannot be written: No space left on device\.$"):
            act(tmp_path / "a.json")
        assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["deep/below/a", "a" * 255, "a" * 256])
def test_file_that_can_be_written_is_found_so_and_nothing_is_made(tmp_path: Path, name: str):
    if len(name) < 256:
        check_writable(tmp_path / name)
    else:
        with pytest.raises(CannotWrite, match="File name too long"):
            check_writable(tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_file_in_the_way_of_a_folder_is_noticed(tmp_path: Path):
    (tmp_path / "plans").touch()
    for act, name in ((check_writable, "plans/below"), (files.make_folder, "plans")):
        with pytest.raises(InvalidFile, match=r"/plans cannot be used: it is a file, and should be a folder"):
            act(tmp_path / name)
    with pytest.raises(InvalidFile, match="it is a folder, and should be a file"):
        check_writable(tmp_path)


@pytest.mark.parametrize(("error", "kept"), [(FileExistsError, "2"), (OSError, "1")])
def test_new_file_is_kept_if_another_writes_it_meanwhile(tmp_path: Path, monkeypatch, error, kept):
    def meanwhile(*_: object) -> None:
        if error is FileExistsError:
            (tmp_path / "a").write_text("2")
        raise error

    with monkeypatch.context() as patched:
        patched.setattr(os, "link", meanwhile)
        assert write_new(tmp_path / "a", "1") is (kept == "1")
    assert not write_new(tmp_path / "a", "3")
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("a", kept)]


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_drafts_change_nothing_until_they_are_put_in_place(tmp_path: Path):
    old, new, gone = places = [tmp_path / name for name in ("old", "new", "gone")]
    old.write_text("1")
    gone.write_text("2")
    with Drafts() as drafts:
        write_atomically(old, "of no more use")
        write_atomically(old, "3")
        remove(new)
        write_atomically(new, "4")
        remove(gone)
        assert (old.read_text(), new.exists(), gone.exists()) == ("1", False, True)
        promised = files.digests({path.name: path for path in places})
        with files.at_once():  # as a checkpoint is
            write_atomically(tmp_path / "checkpoint", "5")
        assert (tmp_path / "checkpoint").read_text() == "5"
        drafts.put_in_place()
    written = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert written == {"old": "3", "new": "4", "checkpoint": "5"}
    assert promised == files.digests({path.name: path for path in places})
    assert promised.keys() == {"old", "new"}


def test_drafts_that_are_not_put_in_place_are_dropped(tmp_path: Path):
    (tmp_path / "old").write_text("1")
    with suppress(KeyboardInterrupt), Drafts():
        write_atomically(tmp_path / "old", "3")
        remove(tmp_path / "old")
        write_atomically(tmp_path / "old", "5")
        write_atomically(tmp_path / "new", "4")
        raise KeyboardInterrupt
    assert names(tmp_path) == ["old"]
    assert (tmp_path / "old").read_text() == "1"
    write_atomically(tmp_path / "old", "6")
    assert (tmp_path / "old").read_text() == "6"


def write_together(path: Path) -> None:
    with Drafts() as drafts:
        write_atomically(path, "together")
        drafts.put_in_place()


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # files that nobody closes
@pytest.mark.parametrize(
    "write",
    [
        lambda path: write_atomically(path, "one"),
        lambda path: write_new(path, "new"),
        write_together,
        check_writable,
    ],
    ids=["one", "new", "together", "none"],
)
def test_a_signal_leaves_no_draft_whenever_it_comes(tmp_path: Path, write: Callable[[Path], object]):
    """Signals are raised between two steps of the interpreter; each step of ours is tried."""
    steps = 0
    while was_interrupted(lambda: write(tmp_path / "file"), steps):
        assert set(names(tmp_path)) <= {"file"}, f"after {steps} steps"
        (tmp_path / "file").unlink(missing_ok=True)
        steps += 1
    assert steps > 20


def was_interrupted(work: Callable[[], object], steps: int) -> bool:
    """Do something that is interrupted after so many steps, and say whether it takes more."""
    left = steps

    def trace(frame: FrameType, event: str, _: object) -> object:
        nonlocal left
        if frame.f_code.co_filename != files.__file__:
            return None
        frame.f_trace_opcodes = True
        left -= event == "opcode"
        if left < 0:
            raise KeyboardInterrupt
        return trace

    here = inspect.currentframe()
    assert here is not None
    here.f_trace_opcodes = True  # else Python 3.12 begins to tell of steps only with the next tracing
    before = sys.gettrace()
    sys.settrace(trace)
    try:
        copy_context().run(work)
    except KeyboardInterrupt:
        return True
    finally:
        sys.settrace(before)
    return False


DRAFT_AND_WAIT = """
import sys, time
from pathlib import Path
from neurosym.files import Drafts
from neurosym.files import write_atomically
with Drafts():
    write_atomically(Path(sys.argv[1]) / "a", "1")
    print("written", flush=True)
    time.sleep(60)
"""


def test_leftovers_of_a_killed_process_are_removed_and_those_of_a_live_one_kept(tmp_path: Path):
    (tmp_path / ".neurosymmetry").touch()
    (tmp_path / ".neurosym-0123456789abcdef").touch()  # as earlier versions called them
    os.mkfifo(tmp_path / ".neurosym-pipe")  # which nobody writes into
    command = [sys.executable, "-c", DRAFT_AND_WAIT, str(tmp_path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "written\n"
        files.remove_leftovers(tmp_path)
        assert len(names(tmp_path)) == 3
        process.send_signal(signal.SIGKILL)
    assert len(names(tmp_path)) == 3
    files.remove_leftovers(tmp_path)
    assert names(tmp_path) == [".neurosym-pipe", ".neurosymmetry"]


HOLD = """
import sys, time
from pathlib import Path
from neurosym import files as locks
assert locks.take(Path(sys.argv[1]), alone=sys.argv[2] == "alone") is not None
print("taken", flush=True)
time.sleep(60)
"""


@pytest.fixture
def ask_once(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(files, "_TRIES", 1)


def holder(folder: Path, how: str) -> subprocess.Popen[str]:
    """Start a process that holds a folder until it is killed."""
    command = [sys.executable, "-c", HOLD, str(folder), how]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "taken\n"
    return process


@pytest.mark.usefixtures("ask_once")
@pytest.mark.parametrize(("held", "alone"), [("alone", True), ("alone", False), ("shared", True)])
def test_folder_that_another_process_holds_is_not_had(tmp_path: Path, held: str, alone: bool):
    with holder(tmp_path, held) as process:
        assert files.take(tmp_path, alone=alone) is None
        assert files.holders(tmp_path) == (process.pid,)
        process.send_signal(signal.SIGKILL)
    given = files.take(tmp_path, alone=alone)
    assert given is not None
    assert files.holders(tmp_path) == (os.getpid(),)
    os.close(given)
    assert list(tmp_path.iterdir()) == []
    assert files.holders(tmp_path) == ()


COUNT = """
import sys
from pathlib import Path
from neurosym.files import write_atomically
from neurosym.files import locked
path = Path(sys.argv[1])
for _ in range(50):
    with locked(path):
        write_atomically(path, str(int(path.read_text()) + 1))
"""


def test_file_that_several_processes_replace_loses_no_change(tmp_path: Path):
    path = tmp_path / "count"
    path.write_text("0")
    processes = [subprocess.Popen([sys.executable, "-c", COUNT, str(path)]) for _ in range(3)]
    assert [process.wait() for process in processes] == [0, 0, 0]
    assert path.read_text() == "150"
