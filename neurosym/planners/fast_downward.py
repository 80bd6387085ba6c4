"""Fast Downward, the one that the package up-fast-downward brings, on our own SAS+ or PDDL.

Going through unified-planning takes seconds on fine grids, because it makes every ground fluent. Here one
search runs after another: the cheapest plan if it can be had soon (blind A*: our states are small, and
heuristics cost more than they save), any plan otherwise. PDDL is translated once before.
"""

import importlib.util
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from neurosym.planners.planner import PlannerMissing
from neurosym.planners.process import Finished, read_text, run_limited
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
        share: How much of the remaining time it may take.
        at_most: How long it may take at most [s].
    """

    configuration: str
    share: float = 1.0
    at_most: float = float("inf")


PORTFOLIO = (
    Search("astar(blind())", share=0.4, at_most=10.0),
    Search("let(hff,ff(),eager_greedy([hff],preferred=[hff]))", share=0.5),
    Search(LAMA_FIRST),
)
"""The cheapest plan first; greedy search and LAMA each solve cases that are too much for the other."""

SAS_SUFFIX = ".sas"
_UNSOLVABLE = (10, 11)
_OUT_OF_TIME = (21, 23, 24)
_OUT_OF_MEMORY = (20, 22)


def plan_fast_downward(
    domain: Path, problem: Path, *, time_limit: float, searches: Sequence[Search] = PORTFOLIO
) -> PlannerAnswer:
    """Solve a problem with Fast Downward.

    Args:
        domain: File of the domain in PDDL.
        problem: File of the problem in PDDL, or of both in SAS+ (`.sas`), which is not translated.
        time_limit: When to give up [s].
        searches: What to try, one after another.

    Raises:
        PlannerMissing: If up-fast-downward is not installed.
    """
    begin = time.perf_counter()
    programs = _programs()
    with scratch_folder() as folder:
        status, reason, text, task = PlanStatus.SOLVED, "", "", problem.resolve()
        if problem.suffix != SAS_SUFFIX:
            status, reason = _translate(folder, programs, domain, problem, time_limit)
            task = folder / "output.sas"
        if status is PlanStatus.SOLVED:
            left = time_limit - (time.perf_counter() - begin)
            status, reason, text = _search(folder, programs / "downward", task, searches, left)
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason)


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
    """Run searches until one finds a plan or proves that there is none."""
    end = time.perf_counter() + time_limit
    status, reason = PlanStatus.TIMEOUT, "the time was up before the search"
    for search in searches:
        left = end - time.perf_counter()
        if left <= 0:
            break
        plan = folder / "plan"
        command = [str(downward), "--search", search.configuration, "--internal-plan-file", str(plan)]
        limit = min(left * search.share, search.at_most)
        status, reason = _judge(run_limited(command, folder, limit, stdin=task))
        if status is PlanStatus.SOLVED:
            text = read_text(plan)
            return (status, "", text) if text else (PlanStatus.FAILED, "Fast Downward wrote no plan", "")
        if status is PlanStatus.UNSOLVABLE:
            break
    return status, reason, ""


def _judge(finished: Finished) -> tuple[PlanStatus, str]:
    """Map an exit code; SOLVED also for a translation that went well."""
    if finished.code is None or finished.code in _OUT_OF_TIME:
        return PlanStatus.TIMEOUT, "Fast Downward found no plan in time"
    if finished.code == 0:
        return PlanStatus.SOLVED, ""
    if finished.code in _UNSOLVABLE:
        return PlanStatus.UNSOLVABLE, "Fast Downward proved that there is no plan"
    if finished.code in _OUT_OF_MEMORY:
        return PlanStatus.FAILED, "Fast Downward ran out of memory"
    return PlanStatus.FAILED, f"Fast Downward ended with code {finished.code}: {finished.last_words}"


def _programs() -> Path:
    """Find the folder of the compiled planner without importing unified-planning."""
    spec = importlib.util.find_spec("up_fast_downward")
    for place in (spec.submodule_search_locations or []) if spec else []:
        folder = Path(place) / "downward" / "builds" / "release" / "bin"
        if (folder / "downward").is_file():
            return folder
    raise PlannerMissing("Fast Downward", "`pip install up-fast-downward` brings it")
