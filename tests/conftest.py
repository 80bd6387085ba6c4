"""What several tests share: a toy domain folder, learned once."""

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from command_line import contents
from filelock import FileLock

LEARN_TOY = ["--strategy", "random", "--regime", "quick", "--workers", "1"]
RUN_TOY = [
    *LEARN_TOY,
    *["--world", "toy", "--steps", "1024", "--seed", "3", "--rehearsals", "40", "--problems", "2"],
    *["--places", "512"],
]
"""How the toy domain folder is learned."""
SHORTLY = "from neurosym.commands.cli import main; from toy_learning import REGIMES, SHORTENED; "
SHORTLY += "REGIMES['quick'] = SHORTENED; main()"


for number in (signal.SIGINT, signal.SIGHUP):
    if signal.getsignal(number) is signal.SIG_IGN:  # in the background, or under nohup
        signal.signal(number, lambda *_: None)  # ignored by us, and not by what tests start


LONGEST = ("test_whole_way.py", "test_fuzz.py", "test_relating.py", "test_own_robot.py", "test_faults.py")
"""What takes longest begins first, so that no process is left with it, or waits for the toy folder."""


def pytest_collection_modifyitems(items):
    order = {name: number for number, name in enumerate(LONGEST)}
    items.sort(key=lambda item: order.get(item.path.name, len(LONGEST)))  # stable


def learn_shortly(folder: Path, *options: object) -> None:
    """Learn a domain folder by a short training, in a process of its own, where no shapes are checked."""
    words = [sys.executable, "-W", "error::RuntimeWarning", "-c", SHORTLY, "run", folder, *options]
    paths = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, env=paths)
    assert ended.returncode == 0, ended.stderr


@pytest.fixture(scope="session")
def toy_folder(tmp_path_factory) -> Path:
    """A domain folder learned from nothing on the toy world, with two problems; tests must not change it."""
    shared = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        shared = shared.parent  # whichever process comes first learns it for all
    folder = shared / "toy"
    with FileLock(shared / "toy.lock"):
        if not folder.is_dir():
            learn_shortly(shared / "toy-unfinished", *RUN_TOY)
            (shared / "toy-unfinished").rename(folder)
    return folder


@pytest.fixture(scope="module")
def kept(toy_folder, tmp_path_factory) -> Iterator[Path]:
    """A copy of it for commands that are refused or only look: at the end it must be as it was."""
    copy = Path(shutil.copytree(toy_folder, tmp_path_factory.mktemp("kept") / "toy"))
    before = contents(copy)
    yield copy
    assert contents(copy) == before


@pytest.fixture
def folder(toy_folder, tmp_path) -> Path:
    """A copy of the toy domain folder that a test may change."""
    return Path(shutil.copytree(toy_folder, tmp_path / "toy"))
