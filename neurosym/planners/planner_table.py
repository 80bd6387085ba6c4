"""The planners by name: what each is, which encodings it takes, how it is called, and what brings it."""

import dataclasses
import math
from functools import cache, partial
from pathlib import Path

import msgspec

from neurosym.files import read_json
from neurosym.pddl.syntax import FORMER, NUMERIC, SAS, EncodingName
from neurosym.planners.action_counts import plan_counting
from neurosym.planners.bfs import DEPTH, branching_of, plan_bfs, predicted_branching, why_not_deeper
from neurosym.planners.external import (
    LAMA_FIRST,
    PLAN,
    UNSOLVABLE,
    Program,
    Search,
    missing,
    plan_fast_downward,
    plan_program,
)
from neurosym.planners.no_plan import Explanation, explain_clash, explain_no_plan
from neurosym.planners.pddl_search import pddl_planner
from neurosym.planners.planner import ON_PAGE, Planner, PlanResult, PlanStatus, Query
from neurosym.planners.unified_planning import engine_program

ON_NUMBERS = (NUMERIC, *ON_PAGE)
_JAVA = ("java", "a Java runtime of version 17 or later")
_KAIROS = (
    *("{scripts}/kairos", "solve", "{domain}", "{problem}", "--timeout", "{seconds}"),
    *("--no-improvement", "1", "--threads", "1", "--output", "{plan}"),
)
_ENHSP = (
    *("java", "-Xmx1g", "-XX:CompressedClassSpaceSize=64m", "-XX:-UsePerfData"),
    *("-jar", "{package}/ENHSP/enhsp.jar", "-o", "{domain}", "-f", "{problem}"),
    *("-planner", "sat-hadd", "-sp", "{plan}"),
)
_LPG = ("{package}/lpg", "-o", "{domain}", "-f", "{problem}", "-n", "1", "-seed", "1", "-out", "{plan}")
_SYMK = (
    *("{python}", "{package}/symk/fast-downward.py", "--plan-file", "{plan}", "{domain}", "{problem}"),
    *("--search-options", "--search", "sym_bd()"),
)
_BUILD = ("--build", "{package}/builds/release/bin")
_KSTAR = (
    *("{python}", "-B", "-m", "kstar_planner.driver.main", *_BUILD, "{domain}", "{problem}"),
    *("--search", "kstar(lmcut(),k=1,dump_plan_files=true)"),
)
_FORBID_ITERATIVE = (
    *("{python}", "-B", "-m", "forbiditerative.plan", *_BUILD, "--planner", "topk"),
    *("--domain", "{domain}", "--problem", "{problem}", "--number-of-plans", "1"),
    *("--symmetries", "--use-local-folder", "--clean-local-folder"),
)
COARSE = 0.02
"""Edge of the cells for planners that fine grids are too much for [m]."""


def _fast_downward(name: str, about: str, search: str | None = None) -> Planner:
    call = partial(plan_fast_downward, searches=(Search(search),)) if search else plan_fast_downward
    aims = search is None
    return pddl_planner(name, about, call, (SAS, *ON_PAGE), missing=missing, ceiling=math.inf, aims=aims)


def _program(
    name: str,
    about: str,
    program: Program,
    *encodings: EncodingName,
    cell: float = COARSE,
    costs: bool = True,
) -> Planner:
    call = partial(plan_program, program=program)
    return pddl_planner(name, about, call, encodings or ON_PAGE, cell, program.missing, costs=costs)


def _search_breadth_first(query: Query) -> PlanResult:
    """Search over what the network predicts, or where there is none, over what the operators promise."""
    problem, grounding = query.problem, query.grounding
    if query.predict is None:
        table = branching_of(problem, grounding)
    else:
        table = predicted_branching(problem, grounding, query.predict(problem.scene().features))
    result = plan_bfs(problem, table, grounding.table, time_limit=query.time_limit)
    if result.status is not PlanStatus.NOT_FOUND:
        return result
    why = explain_no_plan(problem, grounding, branching=table, depth=result.depth)
    if not why.reason:
        return result
    over = "by what the network predicts, " if query.predict else ""
    deeper = "" if why.is_proved else why_not_deeper(table)
    return _explained(result, Explanation(over + why.reason + deeper, why.is_proved))


def _count_primitives(query: Query) -> PlanResult:
    """Count how often each primitive must be done to each object."""
    problem, grounding = query.problem, query.grounding
    if reason := explain_clash(problem, grounding):
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
    result = plan_counting(problem, grounding, time_limit=query.time_limit)
    if result.status is not PlanStatus.NOT_FOUND:
        return result
    return _explained(result, explain_no_plan(problem, grounding))


def _explained(result: PlanResult, why: Explanation) -> PlanResult:
    """Say why no plan was found, and whether it is proved that there is none."""
    status = PlanStatus.UNSOLVABLE if why.is_proved else result.status
    return dataclasses.replace(result, status=status, reason=why.reason or result.reason)


