"""Breadth-first search over relations: the paper's planner (section III-D) for objects that bear one another.

A step puts an object on or into another one, or carries it to a place. What it leads to is what its operator
promises; with which pairs that is likely, a problem says as a network foresees it. Ends that were met before
are not looked at again. Where many objects stand around, sequences of three are too many, so it stops once
`MOST_STEPS` were looked at, possible or not.
"""

import math
from collections.abc import Hashable

from neurosym.grounding import Grounding
from neurosym.planners.effort import check_time, within
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import Task, understand
from neurosym.tasks.transition import State, apply, missed, refusal, start
from neurosym.wording import counted

MOST_STEPS = 60_000
"""How many steps are looked at."""

_Begun = tuple[tuple[PlanStep, ...], State]
"""Steps, and how the objects are after them."""


def plan_relational_bfs(
    problem: Problem, grounding: Grounding, *, time_limit: float = math.inf, most_steps: int = MOST_STEPS
) -> PlanResult:
    """Find a plan with the fewest steps, the first in breadth-first order.

    Args:
        problem: The problem, with the kinds of its pairs, and its goals not met yet.
        grounding: The learned domain.
        time_limit: The user's ceiling [s].
        most_steps: How many steps are looked at.
    """
    task = understand(problem, grounding)
    first, steps = start(task), _steps(task)

    def search(deadline: float) -> PlanResult:
        level: list[_Begun] = [((), first)]
        met, looked, depth = {_key(first)}, 0, 0
        while level:
            found, depth = list[_Begun](), depth + 1
            for before, now in level:
                check_time(deadline)
                for step in steps:
                    looked += 1
                    if refusal(task, now, step):
                        continue
                    then = apply(task, now, step)
                    if _key(then) in met:
                        continue
                    met.add(_key(then))
                    found.append(((*before, step), then))
                    if missed(task, then) is None:
                        return PlanResult(PlanStatus.SOLVED, found[-1][0], 0.0)
                if looked > most_steps:
                    reason = f"{counted(most_steps, 'step')} were looked at, {depth - 1} deep"
                    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, depth - 1)
            level = found
        reason = "no sequence of steps leads there with the places that were drawn"
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, depth)

    return within(time_limit, search)


def _steps(task: Task) -> tuple[PlanStep, ...]:
    """List all steps there are: onto other objects first, in the order of the objects."""
    puts = [PlanStep(put.name, *pair) for pair, found in task.puts.items() for put in found]
    carried = [
        PlanStep(task.carriers[name][0].name, name, place)
        for name in task.names
        if name in task.carriers
        for place in task.places
    ]
    return (*puts, *carried)


def _key(now: State) -> Hashable:
    """Say what tells two ends apart: what bears what, and what stands at which place."""
    borne = ((name, one.by, one.state.symbol) for name, one in now.supports.items())
    return frozenset(borne), frozenset(now.stands.items())
