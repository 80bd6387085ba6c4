"""Fast Downward, the one that the package up-fast-downward brings, on our own SAS+ or PDDL.

Going through unified-planning takes seconds on fine grids, because it makes every ground fluent. Here one
search runs after another: the cheapest plan if it can be had in little memory (blind A*: our states are
small, and heuristics cost more than they save), any plan otherwise. PDDL is translated once before.

Fast Downward knows no limit of expansions, but how many states fit into some memory does not depend on how
busy a machine is. So memory is the budget of a search, and the user's time ends all of them at once.
"""

import importlib.util
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from neurosym.planners.planner import PlannerMissing
from neurosym.planners.process import MEMORY, Finished, read_text, run_limited
from neurosym.planners.result import PlannerAnswer, PlanStatus
from neurosym.planners.scratch import scratch_folder

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
    """

    configuration: str
    memory: int = MEMORY


PORTFOLIO = (Search("astar(blind())", memory=256 * 1024**2), Search(LAMA_FIRST))
"""The cheapest plan first: some 10 million states fit; a grid for one object has less than one million."""

FOR_PLACES = (Search("astar(blind())", memory=16 * 1024**2), Search(LAMA_FIRST, memory=256 * 1024**2))
"""With places there are few steps in a plan, and so many orders of them that more memory seldom helps.

Relations are as places. Four objects fit. With eight, twice the memory took three times as long and was as
seldom enough. The second search finds plans for thirty objects in little of its memory, or else would go on
for minutes in vain.
"""

RELATIONS_SUFFIX = ".relational.pddl"
"""What files of problems in the encodings of relations end with."""
PLACES_SUFFIX = ".places.pddl"
"""What files of problems in the encoding `places` end with."""
SAS_SUFFIX = ".sas"
_UNSOLVABLE = (10, 11)
_INCOMPLETE = 12
_OUT_OF_TIME = (21, 23, 24)
_OUT_OF_MEMORY = (20, 22)


def plan_fast_downward(
    domain: Path, problem: Path, *, time_limit: float, searches: Sequence[Search] = ()
) -> PlannerAnswer:
    """Solve a problem with Fast Downward.

    Args:
        domain: File of the domain in PDDL.
        problem: File of the problem in PDDL, or of both in SAS+ (`.sas`), which is not translated.
        time_limit: When to give up [s].
        searches: What to try, one after another; see `usual_searches` for what is tried otherwise.

    Raises:
        PlannerMissing: If up-fast-downward is not installed.
    """
    begin = time.perf_counter()
    programs = _programs()
    searches = searches or usual_searches(problem.name)
    with scratch_folder() as folder:
        status, reason, text, task = PlanStatus.SOLVED, "", "", problem.resolve()
        if problem.suffix != SAS_SUFFIX:
            status, reason = _translate(folder, programs, domain, problem, time_limit)
            task = folder / "output.sas"
        if status is PlanStatus.SOLVED:
            left = time_limit - (time.perf_counter() - begin)
            status, reason, text = _search(folder, programs / "downward", task, searches, left)
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason)


def usual_searches(file: str) -> Sequence[Search]:
    """Return what is tried one after another, by what the encoding of a problem needs.

    Args:
        file: Name of the problem's file.
    """
    return FOR_PLACES if file.endswith((PLACES_SUFFIX, RELATIONS_SUFFIX)) else PORTFOLIO


def _translate(
    folder: Path, programs: Path, domain: Path, problem: Path, time_limit: float
) -> tuple[PlanStatus, str]:
    """Turn PDDL into SAS+; SOLVED says that this went well."""
    files = [str(file.resolve()) for file in (domain, problem)]
    command = [sys.executable, "-m", "fast_downward.translate", *files]
    return _judge(run_limited(command, folder, time_limit, environment={"PYTHONPATH": str(programs)}))


def _search(
    folder: Path, downward: Path, task: Path, searches: Sequence[Search], time_limit: float
) -> tuple[PlanStatus, str, str]:
    """Run searches until one needs no more memory than it may take."""
    end = time.perf_counter() + time_limit
    plan = folder / "plan"
    status, reason = PlanStatus.TIMEOUT, "the time was up before the search"
    for search in searches:
        command = [str(downward), "--search", search.configuration, "--internal-plan-file", str(plan)]
        left = end - time.perf_counter()
        finished = run_limited(command, folder, left, stdin=task, memory=search.memory)
        status, reason = _judge(finished)
        if finished.code not in _OUT_OF_MEMORY:
            break
    if status is PlanStatus.SOLVED:
        text = read_text(plan)
        return (status, "", text) if text else (PlanStatus.FAILED, "Fast Downward wrote no plan", "")
    return status, reason, ""


def _judge(finished: Finished) -> tuple[PlanStatus, str]:
    """Map an exit code; SOLVED also for a translation that went well."""
    if finished.code is None or finished.code in _OUT_OF_TIME:
        return PlanStatus.TIMEOUT, "Fast Downward found no plan in time"
    if finished.code == 0:
        return PlanStatus.SOLVED, ""
    if finished.code in _UNSOLVABLE:
        return PlanStatus.UNSOLVABLE, "Fast Downward proved that there is no plan"
    if finished.code == _INCOMPLETE:
        return PlanStatus.NOT_FOUND, "Fast Downward found no plan; its search does not look at everything"
    if finished.code in _OUT_OF_MEMORY:
        return PlanStatus.NOT_FOUND, "Fast Downward ran out of memory"
    return PlanStatus.FAILED, f"Fast Downward ended with code {finished.code}: {finished.last_words}"


def _programs() -> Path:
    """Find the folder of the compiled planner without importing unified-planning."""
    spec = importlib.util.find_spec("up_fast_downward")
    for place in (spec.submodule_search_locations or []) if spec else []:
        folder = Path(place) / "downward" / "builds" / "release" / "bin"
        if (folder / "downward").is_file():
            return folder
    raise PlannerMissing("Fast Downward", "`pip install up-fast-downward` brings it")
