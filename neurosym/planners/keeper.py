"""What a process that plans would leave behind if it were killed, and the process that clears that away.

A process that plans puts its mark into the environment of what it starts, and into the names of its
temporary folders. Its keeper is a process that outlives it: it waits for the end of its owner, and clears
away what that has left. It ignores the signals that its owner may get.

This module is also the program of the keeper, `python -I -S keeper.py FOLDER OWNER`. It imports nothing but
the standard library, and starts in 15 ms.
"""

import os
import signal
import sys
import time
from contextlib import suppress
from pathlib import Path

MARK = "NEUROSYM_PLANNER_CALL"
"""The variable that names whoever started a planner, and which call it is."""
FOLDER_PREFIX = "neurosym-planner-"
"""What the names of temporary folders begin with; the mark of their owner follows."""
_PATIENCE = 5.0  # for what was killed to end; what the system does for it may take a while [s]
_PAUSE = 0.005  # until it is looked again [s]
_SETTLE = 0.2  # for what an owner was just starting when it was killed [s]


def end_marked(mark: str) -> None:
    """Kill what has a mark in its environment, and wait until it has ended, which may not be at once.

    It is looked twice in vain: what is just becoming another program has no environment to be known by.
    """
    looks, end = 2, time.monotonic() + _PATIENCE
    while looks and time.monotonic() < end:
        found = marked(mark)
        for process in found:
            with suppress(ProcessLookupError, PermissionError):
                os.kill(process, signal.SIGKILL)
        looks = 2 if found else looks - 1
        time.sleep(_PAUSE if looks else 0.0)


def marked(mark: str) -> list[int]:
    """Find processes that have a mark in their environment; none where the system does not tell."""
    found = list[int]()
    for entry in Path("/proc").glob("[0-9]*/environ"):
        with suppress(OSError):  # it has ended or is not ours
            found += [int(entry.parent.name)] if f"{MARK}={mark}".encode() in entry.read_bytes() else []
    return found


def _keep(place: Path, owner: str) -> None:
    """Wait for the owner to say that it is done or to end, and then clear away what it left in a folder."""
    import shutil

    for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(one, signal.SIG_IGN)
    is_done = os.read(0, 1)
    for wait in () if is_done else (0.0, _SETTLE):
        time.sleep(wait)
        end_marked(f"{owner}.")
        for folder in place.glob(f"{FOLDER_PREFIX}{owner}-*"):
            shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    _keep(Path(sys.argv[1]), sys.argv[2])
