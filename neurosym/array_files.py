"""Arrays in .npz files: measured before they are unpacked, and never unpickled."""

import math
import tokenize
import zipfile
import zlib
from collections.abc import Collection
from io import BufferedReader
from pathlib import Path

import numpy as np

from neurosym.errors import InvalidFile, shortened
from neurosym.reading import MEGABYTE, MOST_DATA, opened

MOST_ARRAYS = 1000
"""Files with more arrays are no data sets."""
_PACKINGS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # numpy has no others
_MOST_HEADER = 10_000  # bytes of what an array says of itself; numpy reads no more either
_FOREIGN = "it is not an .npz file of plain arrays"
_END, _FAR_END = b"PK\x05\x06", b"PK\x06\x07"  # of a zip file; the second only where there is more than 4 GB
_DAMAGED = (
    ArithmeticError,
    AttributeError,
    EOFError,
    LookupError,
    OSError,
    MemoryError,
    RuntimeError,
    SyntaxError,
    TypeError,
    ValueError,
    tokenize.TokenError,
    zipfile.BadZipFile,
    zlib.error,
)
"""What numpy and zipfile raise for files that are damaged, foreign, encrypted or pickled."""


def read_arrays(
    path: Path, wanted: Collection[str]
) -> tuple[dict[str, np.ndarray], tuple[str, ...], list[str]]:
    """Read arrays of an .npz file.

    Args:
        path: The file.
        wanted: The names of those to read; the others are not looked at.

    Returns:
        Those that can be read, the names of all that are there, and why some cannot be read.

    Raises:
        InvalidFile: If it is no .npz file, or holds too much; see `reading.opened`.
    """
    arrays, problems = {}, []
    with opened(path, MOST_DATA) as file:
        try:
            _check_directory(path, file)
            archive = zipfile.ZipFile(file)
        except _DAMAGED as error:
            raise InvalidFile(path, _FOREIGN) from error
        with archive:
            parts = archive.infolist()
            given = tuple(part.filename.removesuffix(".npy") for part in parts)
            last = {name: part for name, part in zip(given, parts, strict=True) if name in wanted}
            _check_sizes(path, parts, last)
            for name in filter(last.__contains__, wanted):
                try:
                    arrays[name] = _read_array(archive, last[name])
                except _DAMAGED:
                    problems.append(
                        f"{name!r} is damaged, or holds Python objects, which are never unpickled; "
                        "valid: a plain array"
                    )
    doubles = sorted({name for name in given if given.count(name) > 1})
    problems += [
        f"it holds {given.count(name)} arrays {shortened(name)!r}; valid: one of each" for name in doubles
    ]
    return arrays, given, problems


def _check_directory(path: Path, file: BufferedReader) -> None:
    """Raise unless a file is a zip file whose list of parts, which is read whole, is short."""
    start = file.read(len(_END))
    file.seek(max(0, file.seek(0, 2) - 2**16 - 22))
    tail = file.read()
    end = tail.rfind(_END)
    size = int.from_bytes(tail[end + 12 : end + 16], "little")
    if start[:2] != b"PK" or end < 0 or tail[max(0, end - 20) : end].startswith(_FAR_END) or size > MEGABYTE:
        raise InvalidFile(path, _FOREIGN)
    file.seek(0)


def _check_sizes(path: Path, parts: Collection[zipfile.ZipInfo], read: dict[str, zipfile.ZipInfo]) -> None:
    if len(parts) > MOST_ARRAYS:
        raise InvalidFile(path, f"it holds {len(parts)} arrays; valid: at most {MOST_ARRAYS}")
    if (size := sum(part.file_size for part in read.values())) > MOST_DATA:
        most = MOST_DATA // MEGABYTE
        raise InvalidFile(path, f"unpacked, it takes {size // MEGABYTE} MB; valid: at most {most} MB")


def _read_array(archive: zipfile.ZipFile, part: zipfile.ZipInfo) -> np.ndarray:
    """Read an array, once it is known that it takes no more room than what the file holds of it."""
    if part.compress_type not in _PACKINGS:
        raise ValueError("it is packed in a way that numpy does not know")
    with archive.open(part) as member:
        version = np.lib.format.read_magic(member)
        width, read_header = {
            (1, 0): (2, np.lib.format.read_array_header_1_0),
            (2, 0): (4, np.lib.format.read_array_header_2_0),
        }[version]
        if int.from_bytes(member.read(width), "little") > _MOST_HEADER:
            raise ValueError("it says too much of itself")
        member.seek(-width, 1)
        shape, _, dtype = read_header(member)
        count = math.prod(shape)
        if min(shape, default=0) < 0 or count * max(dtype.itemsize, 1) > part.file_size - member.tell():
            raise ValueError("it holds less than it says")
        member.seek(0)
        return np.asarray(np.lib.format.read_array(member, allow_pickle=False))
