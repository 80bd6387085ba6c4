"""What processes do in tests: an import that fails, work that prints, first steps that are refused."""

import os
import sys
from pathlib import Path

from neurosym.errors import InvalidFile


def is_up():
    """Say something where errors are printed, and return which process this is."""
    print("seen", file=sys.stderr)
    return os.getpid()


def refused():
    """Do what a worker does first whose memory does not suffice."""
    raise InvalidFile(Path("effect_model.safetensors"), "there is not enough memory to read it")


def never_up(requests, lifeline, errors):
    """Fail as a process does for which a library cannot be loaded."""
    raise ImportError("libtorch_cpu.so: failed to map segment from shared object")


def killed(requests, lifeline, errors):
    """End as a process does that the system kills."""
    os.kill(os.getpid(), 9)


def unreadable():
    """Return what cannot be pickled."""
    return lambda: None
