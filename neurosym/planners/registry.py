"""The planners by name, behind one call."""

import dataclasses

import msgspec

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.moves import Encoding
from neurosym.planners.bfs import DEPTH, plan_bfs
from neurosym.planners.branching import Branching, branching_of
from neurosym.planners.catalogue import PDDL_PLANNERS
from neurosym.planners.counting import plan_counting
from neurosym.planners.no_plan import explain_clash, explain_no_plan
from neurosym.planners.refinement import plan_pddl
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import NEAR_TABLE, Problem

PLANNERS = {
    "bfs": "breadth-first search over the effects that the model predicts, up to 3 primitives (the paper's)",
    "counting": "the fewest primitives there can be, exactly, by counting how often each is done",
    **{name: planner.about for name, planner in PDDL_PLANNERS.items()},
}
"""What each planner is, by the name that the command line knows it by."""

SEARCHES = {"bfs": DEPTH, "counting": None}
"""How many primitives our own planners look ahead."""


def plan(
    problem: Problem,
    grounding: Grounding,
    planner: str = "fast-downward",
    *,
    branching: tuple[Branching, tuple[tuple[str, ...], ...]] | None = None,
    time_limit: float = 60.0,
    encoding: Encoding | None = None,
    whole: bool = False,
    costs: bool = True,
) -> PlanResult:
    """Plan with any of `PLANNERS`.

    Args:
        problem: The problem.
        grounding: The learned domain.
        planner: Name of the planner.
        branching: For `bfs`, what each primitive does to each object, and the operators' names; what the
            operators promise, if not given.
        time_limit: When to give up [s].
        encoding: For PDDL planners, the encoding of the domain; the one that the planner does best with, if
            not given.
        whole: For PDDL planners, solve for all objects at once instead of one by one.
        costs: Whether steps cost the more the rarer they keep their promise; otherwise each costs 1.

    Raises:
        UnknownChoice: If there is no such planner, or it does not take the encoding, or an object's category
            is unknown.
        PlannerMissing: If the planner is not installed.
        InvalidValue: If the planner does not take an option, or an object stands farther off the table than
            a push may have left it.
    """
    check_options(planner, encoding=encoding, whole=whole, costs=costs)
    for item in problem.objects:
        check_on_table(item, grounding, off=NEAR_TABLE)
    if not costs:
        grounding = msgspec.structs.replace(grounding, unit_costs=True)
    if planner not in SEARCHES:
        return plan_pddl(problem, grounding, planner, time_limit=time_limit, encoding=encoding, whole=whole)
    table = branching or branching_of(problem, grounding)
    if planner == "bfs":
        result = plan_bfs(problem, *table, grounding.table, time_limit=time_limit)
    elif reason := explain_clash(problem, grounding):
        result = PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
    else:
        result = plan_counting(problem, grounding, time_limit=time_limit)
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    depth = SEARCHES[planner]
    why = explain_no_plan(problem, grounding, branching=table, depth=depth) or result.reason
    if planner == "bfs" and branching and why != explain_clash(problem, grounding):
        why = f"by what the network predicts, {why}"
    return dataclasses.replace(result, reason=why)


def check_options(planner: str, *, encoding: Encoding | None, whole: bool, costs: bool) -> None:
    """Refuse a planner that there is not, and options that it does not take.

    Args:
        planner: Name of the planner.
        encoding: The encoding asked for, if any.
        whole: Whether it is to solve for all objects at once.
        costs: Whether steps have costs.

    Raises:
        UnknownChoice: If there is no such planner, or it does not take the encoding.
        InvalidValue: If it does not take an option.
    """
    if planner not in PLANNERS:
        raise UnknownChoice("planner", planner, PLANNERS)
    if planner in PDDL_PLANNERS:
        PDDL_PLANNERS[planner].encoding_for(planner, encoding)
        return
    for option, asked, takers in (
        ("encoding", encoding is not None, PDDL_PLANNERS),
        ("whole", whole, PDDL_PLANNERS),
        ("unit-costs", not costs, PLANNERS.keys() - {"bfs"}),
    ):
        if asked and planner not in takers:
            raise InvalidValue(
                f"The planner {planner} does not take {option}; valid with it: {', '.join(sorted(takers))}."
            )
