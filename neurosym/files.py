"""Files: read through one door, written whole or not at all, as drafts and under locks."""

import codecs
import fcntl
import hashlib
import os
import re
import secrets
import stat
import time
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from io import BufferedReader
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from neurosym.errors import CannotWrite, InvalidFile, InvalidValue, shortened

# The door through which files come in: regular files only, no larger and no deeper than what they can be.
#
# A domain folder may come from a stranger, and any file may be a link. Nothing is waited for (a named
# pipe), read without end (a device), or unpacked, nested or counted beyond what the package itself can
# write.

Document = TypeVar("Document")

KILOBYTE, MEGABYTE, GIGABYTE = 2**10, 2**20, 2**30
MOST_DATA = GIGABYTE
"""Bytes of the arrays of a data set, unpacked, or of a network: ten million rows and more."""
MOST_JSON = 256 * MEGABYTE
MOST_TEXT = 64 * MEGABYTE
MOST_SETTINGS = MEGABYTE  # bytes of a `world.toml`
DEEPEST = 50  # how deep lists and tables stand in one another at most; ours do in 8
_TOO_DEEP = f"its lists and tables are nested too deep; valid: at most {DEEPEST} in one another"
LARGEST_WHOLE = 2**63 - 1  # greatest whole number in a file or on the command line
_MOST_DOTS = 200  # in a key of TOML, which is read in time that grows with their square
_NOT_FINITE = re.compile(rb"\b(NaN|Infinity)\b")
_PATTERN = re.compile(r"Expected `str` matching regex '\\\\A[\[(](01|a-z|resting)[^']*'")
_MATCHING = {
    "01": "bits, like '10'",
    "resting": "a kind of end, like 'held'",
    "a-z": "a name: a lower-case letter, then a-z, 0-9 and hyphens",
}
_STRING = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*"', re.DOTALL)
_NO_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))


@contextmanager
def opened(path: Path, most: int) -> Iterator[BufferedReader]:
    """Open a file for reading, if it is a regular one of at most so many bytes.

    Raises:
        InvalidFile: If there is none, it is of another kind or too large, or cannot be read.
    """
    try:
        refuse_other_kinds(path, "")  # a device might do something when it is opened
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        with os.fdopen(descriptor, "rb") as file:
            if (size := os.fstat(descriptor).st_size) > most:
                raise _too_large(path, size, most)
            yield file
    except FileNotFoundError as error:
        raise InvalidFile(path, "there is no such file") from error
    except OSError as error:
        raise InvalidFile(path, f"it cannot be read ({error.strerror or error})") from error
    except MemoryError as error:
        raise InvalidFile(path, "there is not enough memory to read it") from error


def read_bytes(path: Path, most: int = MOST_TEXT) -> bytes:
    """Read a file of at most so many bytes; see `opened`."""
    with opened(path, most) as file:
        content = file.read(most + 1) or b""  # some files say that they hold nothing, and go on and on
    if len(content) > most:
        raise _too_large(path, len(content), most)
    return content


def read_text(path: Path, most: int = MOST_TEXT) -> str:
    """Read a file of UTF-8 text, without its byte order mark; `InvalidFile` if it is none; see `opened`."""
    try:
        return read_bytes(path, most).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InvalidFile(path, f"it is not UTF-8 text: byte {error.start} is none of it") from error


def read_json(path: Path, kind: type[Document], remedy: str = "") -> Document:
    """Read a JSON document and check it against its type; see `opened` and `decode_json`."""
    return decode_json(path, read_bytes(path, MOST_JSON), kind, remedy)


def decode_json(path: Path, content: bytes, kind: type[Document], remedy: str = "") -> Document:
    """Read a JSON document that was found in a file, and check it against its type.

    Args:
        path: The file.
        content: The document.
        kind: The type that it must fit.
        remedy: What the message ends with, if it does not fit.

    Raises:
        InvalidFile: If it does not fit; the message names the field.
    """
    import numpy as np  # which takes long

    from neurosym.checks import decoding

    content = content.removeprefix(codecs.BOM_UTF8)
    outside = _STRING.sub(b"", content)
    brackets = np.frombuffer(outside.translate(None, _NO_BRACKETS), dtype=np.uint8)
    if np.cumsum(np.where(np.isin(brackets, tuple(b"[{")), 1, -1)).max(initial=0) > DEEPEST:
        raise InvalidFile(path, _TOO_DEEP + remedy)
    try:
        with decoding():
            return msgspec.json.decode(content, type=kind)
    except (msgspec.MsgspecError, UnicodeDecodeError, OverflowError, RecursionError, InvalidValue) as error:
        is_other = isinstance(error, msgspec.ValidationError | InvalidValue)
        words = _PATTERN.sub(lambda found: f"Expected {_MATCHING[found[1]]}", str(error).rstrip("."))
        said = ("" if is_other else "it is not JSON: ") + shortened(words, 300)
        if not is_other and (found := _NOT_FINITE.search(outside)):
            said += f"; {found[0].decode()} is no number there"
        raise InvalidFile(path, said + remedy) from error


