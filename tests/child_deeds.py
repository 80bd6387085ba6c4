"""What processes do in tests: work that prints, first steps that are refused."""

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


def unreadable():
    """Return what cannot be pickled."""
    return lambda: None
