"""Odd values, and mutations of what files say, of their bytes, and of what kind of thing they are."""

import copy
import io
import json
import os
import struct
import tomllib
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
import tomli_w

DEEP = 20_000
_split = str.split
NUMBERS = (
    *_split("0 -1 1 2 0.0 -0.0 1e308 -1e308 1e309 1e-320 NaN Infinity -Infinity 2147483648"),
    *_split("9223372036854775807 9223372036854775808 -9223372036854775809"),
    *("1" * 5000, "1e", "0x1"),
)
"""As they stand in JSON, or are typed; not all are numbers."""
WORDS = (
    *("", " ", *_split("- -- . .. nan inf None true null [] {} toy item-01 task-01")),
    *_split("item-1 000 0 10 resting held left\x1b[31mred \x07 <script>alert(1)</script>"),
    *("line\nbreak", "tab\there", "\ufeff", "\u202eright to left", "ä", "\u0130", "\U0001d7d9", "%s%n"),
    *_split("{0} [red]markup[/] os:system subprocess:run neurosym.worlds.toy:make_world own:nothing"),
    *_split(": a:b:c ../toy nowhere/at/all.png /dev/null /dev/full out.png out.gif out.md out.html out.json"),
    *("x" * 300, "x" * 300 + ".png"),
    *_split("item-01=0.6,0.1 item-01=nan,nan item-01= =0,0 item-01=1e308,0 \udcff.plan a\udc80b"),
)
"""Texts that mean something here, or somewhere else."""
RAW = (
    *_split('true false null "" [] {} [null] [[]] [0,0,0] {"a":1} 1979-05-27T07:32:00Z'),
    *('"\\ud800"', '"\\u0000"', '"\\u001b[31m"', '"' + "x" * 100_000 + '"', '"' + "item-01 " * 3 + '"'),
    *("[" * DEEP + "]" * DEEP, "[" * DEEP, '{"a":' * DEEP + "1" + "}" * DEEP, "[" + "0," * 100_000 + "0]"),
)
"""Values as JSON and TOML write them, valid or not."""


def odd_text(draw: Random) -> str:
    """Draw what may be typed: no NUL, which no command line holds, and no path out of the case's folder."""
    return str(draw.choice((_word, _word, _number, _characters, _integer, _float))(draw))


def odd_value(draw: Random) -> str:
    """Draw what may stand for a value in a JSON or TOML document."""
    what = draw.randint(0, 5)
    if what < 2:
        return _number(draw)
    if what == 2:
        return draw.choice(RAW)
    return json.dumps(odd_text(draw)) if what == 3 else str((_integer, _float)[what - 4](draw))


def _word(draw: Random) -> str:
    return draw.choice(WORDS)


def _number(draw: Random) -> str:
    return draw.choice(NUMBERS)


def _integer(draw: Random) -> int:
    return draw.choice((-1, 1)) * draw.getrandbits(draw.choice((1, 3, 8, 16, 33, 65)))


def _float(draw: Random) -> float:
    return draw.choice((-1.0, 1.0)) * draw.random() * 10.0 ** draw.randint(-20, 20)


def _characters(draw: Random) -> str:
    ranges = ((1, 0x7F), (0x80, 0xD7FF), (0xE000, 0x10FFFF))
    signs = (chr(draw.choice([draw.randint(*ends) for ends in ranges])) for _ in range(draw.randint(0, 12)))
    return "".join(signs).replace("/", "")


_SCALES = (-1, 0, 0.5, 0.999, 1.001, 2, 10, 1000, 1_000_000, 1e-6)


def mutated_json(draw: Random, content: bytes) -> bytes:
    """Return a JSON document with some of its nodes changed."""
    return _mutated(draw, json.loads(content), json.dumps)


def mutated_toml(draw: Random, content: bytes) -> bytes:
    """Return a TOML document with some of its nodes changed."""
    return _mutated(draw, tomllib.loads(content.decode()), tomli_w.dumps)


def _mutated(draw: Random, tree: Any, dump: Callable[[Any], str]) -> bytes:
    raw: dict[str, str] = {}
    for _ in range(draw.choice((1, 1, 1, 2, 4))):
        _change(draw, tree, raw)
    text = dump(tree)
    for mark, value in raw.items():
        text = text.replace(f'"{mark}"', value)
    return text.encode(errors="surrogateescape")


