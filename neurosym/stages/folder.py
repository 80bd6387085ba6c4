"""A domain folder that exists: finding what it holds (`layout`), and performing stages in it.

Several processes can work in one folder. What learns takes it for itself; what plans and executes shares it
with its like. A stage's files are replaced together when it is done, and the manifest with them.
"""

import os
import platform
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from enum import IntEnum
from itertools import count
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any

import msgspec

from neurosym.errors import (
    FolderNotFound,
    FolderTaken,
    InvalidFile,
    InvalidValue,
    StageMissing,
    UnknownChoice,
    quoted,
    version_of,
)
from neurosym.files import (
    Drafts,
    check_writable,
    digests,
    holders,
    locked,
    read_json,
    refuse_other_kinds,
    remove_leftovers,
    take,
    write_json,
    write_new,
)
from neurosym.stages.layout import (
    COMMANDS,
    COMPARISONS,
    GROUNDING,
    INTERACTIONS,
    MANIFEST,
    MODEL,
    PICTURES,
    PLACES,
    PLANS,
    PROBLEMS,
    REPORT_PICTURES,
    RUNS,
    SCENE,
    WORLD,
    problem_of,
    scene_file,
)

if TYPE_CHECKING:
    from neurosym.problems import Problem


class StageRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the files of one stage came about.

    Attributes:
        options: What the stage was asked for.
        inputs: SHA-256 of each file it read, by name.
        outputs: SHA-256 of each file it wrote, by name.
        seconds: How long it took, in the last session that worked on it [s].
        versions: Versions of Python and of the packages that decide the outcome.
    """

    options: dict[str, Any]
    inputs: dict[str, str]
    outputs: dict[str, str]
    seconds: float
    versions: dict[str, str]


class Manifest(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The stages that made a domain folder, by name."""

    stages: dict[str, StageRecord] = {}


class Claim(IntEnum):
    """How a stage has the folder while it works; each includes those before it."""

    NONE = 0
    """It looks at what is there, which changes whole files at a time."""
    SHARED = 1
    """It adds to what was learned: several can at the same time, while nobody learns."""
    ALONE = 2
    """It learns: what others would read changes."""


@dataclass(frozen=True, slots=True)
class Stage:
    """One step of the way: what it reads, what it writes, and the work itself.

    Attributes:
        name: The command's name, with the problem's where there is one.
        inputs: Files it reads, relative to the folder.
        outputs: Files it writes, relative to the folder.
        work: Does the work.
        options: What decides the outcome beside the inputs.
        claim: How it has the folder meanwhile.
        renews: Files of other stages that it may write anew; they still count as made by those.
    """

    name: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    work: Callable[[], None]
    options: dict[str, Any] = field(default_factory=dict)
    claim: Claim = Claim.SHARED
    renews: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.options.get("seed", 0) < 0:
            raise InvalidValue(f"seed = {self.options['seed']} must be at least 0.")


def versions() -> dict[str, str]:
    """Return the versions of Python and of the packages that decide what is learned."""
    packages = ("neurosym", "numpy", "pybullet", "torch", "up-fast-downward")
    return {"python": platform.python_version(), **{name: version_of(name) for name in packages}}


def rehearsal_options(manifest: Manifest) -> tuple[int, int]:
    """Return how many objects rehearsal sampled, and where its draws started."""
    distilled = manifest.stages.get("distill")
    options = distilled.options if distilled else {}
    return options.get("objects", 100), options.get("seed", 0)


Notify = Callable[[str], None]
"""Takes a remark, in a sentence without a full stop."""


