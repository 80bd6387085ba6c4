"""Paths, lengths and texts of strangers as a user reads them."""

import shlex
import unicodedata
from collections.abc import Sequence
from pathlib import Path

PIPE_WIDTH = 160
"""Columns to print in, where there is no terminal to ask."""


def quoted(path: Path | str) -> str:
    """Return a path as it is typed in a shell: in quotes if it has blanks or the like."""
    return shlex.quote(str(path))


def harmless(text: str) -> str:
    """Return a text such that a terminal does nothing but show it.

    Control characters, which may hide text or type commands, become escapes as in Python's strings. So does
    what changes the direction of writing, and what is no character at all. Line ends and tabs stay.
    """
    return text if text.isprintable() else "".join(map(_shown, text))


def _shown(sign: str) -> str:
    if sign in "\n\t" or unicodedata.category(sign) not in ("Cc", "Cf", "Cs", "Zl", "Zp"):
        return sign
    return f"\\x{ord(sign):02x}" if ord(sign) < 256 else f"\\u{ord(sign):04x}"


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


def listed_briefly(names: Sequence[str], most: int = 16) -> str:
    """Return names with commas between, of a long list the first ones and how many more there are.

    Args:
        names: What is listed.
        most: How many are named at most.
    """
    more = len(names) - most
    return ", ".join(names[:most]) + (f" and {more} more" if more > 0 else "")
