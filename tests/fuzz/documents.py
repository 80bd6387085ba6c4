"""Mutations of documents: trees of JSON and TOML, and the lines of PDDL and plans."""

import copy
import json
import tomllib
from collections.abc import Callable, Iterator
from random import Random
from typing import Any

import tomli_w
from fuzz.values import odd_text, odd_value

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
