"""Drafts: files that are written beside their places, under names that begin with `.neurosym-`.

A rename puts a draft in its place, so that a kill leaves the old file or the new. The name holds the number
of the process that writes it; what a killed process leaves, `remove_leftovers` removes.
"""

import os
import re
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path

from neurosym.errors import CannotWrite

_BESIDE = ".neurosym-"
_OWNER = re.compile(re.escape(_BESIDE) + r"(\d+)-")


@contextmanager
def draft(place: Path, data: bytes) -> Iterator[Path]:
    """Write a draft, and drop it if what is done with it fails, whenever a signal is raised meanwhile.

    Args:
        place: Where the file shall stand; its folder exists.
        data: What it holds.
    """
    path = place.parent / f"{_BESIDE}{os.getpid()}-{secrets.token_hex(8)}"  # known before there is a file
    try:
        with path.open("xb") as file:
            file.write(data)
        path.chmod(0o644)
        yield path
    except BaseException:
        path.unlink(missing_ok=True)
        raise


class Drafts:
    """Files that are written beside their places, and put there together.

    Within `with Drafts() as drafts:` every write of this thread is a draft, and every removal is noted. What
    was not put in place by the end is dropped: the files are as they were.
    """

    def __init__(self) -> None:
        self._drafts: dict[Path, Path | None] = {}

    def __enter__(self) -> "Drafts":
        self._token = _drafts.set(self)
        return self

    def __exit__(self, *_: object) -> None:
        _drafts.reset(self._token)
        for written in filter(None, self._drafts.values()):
            written.unlink(missing_ok=True)

    def put_in_place(self) -> None:
        """Rename every draft to its place, and remove what shall be gone.

        Raises:
            CannotWrite: If a file cannot be put in its place; those before it are.
        """
        for path, written in tuple(self._drafts.items()):
            with naming(path):
                written.replace(path) if written else path.unlink(missing_ok=True)
            del self._drafts[path]

    def add(self, path: Path, written: Path | None) -> None:
        """Note a draft for a place, or that nothing shall stand there; an earlier one is dropped."""
        if earlier := self._drafts.pop(path, None):
            earlier.unlink(missing_ok=True)
        self._drafts[path] = written

    def holds(self, path: Path) -> bool:
        """Say whether something is to be written at a place, or removed there."""
        return path in self._drafts

    def now_at(self, path: Path) -> Path | None:
        """Return where the content lies that a place has, or will have; None if nothing will stand there."""
        return self._drafts.get(path, path)


_drafts: ContextVar[Drafts | None] = ContextVar("drafts", default=None)


def collecting() -> Drafts | None:
    """Return the drafts that writes are added to now, if any are."""
    return _drafts.get()


@contextmanager
def at_once() -> Iterator[None]:
    """Put files in place as they are written, even among `Drafts`: a checkpoint must outlive a kill."""
    token = _drafts.set(None)
    try:
        yield
    finally:
        _drafts.reset(token)


def remove_leftovers(folder: Path) -> None:
    """Remove what killed processes left of files that they wrote in a folder."""
    for path in folder.glob(f"{_BESIDE}*"):
        if path.is_file() and not path.is_symlink() and not _is_owned(path.name):
            with suppress(OSError):
                path.unlink()


def _is_owned(name: str) -> bool:
    """Say whether the process that writes a draft is alive."""
    owner = _OWNER.match(name)
    if owner is None:
        return False
    try:
        os.kill(int(owner[1]), 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:  # somebody else's
        pass
    return True


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Have errors of the system name the file that could not be written.

    Args:
        path: The file, or folder.

    Raises:
        CannotWrite: In place of any error of the system.
    """
    try:
        yield
    except CannotWrite:
        raise
    except OSError as error:
        raise CannotWrite(path, error) from error
