"""Mutations of files of arrays: .npz and safetensors."""

import io
import json
import struct
import zipfile
from random import Random
from typing import Any

import numpy as np
from fuzz.documents import mutated_json
from fuzz.values import odd_text

_NUMBERS = (0.0, 1.0, -1.0, 0.5, np.nan, np.inf, -np.inf, 1e308, 3e38, -3e38, 1e-45, 1e9, 2.0**63)
_TYPES = ("f2", "f8", "c16", "i1", "u8", "?", "U5", "S3", "M8[s]", "O", "f4,i4", ">f4")
_HEADERS = (
    *("{'descr': '<f4', 'fortran_order': False, 'shape': (", "{}", "", "(" * 9000, "1" * 9000, "{" * 300),
    "{'descr': '<f4', 'fortran_order': False, 'shape': (1000000000000, 4), }",
    "{'descr': '<f4', 'fortran_order': False, 'shape': (-1, 4), }",
    "{'descr': '|O', 'fortran_order': False, 'shape': (3,), }",
    "{'descr': '<f4', 'fortran_order': True, 'shape': (2, 2), 'more': 1, }",
    "__import__('os').abort()",
)


def mutated_npz(draw: Random, content: bytes) -> bytes:
    """Return an archive of arrays with some of its members changed."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        members = [(name, archive.read(name)) for name in archive.namelist()]
    for _ in range(draw.choice((1, 1, 2, 3))):
        if not members:
            break
        number = draw.randint(0, len(members) - 1)
        name, member = members[number]
        what = draw.choice(("array", "array", "array", "header", "drop", "twice", "rename", "bytes"))
        if what == "drop":
            del members[number]
        elif what == "twice":
            members.append((name, member))
        elif what == "rename":
            members[number] = (odd_text(draw).encode(errors="replace").decode(), member)
        elif what == "header":
            members[number] = (name, _with_header(draw.choice(_HEADERS), member))
        elif what == "bytes":
            members[number] = (name, draw.randbytes(draw.randint(0, 50)))
        else:
            members[number] = (name, _other_array(draw, member))
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", draw.choice((zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2))) as archive:
        for name, member in members:
            archive.fp.write(b"")  # a name may come twice: zipfile would only warn
            info = zipfile.ZipInfo(name or "x")
            archive.NameToInfo.pop(info.filename, None)
            archive.writestr(info, member, archive.compression)
    return packed.getvalue()


def _with_header(header: str, member: bytes) -> bytes:
    text = header.encode() + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", min(len(text), 65535)) + text + member[128:]


def _other_array(draw: Random, member: bytes) -> bytes:
    try:
        array = np.load(io.BytesIO(member), allow_pickle=False)
    except Exception:
        return member
    if array.dtype.kind == "U" and array.shape == ():
        array = np.array(mutated_json(draw, array.item().encode()).decode(errors="replace"))
    else:
        array = _reshaped(draw, array) if draw.random() < 0.5 else _with_odd_numbers(draw, array)
    written = io.BytesIO()
    np.save(written, array, allow_pickle=True)
    return written.getvalue()


def _reshaped(draw: Random, array: np.ndarray) -> np.ndarray:
    what = draw.choice(("rows", "no rows", "one row", "flat", "deep", "transposed", "columns", "type"))
    if what == "type":
        with np.errstate(all="ignore"):
            return array.astype(np.bool_).astype(draw.choice(_TYPES))
    if array.ndim == 0:
        return array.reshape(1)
    width = draw.choice((0, 1, 2, 5, 1025))
    shapes = {
        "rows": lambda: array[: draw.randint(0, len(array))],
        "no rows": lambda: array[:0],
        "one row": lambda: array[:1],
        "flat": array.ravel,
        "deep": lambda: array[..., None],
        "transposed": lambda: array.T,
        "columns": lambda: np.resize(array, (len(array), width)),
    }
    return shapes[what]()


def _with_odd_numbers(draw: Random, array: np.ndarray) -> np.ndarray:
    value = draw.choice(_NUMBERS)
    other: Any = array.astype(np.float64) if draw.random() < 0.5 or array.dtype.kind == "b" else array.copy()
    if draw.random() < 0.3:
        value, other = 0.0, other * draw.choice((0.0, 0.5, 2.0, 1e-9, 1e6))
    where = draw.choice(("all", "one", "column"))
    with np.errstate(all="ignore"):
        if where == "all" or other.ndim == 0 or not other.size:
            other[...] = value
        elif where == "one":
            other.flat[draw.randint(0, other.size - 1)] = value
        else:
            other[..., draw.randint(0, other.shape[-1] - 1)] = value
    return other


def mutated_safetensors(draw: Random, content: bytes) -> bytes:
    """Return a file of tensors with its header, its description or its numbers changed."""
    (length,) = struct.unpack("<Q", content[:8])
    header, data = content[8 : 8 + length], bytearray(content[8 + length :])
    what = draw.choice(("header", "description", "description", "numbers", "length", "data"))
    if what == "header":
        header = mutated_json(draw, header)
    elif what == "description":
        tree = json.loads(header)
        text = mutated_json(draw, tree["__metadata__"]["neurosym"].encode())
        tree["__metadata__"]["neurosym"] = text.decode(errors="replace")
        header = json.dumps(tree).encode()
    elif what == "numbers" and len(data) >= 4:
        value = struct.pack("<f", draw.choice((0.0, 1.0, np.nan, np.inf, 3e38, -3e38, 1e-45, 1e9)))
        start = 4 * draw.randint(0, len(data) // 4 - 1)
        count = draw.choice((1, 100, 10**9))
        count = min(count, (len(data) - start) // 4)
        data[start : start + 4 * count] = value * count
    elif what == "data":
        del data[draw.randint(0, len(data)) :]
    length = draw.choice((0, 1, 2**31, 2**63, 2**64 - 1)) if what == "length" else len(header)
    return struct.pack("<Q", length) + header + bytes(data)
