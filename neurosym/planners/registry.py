"""Planning by name: ours, those that were registered, and anybody's own as `module:factory`.

What a planner of one's own returns is checked, and only what comes true is believed. Where relations are
asked for, objects stand at places or on and in one another, and nothing is led over cells.
"""

import dataclasses
import math
import sys
from collections.abc import Callable, Iterator
from contextlib import chdir, contextmanager, redirect_stdout
from functools import partial
from io import StringIO
from pathlib import Path

import msgspec

from neurosym.checks import check_callable, check_kind
from neurosym.choices import admit, is_factory, load_factory, one_line, told
from neurosym.errors import InvalidPlanner, InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl.syntax import NUMERIC, SAS, STRIPS, EncodingName
from neurosym.planners.action_counts import plan_counting
from neurosym.planners.bfs import (
    DEPTH,
    branching_of,
    plan_bfs,
    plan_related,
    predicted_branching,
    why_not_deeper,
)
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
from neurosym.planners.no_plan import explain_clash, explain_no_plan
from neurosym.planners.pddl_search import pddl_planner
from neurosym.planners.planner import (
    LONGEST_REASON,
    MET_AT_START,
    ON_PAGE,
    Option,
    Planner,
    PlannerMissing,
    PlanResult,
    PlanStatus,
    PredictEffects,
    Query,
    Tell,
    checked,
    say_nothing,
)
from neurosym.problems import NEAR_TABLE, Problem, check_on_table
from neurosym.tasks.lying import as_planned, lying
from neurosym.tasks.task import is_reached, is_relational, relations_of, understand, why_no_relation
from neurosym.tasks.transition import PlanStep, check_aims, validate

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
COARSE = 0.02
"""Edge of the cells for planners that fine grids are too much for [m]."""


def _fast_downward(name: str, about: str, search: str | None = None) -> Planner:
    call = partial(plan_fast_downward, searches=(Search(search),)) if search else plan_fast_downward
    return pddl_planner(
        name, about, call, (SAS, *ON_PAGE), missing=missing, ceiling=math.inf, aims=search is None
    )


def _called(name: str, about: str, program: Program, *, numbers: bool = False) -> Planner:
    """Return a planner of what takes the page, or numbers too; others begin with a coarse grid."""
    encodings, cell = ((NUMERIC, *ON_PAGE), 0.0) if numbers else (ON_PAGE, COARSE)
    return pddl_planner(name, about, partial(plan_program, program=program), encodings, cell, program.missing)


def _breadth_first(query: Query, *, foresees: bool) -> PlanResult:
    """Search over what the network predicts, or where there is none, over what the operators promise."""
    problem, grounding = query.problem, query.grounding
    if is_relational(problem, grounding):
        if is_reached(problem, grounding):
            return MET_AT_START
        problem = problem if foresees else msgspec.structs.replace(problem, foreseen={})
        if reason := why_no_relation(problem, grounding):
            return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
        return plan_related(problem, grounding, time_limit=query.time_limit)
    if query.predict is None:
        table = branching_of(problem, grounding)
    else:
        table = predicted_branching(problem, grounding, query.predict(problem.scene().features))
    result = plan_bfs(problem, table, grounding.table, time_limit=query.time_limit)
    if result.status is not PlanStatus.NOT_FOUND:
        return result
    why, is_proved = explain_no_plan(problem, grounding, branching=table, depth=result.depth)
    over = "by what the network predicts, " if query.predict else ""
    deeper = "" if is_proved else why_not_deeper(table)
    return _explained(result, why and f"{over}{why}{deeper}", is_proved)


def _count_primitives(query: Query) -> PlanResult:
    """Count how often each primitive must be done to each object."""
    problem, grounding = query.problem, query.grounding
    if reason := explain_clash(problem, grounding):
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
    result = plan_counting(problem, grounding, time_limit=query.time_limit)
    if result.status is not PlanStatus.NOT_FOUND:
        return result
    return _explained(result, *explain_no_plan(problem, grounding))


def _explained(result: PlanResult, why: str, is_proved: bool) -> PlanResult:
    status = PlanStatus.UNSOLVABLE if is_proved else result.status
    return dataclasses.replace(result, status=status, reason=why or result.reason)


