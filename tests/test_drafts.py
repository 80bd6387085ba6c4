"""Drafts are put in place together or not at all, and what a kill leaves of them is removed."""

import inspect
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from contextvars import copy_context
from pathlib import Path
from types import FrameType

import pytest

from neurosym import files
from neurosym import files as drafts
from neurosym.files import (
    Drafts,
    at_once,
    check_writable,
    digests,
    remove,
    remove_leftovers,
    write_atomically,
    write_new,
)


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
        promised = digests({path.name: path for path in places})
        with at_once():  # as a checkpoint is
            write_atomically(tmp_path / "checkpoint", "5")
        assert (tmp_path / "checkpoint").read_text() == "5"
        drafts.put_in_place()
    written = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert written == {"old": "3", "new": "4", "checkpoint": "5"}
    assert promised == digests({path.name: path for path in places})
    assert promised.keys() == {"old", "new"}


def test_drafts_that_are_not_put_in_place_are_dropped(tmp_path: Path):
    (tmp_path / "old").write_text("1")

    def fail() -> None:
        with Drafts():
            write_atomically(tmp_path / "old", "3")
            remove(tmp_path / "old")
            write_atomically(tmp_path / "old", "5")
            write_atomically(tmp_path / "new", "4")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        fail()
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
        if frame.f_code.co_filename not in (drafts.__file__, files.__file__):
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


def test_more_drafts_can_be_made_than_files_may_be_open(tmp_path: Path):
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (250, hard))
    try:
        with Drafts() as drafts:
            for number in range(400):
                write_atomically(tmp_path / f"{number}", "1")
            drafts.put_in_place()
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    assert len(names(tmp_path)) == 400


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
        remove_leftovers(tmp_path)
        assert len(names(tmp_path)) == 3
        process.send_signal(signal.SIGKILL)
    assert len(names(tmp_path)) == 3
    remove_leftovers(tmp_path)
    assert names(tmp_path) == [".neurosym-pipe", ".neurosymmetry"]
