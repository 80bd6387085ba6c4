"""PyBullet, imported without the build time that its C code prints to standard error on every import.

The rest of this folder takes it from here, so that sizes and shapes can be asked for without it.
"""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from threading import Lock
from typing import Any

_saved, _nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
try:
    os.dup2(_nowhere, 2)
    import pybullet
finally:
    os.dup2(_saved, 2)
    os.close(_saved)
    os.close(_nowhere)

__all__ = ["Client", "overheard", "pybullet"]
_HEARING = Lock()


class Client:
    """A physics client; its methods are PyBullet's functions of that name, for this client.

    Args:
        mode: How it connects: without a screen, or in a window.
    """

    def __init__(self, mode: int = pybullet.DIRECT):
        self.number = int(pybullet.connect(mode))

    def __getattr__(self, name: str) -> Any:
        """Return a function of PyBullet's, and keep it at hand."""
        method = self.__dict__[name] = partial(getattr(pybullet, name), physicsClientId=self.number)
        return method


@contextmanager
def overheard(words: list[str]) -> Iterator[None]:
    """Keep what PyBullet prints to standard output meanwhile, instead of showing it.

    Args:
        words: What it says is appended to these.
    """
    with _HEARING, tempfile.TemporaryFile() as file:
        shown = os.dup(1)
        os.dup2(file.fileno(), 1)
        try:
            yield
        finally:
            os.dup2(shown, 1)
            os.close(shown)
            file.seek(0)
            words.append(file.read().decode(errors="replace"))