def _change(draw: Random, tree: Any, raw: dict[str, str]) -> None:
    """Change a node somewhere in a tree; values that no library writes are marked, and stand in `raw`."""
    places = list(_places(tree))
    if not places:
        return
    parent, key = draw.choice(places)
    what = draw.choice(("value", "value", "scale", "scale", "scale", "drop", "twice", "rename", "swap"))
    if what == "drop":
        del parent[key]
    elif what == "swap":
        other, place = draw.choice(places)
        parent[key] = copy.deepcopy(other[place])  # no tree within itself
    elif what == "scale" and type(parent[key]) in (int, float):
        parent[key] *= draw.choice(_SCALES)
    elif what == "rename" and isinstance(parent, dict):
        parent[odd_text(draw).encode(errors="replace").decode()] = parent.pop(key)
    elif what == "twice" and isinstance(parent, list):
        parent += [parent[key]] * draw.choice((1, 2, 1000))
    else:
        value = odd_value(draw)
        if what == "twice":
            value = f"{value}, {json.dumps(key)}: {odd_value(draw)}"
        raw[mark := f"@{len(raw)}@"] = value
        parent[key] = mark


def _places(tree: Any) -> Iterator[tuple[Any, Any]]:
    """List where values stand in a tree."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        for key in (
            list(node) if isinstance(node, dict) else range(len(node)) if isinstance(node, list) else ()
        ):
            yield node, key
            waiting.append(node[key])


def mutated_lines(draw: Random, content: bytes) -> bytes:
    """Return a text with some of its lines and words changed."""
    lines = content.decode().splitlines() or [""]
    for _ in range(draw.choice((1, 1, 2, 4))):
        number = draw.randint(0, len(lines) - 1)
        what = draw.choice(("drop", "twice", "word", "word", "line", "comment", "open", "swap"))
        if what == "drop":
            lines[number] = ""
        elif what == "twice":
            lines[number : number + 1] = [lines[number]] * draw.choice((2, 3, 3000))
        elif what == "word":
            words = lines[number].split(" ")
            words[draw.randint(0, len(words) - 1)] = odd_text(draw)
            lines[number] = " ".join(words)
        elif what == "line":
            lines[number] = odd_value(draw)
        elif what == "comment":
            lines = [f"; {line}" for line in lines]
        elif what == "open":
            lines[number] = draw.choice(("(", ")", "(" * 20_000, "(push", "((a b))")) + lines[number]
        else:
            other = draw.randint(0, len(lines) - 1)
            lines[number], lines[other] = lines[other], lines[number]
    return "\n".join(lines).encode(errors="surrogateescape")


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


MUTATIONS = {
    ".toml": mutated_toml,
    ".json": mutated_json,
    ".pddl": mutated_lines,
    ".plan": mutated_lines,
    ".npz": mutated_npz,
    ".safetensors": mutated_safetensors,
}
"""How what a file says is changed, by its ending."""
KINDS = ("missing", "folder", "fifo", "endless", "dangling", "loop", "sparse", "device")
"""What may stand where a file is expected."""


def mutated(draw: Random, path: str, seeds: dict[str, bytes]) -> bytes:
    """Return another content for one of the seed files."""
    content, structured = seeds[path], MUTATIONS.get(Path(path).suffix)
    if structured and draw.randint(0, 9) < 7:
        return structured(draw, content)
    return _mutated_bytes(draw, content, seeds)


def _mutated_bytes(draw: Random, content: bytes, seeds: dict[str, bytes]) -> bytes:
    what = draw.choice(("flip", "flip", "cut", "insert", "repeat", "other", "empty", "mark", "wide", "ends"))
    place = draw.randint(0, len(content))
    if what == "flip":
        changed = bytearray(content)
        for _ in range(draw.choice((1, 2, 8))):
            if changed:
                changed[draw.randint(0, len(changed) - 1)] = draw.randint(0, 255)
        return bytes(changed)
    if what == "insert":
        return content[:place] + draw.randbytes(draw.randint(0, 20)) + content[place:]
    if what == "other":
        return seeds[draw.choice(sorted(seeds))]
    return {
        "cut": content[:place],
        "repeat": content + content,
        "empty": b"",
        "mark": b"\xef\xbb\xbf" + content,
        "wide": content.decode("latin-1").encode("utf-16"),
        "ends": content.replace(b"\n", b"\r\n"),
    }[what]


def put(path: Path, kind: str) -> None:
    """Put one of `KINDS` where a file is expected."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    if kind == "folder":
        path.mkdir()
    elif kind == "fifo":
        os.mkfifo(path)
    elif kind == "sparse":
        path.touch()
        os.truncate(path, 1 << 40)
    elif kind in _LINKS:
        path.symlink_to(_LINKS[kind] or path.name)


_LINKS = {"endless": "/dev/zero", "dangling": "nowhere", "loop": "", "device": "/dev/full"}
