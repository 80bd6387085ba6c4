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
    what = draw.randint(0, 5)
    if what == 0:
        ranges = ((1, 0x7F), (0x80, 0xD7FF), (0xE000, 0x10FFFF))
        signs = (chr(draw.randint(*draw.choice(ranges))) for _ in range(draw.randint(0, 12)))
        return "".join(signs).replace("/", "")
    return str(draw.choice(NUMBERS) if what == 1 else _any_number(draw) if what == 2 else draw.choice(WORDS))


def odd_value(draw: Random) -> str:
    """Draw what may stand for a value in a JSON or TOML document."""
    what = draw.randint(0, 3)
    if what < 2:
        return draw.choice((NUMBERS, RAW)[what])
    return json.dumps(odd_text(draw)) if what == 2 else str(_any_number(draw))


def _any_number(draw: Random) -> float:
    if draw.randint(0, 1):
        return draw.choice((-1, 1)) * draw.getrandbits(draw.choice((1, 3, 8, 16, 33, 65)))
    return draw.choice((-1.0, 1.0)) * draw.random() * 10.0 ** draw.randint(-20, 20)


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
    what = draw.choice(("value", "value", "scale", "scale", "scale", "drop", "rename", "swap"))
    if what == "drop":
        del parent[key]
    elif what == "swap":
        other, place = draw.choice(places)
        parent[key] = copy.deepcopy(other[place])  # no tree within itself
    elif what == "scale" and type(parent[key]) in (int, float):
        parent[key] *= draw.choice(_SCALES)
    elif what == "rename" and isinstance(parent, dict):
        parent[odd_text(draw).encode(errors="replace").decode()] = parent.pop(key)
    elif what == "rename":
        parent += [parent[key]] * draw.choice((1, 2, 1000))
    else:
        raw[mark := f"@{len(raw)}@"] = odd_value(draw)
        parent[key] = mark


def _places(tree: Any) -> Iterator[tuple[Any, Any]]:
    """List where values stand in a tree."""
    keys = list(tree) if isinstance(tree, dict) else range(len(tree)) if isinstance(tree, list) else ()
    for key in keys:
        yield tree, key
        yield from _places(tree[key])


def mutated_lines(draw: Random, content: bytes) -> bytes:
    """Return a text with some of its lines and words changed."""
    lines = content.decode().splitlines() or [""]
    for _ in range(draw.choice((1, 1, 2, 4))):
        number, other = (draw.randint(0, len(lines) - 1) for _ in range(2))
        words = lines[number].split(" ")
        words[draw.randint(0, len(words) - 1)] = odd_text(draw)
        opened = draw.choice(("(", ")", "(" * 20_000, "(push", "((a b))")) + lines[number]
        choices = ("", " ".join(words), odd_value(draw), opened, lines[other])
        times = draw.choice((1,) * 9 + (3000,))
        lines[number : number + 1] = [draw.choice(choices)] * times
    return "\n".join(lines).encode(errors="surrogateescape")


_NUMBERS = (0.0, 1.0, -1.0, np.nan, np.inf, -np.inf, 1e308, 3e38, 1e-45, 1e9, 2.0**63)
_TYPES = ("f2", "f8", "c16", "i1", "u8", "?", "U5", "S3", "M8[s]", "O", "f4,i4", ">f4")


def mutated_npz(draw: Random, content: bytes) -> bytes:
    """Return an archive of arrays with some of its members changed; tests/test_reading.py damages headers."""
    with np.load(io.BytesIO(content)) as archive:
        members = dict(archive)
    for _ in range(draw.choice((1, 1, 2, 3))):
        name = draw.choice(sorted(members))
        what = draw.choice(("array", "array", "array", "drop", "rename"))
        if what == "array":
            members[name] = _other_array(draw, members[name])
        elif what == "rename":
            members[odd_text(draw).encode(errors="replace").decode()] = members.pop(name)
        elif len(members) > 1:
            del members[name]
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", draw.choice((zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2))) as archive:
        for name, array in members.items():
            with archive.open(zipfile.ZipInfo(f"{name}.npy"), "w") as file:
                np.lib.format.write_array(file, array)
    return packed.getvalue()


def _other_array(draw: Random, array: np.ndarray) -> np.ndarray:
    if array.dtype.kind == "U" and array.shape == ():
        return np.array(mutated_json(draw, array.item().encode()).decode(errors="replace"))
    other = array.astype(np.float64 if array.dtype.kind == "b" or draw.random() < 0.5 else array.dtype)
    where, rows = (draw.randint(0, max(0, size - 1)) for size in (array.size, len(array)))
    with np.errstate(all="ignore"):
        match draw.choice(("all", "one", "column", "scaled", "shape", "type")):
            case "all":
                other[...] = draw.choice(_NUMBERS)
            case "one" if other.size:
                other.flat[where] = draw.choice(_NUMBERS)
            case "column" if other.size:
                other[..., where % other.shape[-1]] = draw.choice(_NUMBERS)
            case "scaled":
                other *= draw.choice((0.5, 2.0, 1e-9, 1e6))
            case "type":
                return array.astype(np.bool_).astype(draw.choice(_TYPES))
            case _:
                width = draw.choice((0, 1, 2, 5, 1025))
                shapes = (array[:rows], array[:1], array.ravel(), array[..., None], array.T)
                return draw.choice((*shapes, np.resize(array, (len(array), width))))
    return other


def mutated_safetensors(draw: Random, content: bytes) -> bytes:
    """Return a file of tensors with its header, its description or its numbers changed."""
    (length,) = struct.unpack("<Q", content[:8])
    header, data = content[8 : 8 + length], bytearray(content[8 + length :])
    what = draw.choice(("header", "description", "description", "numbers", "data"))
    if what == "header":
        header = mutated_json(draw, header)
    elif what == "description":
        tree = json.loads(header)
        text = mutated_json(draw, tree["__metadata__"]["neurosym"].encode())
        tree["__metadata__"]["neurosym"] = text.decode(errors="replace")
        header = json.dumps(tree).encode()
    elif what == "numbers" and len(data) >= 4:
        start = 4 * draw.randint(0, len(data) // 4 - 1)
        count = min(draw.choice((1, 100, 10**9)), (len(data) - start) // 4)
        data[start : start + 4 * count] = struct.pack("<f", draw.choice((0.0, np.nan, np.inf, 3e38))) * count
    else:
        del data[draw.randint(0, len(data)) :]
    return struct.pack("<Q", len(header)) + header + bytes(data)


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
    content = seeds[path]
    if draw.randint(0, 9) < 7:
        return MUTATIONS[Path(path).suffix](draw, content)
    place, changed = draw.randint(0, len(content)), bytearray(content)
    for _ in range(draw.choice((1, 2, 8)) if content else 0):
        changed[draw.randint(0, len(content) - 1)] = draw.randint(0, 255)
    inserted = content[:place] + draw.randbytes(draw.randint(0, 20)) + content[place:]
    wide, other = content.decode("latin-1").encode("utf-16"), seeds[draw.choice(sorted(seeds))]
    return draw.choice((bytes(changed), content[:place], inserted, content * 2, other, b"", wide))


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