def read_toml(path: Path, remedy: str = "") -> dict[str, Any]:
    """Read a TOML document; `InvalidFile` if it is none, or nested without measure; see `read_json`."""
    text = read_text(path, MOST_SETTINGS)
    lines = (line for line in text.splitlines() if not line.lstrip().startswith("#"))
    if any(piece.count(".") > _MOST_DOTS for line in lines for piece in line.split(",")):
        raise InvalidFile(path, _TOO_DEEP + remedy)
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        deep = isinstance(error, RecursionError)
        said = _TOO_DEEP if deep else f"it is not TOML: {shortened(str(error).rstrip('.'), 300)}"
        raise InvalidFile(path, said + remedy) from error


def digest(path: Path) -> str:
    """Return the SHA-256 of a file, in hexadecimal; see `opened`."""
    with opened(path, 4 * MOST_DATA) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def refuse_other_kinds(path: Path, remedy: str = "; move it away") -> None:
    """Raise `InvalidFile` if something stands in the place of a file that is none."""
    if path.exists() and not stat.S_ISREG(path.stat().st_mode):
        kind = "a folder" if path.is_dir() else "a pipe, a socket or a device"
        raise InvalidFile(path, f"it is {kind}, and should be a file{remedy}")


def _too_large(path: Path, size: int, most: int) -> InvalidFile:
    return InvalidFile(path, f"it has {size / MEGABYTE:.0f} MB; valid: at most {most / MEGABYTE:g} MB")


# Drafts: files that are written beside their places, under names that begin with `.neurosym-`.
#
# A rename puts a draft in its place, so that a kill leaves the old file or the new. The name holds the
# number of the process that writes it; what a killed process leaves, `remove_leftovers` removes.

_BESIDE = ".neurosym-"
_OWNER = re.compile(re.escape(_BESIDE) + r"(\d+)-")


@contextmanager
def draft(place: Path, data: bytes) -> Iterator[Path]:
    """Write a draft beside its place, and drop it if what is done with it fails, or a signal is raised."""
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
    """Files that are written beside their places within a `with`, and put there together.

    Every write of this thread is a draft, and every removal is noted. What was not put in place by the end
    is dropped: the files are as they were.
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
        """Rename every draft to its place, and remove what shall be gone; `CannotWrite` once that fails."""
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
    if (owner := _OWNER.match(name)) is None:
        return False
    try:
        os.kill(int(owner[1]), 0)
    except (OSError, OverflowError) as error:
        return isinstance(error, PermissionError)  # then it is somebody else's
    return True


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Have errors of the system name the file that could not be written, as `CannotWrite`."""
    try:
        yield
    except CannotWrite:
        raise
    except OSError as error:
        raise CannotWrite(path, error) from error


# Writing files whole or not at all; a write that fails names the file.

_BLOCK = bytes(4096)  # as much as any file system sets aside for a small file


def write_atomically(path: Path, content: bytes | str) -> None:
    """Write bytes, or text as UTF-8, by a draft and a rename: a kill leaves the old file or the new."""
    # A name that is not UTF-8 can only be told by escapes.
    data = content.encode(errors="backslashreplace") if isinstance(content, str) else content
    with naming(path), draft(path, data) as written:
        if drafts := _drafts.get():
            drafts.add(path, written)
        else:
            written.replace(path)


def write_new(path: Path, content: bytes | str) -> bool:
    """Write a file unless one is there, and say whether it was written; of several writers one does it."""
    if path.exists():
        return False
    data = content.encode() if isinstance(content, str) else content
    with naming(path), draft(path, data) as written:
        try:
            os.link(written, path)
        except FileExistsError:
            return False
        except OSError:  # a file system without links
            written.replace(path)
        finally:
            written.unlink(missing_ok=True)
    return True


