"""A case: a domain folder, learned once, with a few files changed, and a command line.

What signals do is tried by `make faults`.
"""

import base64
import json
import subprocess
import sys
from collections.abc import Callable
from fnmatch import fnmatch
from pathlib import Path
from random import Random

import msgspec
from fuzz.lines import command_line
from fuzz.mutations import KINDS, MUTATIONS, mutated, put

READS = {
    "run": "world.toml manifest.json interactions.npz exploration.safetensors interactions.partial.npz",
    "see": "world.toml manifest.json",
    "explore": "world.toml manifest.json interactions.npz exploration.safetensors interactions.partial.npz",
    "check": "interactions.npz",
    "train": "interactions.npz manifest.json",
    "distill": "*_model.safetensors interactions.npz world.toml manifest.json",
    "compile-domain": "pr*.json upright/*.json world.toml manifest.json",
    "new-problem": "world.toml grounding.json effect_model.safetensors manifest.json problems/*.scene.json",
    "plan": "grounding.json problems/* world.toml effect_model.safetensors pasts/* manifest.json",
    "execute": "grounding.json problems/*.scene.json plans/*.plan world.toml runs/*.json pasts/*",
    "meet": "grounding.json problems/*.scene.json world.toml pasts/*",
    "replay": "runs/*.json grounding.json problems/*.scene.json world.toml",
    "compare": "comparison/*/*.json grounding.json world.toml effect_model.safetensors",
    "show": "interactions.npz grounding.json problems/*.scene.json world.toml effect_model.* manifest.json",
    "explain": "*.json interactions.npz world.toml effect_model.safetensors",
    "report": "*",
}
"""Which files each command reads, as patterns: mostly one of these is changed."""
OFTEN = ("plan", "execute", "explain", "report", "train", "distill", "compile-domain", "new-problem")
"""Commands that are drawn twice as often as others: there is much that they read."""
LONG = {"demo"}
"""Commands that are not drawn: they read no file of a user's, and take a minute."""
STAGES = {"whole": "*", "explored": "world.toml interactions.npz", "begun": "world.toml", "empty": ""}
"""How far the domain folder came: which of its files are there, as patterns."""


class Edit(msgspec.Struct, frozen=True):
    """Another content for a file, or another kind of thing in its place."""

    path: str
    kind: str = "content"
    content: str = ""  # base 64


class Case(msgspec.Struct, frozen=True):
    """What is tried."""

    arguments: tuple[str, ...]  # typed after `neurosym`; bytes that are no UTF-8 as `os.fsdecode` has them
    stage: str = "whole"  # how far the domain folder came, one of `STAGES`
    edits: tuple[Edit, ...] = ()  # what is changed in it before

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


def as_json(case: Case) -> str:
    """Write a case down, also one whose arguments are no UTF-8."""
    return json.dumps(msgspec.to_builtins(case), indent=1)


def from_json(text: str) -> Case:
    """Read a case that was written down."""
    return msgspec.convert(json.loads(text), Case)


def drawn_case(draw: Random, commands: dict[str, Callable[..., int]], seeds: dict[str, bytes]) -> Case:
    """Draw a command, and changes to files, the seeds."""
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
    return Case(arguments, stage, tuple(edits.values()))


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


LEARN = (
    "run {0} --world toy-relations --steps 1024 --seed 3 --strategy random --regime quick --workers 1 "
    "--rehearsals 40 --problems 2 --places 512 --relations 1024"
)
MORE = (
    "plan {0} task-01 --planner bfs",
    "meet {0} task-01 --tries 1",
    "new-problem {0} --name far --seed 3 --goal item-01=0.98,0.29",
    "new-problem {0} --name long --seed 5 --objects 3 --actions 4",
    "plan {0} long",
    "compare {0} --tasks 2 --workers 1 --planners counting fast-downward",
)
"""What is added to a learned folder, so that every format that is read has a seed."""
RELATED = (
    "new-problem {0} --name tower --task tower --objects 4 --seed 3",
    "plan {0} tower",
    "execute {0} tower {0}/plans/tower.fast-downward.plan",
)
"""What is added to one that learned relations."""


def build(folder: Path) -> None:
    """Learn the domain folder, unless it is there."""
    if folder.is_dir():
        return
    unfinished = folder.with_name(f"{folder.name}-unfinished")
    for line in (LEARN, *MORE, *RELATED):
        arguments = [part.format(unfinished) for part in line.split()]
        subprocess.run([sys.executable, "-m", "neurosym", *arguments], check=True, capture_output=True)
    unfinished.rename(folder)
