"""Paths and lengths as a user reads them."""

import shlex
from pathlib import Path


def quoted(path: Path | str) -> str:
    """Return a path as it is typed in a shell: in quotes if it has blanks or the like."""
    return shlex.quote(str(path))


def in_millimetres(distance: float, allowed: float) -> str:
    """Return a distance in whole mm, with decimals where it would look allowed and is not.

    Args:
        distance: The distance [m].
        allowed: The greatest that is allowed [m].
    """
    text = ""
    for digits in range(10):
        text = f"{1000 * distance:.{digits}f}"
        if distance <= allowed or float(text) > 1000 * allowed:
            break
    return f"{text} mm"


def counted(count: int, noun: str) -> str:
    """Return a number with its noun, which takes an s if there is not exactly one."""
    return f"{count} {noun}{'' if count == 1 else 's'}"
