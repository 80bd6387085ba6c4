"""Putting the steps of a plan in another order: displacements commute, so the end stays the same.

What changes is where the objects are on the way: one order leads an object off the table or into another, and
the next does not.
"""

from collections.abc import Sequence

from neurosym.pddl.grounding import Grounding, is_lift
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.replay import Replay, replay
from neurosym.problems import Problem

MAX_REPLAYS = 2000
"""How many beginnings of plans are tried."""


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
    if given.possible:
        return tuple(steps), given  # valid, or missing its goal in every order
    blocks = _blocks(steps)
    last = blocks.pop() if ends_held(steps, grounding) else ()
    # Depth first: what has been ordered so far, and the blocks that are left.
    waiting: list[tuple[tuple[PlanStep, ...], list[tuple[PlanStep, ...]]]] = [((), blocks)]
    for _ in range(MAX_REPLAYS):
        if not waiting:
            break
        done, left = waiting.pop()
        ordered = done if left else done + last
        checked = replay(ordered, problem, grounding)
        if checked.valid and not left:
            return ordered, checked
        if checked.possible:
            for index in reversed(range(len(left))):
                waiting.append((done + left[index], left[:index] + left[index + 1 :]))
    return tuple(steps), given


def ends_held(steps: Sequence[PlanStep], grounding: Grounding) -> bool:
    """Say whether a plan ends with an object in the hand."""
    return bool(steps) and not steps[-1].puts_down and is_lift(grounding.operator_named(steps[-1].base))


def _blocks(steps: Sequence[PlanStep]) -> list[tuple[PlanStep, ...]]:
    """Cut a plan before every step that an empty hand begins: a put-down stays with its lift."""
    blocks: list[tuple[PlanStep, ...]] = []
    for step in steps:
        if step.puts_down and blocks:
            blocks[-1] += (step,)
        else:
            blocks.append((step,))
    return blocks
