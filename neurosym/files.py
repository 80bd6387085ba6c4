"""Writing files whole or not at all."""

import os
import tempfile
from pathlib import Path

import msgspec


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