class DomainFolder:
    """A domain folder that exists; its files are named relative to it.

    Args:
        path: The folder.
        notify: Called with what a user should know though the work goes on.

    Raises:
        FolderNotFound: If there is none.
    """

    def __init__(self, path: Path, notify: Notify = lambda _: None):
        if not path.is_dir():
            raise FolderNotFound(path)
        self.path, self.notify = path, notify
        self._claim = Claim.NONE

    def __truediv__(self, name: str) -> Path:
        return self.path / name

    def require(self, name: str) -> Path:
        """Return the path of a file that an earlier stage writes.

        Raises:
            StageMissing: If it is not there; the message names the command that writes it.
            InvalidFile: If it is no file.
        """
        path = self.path / name
        refuse_other_kinds(path)
        if not path.is_file():
            command, besides = f"neurosym {COMMANDS[path.name]} {quoted(self.path)}", ""
            if name == INTERACTIONS:
                besides = ", or a script of yours (docs/data.md)"
            has_data = (self.path / INTERACTIONS).exists() and "explore" not in self.manifest().stages
            if name == WORLD and has_data:
                command, besides = f"{command} --world module:factory", " for the world of your data"
            raise StageMissing(path, command, besides)
        return path

    def problem_names(self) -> tuple[str, ...]:
        """List the problems of this folder: scenes, and PDDL files whose scene is missing."""
        found = [*(self.path / PROBLEMS).glob(f"*{SCENE}"), *(self.path / PROBLEMS).glob("*.pddl")]
        return tuple(sorted({problem_of(path.name) for path in found}))

    def problem(self, name: str) -> str:
        """Return a problem's name from what a user typed: the name, or the path of its file.

        Raises:
            InvalidValue: If this is no domain folder.
            UnknownChoice: If there is no such problem here.
        """
        stem, known = problem_of(Path(name).name), self.problem_names()
        is_file = os.path.isfile(name)  # noqa: PTH113 (no error for names that are too long)
        is_foreign = is_file and not Path(name).resolve().is_relative_to(self.path.resolve())
        if stem in known and not (is_foreign and name.endswith(SCENE)):
            return stem
        if not any((self.path / file).exists() for file in (WORLD, GROUNDING)):
            raise InvalidValue(
                f"{self.path} is no domain folder, it has neither {WORLD} nor {GROUNDING}; name one that has."
            )
        if name.endswith(".json") and is_foreign:
            command = f"neurosym new-problem {quoted(self.path)} --scene {quoted(name)}"
            there = f" --name {own}" if (own := stem.removesuffix(".json")) in known else ""
            raise InvalidValue(f"{name} lies outside of {self.path}; take it over with: {command}{there}")
        raise UnknownChoice("problem", name, known, str(self.path / PROBLEMS))

    def free_problem_name(self) -> str:
        """Return the first of `task-01`, `task-02`, ... that no problem of this folder has."""
        taken = {path.name.split(".")[0] for path in (self.path / PROBLEMS).glob("task-*")}
        return next(name for number in count(1) if (name := f"task-{number:02d}") not in taken)

    def made_for(self, problem: str) -> tuple[str, ...]:
        """List the plans of a problem, what is known of them, and their runs, relative to the folder."""
        found = [path for place in (PLANS, RUNS) for path in (self.path / place).glob(f"{problem}.*")]
        return tuple(sorted(path.relative_to(self.path).as_posix() for path in found))

    def manifest(self) -> Manifest:
        """Read how the files came about; nothing is known of files that a user put there."""
        path = self.path / MANIFEST
        return read_json(path, Manifest) if path.exists() else Manifest()

    @contextmanager
    def naming_problems(self) -> Iterator[None]:
        """Keep others from making a problem here meanwhile, who would find the same name free."""
        path = self.require(GROUNDING)
        if others := holders(path):
            self.notify(f"waiting for process {others[0]}, which makes a problem here")
        with locked(path):
            yield

    @contextmanager
    def claimed(self, claim: Claim) -> Iterator[None]:
        """Have the folder as some work needs it, until that is done; what is held already is not taken again.

        Raises:
            FolderTaken: If another process has it, and goes on having it for two seconds.
        """
        if claim <= self._claim:
            yield
            return
        held = take(self.path, alone=claim is Claim.ALONE)
        if held is None:
            raise FolderTaken(self.path, holders(self.path))
        try:
            before, self._claim = self._claim, claim
            yield
        finally:
            self._claim = before
            os.close(held)

    def perform(self, stage: Stage, *, again: bool) -> bool:
        """Do a stage's work and record it, unless it is done already.

        Args:
            stage: The stage.
            again: Do it even if its files are up to date.

        Returns:
            Whether there was anything to do.

        Raises:
            FolderTaken: If another process works in the folder that it cannot be shared with.
            CannotWrite: If files cannot be written; those that were there are as they were.
        """
        with self.claimed(stage.claim):
            return self._perform(stage, again=again)

    def _perform(self, stage: Stage, *, again: bool) -> bool:
        self.manifest()  # refuses a damaged one before anything is written
        for name in (*stage.outputs, MANIFEST):
            refuse_other_kinds(self.path / name)
        if not again and self.is_current(stage):
            return False
        self.prepare(*stage.outputs, MANIFEST)
        if remarks := self.outdated(stage.inputs):
            _refuse_damaged(self.path, stage.inputs)
        for remark in remarks:
            self.notify(remark)
        inputs = self._digests(stage.inputs)
        start = perf_counter()
        with Drafts() as drafts:
            stage.work()
            seconds = round(perf_counter() - start, 1)
            with self._recording():
                outputs = self._digests(stage.outputs)
                renewed = self._digests(tuple(f for f in stage.renews if drafts.holds(self.path / f)))
                record = StageRecord(stage.options, inputs, outputs, seconds, versions())
                write_json(self.path / MANIFEST, Manifest({**self._others(renewed), stage.name: record}))
                drafts.put_in_place()
        return True

    def _others(self, renewed: dict[str, str]) -> dict[str, StageRecord]:
        """Return the records of all stages, with the digests of files that were written anew for them."""
        return {
            name: msgspec.structs.replace(
                record, outputs={file: renewed.get(file, made) for file, made in record.outputs.items()}
            )
            for name, record in self.manifest().stages.items()
        }

    def prepare(self, *names: str) -> None:
        """Raise unless files can be written, and remove what killed processes left of theirs.

        Raises:
            InvalidFile: If a folder stands in the place of a file, or a file in that of a folder.
            CannotWrite: If the system does not let them be written.
        """
        for place in ("", PLACES, PROBLEMS, PLANS, RUNS, PICTURES, REPORT_PICTURES, f"{COMPARISONS}/*"):
            for folder in self.path.glob(place) if place else (self.path,):
                remove_leftovers(folder)
        for name in {str(Path(name).parent): name for name in names}.values():
            check_writable(self.path / name)

    @contextmanager
    def _recording(self) -> Iterator[None]:
        """Keep others from recording a stage meanwhile, whose record would be lost."""
        path = self.path / MANIFEST
        write_new(path, msgspec.json.encode(Manifest()))  # so that there is what to lock
        with locked(path):
            yield

    def outdated(self, names: tuple[str, ...]) -> list[str]:
        """Say which of these files were made from others than those that are there now, if any are."""
        remarks = []
        for stage, record in self.manifest().stages.items():
            made = {name: made for name, made in record.outputs.items() if name in names}
            if not made or made != self._digests(tuple(made)):
                continue
            now = self._digests(tuple(record.inputs))
            if changed := [name for name, digested in now.items() if digested != record.inputs[name]]:
                files, others = " and ".join(made), " and ".join(changed)
                command = _command(self.path, stage, next(iter(made)))
                remarks.append(f"{files} came from another {others}; `{command}` makes it anew")
        return remarks

    def is_as_made(self, name: str) -> bool:
        """Say whether a file is as a command wrote it, and was not put there or changed since."""
        made = [record.outputs[name] for record in self.manifest().stages.values() if name in record.outputs]
        return self._digests((name,)).get(name) in made

    def is_current(self, stage: Stage) -> bool:
        """Say whether a stage was done with the files and options that are there now."""
        record = self.manifest().stages.get(stage.name)
        return (
            record is not None
            and record.options == stage.options
            and record.inputs == self._digests(stage.inputs)
            and record.outputs == self._digests(stage.outputs)
        )

    def _digests(self, names: tuple[str, ...]) -> dict[str, str]:
        return digests({name: self.path / name for name in names})


