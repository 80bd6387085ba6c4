"""Planners that are programs of their own, each run on our own PDDL as its authors mean it to be called.

What they are called with is all we know of them: they are run in an empty folder, and what they leave there
as a plan is read by us. Packages from the Python index bring them; none is imported.
"""

import importlib.util
import re
import shutil
import sys
import sysconfig
import time
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from neurosym.files import read_bytes
from neurosym.planners.planner import PlannerAnswer, PlannerMissing, PlanStatus
from neurosym.planners.process import MEMORY, Finished, read_text, run_limited, scratch_folder

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


# Fast Downward, the one that the package up-fast-downward brings, on our own SAS+ or PDDL.
#
# Going through unified-planning takes seconds on fine grids, because it makes every ground fluent. Here one
# search runs after another: the cheapest plan if it can be had in little memory (blind A*: our states are
# small, and heuristics cost more than they save), any plan otherwise. PDDL is translated once before.
#
# Fast Downward knows no limit of expansions, but how many states fit into some memory does not depend on
# how busy a machine is. So memory is the budget of a search, and the user's time ends all of them at once.

LAMA_FIRST = (
    "let(hlm,eval_modify_costs(landmark_sum(lm_factory=lm_reasonable_orders_hps(lm_rhw()),pref=false),"
    "cost_type=one),let(hff,eval_modify_costs(ff(),cost_type=one),"
    "lazy_greedy([hff,hlm],preferred=[hff,hlm],cost_type=one,reopen_closed=false)))"
)


@dataclass(frozen=True, slots=True)
class Search:
    """One search of a portfolio.

    Attributes:
        configuration: What Fast Downward calls it; no blanks.
        memory: How much memory it may take [bytes]; the next search begins when it wants more.
        for_task: How much more for each byte of the task that it reads [bytes].
        weight: How many states of blind A* one that it evaluates takes as long as.
    """

    configuration: str
    memory: int = MEMORY
    for_task: int = 0
    weight: int = 15

    def memory_for(self, task: Path) -> int:
        """Return how much memory it may take for a task [bytes]."""
        return min(MEMORY, self.memory + self.for_task * task.stat().st_size)

    def work(self, output: str, memory: int) -> int:
        """Return how much it has looked at [states, see `effort`].

        Where the memory ended it, that is what fits into so much, and no sum of what it said: the last line
        that it writes then may differ.

        Args:
            output: What it wrote.
            memory: How much it was given [bytes].
        """
        evaluated = _EVALUATED.search(output)
        if evaluated:
            return self.weight * int(evaluated[1])
        return max(0, memory - _ITSELF) // (_PER_STATE if self.weight == 1 else _PER_HEAVY)


_EVALUATED = re.compile(r"\] Evaluated (\d+) state")
_ITSELF = 12 * 1024**2
"""How much memory Fast Downward takes before it searches [bytes]."""
_PER_STATE, _PER_HEAVY = 48, 16
"""How much memory without success counts as a state [bytes]: of blind A*; and of others, which are slower."""
_TRANSLATING, _PER_FACT = 50_000, 2
"""As how many states translating a task counts, and how much of it counts as one more [bytes]."""

PORTFOLIO = (Search("astar(blind())", memory=256 * 1024**2, weight=1), Search(LAMA_FIRST))
"""The cheapest plan first: some 10 million states fit; a grid for one object has less than one million."""

FOR_PLACES = (
    Search("astar(blind())", memory=16 * 1024**2, weight=1),
    Search("astar(lmcut())", memory=11 * 1024**2, for_task=7),
    Search(LAMA_FIRST, memory=16 * 1024**2, for_task=12),
)
"""With places there are few steps in a plan, and so many orders of them that more memory seldom helps.

Relations are as places. Four objects fit. With eight, twice the memory took three times as long and was as
seldom enough. Landmark cuts find the cheapest plan with relations, where plans have few steps; states take
them long, so they get little memory. The last search finds plans for thirty objects in hardly more memory
than reading them takes, seven bytes for each of the task; or else it would go on for minutes in vain.
"""

