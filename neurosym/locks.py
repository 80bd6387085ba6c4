"""Locks on files and folders, which the system takes back from a process that ends, however it ends.

No lock file is needed, and none can be left behind: the lock is on the file or folder itself (`flock`). Where
the file system knows no locks, nothing is locked.
"""

import fcntl
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

_TRIES, _PAUSE = 40, 0.05  # how often somebody who is busy for a moment is asked, and how long apart [s]


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold a file or folder, which exists, for oneself alone; wait while another process holds it.

    Args:
        path: The file or folder; it may be replaced by a rename meanwhile.
    """
    while True:
        descriptor = os.open(path, os.O_RDONLY)
        try:
            _lock(descriptor, fcntl.LOCK_EX)
            if os.path.samestat(os.fstat(descriptor), path.stat()):
                yield
                return
        finally:
            os.close(descriptor)


def take(folder: Path, *, alone: bool) -> int | None:
    """Take a folder, for oneself or together with others who do not want it alone.

    Whoever has it for a moment only, about two seconds, is waited for.

    Args:
        folder: The folder.
        alone: Whether to take it for oneself.

    Returns:
        What `os.close` gives back; None if another process has the folder.
    """
    how = (fcntl.LOCK_EX if alone else fcntl.LOCK_SH) | fcntl.LOCK_NB
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        for left in reversed(range(_TRIES)):
            with suppress(BlockingIOError):
                _lock(descriptor, how)
                return descriptor
            time.sleep(_PAUSE if left else 0.0)
    except BaseException:
        os.close(descriptor)
        raise
    os.close(descriptor)
    return None


def holders(path: Path) -> tuple[int, ...]:
    """List the processes that have a file or folder locked, as far as the system tells."""
    try:
        lines, node = Path("/proc/locks").read_text().splitlines(), path.stat().st_ino
    except OSError:
        return ()
    fields = [line.split() for line in lines]
    found = {int(f[4]) for f in fields if f[1] == "FLOCK" and f[5].endswith(f":{node}")}
    return tuple(sorted(number for number in found if number > 0))


def _lock(descriptor: int, how: int) -> None:
    try:
        fcntl.flock(descriptor, how)
    except BlockingIOError:
        raise
    except OSError:
        pass  # a file system without locks
