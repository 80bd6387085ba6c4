"""Mutations of files: of what they say, of their bytes, and of what kind of thing they are."""

import os
from pathlib import Path
from random import Random

from fuzz.arrays import mutated_npz, mutated_safetensors
from fuzz.documents import mutated_json, mutated_lines, mutated_toml

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
    """Return another content for one of the seed files.

    Args:
        draw: Source of randomness.
        path: The file, relative to the folder of the seeds.
        seeds: What all of them hold.
    """
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
    """Put something where a file is expected.

    Args:
        path: The file, which is removed if it is there.
        kind: One of `KINDS`.
    """
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
