"""A lock is held by one process, waits for its turn, and ends with whoever holds it."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from neurosym import files

HOLD = """
import sys, time
from pathlib import Path
from neurosym import files as locks
assert locks.take(Path(sys.argv[1]), alone=sys.argv[2] == "alone") is not None
print("taken", flush=True)
time.sleep(60)
"""


@pytest.fixture(autouse=True)
def ask_once(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(files, "_TRIES", 1)


def holder(folder: Path, how: str) -> subprocess.Popen[str]:
    """Start a process that holds a folder until it is killed."""
    process = subprocess.Popen(
        [sys.executable, "-c", HOLD, str(folder), how], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "taken\n"
    return process


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


def test_folder_is_had_when_its_holder_is_soon_done(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    first = files.take(tmp_path, alone=True)
    assert first is not None
    monkeypatch.setattr(files, "_TRIES", 2)
    monkeypatch.setattr(files.time, "sleep", lambda _: os.close(first))
    second = files.take(tmp_path, alone=True)
    assert second is not None
    os.close(second)


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