_SEARCHES = (
    Planner(
        "bfs",
        "the paper's breadth-first search over what the model predicts: 3 primitives, or steps of relations",
        partial(_breadth_first, foresees=True),
        reads="network",
        depth=DEPTH,
        ceiling=math.inf,
    ),
    Planner(
        "bfs-operators",
        "the same search over what the operators promise",
        partial(_breadth_first, foresees=False),
        depth=DEPTH,
        ceiling=math.inf,
    ),
    Planner(
        "counting",
        "the fewest primitives there can be without places, by counting how often each is done",
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
    _called(
        "kairos",
        "Kairos, on numbers or on a grid",
        Program("Kairos", "kairos", _KAIROS, f"{PLAN}*", (10,), distribution="kairos-planner"),
        numbers=True,
    ),
    _called(
        "enhsp",
        "ENHSP, on numbers (needs Java)",
        Program("ENHSP", "up_enhsp", _ENHSP, no_plan="nsolvable", needs=_JAVA),
        numbers=True,
    ),
    _called(
        "lpg",
        "LPG-td, local search on numbers: soon there, with longer plans",
        Program("LPG", "up_lpg", _LPG, plans=f"{PLAN}*", no_plan="The problem is unsolvable"),
        numbers=True,
    ),
    _called(
        "symk",
        "SymK, symbolic search: the cheapest plan on its grid",
        Program("SymK", "up_symk", _SYMK, unsolvable=(*UNSOLVABLE, 12)),
    ),
)
PLANNERS: dict[str, Planner] = {planner.name: planner for planner in (*_SEARCHES, *PROGRAMS)}
"""The planners, by the name that the command line knows them by; `register_planner` adds one."""
Replanner = Callable[[Problem, Grounding], PlanResult]
"""Plans from where things are now, with what is now believed of them."""
OURS = dict(PLANNERS)
BREADTH_FIRST = ("bfs", "bfs-operators")
"""These search among relations themselves."""


def plan(
    problem: Problem,
    grounding: Grounding,
    planner: str | Planner = "fast-downward",
    *,
    predict: PredictEffects | None = None,
    time_limit: float | None = None,
    encoding: EncodingName | None = None,
    whole: bool = False,
    costs: bool = True,
    work: int | None = None,
    tell: Tell | None = None,
) -> PlanResult:
    """Plan with any planner; finding no plan is a result.

    Args:
        problem: The problem.
        grounding: The learned domain.
        planner: The planner, or its name; see `planner_named`.
        predict: For planners that read the network, what it predicts; what the operators promise, if not
            given.
        time_limit: The user's ceiling [s]; the planner's own if not given, and ours have none.
        encoding: For PDDL planners, the encoding of the domain; the one that the planner does best with, if
            not given.
        whole: For PDDL planners, solve for all objects at once instead of one by one.
        costs: Whether steps cost the more the rarer they keep their promise; otherwise each costs 1.
        work: How much may be looked at in all [states, see `Effort`], for PDDL planners; only each search
            has a budget of its own, if not given.
        tell: Told what is tried, if given.

    Raises:
        UnknownChoice: If there is no such planner, or an object's category is unknown.
        PlannerMissing: If the planner is not installed.
        InvalidPlanner: If it is somebody's own, and fails or returns what is no result.
        InvalidValue: If the planner does not take the encoding or an option, or an object stands farther off
            the table than a push may have left it.
    """
    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    if time_limit is not None:
        check_kind("time_limit", time_limit, int | float, "a time above 0 s")
        if not time_limit > 0:
            raise InvalidValue(f"time_limit = {time_limit} s must be above 0 s.")
    check_kind("work", 0 if work is None else work, int, "a number of states")
    check_callable("tell", tell or say_nothing, "a function of a text")
    if predict is not None:
        check_callable("predict", predict, "a function from features (M, F) to effects (M, P, 3)")
    problem = msgspec.structs.replace(problem, conditions=())  # its goals were chosen for these
    lie, problem = lying(problem, grounding), as_planned(problem, grounding)
    chosen = planner_named(planner) if isinstance(planner, str) else planner
    _check_planner(chosen, "given")
    check_options(chosen, encoding=encoding, whole=whole, costs=costs)
    for item in problem.objects:
        check_on_table(item, grounding.table, off=NEAR_TABLE)
    _check_installed(chosen)
    if unknown := [name for name, operator in lie.items() if operator is None]:
        reason = f"nothing that was learned sets {unknown[0]} upright as and where it lies"
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason)
    raised = tuple(PlanStep(operator.name, name) for name, operator in lie.items() if operator)
    if raised and is_reached(problem, grounding):
        return PlanResult(PlanStatus.SOLVED, raised, 0.0)
    query = Query(
        problem,
        grounding if costs else msgspec.structs.replace(grounding, unit_costs=True),
        predict if chosen.reads == "network" else None,
        chosen.ceiling if time_limit is None else time_limit,
        encoding,
        whole,
        sys.maxsize if work is None else work,
        tell or say_nothing,
    )
    if is_relational(problem, grounding):
        _check_relations(chosen, query)
    result = chosen.solve(query) if OURS.get(chosen.name) is chosen else solve_checked(chosen, query)
    if result.has_plan or result.reason:
        return dataclasses.replace(result, steps=(*raised, *result.steps)) if result.has_plan else result
    ends = {PlanStatus.TIMEOUT: "found no plan in time", PlanStatus.UNSOLVABLE: "says that there is no plan"}
    said = ends.get(result.status, "failed, and does not say why")
    return dataclasses.replace(result, reason=f"{chosen.name} {said}")


