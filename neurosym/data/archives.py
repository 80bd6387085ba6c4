"""Arrays in .npz files: measured before they are unpacked, and never unpickled."""

import json
import zipfile
from collections.abc import Collection
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load, save

from neurosym.errors import InvalidFile, shortened
from neurosym.files import MEGABYTE, MOST_DATA, decode_json, opened, read_bytes, write_atomically

_MOST_ARRAYS = 1000  # files with more are no data sets


def read_arrays(
    path: Path, wanted: Collection[str]
) -> tuple[dict[str, np.ndarray], tuple[str, ...], list[str]]:
    """Read arrays of an .npz file.

    Returned are those that can be read of the wanted, the names of all, and why some cannot be read.
    """
    arrays, problems = {}, []
    with opened(path, MOST_DATA) as file:
        try:
            archive = np.load(file, allow_pickle=False)
            parts: list[zipfile.ZipInfo] = archive.zip.infolist()
        except Exception as error:  # numpy and zipfile raise all kinds for what is damaged
            raise InvalidFile(path, "it is not an .npz file of plain arrays") from error
        sizes = [(part.filename.removesuffix(".npy"), part.file_size) for part in parts]
        given = tuple(name for name, _ in sizes)
        if len(parts) > _MOST_ARRAYS:
            raise InvalidFile(path, f"it holds {len(parts)} arrays; valid: at most {_MOST_ARRAYS}")
        if (size := sum(size for name, size in sizes if name in wanted)) > MOST_DATA:
            most = MOST_DATA // MEGABYTE
            raise InvalidFile(path, f"unpacked, it takes {size // MEGABYTE} MB; valid: at most {most} MB")
        for name in filter(given.__contains__, wanted):
            try:
                array = archive[name]
                if not array.dtype.itemsize:
                    raise ValueError("it holds nothing, as often as it likes")
                arrays[name] = array
            except Exception:  # encrypted, pickled, or anything else
                problems.append(
                    f"{name!r} is damaged, or holds Python objects, which are never unpickled; "
                    "valid: a plain array"
                )
    doubles = sorted({name for name in given if given.count(name) > 1})
    problems += [
        f"it holds {given.count(name)} arrays {shortened(name)!r}; valid: one of each" for name in doubles
    ]
    return arrays, given, problems


# Named arrays with a description beside them, in the safetensors format: nothing is ever unpickled

_GREATEST = 1e18  # the variance of the greatest data; with more, predictions are not finite
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
        if np.any(np.abs(tensor) > _GREATEST):
            raise InvalidFile(path, f"{name!r} holds a number beyond {_GREATEST:g}")
    return tensors, description
