"""What a process that plans would leave behind if it were killed, and the process that clears that away.

A process that plans puts its own number and time of start into the environment of what it starts, and its
number into the names of its temporary folders. Its keeper is a process that outlives it: it waits for the end
of its owner, and clears away what that has left. It ignores the signals that its owner may get.

This module is also the program of the keeper, `python -I -S keeper.py FOLDER OWNER`. It imports nothing but
the standard library, and starts in 15 ms.
"""

import os
import select
import signal
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

MARK = "NEUROSYM_PLANNER_CALL"
"""The variable that names whoever started a planner, and which call it is."""
FOLDER_PREFIX = "neurosym-planner-"
"""What the names of temporary folders begin with; the number of their owner follows."""
_LOOK = 1.0  # how often to see whether the owner is still there, if its pipe does not say so [s]
_PATIENCE = 5.0  # for what was killed to end; what the system does for it may take a while [s]
_SETTLE = 0.2  # for what an owner was just starting when it was killed [s]


def this_process() -> str:
    """Name this process such that no other on this machine has the name before the next start of it."""
    return f"{os.getpid()}.{_born(os.getpid()) or 0}"


def clear(place: Path, owner: str) -> None:
    """Kill the planners of a process and remove its temporary folders.

    Args:
        place: Where temporary folders are made.
        owner: The process; see `this_process`.
    """
    import shutil

    end_processes(lambda: marked(f"{MARK}={owner}."))
    for folder in place.glob(f"{FOLDER_PREFIX}{owner.partition('.')[0]}-*"):
        shutil.rmtree(folder, ignore_errors=True)


def end_processes(find: Callable[[], set[int]]) -> None:
    """Kill processes, and wait until they have ended, which on a busy machine is not at once.

    They are stopped first, so that none can start another while they are being listed. Then it is looked
    again: a process that was just becoming another program has no environment to be known by.

    Args:
        find: Lists those that there are now.
    """
    ended: set[int] = set()
    while find() - ended:
        stopped: set[int] = set()
        while new := find() - stopped - ended:
            for process in new:
                _signal(process, signal.SIGSTOP)
            stopped |= new
        for process in stopped:
            _signal(process, signal.SIGKILL)
        end = time.monotonic() + _PATIENCE
        while any(_born(process) for process in stopped) and time.monotonic() < end:
            time.sleep(0.002)
        ended |= stopped


def processes() -> list[int]:
    """List the processes of this machine; none where the system does not tell."""
    try:
        return [int(entry.name) for entry in os.scandir("/proc") if entry.name.isdigit()]
    except OSError:
        return []


def marked(mark: str) -> set[int]:
    """Find processes that have something in their environment."""
    return {number for number in processes() if mark.encode() in _about(number, "environ")}


def state_of(process: int) -> list[bytes]:
    """Return the fields of what the system tells about a process, from its state on; none if it is gone."""
    # The command's name, in brackets, may hold anything.
    return _about(process, "stat").rpartition(b")")[2].split()


def _about(process: int, what: str) -> bytes:
    """Read what the system tells about a process; nothing if it has ended or is not ours."""
    with suppress(OSError):
        return Path(f"/proc/{process}/{what}").read_bytes()
    return b""


def _born(process: int) -> int | None:
    """Say when a process started, in ticks of the machine; None if it has ended."""
    fields = state_of(process)
    return int(fields[19]) if fields and fields[0] not in b"ZX" else None


def _signal(process: int, number: signal.Signals) -> None:
    with suppress(ProcessLookupError, PermissionError):
        os.kill(process, number)


def _keep(place: Path, owner: str) -> None:
    """Wait for the owner to say that it is done or to end, and then clear away."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    while os.getppid() == int(owner.partition(".")[0]):
        if select.select([0], [], [], _LOOK)[0]:
            if os.read(0, 1):
                return
            break
    for wait in (0.0, _SETTLE):
        time.sleep(wait)
        clear(place, owner)


if __name__ == "__main__":
    _keep(Path(sys.argv[1]), sys.argv[2])
