"""Examples: the runs of a domain folder, those first that show most of what plans can do."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import TypeVar

from neurosym.errors import InvalidFile, StageMissing
from neurosym.execution.record import Run
from neurosym.problems import Problem
from neurosym.reading import read_json
from neurosym.stages.folder import DomainFolder, Notify
from neurosym.stages.layout import RECORD, RUNS
from neurosym.stages.planning import load_problem

Record = TypeVar("Record")
ProblemReader = Callable[[str], Problem | None]
MOST_STEPS = 6
"""How many steps an example has at most, so that its pictures fit into a row."""


@dataclass(frozen=True, slots=True)
class Example:
    """A run of a domain folder.

    Attributes:
        path: The file of the run.
        problem: The problem it was to solve.
        run: What became of the plan.
    """

    path: Path
    problem: Problem
    run: Run

    @property
    def name(self) -> str:
        """Name of the plan, the planner's name included."""
        return self.path.name.removesuffix(RECORD)

    @property
    def planner(self) -> str:
        """Name of the planner, if the plan's file was named by it."""
        return self.name.removeprefix(self.problem.name).removeprefix(".") or self.name


def spared(read: Callable[[], Record], notify: Notify) -> Record | None:
    """Read a record; one that is damaged is named in a note, and None."""
    try:
        return read()
    except (InvalidFile, StageMissing) as error:
        notify(f"{str(error).rstrip('.')}; left out")
        return None


def problem_reader(folder: DomainFolder) -> ProblemReader:
    """Return what reads each problem of a folder once; None for one that is damaged or no longer there."""
    known = folder.problem_names()
    return cache(
        lambda name: spared(partial(load_problem, folder, name), folder.notify) if name in known else None
    )


def runs_of(folder: DomainFolder, read_problem: ProblemReader) -> tuple[Example, ...]:
    """Read the runs of a folder, by name, as far as they and their problems can be read."""
    found = []
    for path in sorted((folder / RUNS).glob(f"*{RECORD}")):
        run = spared(partial(read_json, path, Run), folder.notify)
        if run and (problem := read_problem(run.problem)):
            found.append(Example(path, problem, run))
    return tuple(found)


def telling_examples(runs: Sequence[Example]) -> tuple[Example, ...]:
    """Order runs such that those come first that reached their goal, moving more objects in more steps.

    Each problem comes once, and those with one object and with several take turns. Runs without a step, or
    with too many for a row of pictures, are left out.
    """
    shown = [example for example in runs if 1 <= len(example.run.steps) <= MOST_STEPS]
    ordered = sorted(shown, key=_rank)
    first: dict[str, Example] = {}
    for example in ordered:
        first.setdefault(example.problem.name, example)
    groups = [
        [example for example in first.values() if (len(example.problem.objects) == 1) is is_single]
        for is_single in (True, False)
    ]
    longest = max(map(len, groups))
    return tuple(group[index] for index in range(longest) for group in groups if index < len(group))


def _rank(example: Example) -> tuple[bool, int, int, str]:
    steps = example.run.steps
    return not example.run.reached, -len({step.object for step in steps}), -len(steps), example.name