def load_scene(path: Path) -> "Problem":
    """Read a problem of a folder; it is called as its file is, whatever stands in it.

    Raises:
        InvalidFile: If it is no problem, or its name is none that a problem can have.
    """
    from neurosym.problems import Problem

    problem, name = Problem.load(path), path.name.removesuffix(SCENE)
    try:
        return problem if problem.name == name else msgspec.structs.replace(problem, name=name)
    except InvalidValue as error:
        raise InvalidFile(path, str(error).rstrip(".")) from error


def _refuse_damaged(folder: Path, names: tuple[str, ...]) -> None:
    """Raise `InvalidFile` if one of some files that decide most can no longer be read."""
    from neurosym.grounding import Grounding
    from neurosym.worlds.world_file import read_world

    def read_model(path: Path) -> None:
        from neurosym.learning.network import EffectModel

        EffectModel.load(path)

    for name, read in ((WORLD, read_world), (GROUNDING, Grounding.load), (MODEL, read_model)):
        if name in names and (folder / name).is_file():
            read(folder / name)


def _command(folder: Path, stage: str, made: str) -> str:
    """Return what to type to perform a stage once more, which made a file."""
    command, *of = stage.split()
    if (verb := command.partition("-")[0]) in ("explore", "train", "distill"):
        command = verb  # whatever it is aimed at
    typed = f"neurosym {COMMANDS.get(made, command)} {quoted(folder)}"
    if command == "new-problem":
        scene = folder / scene_file(of[0])  # taken over as it is, so that the task stays the same
        return f"{typed} --name {of[0]}" + (f" --scene {quoted(scene)}" if scene.exists() else "")
    return f"{typed} {of[0].split('.')[0]}" if command in ("plan", "execute") else typed