_SEARCHES = (
    Planner(
        "bfs",
        "the paper's breadth-first search over what the model predicts: 3 primitives, or steps of relations",
        _search_breadth_first,
        reads="network",
        depth=DEPTH,
        ceiling=math.inf,
    ),
    Planner(
        "bfs-operators",
        "the same search over what the operators promise",
        _search_breadth_first,
        depth=DEPTH,
        ceiling=math.inf,
    ),
    Planner(
        "counting",
        "the fewest primitives there can be, by counting how often each is done",
        _count_primitives,
        takes=frozenset({"unit-costs"}),
        is_exact=True,
        ceiling=math.inf,
    ),
)
PROGRAMS = (
    _fast_downward(
        "fast-downward", "Fast Downward: the cheapest plan if 256 MB suffice for it, else LAMA's first"
    ),
    _fast_downward("lama-first", "Fast Downward's LAMA, the first plan it finds", LAMA_FIRST),
    _fast_downward("lmcut", "Fast Downward's A* with landmark cuts: the cheapest plan", "astar(lmcut())"),
    _program(
        "up-fast-downward",
        "Fast Downward through unified-planning, several times slower",
        engine_program("fast-downward", "up_fast_downward"),
    ),
    _program(
        "up-fast-downward-opt",
        "Fast Downward through unified-planning, A* with landmark cuts",
        engine_program("fast-downward-opt", "up_fast_downward"),
    ),
    _program(
        "kairos",
        "Kairos, on numbers or on a grid",
        Program("Kairos", "kairos", _KAIROS, f"{PLAN}*", (10,), distribution="kairos-planner"),
        *ON_NUMBERS,
        cell=0.0,
    ),
    _program(
        "enhsp",
        "ENHSP, on numbers (needs Java)",
        Program("ENHSP", "up_enhsp", _ENHSP, no_plan="nsolvable", needs=_JAVA),
        *ON_NUMBERS,
        cell=0.0,
    ),
    _program(
        "lpg",
        "LPG-td, local search on numbers: soon there, with longer plans",
        Program("LPG", "up_lpg", _LPG, plans=f"{PLAN}*", no_plan="The problem is unsolvable"),
        *ON_NUMBERS,
        cell=0.0,
    ),
    _program(
        "symk",
        "SymK, symbolic search: the cheapest plan on its grid",
        Program("SymK", "up_symk", _SYMK, unsolvable=(*UNSOLVABLE, 12)),
    ),
    _program(
        "kstar",
        "K*, top-k planning: the cheapest plan on its grid",
        Program("K*", "kstar_planner", _KSTAR, plans="found_plans/*.1", unsolvable=(*UNSOLVABLE, 12)),
    ),
    _program(
        "forbid-iterative",
        "Forbid-Iterative, top-k planning",
        Program(
            "Forbid-Iterative",
            "forbiditerative",
            _FORBID_ITERATIVE,
            plans="found_plans/done/*.1",
            no_plan="no solution",
        ),
    ),
    _program(
        "pyperplan",
        "pyperplan, written for teaching",
        engine_program("pyperplan", "up_pyperplan"),
        costs=False,
    ),
    _program("aries", "Aries, by constraint solving", engine_program("aries", "up_aries"), costs=False),
)
PLANNERS: dict[str, Planner] = {planner.name: planner for planner in (*_SEARCHES, *PROGRAMS)}
"""The planners, by the name that the command line knows them by; `register_planner` adds one."""


# What each planner solved of shipped problems, by encoding: measured, and kept in the package.
#
# `make evaluate-planners` writes `track_record.json` from the same run as `docs/results/planners.md`. Each
# planner was given whole problems as they are printed.

FILE = Path(__file__).with_name("track_record.json")


class TrackRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What planners solved.

    Attributes:
        problems: Names of the problems of the shipped domain `tabletop`.
        time_limit: How long a planner had for each [s].
        solved: How many of them each planner solved, by its name and by encoding.
    """

    problems: tuple[str, ...]
    time_limit: float
    solved: dict[str, dict[str, int]]

    def of(self, planner: str) -> str:
        """Say what a planner solved in each encoding, in short; nothing if it was not measured."""
        given = len(self.problems)
        return ", ".join(f"{name} {count}/{given}" for name, count in self.solved.get(planner, {}).items())


@cache
def track_record() -> TrackRecord:
    """Read what planners solved, in the encodings that there are: earlier versions measured others, too."""
    read = read_json(FILE, TrackRecord)
    solved = {
        planner: {encoding: count for encoding, count in counts.items() if encoding not in FORMER}
        for planner, counts in read.solved.items()
    }
    return msgspec.structs.replace(read, solved=solved)
