"""Processes that a test must not leave behind."""

from pathlib import Path


def alive(marker: str) -> list[str]:
    """Command lines of the processes that name a file of ours."""
    found = []
    for entry in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            line = entry.read_bytes().replace(b"\0", b" ").decode(errors="replace")
        except OSError:
            continue
        found += [line] if marker in line else []
    return found
