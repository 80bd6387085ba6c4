"""Examples: the runs of a domain folder, those first that show most of what plans can do."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from neurosym.files import read_json
from neurosym.folder import DomainFolder
from neurosym.plan_stages import load_problem
from neurosym.problems import Problem
from neurosym.run_record import Run

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
        return self.path.name.removesuffix(".run.json")

    @property
    def planner(self) -> str:
        """Name of the planner, if the plan's file was named by it."""
        return self.name.removeprefix(self.problem.name).removeprefix(".") or self.name


def runs_of(folder: DomainFolder) -> tuple[Example, ...]:
    """Read the runs of a folder, by name; those of problems that are no longer there are passed over.

    Args:
        folder: The domain folder.

    Raises:
        InvalidFile: If a run or a problem is damaged.
    """
    known = folder.problem_names()
    found = []
    for path in sorted((folder / "runs").glob("*.run.json")):
        run = read_json(path, Run)
        if run.problem in known:
            found.append(Example(path, load_problem(folder, run.problem), run))
    return tuple(found)


def telling_examples(runs: Sequence[Example]) -> tuple[Example, ...]:
    """Order runs such that those come first that reached their goal, moving more objects in more steps.

    Each problem comes once, and those with one object and with several take turns. Runs without a step, or
    with too many for a row of pictures, are left out.

    Args:
        runs: The runs.
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
