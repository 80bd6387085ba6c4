"""The planners by name, behind one call."""

from neurosym.errors import UnknownChoice
from neurosym.pddl.grounding import Grounding
from neurosym.pddl.moves import Encoding
from neurosym.planners.bfs import plan_bfs
from neurosym.planners.branching import Branching, branching_of
from neurosym.planners.counting import plan_counting
from neurosym.planners.result import PlanResult
from neurosym.planners.solve import plan_pddl
from neurosym.problems import Problem

PLANNERS = {
    "bfs": "breadth-first search over the effects that the model predicts, up to 3 primitives (the paper's)",
    "counting": "the fewest primitives there can be, exactly, by counting how often each is done",
    "fast-downward": "Fast Downward on our own PDDL: the cheapest plan if it can be had soon",
    "up-fast-downward": "Fast Downward through unified-planning, several times slower on fine grids",
}
"""What each planner is, by the name that the command line knows it by."""


def plan(
    problem: Problem,
    grounding: Grounding,
    planner: str = "fast-downward",
    *,
    branching: tuple[Branching, tuple[tuple[str, ...], ...]] | None = None,
    time_limit: float = 60.0,
    encoding: Encoding = "stepwise",
) -> PlanResult:
    """Plan with any of `PLANNERS`.

    Args:
        problem: The problem.
        grounding: The learned domain.
        planner: Name of the planner.
        branching: For `bfs`, what each primitive does to each object, and the operators' names; what the
            operators promise, if not given.
        time_limit: When to give up [s].
        encoding: For PDDL planners, the encoding of the domain.

    Raises:
        UnknownChoice: If there is no such planner or encoding, or an object's category is unknown.
        InvalidValue: If an object stands off the table.
    """
    if planner not in PLANNERS:
        raise UnknownChoice("planner", planner, PLANNERS)
    if planner == "bfs":
        table, names = branching or branching_of(problem, grounding)
        return plan_bfs(problem, table, names, grounding.table, time_limit=time_limit)
    if planner == "counting":
        return plan_counting(problem, grounding, time_limit=time_limit)
    return plan_pddl(problem, grounding, planner, time_limit=time_limit, encoding=encoding)
