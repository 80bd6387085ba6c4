"""Our own searches as planners: they read no PDDL, and say why a goal that they miss is out of reach."""

import dataclasses

from neurosym.planners.bfs import DEPTH, plan_bfs
from neurosym.planners.branching import branching_of, predicted_branching
from neurosym.planners.counting import plan_counting
from neurosym.planners.no_plan import explain_clash, explain_no_plan
from neurosym.planners.planner import Planner, Query
from neurosym.planners.result import PlanResult, PlanStatus


def search_breadth_first(query: Query) -> PlanResult:
    """Search over what the network predicts, or where there is none, over what the operators promise."""
    problem, grounding = query.problem, query.grounding
    if query.predict is None:
        table = branching_of(problem, grounding)
    else:
        table = predicted_branching(problem, grounding, query.predict(problem.scene().features))
    result = plan_bfs(problem, *table, grounding.table, time_limit=query.time_limit)
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    why = explain_no_plan(problem, grounding, branching=table, depth=DEPTH) or result.reason
    if query.predict is not None and why != explain_clash(problem, grounding):
        why = f"by what the network predicts, {why}"
    return dataclasses.replace(result, reason=why)


def count_primitives(query: Query) -> PlanResult:
    """Count how often each primitive must be done to each object."""
    problem, grounding = query.problem, query.grounding
    if reason := explain_clash(problem, grounding):
        result = PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
    else:
        result = plan_counting(problem, grounding, time_limit=query.time_limit)
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    return dataclasses.replace(result, reason=explain_no_plan(problem, grounding) or result.reason)


SEARCHES = (
    Planner(
        "bfs",
        "breadth-first search over the effects that the model predicts, up to 3 primitives (the paper's)",
        search_breadth_first,
        reads="network",
        depth=DEPTH,
    ),
    Planner(
        "bfs-operators",
        "the same search over what the operators promise",
        search_breadth_first,
        depth=DEPTH,
    ),
    Planner(
        "counting",
        "the fewest primitives there can be, exactly, by counting how often each is done",
        count_primitives,
        takes=frozenset({"unit-costs"}),
        is_exact=True,
    ),
)
