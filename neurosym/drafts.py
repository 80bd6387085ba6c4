"""Drafts: files that are written beside their places, under names that begin with `.neurosym-`.

A rename puts a draft in its place, so that a kill leaves the old file or the new. What a killed process
leaves beside it, `remove_leftovers` removes.
"""

import fcntl
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path
from typing import BinaryIO

from neurosym.errors import CannotWrite

_BESIDE = ".neurosym-"
_MOST_OPEN = 100  # drafts; a process may not have many more files open


class Draft:
    """A file beside its place; while it is open it is locked, so that nobody takes it for a leftover.

    Its name is known before there is a file: whenever a signal is raised meanwhile, `drop` leaves nothing.

    Args:
        place: Where the file shall stand; its folder exists.
        data: What it holds.
    """

    def __init__(self, place: Path, data: bytes):
        self.place, self.path = place, place.parent / f"{_BESIDE}{secrets.token_hex(8)}"
        self._data = data
        self._file: BinaryIO | None = None

    def write(self) -> None:
        """Make the file; unless this comes to its end, it is to be dropped."""
        self._file = _make_locked(self.path)
        self._file.write(self._data)
        self._file.flush()
        self.path.chmod(0o644)

    def put_in_place(self) -> None:
        """Rename it to its place."""
        self.path.replace(self.place)
        self.unlock()

    def drop(self) -> None:
        """Remove it."""
        self.path.unlink(missing_ok=True)
        self.unlock()

    def unlock(self) -> None:
        """Close it, which lets go of the lock."""
        if self._file:
            with suppress(OSError):  # on a full disk it closes, and says that it could not write
                self._file.close()


class Drafts:
    """Files that are written beside their places, and put there together.

    Within `with Drafts() as drafts:` every write of this thread is a draft, and every removal is noted. What
    was not put in place by the end is dropped: the files are as they were.
    """

    def __init__(self) -> None:
        self._drafts: dict[Path, Draft | None] = {}

    def __enter__(self) -> "Drafts":
        self._token = _drafts.set(self)
        return self

    def __exit__(self, *_: object) -> None:
        _drafts.reset(self._token)
        for draft in filter(None, self._drafts.values()):
            draft.drop()

    def put_in_place(self) -> None:
        """Rename every draft to its place, and remove what shall be gone.

        Raises:
            CannotWrite: If a file cannot be put in its place; those before it are.
        """
        for path, draft in tuple(self._drafts.items()):
            with naming(path):
                draft.put_in_place() if draft else path.unlink(missing_ok=True)
            del self._drafts[path]

    def add(self, path: Path, draft: Draft | None) -> None:
        """Note a draft for a place, or that nothing shall stand there; an earlier one is dropped."""
        if earlier := self._drafts.pop(path, None):
            earlier.drop()
        if draft and len(self._drafts) >= _MOST_OPEN:
            draft.unlock()
        self._drafts[path] = draft

    def holds(self, path: Path) -> bool:
        """Say whether something is to be written at a place, or removed there."""
        return path in self._drafts

    def now_at(self, path: Path) -> Path | None:
        """Return where the content lies that a place has, or will have; None if nothing will stand there."""
        if path not in self._drafts:
            return path
        draft = self._drafts[path]
        return draft.path if draft else None


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
    """Remove what killed processes left of files that they wrote in a folder; live ones hold a lock."""
    for path in folder.glob(f"{_BESIDE}*"):
        if path.is_symlink() or not path.is_file():
            continue
        with suppress(OSError), path.open("rb") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            path.unlink()


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


def _make_locked(path: Path) -> BinaryIO:
    """Make an empty file, and lock it."""
    while True:
        file = path.open("xb")
        with suppress(OSError):  # not every file system has locks
            fcntl.flock(file, fcntl.LOCK_EX)
        if os.fstat(file.fileno()).st_nlink:  # else somebody took it for a leftover before it was locked
            return file
        file.close()
