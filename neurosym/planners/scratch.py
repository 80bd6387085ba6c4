"""The one place where temporary folders are made: none outlives the process that made it, however it ends."""

import atexit
import os
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from neurosym.planners import keeper
from neurosym.planners.keeper import FOLDER_PREFIX, MARK, end_processes, hold, marked, sweep, this_process

_PATIENCE = 2.0  # for the keeper to end [s]

_keepers: dict[int, "subprocess.Popen[bytes]"] = {}
"""The keeper by the process that it was started for; a forked process has none yet."""
_open: set[object] = set()
"""What is being done, or was broken off by an error."""
_starting = threading.Lock()


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """Make an empty folder, and remove it with all that is in it; also when this process is killed."""
    with kept():
        while True:
            prefix = f"{FOLDER_PREFIX}{os.getpid()}-"
            with tempfile.TemporaryDirectory(prefix=prefix, ignore_cleanup_errors=True) as name:
                try:
                    descriptor = hold(Path(name))
                except FileNotFoundError:  # a keeper found it before it was held
                    continue
                try:
                    yield Path(name)
                finally:
                    os.close(descriptor)
            return


@contextmanager
def kept() -> Iterator[None]:
    """Have the keeper look after what is made and started inside, in case that it is not left in order."""
    _start_keeper()
    task = object()
    _open.add(task)
    yield
    _open.discard(task)


def _start_keeper() -> None:
    """Start the process that clears away what this one leaves when it is killed; once for each process."""
    with _starting:
        owner = os.getpid()
        if owner in _keepers:
            return
        program = [sys.executable, "-I", "-S", keeper.__file__, tempfile.gettempdir(), str(owner)]
        with suppress(OSError):  # then a later one does its work
            _keepers[owner] = subprocess.Popen(
                program,
                cwd="/",
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                env={name: value for name, value in os.environ.items() if name != MARK},
                start_new_session=True,
            )


@atexit.register
def _dismiss() -> None:
    """Clear away what was broken off, tell the keeper that nothing is left, and wait for its end."""
    found = _keepers.pop(os.getpid(), None)
    if found:
        if _open:
            end_processes(lambda: marked(f"{MARK}={this_process()}."))
            sweep(Path(tempfile.gettempdir()))
        with suppress(OSError, subprocess.TimeoutExpired):
            found.communicate(b".", timeout=_PATIENCE)
