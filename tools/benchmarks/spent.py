"""What was spent so far, of what machines have."""

import os


def cpu_seconds() -> float:
    """Return the CPU time of this process and of those that it started and waited for [s]."""
    spent = os.times()
    return spent.user + spent.system + spent.children_user + spent.children_system
