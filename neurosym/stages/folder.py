"""A domain folder that exists: finding what it holds (`layout`), and performing stages in it.

Several processes can work in one folder. What learns takes it for itself; what plans and executes shares it
with its like. A stage's files are replaced together when it is done, and the manifest with them.
"""

import os
import platform
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from enum import IntEnum
from itertools import count
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any, TypeVar

import msgspec

from neurosym.errors import (
    FolderNotFound,
    FolderTaken,
    InvalidValue,
    StageMissing,
    UnknownChoice,
    blaming,
    quoted,
    version_of,
)
from neurosym.files import (
    MOST_DATA,
    Drafts,
    check_writable,
    digests,
    holders,
    locked,
    make_folder,
    read_bytes,
    read_json,
    refuse_other_kinds,
    remove,
    remove_leftovers,
    retake,
    take,
    write_atomically,
    write_json,
    write_new,
)
from neurosym.stages import layout

if TYPE_CHECKING:
    from neurosym.learning.network import EffectModel
    from neurosym.problems import Problem


class StageRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the files of one stage came about."""

    options: dict[str, Any]  # what the stage was asked for
    inputs: dict[str, str]  # SHA-256 of each file it read, by name
    outputs: dict[str, str]  # SHA-256 of each file it wrote, by name
    seconds: float  # how long it took, in the last session that worked on it [s]
    versions: dict[str, str]  # versions of Python and of the packages that decide the outcome


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
    """One step of the way: what it reads, what it writes, and the work itself."""

    name: str  # the command's name, with the problem's where there is one
    inputs: tuple[str, ...]  # files it reads, relative to the folder
    outputs: tuple[str, ...]  # files it writes, relative to the folder
    work: Callable[[], None]  # does the work
    options: dict[str, Any] = field(default_factory=dict)  # what decides the outcome beside the inputs
    claim: Claim = Claim.SHARED  # how it has the folder meanwhile
    # files of other stages that it may write anew; they still count as made by those
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


_T = TypeVar("_T")
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
        self._claim, self._held = Claim.NONE, -1

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
            command, besides = f"neurosym {layout.COMMANDS[path.name]} {quoted(self.path)}", ""
            if name == layout.INTERACTIONS:
                besides = ", or a script of yours (docs/data.md)"
            has_data = (self.path / layout.INTERACTIONS).exists() and "explore" not in self.manifest().stages
            if name == layout.WORLD and has_data:
                command, besides = f"{command} --world module:factory", " for the world of your data"
            raise StageMissing(path, command, besides)
        return path

    def found(self, name: str, load: Callable[[Path], _T]) -> _T | None:
        """Return what a file holds; None if it is not there."""
        return load(self.path / name) if (self.path / name).is_file() else None

    def there(self, *names: str) -> tuple[str, ...]:
        """Name those of some files that are there."""
        return tuple(name for name in names if (self.path / name).exists())

    def network(self) -> "EffectModel":
        """Read the network whose bits are the symbols; what it needs takes seconds to import."""
        from neurosym.learning.network import EffectModel

        return EffectModel.load(self.require(layout.MODEL))

    def problem_names(self) -> tuple[str, ...]:
        """List the problems of this folder: scenes, and PDDL files whose scene is missing."""
        place = self.path / layout.PROBLEMS
        found = (*place.glob(f"*{layout.SCENE}"), *place.glob("*.pddl"))
        return tuple(sorted({layout.problem_of(path.name) for path in found}))

    def problem(self, name: str) -> str:
        """Return a problem's name from what a user typed: the name, or the path of its file.

        Raises:
            InvalidValue: If this is no domain folder.
            UnknownChoice: If there is no such problem here.
        """
        stem, known = layout.problem_of(Path(name).name), self.problem_names()
        is_file = os.path.isfile(name)  # noqa: PTH113 (no error for names that are too long)
        is_foreign = is_file and not Path(name).resolve().is_relative_to(self.path.resolve())
        if stem in known and not (is_foreign and name.endswith(layout.SCENE)):
            return stem
        either = layout.WORLD, layout.GROUNDING
        if not any((self.path / file).exists() for file in either):
            has = f"it has neither {' nor '.join(either)}"
            raise InvalidValue(f"{self.path} is no domain folder, {has}; name one that has.")
        if name.endswith(".json") and is_foreign:
            command = f"neurosym new-problem {quoted(self.path)} --scene {quoted(name)}"
            there = f" --name {own}" if (own := stem.removesuffix(".json")) in known else ""
            raise InvalidValue(f"{name} lies outside of {self.path}; take it over with: {command}{there}")
        raise UnknownChoice("problem", name, known, str(self.path / layout.PROBLEMS))

    def free_problem_name(self) -> str:
        """Return the first of `task-01`, `task-02`, ... that no problem of this folder has."""
        taken = {path.name.split(".")[0] for path in (self.path / layout.PROBLEMS).glob("task-*")}
        return next(name for number in count(1) if (name := f"task-{number:02d}") not in taken)

    def manifest(self) -> Manifest:
        """Read how the files came about; nothing is known of files that a user put there."""
        path = self.path / layout.MANIFEST
        return read_json(path, Manifest) if path.exists() else Manifest()

    def naming_problems(self) -> AbstractContextManager[None]:
        """Keep others from making a problem here meanwhile, who would find the same name free."""
        return locked(self.require(layout.GROUNDING))

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
            before = self._claim, self._held
            self._claim, self._held = claim, held
            yield
        finally:
            self._claim, self._held = before
            os.close(held)

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Have a folder that is shared for oneself, as soon as those who share it have ended."""
        if not retake(self._held, alone=True, wait=False):
            numbers = ", ".join(str(one) for one in holders(self.path) if one != os.getpid())
            self.notify(f"waiting for others who work in {self.path} (process {numbers or 'unknown'})")
            retake(self._held, alone=True)
        try:
            self._claim = Claim.ALONE
            yield
        finally:
            self._claim = Claim.SHARED
            retake(self._held, alone=False)

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
            self.manifest()  # refuses a damaged one before anything is written
            for name in (*stage.outputs, layout.MANIFEST):
                refuse_other_kinds(self.path / name)
            if not again and self.is_current(stage):
                return False
            self._prepare(*stage.outputs, layout.MANIFEST)
            for remark in self.outdated(stage.inputs):
                self.notify(remark)
            inputs, start = self._digests(stage.inputs), perf_counter()
            with Drafts() as drafts:
                stage.work()
                self._record(stage, inputs, round(perf_counter() - start, 1), drafts)
        return True

    def _prepare(self, *names: str) -> None:
        """Raise unless files can be written, and remove what killed processes left of theirs."""
        for place in ("", *layout.FOLDERS):
            for folder in self.path.glob(place) if place else (self.path,):
                remove_leftovers(folder)
        for name in {str(Path(name).parent): name for name in names}.values():
            check_writable(self.path / name)

    def _record(self, stage: Stage, inputs: dict[str, str], seconds: float, drafts: Drafts) -> None:
        """Put what a stage wrote in place, with a manifest that tells of it.

        Records of other stages get the digests of what was written anew for them, and this one those that no
        other has. Nobody else records a stage meanwhile, whose record would be lost.
        """
        path = self.path / layout.MANIFEST
        write_new(path, msgspec.json.encode(Manifest()))  # so that there is what to lock
        with locked(path):
            renewed = self._digests(tuple(name for name in stage.renews if drafts.holds(self.path / name)))
            stages = {
                name: msgspec.structs.replace(
                    one, outputs={file: renewed.get(file, made) for file, made in one.outputs.items()}
                )
                for name, one in self.manifest().stages.items()
            }
            others = {file for name, one in stages.items() if name != stage.name for file in one.outputs}
            own = {file: made for file, made in renewed.items() if file not in others}
            outputs = self._digests(stage.outputs) | own
            stages[stage.name] = StageRecord(stage.options, inputs, outputs, seconds, versions())
            write_json(path, Manifest(stages))
            drafts.put_in_place()

    def take_over(self, other: "DomainFolder", names: Iterable[str]) -> None:
        """Put files of another folder in the place of those here, together, and what is known of its stages.

        Args:
            other: The other folder.
            names: Which files; those that it does not have are removed.

        Raises:
            CannotWrite: If they cannot be written; those that were there are as they were.
        """
        mine, path = self._digests(names := tuple(names)), self.path / layout.MANIFEST
        theirs, stages = other._digests(names), other.manifest().stages
        made = {stage: one for stage, one in stages.items() if one.outputs.keys() & set(names)}
        with Drafts() as drafts:
            for name in names:
                if name in theirs and theirs[name] != mine.get(name):
                    make_folder((self.path / name).parent)
                    write_atomically(self.path / name, read_bytes(other.path / name, MOST_DATA))
                elif name in mine and name not in theirs:
                    remove(self.path / name)
            write_new(path, msgspec.json.encode(Manifest()))
            with locked(path):
                known = self.manifest()
                if known != (whole := Manifest(known.stages | made)):
                    write_json(path, whole)
                drafts.put_in_place()

    def outdated(self, names: tuple[str, ...]) -> list[str]:
        """Say which of these files were made from others than those that are there now, if any are."""
        remarks = []
        for stage, record in self.manifest().stages.items():
            made = {name: made for name, made in record.outputs.items() if name in names}
            if not made or made != self._digests(tuple(made)):
                continue
            now, said = self._digests(tuple(record.inputs)), list[str]()
            if changed := [name for name, digested in now.items() if digested != record.inputs[name]]:
                said.append(f"from another {' and '.join(changed)}")
            forgotten = [name for name in record.inputs if name not in now and name.startswith(layout.PASTS)]
            if forgotten:
                said.append(f"from {' and '.join(forgotten)}, which was forgotten")
            if said:
                command = _command(self.path, stage, next(iter(made)))
                came = f"{' and '.join(made)} came {' and '.join(said)}"
                remarks.append(f"{came}; `{command}` makes it anew")
        return remarks

    def outdated_file(self, path: Path) -> list[str]:
        """Say the same of a file, wherever it lies; nothing is said of one that lies elsewhere."""
        inside, home = path.resolve(), self.path.resolve()
        return self.outdated((inside.relative_to(home).as_posix(),)) if inside.is_relative_to(home) else []

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
            and {file: made for file, made in record.outputs.items() if file not in stage.renews}
            == self._digests(stage.outputs)
        )

    def _digests(self, names: tuple[str, ...]) -> dict[str, str]:
        return digests({name: self.path / name for name in names})


def load_scene(path: Path) -> "Problem":
    """Read a problem of a folder; it is called as its file is, whatever stands in it.

    Raises:
        InvalidFile: If it is no problem, or its name is none that a problem can have.
    """
    from neurosym.problems import Problem

    problem, name = Problem.load(path), path.name.removesuffix(layout.SCENE)
    with blaming(path):
        return problem if problem.name == name else msgspec.structs.replace(problem, name=name)


def _command(folder: Path, stage: str, made: str) -> str:
    """Return what to type to perform a stage once more, which made a file."""
    command, *of = stage.split()
    if (verb := command.partition("-")[0]) in ("explore", "train", "distill"):
        command = verb  # whatever it is aimed at
    typed = f"neurosym {layout.COMMANDS.get(made, command)} {quoted(folder)}"
    if command == "new-problem":
        scene = folder / layout.scene_file(of[0])  # taken over as it is, so that the task stays the same
        return f"{typed} --name {of[0]}" + (f" --scene {quoted(scene)}" if scene.exists() else "")
    return f"{typed} {of[0].split('.')[0]}" if command in ("plan", "execute") else typed
