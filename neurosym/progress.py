"""How long work reports how far it has come."""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import Protocol

Progress = Callable[[int, int], None]
"""Called with how many parts are done, and how many there are."""


class Advance(Protocol):
    """Reports how far some long work has come."""

    def __call__(self, done: int, total: int, label: str | None = None) -> None:
        """Say that `done` of `total` parts are finished; a new label begins a new bar."""
        ...


Doing = Callable[[str], None]
"""Tells what a command is doing now, in a few words."""
OpenBar = Callable[[str], AbstractContextManager[Progress]]
"""Called with what is being done; gives what reports how far that has come."""


def part(progress: Progress | None, before: int, total: int | None = None) -> Progress | None:
    """Return what reports how far a part of long work has come, such that the whole is reported.

    Args:
        progress: Reports how far the whole has come, if anybody wants to know.
        before: How much was done before this part.
        total: How much there is in all; what was done before and this part, if that is not known yet.
    """
    if progress is None:
        return None
    return lambda done, of: progress(before + done, before + of if total is None else total)


def silent(_: str) -> AbstractContextManager[Progress]:
    """Report nothing."""
    return nullcontext(lambda done, total: None)  # noqa: ARG005 (a `Progress`)
