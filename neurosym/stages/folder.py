"""A domain folder that exists: finding what it holds (`layout`), and performing stages in it."""

from collections.abc import Callable
from itertools import count
from pathlib import Path
from time import perf_counter

from neurosym.errors import FolderNotFound, InvalidValue, StageMissing, UnknownChoice
from neurosym.files import write_json
from neurosym.grounding import Grounding
from neurosym.reading import digest, read_json, refuse_other_kinds
from neurosym.stages.layout import (
    COMMANDS,
    GROUNDING,
    INTERACTIONS,
    MANIFEST,
    NUMERIC,
    PLANS,
    PROBLEMS,
    RUNS,
    SCENE,
    WORLD,
)
from neurosym.stages.manifest import Manifest, Stage, StageRecord, versions
from neurosym.wording import quoted

Notify = Callable[[str], None]
"""Takes a remark, in a sentence without a full stop."""


def _keep_quiet(remark: str) -> None:
    """Pass over a remark."""


class DomainFolder:
    """A domain folder that exists.

    Args:
        path: The folder.
        notify: Called with what a user should know though the work goes on.

    Raises:
        FolderNotFound: If there is none.
    """

    def __init__(self, path: Path, notify: Notify = _keep_quiet):
        if not path.is_dir():
            raise FolderNotFound(path)
        self.path, self.notify = path, notify

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
            command, besides = f"neurosym {COMMANDS[name]} {quoted(self.path)}", ""
            if name == INTERACTIONS:
                besides = ", or a script of yours (docs/data.md)"
            if name == WORLD and self._has_own_data():
                command, besides = f"{command} --world module:factory", " for the world of your data"
            raise StageMissing(path, command, besides)
        return path

    def _has_own_data(self) -> bool:
        return (self.path / INTERACTIONS).exists() and "explore" not in self.manifest().stages

    def problem_names(self) -> tuple[str, ...]:
        """List the problems of this folder: scenes, and PDDL files whose scene is missing."""
        found = [*(self.path / PROBLEMS).glob(f"*{SCENE}"), *(self.path / PROBLEMS).glob("*.pddl")]
        return tuple(sorted({_problem_of(path.name) for path in found}))

    def problem(self, name: str) -> str:
        """Return a problem's name from what a user typed: the name, or the path of its file.

        Raises:
            InvalidValue: If this is no domain folder.
            UnknownChoice: If there is no such problem here.
        """
        stem = _problem_of(Path(name).name)
        known = self.problem_names()
        if stem in known:
            return stem
        if not any((self.path / file).exists() for file in (WORLD, GROUNDING)):
            raise InvalidValue(
                f"{self.path} is no domain folder, it has neither {WORLD} nor {GROUNDING}; name one that has."
            )
        raise UnknownChoice("problem", name, known)

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

    def perform(self, stage: Stage, *, again: bool) -> bool:
        """Do a stage's work and record it, unless it is done already.

        Args:
            stage: The stage.
            again: Do it even if its files are up to date.

        Returns:
            Whether there was anything to do.
        """
        self.manifest()  # refuses a damaged one before anything is written
        for name in (*stage.outputs, MANIFEST):
            refuse_other_kinds(self.path / name)
        if not again and self._is_current(stage):
            return False
        if remarks := self.outdated(stage.inputs):
            self._refuse_damaged(stage.inputs)
        for remark in remarks:
            self.notify(remark)
        inputs = self._digests(stage.inputs)
        start = perf_counter()
        stage.work()
        record = StageRecord(
            options=stage.options,
            inputs=inputs,
            outputs=self._digests(stage.outputs),
            seconds=round(perf_counter() - start, 1),
            versions=versions(),
        )
        write_json(self.path / MANIFEST, Manifest({**self.manifest().stages, stage.name: record}))
        return True

    def outdated(self, names: tuple[str, ...]) -> list[str]:
        """Say which of these files were made from others than those that are there now, if any are.

        Args:
            names: Files, relative to the folder.
        """
        remarks = []
        for stage, record in self.manifest().stages.items():
            made = {name: made for name, made in record.outputs.items() if name in names}
            if not made or made != self._digests(tuple(made)):
                continue
            now = self._digests(tuple(record.inputs))
            if changed := [name for name, digested in now.items() if digested != record.inputs[name]]:
                files, others, command = " and ".join(made), " and ".join(changed), stage.split()[0]
                remarks.append(f"{files} came from another {others}; `neurosym {command}` makes it anew")
        return remarks

    def _is_current(self, stage: Stage) -> bool:
        record = self.manifest().stages.get(stage.name)
        return (
            record is not None
            and record.options == stage.options
            and record.inputs == self._digests(stage.inputs)
            and record.outputs == self._digests(stage.outputs)
        )

    def _refuse_damaged(self, names: tuple[str, ...]) -> None:
        """Raise `InvalidFile` if what decides most can no longer be read."""
        from neurosym.worlds.world_file import read_world

        for name, read in ((WORLD, read_world), (GROUNDING, Grounding.load)):
            if name in names and (self.path / name).is_file():
                read(self.path / name)

    def _digests(self, names: tuple[str, ...]) -> dict[str, str]:
        return {name: digest(self.path / name) for name in names if (self.path / name).is_file()}


def _problem_of(file: str) -> str:
    """Return the name of the problem that a file is of."""
    return file.removesuffix(SCENE).removesuffix(NUMERIC).removesuffix(".pddl")
