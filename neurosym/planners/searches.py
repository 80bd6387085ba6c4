"""Our own searches as planners: they read no PDDL, and say why a goal that they miss is out of reach."""

import dataclasses
import math

from neurosym.planners.bfs import DEPTH, plan_bfs, why_not_deeper
from neurosym.planners.branching import branching_of, predicted_branching
from neurosym.planners.counting import plan_counting
from neurosym.planners.no_plan import Explanation, explain_clash, explain_no_plan
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
    if result.status is not PlanStatus.NOT_FOUND:
        return result
    why = explain_no_plan(problem, grounding, branching=table, depth=result.depth)
    if not why.reason:
        return result
    over = "by what the network predicts, " if query.predict else ""
    deeper = "" if why.is_proved else why_not_deeper(table[0])
    return _explained(result, Explanation(over + why.reason + deeper, why.is_proved))


def count_primitives(query: Query) -> PlanResult:
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


SEARCHES = (
    Planner(
        "bfs",
        "the paper's breadth-first search over what the model predicts: 3 primitives, or steps of relations",
        search_breadth_first,
        reads="network",
        depth=DEPTH,
        ceiling=math.inf,
    ),
    Planner(
        "bfs-operators",
        "the same search over what the operators promise",
        search_breadth_first,
        depth=DEPTH,
        ceiling=math.inf,
    ),
    Planner(
        "counting",
        "the fewest primitives there can be, by counting how often each is done",
        count_primitives,
        takes=frozenset({"unit-costs"}),
        is_exact=True,
        ceiling=math.inf,
    ),
)