SAS_SUFFIX = ".sas"
_TITLE = "Fast Downward"


def plan_fast_downward(
    domain: Path, problem: Path, *, time_limit: float, searches: Sequence[Search] = ()
) -> PlannerAnswer:
    """Solve a problem with Fast Downward.

    Args:
        domain: File of the domain in PDDL.
        problem: File of the problem in PDDL, or of both in SAS+ (`.sas`), which is not translated.
        time_limit: When to give up [s].
        searches: What to try, one after another; by what the problem needs, if not given.

    Raises:
        PlannerMissing: If up-fast-downward is not installed.
    """
    begin = time.perf_counter()
    programs = _programs()
    if programs is None:
        raise PlannerMissing(_TITLE, missing())
    searches = searches or _usual_searches(problem)
    with scratch_folder() as folder:
        status, reason, text, task, work = PlanStatus.SOLVED, "", "", problem.resolve(), 0
        if problem.suffix != SAS_SUFFIX:
            status, reason = _translate(folder, programs, domain, problem, time_limit)
            task = folder / "output.sas"
            work = _TRANSLATING + (task.stat().st_size // _PER_FACT if task.is_file() else 0)
        if status is PlanStatus.SOLVED:
            left = time_limit - (time.perf_counter() - begin)
            status, reason, text, looked_at = _search(folder, programs / "downward", task, searches, left)
            work += looked_at
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason, work)


def _usual_searches(problem: Path) -> Sequence[Search]:
    """Return what is tried one after another, by what a problem needs."""
    has_places = problem.suffix != SAS_SUFFIX and b" - spot" in read_bytes(problem)
    return FOR_PLACES if has_places else PORTFOLIO


def _translate(
    folder: Path, programs: Path, domain: Path, problem: Path, time_limit: float
) -> tuple[PlanStatus, str]:
    """Turn PDDL into SAS+; SOLVED says that this went well."""
    files = [str(file.resolve()) for file in (domain, problem)]
    command = [sys.executable, "-m", "fast_downward.translate", *files]
    return judged(run_limited(command, folder, time_limit, environment={"PYTHONPATH": str(programs)}), _TITLE)


def _search(
    folder: Path, downward: Path, task: Path, searches: Sequence[Search], time_limit: float
) -> tuple[PlanStatus, str, str, int]:
    """Run searches until one needs no more memory than it may take; the last number is their work."""
    end = time.perf_counter() + time_limit
    plan = folder / "plan"
    status, reason, work = PlanStatus.TIMEOUT, "the time was up before the search", 0
    for search in searches:
        command = [str(downward), "--search", search.configuration, "--internal-plan-file", str(plan)]
        left, memory = end - time.perf_counter(), search.memory_for(task)
        finished = run_limited(command, folder, left, stdin=task, memory=memory)
        work += search.work(finished.output, memory)
        status, reason = judged(finished, _TITLE)
        if finished.code not in OUT_OF_MEMORY:
            break
    text = read_text(plan) if status is PlanStatus.SOLVED else ""
    if status is PlanStatus.SOLVED and not text:
        status, reason = PlanStatus.FAILED, f"{_TITLE} wrote no plan"
    return status, reason, text, work


def missing() -> str:
    """Say what to do if it is not installed, or nothing if it is."""
    return "" if _programs() else "`pip install up-fast-downward` brings it"


def _programs() -> Path | None:
    """Find the folder of the compiled planner without importing unified-planning."""
    spec = importlib.util.find_spec("up_fast_downward")
    places = (spec.submodule_search_locations if spec else None) or []
    folders = (Path(place) / "downward" / "builds" / "release" / "bin" for place in places)
    return next((folder for folder in folders if (folder / "downward").is_file()), None)
