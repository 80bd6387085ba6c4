"""Planners that are programs of their own, each run on our own PDDL as its authors mean it to be called.

What they are called with is all we know of them: they are run in an empty folder, and what they leave there
as a plan is read by us. Packages from the Python index bring them; none is imported.
"""

import importlib.util
import shutil
import sys
import sysconfig
import time
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from neurosym.planners.planner import PlannerMissing
from neurosym.planners.process import Finished, read_text, run_limited, scratch_folder
from neurosym.planners.result import PlannerAnswer, PlanStatus

PLAN = "plan"
"""The file that programs are asked to write a plan to."""
UNSOLVABLE, OUT_OF_MEMORY = (10, 11), (20, 22)
"""Exit codes of Fast Downward and its descendants."""
_INCOMPLETE, _OUT_OF_TIME = 12, (21, 23, 24)


@dataclass(frozen=True, slots=True)
class Program:
    """How a planner is called, and what its end means.

    Attributes:
        title: What it is called.
        package: The Python package that brings it.
        command: The words of the command; in them, {python}, {scripts} and {package} stand for the
            interpreter, the folder of installed commands and that of the package, {domain}, {problem} and
            {plan} for files, and {seconds} for how long it may take.
        plans: Where it leaves plans, as a pattern; of several, the last is the best.
        unsolvable: Exit codes that mean that there is no plan.
        no_plan: What it prints if there is no plan.
        needs: A command that must be there too, and what brings that.
        distribution: What the package is called in the Python index, if it is not its own name with hyphens.
    """

    title: str
    package: str
    command: Sequence[str]
    plans: str = PLAN
    unsolvable: tuple[int, ...] = ()
    no_plan: str = ""
    needs: tuple[str, str] | None = None
    distribution: str = ""

    def missing(self) -> str:
        """Say what to do about what is not installed, or nothing if everything is."""
        if _folder_of(self.package) is None:
            named = self.distribution or self.package.replace("_", "-")
            return f"`pip install {named}` brings it"
        if self.needs and shutil.which(self.needs[0]) is None:
            return f"it needs {self.needs[0]}, which {self.needs[1]} brings"
        return ""


def plan_program(domain: Path, problem: Path, *, time_limit: float, program: Program) -> PlannerAnswer:
    """Solve a PDDL problem with a program.

    Args:
        domain: File of the domain.
        problem: File of the problem.
        time_limit: When to give up [s].
        program: The program.

    Raises:
        PlannerMissing: If it is not installed.
    """
    begin = time.perf_counter()
    package = _folder_of(program.package)
    if package is None or program.missing():
        raise PlannerMissing(program.title, program.missing())
    with scratch_folder() as folder:
        given = {
            "{python}": sys.executable,
            "{scripts}": sysconfig.get_path("scripts"),
            "{package}": str(package),
            "{domain}": str(domain.resolve()),
            "{problem}": str(problem.resolve()),
            "{plan}": PLAN,
            "{seconds}": f"{max(0.8 * time_limit, 0.1):.1f}",
        }
        command = [_put_in(word, given) for word in program.command]
        finished = run_limited(command, folder, time_limit)
        found = sorted(folder.glob(program.plans), key=lambda path: (len(path.name), path.name))
        text = read_text(found[-1]) if found else ""
    status, reason = PlanStatus.SOLVED, ""
    if "(" not in text:
        status, reason = judged(finished, program.title, program.unsolvable, program.no_plan)
        if status is PlanStatus.SOLVED:
            status, reason = _failed(finished, program.title)
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason)


def _put_in(word: str, given: Mapping[str, str]) -> str:
    for name, value in given.items():
        word = word.replace(name, value)
    return word


def judged(
    finished: Finished, title: str, unsolvable: Container[int] = UNSOLVABLE, no_plan: str = ""
) -> tuple[PlanStatus, str]:
    """Say what the end of a program means; SOLVED if it ended well.

    Args:
        finished: How it ended.
        title: What it is called.
        unsolvable: Exit codes that mean that there is no plan.
        no_plan: What it prints if there is no plan, if it does.
    """
    code = finished.code
    if code is None or code in _OUT_OF_TIME:
        return PlanStatus.TIMEOUT, f"{title} found no plan in time"
    if code in unsolvable or (no_plan and no_plan in finished.output):
        return PlanStatus.UNSOLVABLE, f"{title} says that there is no plan"
    if code == _INCOMPLETE:
        return PlanStatus.NOT_FOUND, f"{title} found no plan; its search does not look at everything"
    if code in OUT_OF_MEMORY:
        remedy = "ask for fewer goals at a time, or for another planner"
        return PlanStatus.NOT_FOUND, f"{title} ran out of memory; {remedy}"
    return (PlanStatus.SOLVED, "") if code == 0 else _failed(finished, title)


def _failed(finished: Finished, title: str) -> tuple[PlanStatus, str]:
    return PlanStatus.FAILED, f"{title} ended with code {finished.code}: {finished.last_words}"


def _folder_of(package: str) -> Path | None:
    """Find the folder of a package without importing it."""
    spec = importlib.util.find_spec(package)
    places = spec.submodule_search_locations if spec else None
    return Path(next(iter(places))) if places else None
