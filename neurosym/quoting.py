"""Paths in commands that a user can copy into a shell."""

import shlex
from pathlib import Path


def quoted(path: Path | str) -> str:
    """Return a path as it is typed in a shell: in quotes if it has blanks or the like."""
    return shlex.quote(str(path))
