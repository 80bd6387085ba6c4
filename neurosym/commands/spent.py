"""What a command has taken so far: the CPU of its process since it was started, and of all it started."""

import os

_before = [0.0]  # what was spent before the command began [s]


def begin(is_own_process: bool) -> None:
    """Begin to count.

    Args:
        is_own_process: Whether the process is there for this command, so that all it has done counts.
    """
    _before[0] = 0.0 if is_own_process else _now()


def spent() -> float:
    """Return the CPU seconds that the command has taken so far [s]."""
    return _now() - _before[0]


def _now() -> float:
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system
