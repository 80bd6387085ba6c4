"""Making do with the surroundings that a command is started in: closed streams, narrow encodings."""

import io
import os
import sys
from contextlib import suppress


def make_usable() -> None:
    """Make standard streams such that anything can be printed.

    Where one is closed (`>&-`), what is printed goes nowhere; without this the next file that is opened would
    be taken for it.
    """
    for descriptor in (0, 1, 2):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # the lowest number that is free
    for name in ("stdin", "stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, io.TextIOWrapper(io.FileIO(os.devnull, "r+"), encoding="utf-8"))
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # names that the encoding does not have


def leave_no_folders() -> None:
    """Let nothing be left in temporary folders: torch would make one there as soon as it is imported."""
    import tempfile

    with suppress(OSError):
        os.environ.setdefault("TORCHINDUCTOR_CACHE_DIR", tempfile.gettempdir())
