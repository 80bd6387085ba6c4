"""Arrays in .npz files: measured before they are unpacked, and never unpickled."""

import lzma
import tokenize
import zipfile
import zlib
from collections.abc import Collection
from pathlib import Path

import numpy as np

from neurosym.errors import InvalidFile, shortened
from neurosym.reading import MEGABYTE, MOST_DATA, opened

_MOST_ARRAYS = 1000  # files with more are no data sets
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
    lzma.LZMAError,
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
            archive = np.load(file, allow_pickle=False)
            parts: list[zipfile.ZipInfo] = archive.zip.infolist()
        except _DAMAGED as error:
            raise InvalidFile(path, "it is not an .npz file of plain arrays") from error
        with archive:
            given = tuple(part.filename.removesuffix(".npy") for part in parts)
            _check_sizes(path, parts, wanted)
            for name in filter(given.__contains__, wanted):
                try:
                    array = archive[name]
                    if not array.dtype.itemsize:
                        raise ValueError("it holds nothing, as often as it likes")
                    arrays[name] = array
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


def _check_sizes(path: Path, parts: Collection[zipfile.ZipInfo], wanted: Collection[str]) -> None:
    if len(parts) > _MOST_ARRAYS:
        raise InvalidFile(path, f"it holds {len(parts)} arrays; valid: at most {_MOST_ARRAYS}")
    sizes = {part.filename.removesuffix(".npy"): part.file_size for part in parts}
    if (size := sum(size for name, size in sizes.items() if name in wanted)) > MOST_DATA:
        most = MOST_DATA // MEGABYTE
        raise InvalidFile(path, f"unpacked, it takes {size // MEGABYTE} MB; valid: at most {most} MB")
