"""Aiming at the middle: of plans that cost nearly the same, take the one likeliest to end inside its goals.

A planner is content with any end in the goal ball, and small errors push what ends at its edge out of it. So
for each object other ways to its goal are listed that cost little more (see `count_vectors`), and judged by
how likely they end inside, by the spreads that operators promise (see `chances`).
"""

import math
from collections.abc import Sequence

import msgspec

from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.pddl.chances import expected_success
from neurosym.planners.branching import branching_of
from neurosym.planners.count_vectors import Candidate, candidates
from neurosym.planners.effort import Effort
from neurosym.planners.joins import choices_of
from neurosym.planners.ordering import ends_held
from neurosym.problems import Problem
from neurosym.promises import promised
from neurosym.tasks.moves import PUT_DOWN, step_cost
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import operator_for, validate

DEARER = 1.1
"""What a way may cost beside the plan's own."""
LONGER = 1
"""How many primitives more it may have."""
WORK = 3000
"""How many ways of an object are judged."""
_TRIED = 3  # of the likeliest ways of an object are put into the plan, until one fits


def aim(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, deadline: float = math.inf
) -> tuple[PlanStep, ...]:
    """Return a plan that costs little more and is likelier to come true, or else the plan.

    Args:
        steps: A valid plan.
        problem: The problem it is for.
        grounding: The learned domain.
        deadline: When the user's time is up, by `time.perf_counter()` [s].

    Raises:
        TimeIsUp: If the deadline passes.
    """
    best = tuple(steps)
    likely = expected_success(best, problem, grounding)
    for name in problem.goals:
        own = [step for step in best if step.object == name]
        others = [step for step in best if step.object != name]
        if not own or ends_held(others, grounding):
            continue
        for way in _ways(own, problem, grounding, Effort(WORK, deadline)):
            place = len(others) if ends_held(way, grounding) else best.index(own[0])
            joined = (*others[:place], *way, *others[place:])
            if not validate(joined, problem, grounding).valid:
                continue  # others are in the way
            if (found := expected_success(joined, problem, grounding)) > likely:
                best, likely = joined, found
                break
    return best


def _ways(
    own: Sequence[PlanStep], problem: Problem, grounding: Grounding, effort: Effort
) -> list[tuple[PlanStep, ...]]:
    """List the likeliest ways to bring an object to its goal that cost little more than its own steps."""
    item = problem.object_named(own[0].object)
    goal, tolerance = problem.goals[item.name], problem.tolerance
    alone = msgspec.structs.replace(problem, objects=(item,), goals={item.name: goal})
    branching, names = branching_of(alone, grounding)
    (choices,) = choices_of(alone, branching, grounding, names)
    promises = promised(grounding, item)
    operators = [promises[names[0][column]] for column in branching.usable(0)]
    made = [operator_for(step, problem, grounding) for step in own if not step.puts_down]
    most = DEARER * sum(step_cost(operator, grounding) for operator in made)
    near = candidates(choices, goal, tolerance, effort, moves=len(made) + LONGER, cost=most)
    ways = {
        steps: expected_success(steps, alone, grounding)
        for steps in (_steps(one, item.name, operators) for one in near)
    }
    return sorted(ways, key=lambda steps: -ways[steps])[:_TRIED]


def _steps(way: Candidate, name: str, operators: Sequence[Operator]) -> tuple[PlanStep, ...]:
    """Write a way as steps, each lift with its put-down unless it ends held."""
    steps: list[PlanStep] = []
    for move in way.moves:
        steps.append(PlanStep(operators[move].name, name))
        if is_lift(operators[move]):
            steps.append(PlanStep(PUT_DOWN + operators[move].name, name))
    return tuple(steps[:-1] if way.held else steps)