def remove(path: Path) -> None:
    """Remove a file, if it is there; among `Drafts`, when they are put in place."""
    if drafts := _drafts.get():
        drafts.add(path, None)
    else:
        with naming(path):
            path.unlink(missing_ok=True)


def make_folder(path: Path) -> None:
    """Make a folder and those above it, unless it is there.

    Raises:
        InvalidFile: If it is a file.
        CannotWrite: If the system does not let it be made.
    """
    with naming(path):
        try:
            path.mkdir(parents=True, exist_ok=True)
        except FileExistsError as error:
            raise InvalidFile(path, "it is a file, and should be a folder; move it away") from error


def check_writable(path: Path) -> None:
    """Raise unless a file can be written, before the work is done whose result it is to hold.

    Raises:
        InvalidFile: If it is a folder or a device, or one of the folders above it is a file.
        CannotWrite: If the folder, or the disk, takes no file.
    """
    with naming(path):
        refuse_other_kinds(path)
        folder = next(place for place in path.absolute().parents if place.exists())
        if not folder.is_dir():
            raise InvalidFile(folder, "it is a file, and should be a folder; move it away")
        remove_leftovers(folder)
        with draft(folder / path.name, _BLOCK) as written:
            written.unlink()


def write_json(path: Path, document: object) -> None:
    """Write a document as indented JSON with a stable order of keys."""
    write_atomically(path, msgspec.json.format(msgspec.json.encode(document), indent=1) + b"\n")


def digests(places: Mapping[str, Path]) -> dict[str, str]:
    """Return the SHA-256 of each file, by name, that is there, or will be when `Drafts` are in place."""
    drafts = _drafts.get()
    found = {name: drafts.now_at(path) if drafts else path for name, path in places.items()}
    return {name: digest(path) for name, path in found.items() if path and path.is_file()}


# Locks on files and folders, which the system takes back from a process that ends, however it ends.
#
# No lock file is needed, and none can be left behind: the lock is on the file or folder itself (`flock`).
# Where the file system knows no locks, nothing is locked.

_TRIES, _PAUSE = 40, 0.05  # how often somebody who is busy for a moment is asked, and how long apart [s]


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold a file or folder, which exists and may be replaced by a rename meanwhile, for oneself alone."""
    while True:
        descriptor = os.open(path, os.O_RDONLY)
        try:
            _lock(descriptor, fcntl.LOCK_EX)
            if os.path.samestat(os.fstat(descriptor), path.stat()):
                yield
                return
        finally:
            os.close(descriptor)


def take(folder: Path, *, alone: bool) -> int | None:
    """Take a folder, for oneself or together with others who do not want it alone.

    Whoever has it for a moment only, about two seconds, is waited for.

    Returns:
        What `os.close` gives back; None if another process has the folder.
    """
    how = (fcntl.LOCK_EX if alone else fcntl.LOCK_SH) | fcntl.LOCK_NB
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        for left in reversed(range(_TRIES)):
            with suppress(BlockingIOError):
                _lock(descriptor, how)
                return descriptor
            time.sleep(_PAUSE if left else 0.0)
    except BaseException:
        os.close(descriptor)
        raise
    os.close(descriptor)
    return None


def retake(held: int, *, alone: bool, wait: bool = True) -> bool:
    """Have what `take` gave alone, or together with others; return whether it is so.

    Args:
        held: What it gave.
        alone: Whether to have it alone.
        wait: Whether to wait for others, however long.
    """
    try:
        _lock(held, (fcntl.LOCK_EX if alone else fcntl.LOCK_SH) | (0 if wait else fcntl.LOCK_NB))
    except BlockingIOError:
        return False
    return True


def holders(path: Path) -> tuple[int, ...]:
    """List the processes that have a file or folder locked, as far as the system tells."""
    try:
        lines, node = Path("/proc/locks").read_text().splitlines(), path.stat().st_ino
    except OSError:
        return ()
    fields = [line.split() for line in lines]
    found = {int(f[4]) for f in fields if f[1] == "FLOCK" and f[5].endswith(f":{node}")}
    return tuple(sorted(number for number in found if number > 0))


def _lock(descriptor: int, how: int) -> None:
    try:
        fcntl.flock(descriptor, how)
    except OSError as error:
        if isinstance(error, BlockingIOError):
            raise  # all others are of a file system without locks
