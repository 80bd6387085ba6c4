"""The door through which files come in: regular files only, no larger and no deeper than what they can be.

A domain folder may come from a stranger, and any file may be a link. Nothing is waited for (a named
pipe), read without end (a device), or unpacked, nested or counted beyond what the package itself can write.
"""

import codecs
import hashlib
import os
import re
import stat
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from io import BufferedReader
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from neurosym.errors import InvalidFile, InvalidValue, shortened

Document = TypeVar("Document")

KILOBYTE, MEGABYTE, GIGABYTE = 2**10, 2**20, 2**30
MOST_DATA = GIGABYTE
"""Bytes of the arrays of a data set, unpacked, or of a network: ten million rows and more."""
MOST_JSON = 256 * MEGABYTE
MOST_TEXT = 64 * MEGABYTE
MOST_SETTINGS = MEGABYTE
"""Bytes of a `world.toml`."""
DEEPEST = 50
"""How deep lists and tables stand in one another at most; ours do in 8."""
LARGEST_WHOLE = 2**63 - 1
"""Greatest whole number in a file or on the command line."""
_MOST_DOTS = 200  # in a key of TOML, which is read in time that grows with their square
_NOT_FINITE = re.compile(rb"\b(NaN|Infinity)\b")
_PATTERN = re.compile(r"Expected `str` matching regex '\\\\A\[(01|a-z)\]\S*'")
_MATCHING = {"01": "bits, like '10'", "a-z": "a name: a lower-case letter, then a-z, 0-9 and hyphens"}
_STRING = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*"', re.DOTALL)
_NO_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))


@contextmanager
def opened(path: Path, most: int) -> Iterator[BufferedReader]:
    """Open a file for reading, if it is a regular one and not too large.

    Args:
        path: The file.
        most: How large it can be [bytes].

    Raises:
        InvalidFile: If there is none, it is of another kind or too large, or cannot be read.
    """
    try:
        _check_kind(path, path.stat())  # a device might do something when it is opened
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        with os.fdopen(descriptor, "rb") as file:
            found = os.fstat(descriptor)
            _check_kind(path, found)
            if found.st_size > most:
                raise _too_large(path, found.st_size, most)
            yield file
    except FileNotFoundError as error:
        raise InvalidFile(path, "there is no such file") from error
    except OSError as error:
        raise InvalidFile(path, f"it cannot be read ({error.strerror or error})") from error
    except MemoryError as error:
        raise InvalidFile(path, "there is not enough memory to read it") from error


def read_bytes(path: Path, most: int = MOST_TEXT) -> bytes:
    """Read a file.

    Args:
        path: The file.
        most: How large it can be [bytes].

    Raises:
        InvalidFile: See `opened`.
    """
    with opened(path, most) as file:
        content = file.read(most + 1) or b""  # some files say that they hold nothing, and go on and on
    if len(content) > most:
        raise _too_large(path, len(content), most)
    return content


def read_text(path: Path, most: int = MOST_TEXT) -> str:
    """Read a file of UTF-8 text; a byte order mark at its beginning is left out.

    Args:
        path: The file.
        most: How large it can be [bytes].

    Raises:
        InvalidFile: If it is no text; see `opened`.
    """
    try:
        return read_bytes(path, most).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InvalidFile(path, f"it is not UTF-8 text: byte {error.start} is none of it") from error


def read_json(path: Path, kind: type[Document], remedy: str = "") -> Document:
    """Read a JSON document and check it against its type.

    Args:
        path: The file.
        kind: The msgspec structure that it must fit.
        remedy: What the message ends with, if the file does not fit.

    Raises:
        InvalidFile: If the file cannot be read or does not fit; the message names the field.
    """
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
    from neurosym.checks import decoding  # with numpy, which takes long to import

    content = content.removeprefix(codecs.BOM_UTF8)
    outside = _STRING.sub(b"", content)
    if _depth(outside) > DEEPEST:
        raise InvalidFile(path, _too_deep() + remedy)
    decoding.now = True
    try:
        return msgspec.json.decode(content, type=kind)
    except (msgspec.MsgspecError, UnicodeDecodeError, OverflowError, RecursionError, InvalidValue) as error:
        is_other = isinstance(error, msgspec.ValidationError | InvalidValue)
        said = ("" if is_other else "it is not JSON: ") + shortened(_in_words(error), 300)
        if not is_other and (found := _NOT_FINITE.search(outside)):
            said += f"; {found[0].decode()} is no number there"
        raise InvalidFile(path, said + remedy) from error
    finally:
        decoding.now = False


def _depth(outside: bytes) -> int:
    """Return how deep lists and tables stand in one another in a document without its strings."""
    import numpy as np

    brackets = np.frombuffer(outside.translate(None, _NO_BRACKETS), dtype=np.uint8)
    opens = np.isin(brackets, tuple(b"[{"))
    return int(np.cumsum(np.where(opens, 1, -1)).max(initial=0))


def _in_words(error: Exception) -> str:
    """Return what an error says, with words for patterns of ours."""
    said = str(error).rstrip(".")
    return _PATTERN.sub(lambda found: f"Expected {_MATCHING[found[1]]}", said)


def read_toml(path: Path, remedy: str = "") -> dict[str, Any]:
    """Read a TOML document.

    Args:
        path: The file.
        remedy: What the message ends with, if it cannot be read.

    Raises:
        InvalidFile: If it is not TOML, or nested without measure; see `opened`.
    """
    text = read_text(path, MOST_SETTINGS)
    lines = (line for line in text.splitlines() if not line.lstrip().startswith("#"))
    if any(piece.count(".") > _MOST_DOTS for line in lines for piece in line.split(",")):
        raise InvalidFile(path, _too_deep() + remedy)
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        deep = isinstance(error, RecursionError)
        said = _too_deep() if deep else f"it is not TOML: {shortened(str(error).rstrip('.'), 300)}"
        raise InvalidFile(path, said + remedy) from error


def digest(path: Path) -> str:
    """Return the SHA-256 of a file, in hexadecimal.

    Raises:
        InvalidFile: See `opened`.
    """
    with opened(path, 4 * MOST_DATA) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def refuse_other_kinds(path: Path) -> None:
    """Raise `InvalidFile` if something stands in the place of a file that is none."""
    if path.exists():
        _check_kind(path, path.stat(), "; move it away")


def _check_kind(path: Path, found: os.stat_result, remedy: str = "") -> None:
    if not stat.S_ISREG(found.st_mode):
        kind = "a folder" if stat.S_ISDIR(found.st_mode) else "a pipe, a socket or a device"
        raise InvalidFile(path, f"it is {kind}, and should be a file{remedy}")


def _too_large(path: Path, size: int, most: int) -> InvalidFile:
    return InvalidFile(path, f"it has {size / MEGABYTE:.0f} MB; valid: at most {most / MEGABYTE:g} MB")


def _too_deep() -> str:
    return f"its lists and tables are nested too deep; valid: at most {DEEPEST} in one another"
