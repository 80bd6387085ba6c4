"""Named arrays with a description beside them, in the safetensors format: nothing is ever unpickled."""

import json
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load, save

from neurosym.errors import InvalidFile
from neurosym.files import write_atomically
from neurosym.reading import MOST_DATA, decode_json, read_bytes

GREATEST_NUMBER = 1e18
"""Greatest number in a file: the variance of the greatest data. With more, predictions are not finite."""
_METADATA = "neurosym"
_LENGTH = 8  # bytes that a file begins with, and which say how long its header is


class _Header(msgspec.Struct, frozen=True):
    metadata: dict[str, str] = msgspec.field(default={}, name="__metadata__")


def write_tensors(
    path: Path, file_format: str, tensors: dict[str, np.ndarray], description: dict[str, Any]
) -> None:
    """Write arrays and their description whole or not at all; equal contents give equal bytes.

    Args:
        path: Where the file shall stand.
        file_format: What the file calls itself.
        tensors: The arrays by name.
        description: Plain JSON values.
    """
    text = json.dumps({"format": file_format, **description}, sort_keys=True)
    ordered = {name: np.ascontiguousarray(tensors[name]) for name in sorted(tensors)}
    write_atomically(path, save(ordered, {_METADATA: text}))  # one key, whose order cannot vary


def read_tensors(path: Path, file_format: str) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Read the arrays and the description of a file.

    Args:
        path: The file.
        file_format: What it must call itself.

    Raises:
        InvalidFile: If it is not a file of that format, or holds a number that is not finite, or too great.
    """
    content = read_bytes(path, MOST_DATA)
    try:
        tensors = load(content)  # checks the header against the file
        header = int.from_bytes(content[:_LENGTH], "little")
    except (SafetensorError, LookupError, MemoryError, TypeError, ValueError) as error:
        raise InvalidFile(path, "it is not a safetensors file, or it is damaged") from error
    metadata = decode_json(path, content[_LENGTH : _LENGTH + header], _Header).metadata
    description: dict[str, Any] = decode_json(path, metadata.get(_METADATA, "{}").encode(), dict)
    if description.get("format") != file_format:
        raise InvalidFile(path, f"it is not of the format {file_format}")
    for name, tensor in tensors.items():
        if not np.all(np.isfinite(tensor)):
            raise InvalidFile(path, f"{name!r} holds a value that is not finite")
        if np.any(np.abs(tensor) > GREATEST_NUMBER):
            raise InvalidFile(path, f"{name!r} holds a number beyond {GREATEST_NUMBER:g}")
    return tensors, description
