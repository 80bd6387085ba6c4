"""Writing files whole or not at all, and reading JSON documents of a known shape."""

import hashlib
import os
import tempfile
from pathlib import Path
from typing import TypeVar

import msgspec

from neurosym.errors import InvalidFile

Document = TypeVar("Document")


def write_atomically(path: Path, content: bytes | str) -> None:
    """Write a file through a temporary one and a rename, so that a kill leaves the old file or the new.

    Args:
        path: Where the file shall stand; its folder exists.
        content: Bytes, or text that is written as UTF-8.
    """
    data = content.encode() if isinstance(content, str) else content
    descriptor, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(data)
        Path(temporary).chmod(0o644)
        Path(temporary).replace(path)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise


def write_json(path: Path, document: object) -> None:
    """Write a document as indented JSON with a stable order of keys."""
    write_atomically(path, msgspec.json.format(msgspec.json.encode(document), indent=1) + b"\n")


def read_json(path: Path, kind: type[Document], remedy: str = "") -> Document:
    """Read a JSON document and check it against its type.

    Args:
        path: The file.
        kind: The msgspec structure that it must fit.
        remedy: What the message ends with, if the file cannot be read or does not fit.

    Raises:
        InvalidFile: If the file cannot be read or does not fit; the message names the field.
    """
    try:
        return msgspec.json.decode(path.read_bytes(), type=kind)
    except (OSError, msgspec.MsgspecError, UnicodeDecodeError) as error:
        raise InvalidFile(path, str(error).rstrip(".") + remedy) from error


def digest(path: Path) -> str:
    """Return the SHA-256 of a file, in hexadecimal."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
