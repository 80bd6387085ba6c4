"""Putting the steps of a plan in another order: displacements commute, so the end stays the same.

What changes is where the objects are on the way: one order leads an object off the table or into another, and
the next does not.
"""

import itertools
from collections.abc import Sequence

from neurosym.pddl.grounding import Grounding, is_lift
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.replay import Replay, replay
from neurosym.problems import Problem

MAX_ORDERS = 720


def mend(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding
) -> tuple[tuple[PlanStep, ...], Replay]:
    """Find an order of the steps whose replay is right, beginning with the one given.

    Args:
        steps: The plan.
        problem: The problem it is for.
        grounding: The learned domain.

    Returns:
        The first order that is right, or the one given if none is; and its replay.
    """
    given = replay(steps, problem, grounding)
    if len(given.positions) > len(steps) and not problem.is_met(given.positions[-1]):
        return tuple(steps), given  # all steps are counted, and no order ends anywhere else
    blocks = _blocks(steps)
    last = [blocks.pop()] if ends_held(steps, grounding) else []
    for order in itertools.islice(itertools.permutations(blocks), MAX_ORDERS):
        ordered = tuple(step for block in [*order, *last] for step in block)
        checked = replay(ordered, problem, grounding)
        if checked.valid:
            return ordered, checked
    return tuple(steps), given


def ends_held(steps: Sequence[PlanStep], grounding: Grounding) -> bool:
    """Say whether a plan ends with an object in the hand."""
    return bool(steps) and not steps[-1].puts_down and is_lift(grounding.operator_named(steps[-1].base))


def _blocks(steps: Sequence[PlanStep]) -> list[list[PlanStep]]:
    """Cut a plan before every step that an empty hand begins: a put-down stays with its lift."""
    blocks: list[list[PlanStep]] = []
    for step in steps:
        if step.puts_down and blocks:
            blocks[-1].append(step)
        else:
            blocks.append([step])
    return blocks
