"""The commands that are disturbed, on the toy world and on the tabletop, and how each goes undisturbed."""

import json
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from tools.benchmarks.places import SHIPPED
from tools.faults.commands import Ending, content, differences, run

WorldName = Literal["toy", "tabletop"]
WORLDS: tuple[WorldName, ...] = ("toy", "tabletop")
FEW = ("--steps", "128", "--regime", "quick", "--rehearsals", "12", "--workers", "2", "--seed", "3")
LEARN_TOY = (
    *("--world", "toy", "--steps", "1024", "--seed", "3", "--rehearsals", "40", "--problems", "0"),
    *("--strategy", "random", "--regime", "quick", "--workers", "1"),
)
TASK, PLAN = "errand", "plans/errand.fast-downward.plan"


@dataclass(frozen=True)
class Subject:
    """A command in a folder.

    Attributes:
        name: What it is called in the table.
        world: Whose folder it works in.
        arguments: What is typed, given the folder.
        without: Patterns of files that it makes, which are taken out of the learned folder before.
        begins_empty: Whether it begins with no folder at all.
        chain: How often it may be killed in one folder before it is left to end.
    """

    name: str
    world: WorldName
    arguments: Callable[[Path], tuple[str, ...]]
    without: tuple[str, ...] = ()
    begins_empty: bool = False
    chain: int = 1

    @property
    def title(self) -> str:
        """What it is called among all."""
        return f"{self.name}-{self.world}"


@dataclass
class Undisturbed:
    """How a command goes when nothing disturbs it.

    Attributes:
        ending: How it ended.
        content: What it made of the folder.
        written: How large the files are that it wrote [bytes].
    """

    ending: Ending
    content: dict[str, str]
    written: int


def subjects(world: WorldName) -> tuple[Subject, ...]:
    """List the commands that are killed, doubled, limited and given other clocks."""
    extra = ("--world", "toy", "--problems", "1")
    if world == "tabletop":  # where auditions of actions for each category take minutes
        extra = ("--choice", "predictable", "--problems", "0")
    return (
        Subject("plan", world, lambda folder: ("plan", str(folder), TASK), ("plans/*",)),
        Subject("execute", world, _execute, ("runs/*",)),
        Subject("compare", world, _compare, ("comparison",), chain=5),
        Subject("run", world, lambda folder: ("run", str(folder), *FEW, *extra), begins_empty=True, chain=5),
    )


def _execute(folder: Path) -> tuple[str, ...]:
    return ("execute", str(folder), TASK, str(folder / PLAN), "--disturb", "3")


def _compare(folder: Path) -> tuple[str, ...]:
    return ("compare", str(folder), "--tasks", "3", "--workers", "2")


STAGES: dict[str, tuple[Callable[[Path], tuple[str, ...]], tuple[str, ...]]] = {
    "explore": (
        lambda folder: ("explore", str(folder), "--steps", "128", "--strategy", "random", "--workers", "1"),
        ("*.npz", "*.safetensors", "*.json", "*.pddl"),
    ),
    "train": (lambda folder: ("train", str(folder), "--regime", "quick"), ("*_model.safetensors",)),
    "distill": (
        lambda folder: ("distill", str(folder), "--objects", "12"),
        ("primitives.json", "grounding.json"),
    ),
    "compile-domain": (lambda folder: ("compile-domain", str(folder)), ("grounding.json", "*.pddl")),
    "new-problem": (lambda folder: ("new-problem", str(folder), "--name", "other"), ()),
    "plan": (lambda folder: ("plan", str(folder), TASK), ("plans/*",)),
    "execute": (_execute, ("runs/*",)),
    "compare": (_compare, ("comparison",)),
    "report": (lambda folder: ("report", str(folder)), ("report.html",)),
}
"""What fills a disk, stage by stage: the command, and what it makes."""


def stages(world: WorldName) -> tuple[Subject, ...]:
    """List the stages that write."""
    return tuple(Subject(name, world, *stage) for name, stage in STAGES.items())