def planner_named(name: str, domain_folder: Path | None = None) -> Planner:
    """Return one of `PLANNERS` by its name, or what `module:factory` returns, if that is a planner.

    Where a domain lies, if that is given, there must not be code for it.
    """
    if not is_factory(name):
        if name not in PLANNERS:
            raise UnknownChoice("planner", name, [*PLANNERS, "your own as module:factory"])
        return PLANNERS[name]
    if domain_folder is not None:
        admit(name, domain_folder, InvalidPlanner)
    made = load_factory(name, InvalidPlanner)
    if callable(made) and not isinstance(made, Planner):
        with _guarded(name, "cannot be made", InvalidPlanner):
            made = made()
    _check_planner(made, name)
    if made.name in OURS:
        raise InvalidPlanner(name, f"has the name {made.name!r}, which one of ours has; give it another")
    return made  # type: ignore[no-any-return]


def register_planner(planner: Planner) -> None:
    """Let a planner be called by its name, in this process; on the command line it is `module:factory`.

    A second one of the same name takes the place of the first.

    Raises:
        InvalidPlanner: If it is no `Planner`, or has the name of one of ours.
    """
    _check_planner(planner, repr(planner))
    if planner.name in OURS:
        raise InvalidPlanner(planner.name, "has a name which one of ours has; give it another")
    PLANNERS[planner.name] = planner


def check_options(planner: Planner, *, encoding: EncodingName | None, whole: bool, costs: bool) -> None:
    """Raise `InvalidValue` if a planner does not take the encoding or an option."""
    asked: dict[Option, bool] = {"encoding": encoding is not None, "whole": whole, "unit-costs": not costs}
    for option, is_asked in asked.items():
        if is_asked and option not in planner.takes:
            takers = ", ".join(sorted(other.name for other in PLANNERS.values() if option in other.takes))
            raise InvalidValue(f"The planner {planner.name} does not take {option}; valid with it: {takers}.")
    if planner.program:
        planner.program.encoding_for(planner.name, encoding)


def solve_checked(planner: Planner, query: Query) -> PlanResult:
    """Ask somebody's own planner, and believe of what it returns only what comes true."""
    with _guarded(planner.name, "raises an error in solve", InvalidValue):
        solved = planner.solve(query)
    result = checked(planner.name, solved, PlanResult, "solve")
    try:
        for step in result.steps:
            _look_up(step, query)
    except (UnknownChoice, InvalidValue) as error:
        reason = one_line(f"its plan names what there is not: {error}", LONGEST_REASON)
        return PlanResult(PlanStatus.FAILED, (), result.seconds, reason)
    if result.status is PlanStatus.SOLVED and planner.reads == "operators":
        replay = validate(result.steps, query.problem, query.grounding)
        if not replay.valid:
            reason = f"its plan is not true when replayed: {replay.reason}"
            return PlanResult(PlanStatus.FAILED, (), result.seconds, reason)
    return result


@contextmanager
def _guarded(name: str, fails: str, *passed: type[Exception]) -> Iterator[None]:
    """Name somebody's own planner in its errors; what it prints is dropped, and we stay where we are."""
    try:
        with redirect_stdout(StringIO()), chdir(Path.cwd()):
            yield
    except BaseException as error:
        if isinstance(error, (*passed, KeyboardInterrupt)):
            raise
        raise InvalidPlanner(name, f"{fails}: {told(error)}") from error


def _check_planner(planner: object, name: str) -> None:
    """Raise `InvalidPlanner` unless something is a planner."""
    if not isinstance(planner, Planner):
        kind = type(planner).__name__
        raise InvalidPlanner(
            name, f"is no Planner but of type {kind}; return what neurosym.pddl_planner makes"
        )


def _check_installed(planner: Planner) -> None:
    """Raise `PlannerMissing`, which says what to do, unless a planner is installed."""
    with _guarded(planner.name, "raises an error in missing"):
        remedy = planner.missing()
    if not isinstance(remedy, str):
        raise InvalidPlanner(planner.name, f"gives {remedy!r} from missing; valid: text")
    if remedy:
        raise PlannerMissing(planner.name, remedy)


def _look_up(step: PlanStep, query: Query) -> None:
    """Raise `UnknownChoice` or `InvalidValue` if a step names what there is not."""
    problem, grounding = query.problem, query.grounding
    problem.object_named(step.object)
    check_aims(understand(problem, grounding).flat, grounding, (step,), free=True)


def _check_relations(planner: Planner, query: Query) -> None:
    """Refuse to ask one of our planners for relations that it, or the encoding, does not know."""
    problem = query.problem
    relations_of(query.grounding, problem)
    if query.encoding not in (None, STRIPS):
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, which the encoding {query.encoding} cannot "
            f"say; valid: {STRIPS}."
        )
    takers = {*BREADTH_FIRST, *(one.name for one in (*PLANNERS.values(), planner) if STRIPS in one.encodings)}
    is_own = planner.program is None and OURS.get(planner.name) is not planner
    if planner.name not in takers and not is_own:
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, which {planner.name} does not take; valid: "
            f"{', '.join(sorted(takers))}."
        )
