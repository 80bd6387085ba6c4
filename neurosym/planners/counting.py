"""The exact planner: the fewest steps there can be, by counting instead of searching.

Objects do not interact but by standing in each other's way, and where one comes to rest depends only on how
often each primitive was done to it (see `count_vectors`). So the shortest ways to move each object are
listed and joined (see `joins`), and put in an order that works. The first that fits has provably the fewest
primitives, and costs the least among those. Where none is found, that proves nothing, and what was looked at
is said.
"""

import math

from neurosym.grounding import Grounding
from neurosym.planners.effort import PLACE, Effort, within
from neurosym.planners.joins import Join
from neurosym.planners.ordering import mend
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem

MOST_WORK = 200_000
"""How many candidates, ways to join them and beginnings of plans are looked at; some tens of seconds."""


def plan_counting(
    problem: Problem, grounding: Grounding, *, time_limit: float = math.inf, work: int = MOST_WORK
) -> PlanResult:
    """Find a plan with the fewest primitives, and among those the cheapest.

    Args:
        problem: The problem.
        grounding: The learned domain.
        time_limit: The user's ceiling [s].
        work: How much is looked at.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """

    def search(deadline: float) -> PlanResult:
        join = Join(problem, grounding, Effort(work, deadline))
        for steps in join.plans():
            ordered, checked = mend(steps, problem, grounding, join.effort)
            if checked.valid:
                return PlanResult(PlanStatus.SOLVED, ordered, 0.0, work=PLACE * join.effort.spent)
            join.missed = checked.reason
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, join.why_none(), work=PLACE * join.effort.spent)

    return within(time_limit, search)


def fewest_steps(problem: Problem, grounding: Grounding) -> int | None:
    """Return the fewest primitives that can solve a problem, put-downs not counted; None if none are found.

    Each object stays on the table, and at most one ends held. No plan that replays well has fewer; where
    objects stand in each other's way it may need more.

    Args:
        problem: The problem.
        grounding: The learned domain.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    join = Join(problem, grounding, Effort(MOST_WORK))
    saved, total = [0], 0
    must_be_held = 0
    for name in problem.goals:
        free, resting = join.candidate(name, False, 0), join.candidate(name, True, 0)
        if free is None:
            return None
        if resting is None:
            must_be_held += 1
            total += len(free.moves)
        else:
            total += len(resting.moves)
            saved.append(len(resting.moves) - len(free.moves))
    if must_be_held > 1:
        return None
    return total - (0 if must_be_held else max(saved))
