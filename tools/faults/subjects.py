"""The commands that are disturbed, on the toy world and on the tabletop, and how each goes undisturbed."""

import json
import shutil
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal, NamedTuple

from tools.benchmarks.options import ROOT
from tools.faults.commands import Ending, content, differences, run

WorldName = Literal["toy", "tabletop"]
WORLDS: tuple[WorldName, ...] = ("toy", "tabletop")
TASK, PLAN = "errand", "plans/errand.fast-downward.plan"
RANDOM = "--strategy random --workers 1"
EXPLORATION = f"explore {{}} --steps 128 {RANDOM}"
FEW = "--steps 128 --regime quick --rehearsals 12 --workers 2 --seed 3"
LEARN_TOY = f"run {{}} --world toy {RANDOM} --steps 1024 --seed 3 --rehearsals 40 --problems 0 --regime quick"
PLANNING, EXECUTION = f"plan {{}} {TASK}", f"execute {{}} {TASK} {{}}/{PLAN} --disturb 3"
COMPARISON = "compare {} --tasks 3 --workers 2"


@dataclass(frozen=True)
class Subject:
    """A command in a folder."""

    name: str  # what it is called in the table
    world: WorldName  # whose folder it works in
    typed: str  # what is typed; `{}` stands for the folder
    without: tuple[str, ...] = ()  # patterns of files that it makes, taken out of the learned folder before
    begins_empty: bool = False  # whether it begins with no folder at all
    chain: int = 1  # how often it may be killed in one folder before it is left to end

    @property
    def title(self) -> str:
        """What it is called among all."""
        return f"{self.name}-{self.world}"

    def arguments(self, folder: Path) -> tuple[str, ...]:
        """Return what is typed, given the folder."""
        return tuple(word.replace("{}", str(folder)) for word in self.typed.split())


class Undisturbed(NamedTuple):
    """How a command goes when nothing disturbs it."""

    ending: Ending
    content: dict[str, str]  # what it made of the folder
    written: int  # how large the files are that it wrote [bytes]


def subjects(world: WorldName) -> tuple[Subject, ...]:
    """List the commands that are killed, doubled, limited and given other clocks."""
    extra = "--world toy --problems 1"
    if world == "tabletop":  # where auditions of actions for each category take minutes
        extra = "--choice predictable --problems 0"
    return (
        Subject("plan", world, PLANNING, ("plans/*",)),
        Subject("execute", world, EXECUTION, ("runs/*",)),
        Subject("compare", world, COMPARISON, ("comparison",), chain=5),
        Subject("run", world, f"run {{}} {FEW} {extra}", begins_empty=True, chain=5),
    )


STAGES = {
    "explore": (EXPLORATION, ("*.npz", "*.safetensors", "*.json", "*.pddl")),
    "train": ("train {} --regime quick", ("*_model.safetensors",)),
    "distill": ("distill {} --objects 12", ("primitives.json", "grounding.json")),
    "compile-domain": ("compile-domain {}", ("grounding.json", "*.pddl")),
    "new-problem": ("new-problem {} --name other", ()),
    "plan": (PLANNING, ("plans/*",)),
    "execute": (EXECUTION, ("runs/*",)),
    "compare": (COMPARISON, ("comparison",)),
    "report": ("report {}", ("report.html",)),
}  # what fills a disk, stage by stage: the command, and what it makes


def stages(world: WorldName) -> tuple[Subject, ...]:
    """List the stages that write."""
    return tuple(Subject(name, world, *stage) for name, stage in STAGES.items())


class Bench:
    """Where trials take place: a folder for learned domains and for trials."""

    def __init__(self, place: Path):
        self.place = place.resolve()
        self.undisturbed = cache(self._undisturbed)

    def learned(self, world: WorldName) -> Path:
        """Return a domain with one problem, a plan and its run; that of the tabletop is the shipped one."""
        folder, unfinished = self.place / f"learned-{world}", self.place / f"unfinished-{world}"
        if folder.exists():
            return folder
        shutil.rmtree(unfinished, ignore_errors=True)
        if world == "toy":
            self._must(unfinished, LEARN_TOY)
        else:
            left_out = shutil.ignore_patterns("plans", "problems", "runs")
            shutil.copytree(ROOT / "domains/tabletop", unfinished, ignore=left_out)
        for seed in range(20):  # until one of them has a plan
            shutil.rmtree(unfinished / "problems", ignore_errors=True)
            self._must(unfinished, f"new-problem {{}} --name {TASK} --objects 2 --seed {seed}")
            if self._must(unfinished, PLANNING) == 0:
                break
        self._must(unfinished, EXECUTION)
        return unfinished.rename(folder)

    def _must(self, folder: Path, typed: str) -> int:
        ending, _ = run(Subject("", "toy", typed).arguments(folder), self.place / "scratch")
        assert ending.code in (0, 3), f"{typed}: {ending}"
        return ending.code

    def fresh(self, subject: Subject, folder: Path) -> Path:
        """Make the folder that a command begins with; its manifest knows only of what is there."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(parents=True, exist_ok=True)
        if subject.begins_empty:
            return folder
        learned = self.learned(subject.world)
        shutil.copytree(learned, folder)
        for path in [path for pattern in subject.without for path in folder.glob(pattern)]:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        if (manifest := folder / "manifest.json").exists():
            kept, stages = json.loads(manifest.read_text()), {}
            for name, record in kept["stages"].items():
                if all((folder / output).exists() for output in record["outputs"]):
                    stages[name] = record
            manifest.write_text(json.dumps({**kept, "stages": stages}))
        return folder

    def finished(self, subject: Subject, folder: Path, scratch: Path, **options: Any) -> list[str]:
        """Run a command to its end; say what it leaves, and where its folder is not as when undisturbed."""
        goal = self.undisturbed(subject)
        ending, left = run(subject.arguments(folder), scratch, **options)
        wrong = ending.complaints((goal.ending.code or 0,))
        return [*wrong, *left, *differences(content(folder), goal.content)]

    def _undisturbed(self, subject: Subject) -> Undisturbed:
        """Run a command undisturbed, twice; both must come to the same, and the faster one is returned."""
        found = [self._once(subject) for _ in range(2)]
        if found[0].content != found[1].content:
            raise AssertionError(f"{subject.title} comes to different files by itself")
        return min(found, key=lambda one: one.ending.seconds)

    def _once(self, subject: Subject) -> Undisturbed:
        folder = self.fresh(subject, self.place / "trial" / "domain")
        before = _files(folder)
        ending, _ = run(subject.arguments(folder), self.place / "trial" / "scratch")
        if ending.code not in (0, 3):
            raise AssertionError(f"{subject.title} fails by itself: {ending}")
        new = [path for path, _ in _files(folder) - before]
        return Undisturbed(ending, content(folder), sum(path.stat().st_size for path in new))


def _files(folder: Path) -> set[tuple[Path, int]]:
    """List files with the times at which they were written."""
    return {(path, path.stat().st_mtime_ns) for path in folder.rglob("*") if path.is_file()}