class Bench:
    """Where trials take place.

    Args:
        place: A folder for learned domains and for trials.
    """

    def __init__(self, place: Path):
        self.place = place.resolve()
        self.known: dict[Subject, Undisturbed] = {}

    @cached_property
    def toy(self) -> Path:
        """A domain learned on the toy world, with a problem, a plan and its run."""
        return self._learned("toy", lambda folder: self._must("run", str(folder), *LEARN_TOY))

    @cached_property
    def tabletop(self) -> Path:
        """The shipped domain, with one problem, a plan and its run."""

        def copy(folder: Path) -> None:
            shutil.copytree(SHIPPED, folder, ignore=shutil.ignore_patterns("plans", "problems", "runs"))

        return self._learned("tabletop", copy)

    def _learned(self, name: str, make: Callable[[Path], None]) -> Path:
        folder, unfinished = self.place / f"learned-{name}", self.place / f"unfinished-{name}"
        if not folder.exists():
            shutil.rmtree(unfinished, ignore_errors=True)
            make(unfinished)
            for seed in range(20):  # until one of them has a plan
                shutil.rmtree(unfinished / "problems", ignore_errors=True)
                asked = ("--name", TASK, "--objects", "2", "--seed", str(seed))
                self._must("new-problem", str(unfinished), *asked)
                if self._must("plan", str(unfinished), TASK) == 0:
                    break
            self._must(*_execute(unfinished))
            unfinished.rename(folder)
        return folder

    def _must(self, *arguments: str) -> int:
        ending, _ = run(arguments, self.place / "scratch")
        assert ending.code in (0, 3), f"{arguments}: {ending}"
        return ending.code

    def fresh(self, subject: Subject, folder: Path) -> Path:
        """Make the folder that a command begins with."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(parents=True, exist_ok=True)
        if not subject.begins_empty:
            shutil.copytree(self.toy if subject.world == "toy" else self.tabletop, folder)
            for pattern in subject.without:
                for path in folder.glob(pattern):
                    shutil.rmtree(path) if path.is_dir() else path.unlink()
            _restore_needed(subject, self.toy if subject.world == "toy" else self.tabletop, folder)
        return folder

    def undisturbed(self, subject: Subject) -> Undisturbed:
        """Run a command undisturbed, twice the first time; both must come to the same."""
        if subject not in self.known:
            found = [self._once(subject) for _ in range(2)]
            if found[0].content != found[1].content:
                raise AssertionError(f"{subject.title} comes to different files by itself")
            fastest = min(found, key=lambda one: one.ending.seconds)
            self.known[subject] = fastest
        return self.known[subject]

    def finished(self, subject: Subject, folder: Path, scratch: Path, **options: Any) -> list[str]:
        """Run a command to its end; say what it leaves, and where its folder is not as when undisturbed."""
        goal = self.undisturbed(subject)
        ending, left = run(subject.arguments(folder), scratch, **options)
        wrong = ending.complaints((goal.ending.code or 0,))
        return [*wrong, *left, *differences(content(folder), goal.content)]

    def _once(self, subject: Subject) -> Undisturbed:
        folder = self.fresh(subject, self.place / "trial" / "domain")
        before = set(_files(folder))
        ending, _ = run(subject.arguments(folder), self.place / "trial" / "scratch")
        if ending.code not in (0, 3):
            raise AssertionError(f"{subject.title} fails by itself: {ending}")
        new = [path for path, _ in set(_files(folder)) - before]
        return Undisturbed(ending, content(folder), sum(path.stat().st_size for path in new))


def _files(folder: Path) -> list[tuple[Path, int]]:
    """List files with the times at which they were written."""
    return [(path, path.stat().st_mtime_ns) for path in folder.rglob("*") if path.is_file()]


def _restore_needed(subject: Subject, learned: Path, folder: Path) -> None:
    """Put back what a pattern took away too much, and let the manifest know only of what is there."""
    if subject.name == "execute":
        (folder / PLAN).parent.mkdir(exist_ok=True)
        shutil.copy(learned / PLAN, folder / PLAN)
    manifest = folder / "manifest.json"
    if manifest.exists():
        kept = json.loads(manifest.read_text())
        kept["stages"] = {
            name: record
            for name, record in kept["stages"].items()
            if all((folder / output).exists() for output in record["outputs"])
        }
        manifest.write_text(json.dumps(kept))
