"""A case: a domain folder with a few files changed, a command line, and a signal."""

import base64
from collections.abc import Callable
from fnmatch import fnmatch
from pathlib import Path
from random import Random

import msgspec
from fuzz.files import KINDS, MUTATIONS, mutated, put
from fuzz.lines import command_line

READS = {
    "run": "world.toml manifest.json interactions.npz exploration.safetensors interactions.partial.npz",
    "explore": "world.toml manifest.json interactions.npz exploration.safetensors interactions.partial.npz",
    "check": "interactions.npz",
    "train": "interactions.npz manifest.json",
    "distill": "*_model.safetensors interactions.npz world.toml manifest.json",
    "practise": "pr*.json *_model.safetensors interactions.npz world.toml manifest.json",
    "compile-domain": "pr*.json world.toml manifest.json",
    "new-problem": "world.toml grounding.json effect_model.safetensors manifest.json problems/*.scene.json",
    "plan": "grounding.json problems/* world.toml effect_model.safetensors manifest.json",
    "execute": "grounding.json problems/*.scene.json plans/*.plan world.toml runs/*.json manifest.json",
    "replay": "runs/*.json grounding.json problems/*.scene.json world.toml",
    "compare": "comparison/*/*.json grounding.json world.toml effect_model.safetensors",
    "show": "interactions.npz grounding.json problems/*.scene.json world.toml effect_model.* manifest.json",
    "explain": "*.json interactions.npz world.toml effect_model.safetensors",
    "report": "*",
    "evaluate": "kinds.json comparison/*/*.json *ing.json interactions.npz *_model.* primitives.json",
}
"""Which files each command reads, as patterns: mostly one of these is changed."""
OFTEN = ("plan", "execute", "explain", "report", "train", "distill", "compile-domain", "new-problem")
"""Commands that are drawn twice as often as others: there is much that they read."""
LONG = {"demo"}
"""Commands that are not drawn: they read no file of a user's, and take a minute."""
TRAINING = ("run", "train", "report")
"""Commands that are never processes of their own: they would train for long."""
STAGES = {"whole": "*", "explored": "world.toml interactions.npz", "begun": "world.toml", "empty": ""}
"""How far the domain folder came: which of its files are there, as patterns."""
SIGNALS = ("SIGINT", "SIGINT", "SIGTERM", "SIGHUP")
LONGEST_WAIT = 1.5
"""When a signal is sent at the latest, after the command began [s]."""


class Edit(msgspec.Struct, frozen=True):
    """Another content for a file, or another kind of thing in its place."""

    path: str
    kind: str = "content"
    content: str = ""  # base 64


class Case(msgspec.Struct, frozen=True):
    """What is tried.

    Attributes:
        arguments: What is typed after `neurosym`; bytes that are no UTF-8 as `os.fsdecode` has them.
        stage: How far the domain folder came, one of `STAGES`.
        edits: What is changed in it before.
        alone: Whether it is a process of its own, and not forked from one that has imported everything.
        signal: What the process is sent, if anything is.
        after: When [s].
    """

    arguments: tuple[str, ...]
    stage: str = "whole"
    edits: tuple[Edit, ...] = ()
    alone: bool = False
    signal: str | None = None
    after: float = 0.0

    def prepare(self, folder: Path) -> None:
        """Take away and change files of a domain folder."""
        for name in read_seeds(folder):
            if not _fits(name, STAGES[self.stage]):
                (folder / name).unlink()
        for edit in self.edits:
            path = folder / edit.path
            if edit.kind == "content":
                path.write_bytes(base64.b64decode(edit.content))
            else:
                put(path, edit.kind)


def as_json(case: Case) -> bytes:
    """Write a case down; arguments are kept as what the system hands over, in base 64."""
    kept = [base64.b64encode(text.encode(errors="surrogateescape")).decode() for text in case.arguments]
    document = {**msgspec.to_builtins(msgspec.structs.replace(case, arguments=())), "arguments": kept}
    return msgspec.json.encode({"typed": " ".join(map(ascii, case.arguments)), **document})


def from_json(text: bytes) -> Case:
    """Read a case that was written down."""
    case = msgspec.json.decode(text, type=Case)
    typed = (base64.b64decode(part).decode(errors="surrogateescape") for part in case.arguments)
    return msgspec.structs.replace(case, arguments=tuple(typed))


def drawn_case(
    draw: Random,
    commands: dict[str, Callable[..., int]],
    seeds: dict[str, bytes],
    *,
    alone: int = 0,
    signals: int = 0,
) -> Case:
    """Draw a case.

    Args:
        draw: Source of randomness.
        commands: The commands by name.
        seeds: What the files of the domain folder hold, by their paths in it.
        alone: How many of a hundred are processes of their own.
        signals: How many of a hundred are sent a signal.
    """
    often = (name for name in OFTEN if name in commands)
    name = draw.choice((*sorted(commands.keys() - LONG), *often))
    arguments = command_line(draw, name, commands[name])
    begins = name in ("run", "explore", "train", "init") and draw.random() < 0.4
    stage = draw.choice(tuple(STAGES)) if begins else "whole"
    likely = [path for path in seeds if _fits(path, READS.get(name, ""))]
    edits = {}
    for _ in range(draw.choice((0, 1, 1, 1, 1, 2))):
        path = draw.choice(sorted(likely if likely and draw.random() < 0.9 else seeds))
        edits[path] = _edit(draw, path, seeds)
    signal = draw.choice(SIGNALS) if draw.randint(0, 99) < signals else None
    after = round(draw.uniform(0, LONGEST_WAIT), 3) if signal else 0.0
    is_alone = draw.randint(0, 99) < alone and name not in TRAINING
    return Case(arguments, stage, tuple(edits.values()), is_alone, signal, after)


def _fits(path: str, patterns: str) -> bool:
    return any(fnmatch(path, pattern) for pattern in patterns.split())


def _edit(draw: Random, path: str, seeds: dict[str, bytes]) -> Edit:
    if draw.randint(0, 11) == 0:
        return Edit(path, draw.choice(KINDS))
    return Edit(path, content=base64.b64encode(mutated(draw, path, seeds)).decode())


def read_seeds(folder: Path) -> dict[str, bytes]:
    """Read the files of a domain folder that commands read, by their paths in it: no pictures, no page."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.suffix in MUTATIONS)
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}
