"""Planning by name: ours, those that were registered, and anybody's own as `module:factory`."""

import dataclasses
import sys
from collections.abc import Callable
from pathlib import Path

import msgspec

from neurosym.checks import check_callable, check_kind
from neurosym.errors import InvalidPlanner, InvalidValue, UnknownChoice
from neurosym.factories import is_factory
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import STRIPS, EncodingName
from neurosym.pddl.grid import check_on_table
from neurosym.planners.by_relations import by_relations
from neurosym.planners.catalogue import PLANNERS
from neurosym.planners.custom import check_installed, check_planner, load_planner, solve_checked
from neurosym.planners.planner import Option, Planner, PredictEffects, Query, Tell
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import NEAR_TABLE, Problem

Replanner = Callable[[Problem, Grounding], PlanResult]
"""Plans from where things are now, with what is now believed of them."""
OURS = dict(PLANNERS)


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
        work: How much may be looked at in all [states, see `effort`], for PDDL planners; only each search
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
    if work is not None:
        check_kind("work", work, int, "a number of states")
    if tell is not None:
        check_callable("tell", tell, "a function of a text")
    if predict is not None:
        check_callable("predict", predict, "a function from features (M, F) to effects (M, P, 3)")
    chosen = planner_named(planner) if isinstance(planner, str) else planner
    check_planner(chosen, "given")
    is_ours = OURS.get(chosen.name) is chosen
    check_options(chosen, encoding=encoding, whole=whole, costs=costs)
    for item in problem.objects:
        check_on_table(item, grounding, off=NEAR_TABLE)
    check_installed(chosen)
    if not costs:
        grounding = msgspec.structs.replace(grounding, unit_costs=True)
    read = predict if chosen.reads == "network" else None
    ceiling = chosen.ceiling if time_limit is None else time_limit
    query = Query(problem, grounding, read, ceiling, encoding, whole, sys.maxsize if work is None else work)
    query = query if tell is None else dataclasses.replace(query, tell=tell)
    takers = tuple(other.name for other in (*PLANNERS.values(), chosen) if reads_relations(other))
    chosen = by_relations(chosen, query, takers, is_ours=is_ours)
    result = chosen.solve(query) if is_ours else solve_checked(chosen, query)
    if result.has_plan or result.reason:
        return result
    return dataclasses.replace(result, reason=_unexplained(chosen, result.status))


def reads_relations(planner: Planner) -> bool:
    """Say whether a planner can be asked for relations in PDDL: it reads what is no grid and no numbers.

    Args:
        planner: The planner.
    """
    return planner.program is not None and STRIPS in planner.program.encodings


def _unexplained(planner: Planner, status: PlanStatus) -> str:
    """Say in a planner's place why it has no plan, where it says nothing."""
    ends = {PlanStatus.TIMEOUT: "found no plan in time", PlanStatus.UNSOLVABLE: "says that there is no plan"}
    return f"{planner.name} {ends.get(status, 'failed, and does not say why')}"


def planner_named(name: str, domain_folder: Path | None = None) -> Planner:
    """Return a planner by its name.

    Args:
        name: One of `PLANNERS`, or `module:factory` for what returns one.
        domain_folder: Where a domain lies, which must not bring code of its own; if there is one.

    Raises:
        UnknownChoice: If there is no such planner.
        InvalidPlanner: If somebody's own is not found, cannot be made, or is no `Planner`.
    """
    if not is_factory(name):
        if name not in PLANNERS:
            raise UnknownChoice("planner", name, [*PLANNERS, "your own as module:factory"])
        return PLANNERS[name]
    return load_planner(name, domain_folder, OURS)


def register_planner(planner: Planner) -> None:
    """Let a planner be called by its name, in this process; on the command line it is `module:factory`.

    A second one of the same name takes the place of the first.

    Raises:
        InvalidPlanner: If it is no `Planner`, or has the name of one of ours.
    """
    check_planner(planner, repr(planner))
    if planner.name in OURS:
        raise InvalidPlanner(planner.name, "has a name which one of ours has; give it another")
    PLANNERS[planner.name] = planner


def check_options(planner: Planner, *, encoding: EncodingName | None, whole: bool, costs: bool) -> None:
    """Refuse options that a planner does not take.

    Args:
        planner: The planner.
        encoding: The encoding asked for, if any.
        whole: Whether it is to solve for all objects at once.
        costs: Whether steps have costs.

    Raises:
        InvalidValue: If it does not take the encoding or an option.
    """
    asked: dict[Option, bool] = {"encoding": encoding is not None, "whole": whole, "unit-costs": not costs}
    for option, is_asked in asked.items():
        if is_asked and option not in planner.takes:
            takers = ", ".join(sorted(other.name for other in PLANNERS.values() if option in other.takes))
            raise InvalidValue(f"The planner {planner.name} does not take {option}; valid with it: {takers}.")
    if planner.program:
        planner.program.encoding_for(planner.name, encoding)
