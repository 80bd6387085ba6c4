"""Putting the steps of a plan in another order: displacements commute, so the end stays the same.

What changes is where the objects are on the way: one order leads an object off the table or into another, and
the next does not. What is left to do says where everything stands, so no set of steps is looked at twice.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from neurosym.pddl.grounding import Grounding, is_lift
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.replay import Replay, footprints_apart, overlapping, replay
from neurosym.problems import Problem

MOST_STATES = 20_000
"""How many beginnings of plans are tried."""
_Block = tuple[PlanStep, ...]
"""A step that an empty hand begins, and the put-down that ends it if it is a lift."""


def mend(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding
) -> tuple[tuple[PlanStep, ...], Replay]:
    """Find an order of the steps in which all are possible, beginning with the one given.

    Args:
        steps: The plan.
        problem: The problem it is for.
        grounding: The learned domain.

    Returns:
        The first order that is possible, or the one given if none is; and its replay.
    """
    given = replay(steps, problem, grounding)
    if given.possible:
        return tuple(steps), given  # valid, or missing its goal in every order
    blocks = _blocks(steps)
    last = blocks.pop() if ends_held(steps, grounding) else ()
    if blocks and (found := _Search(blocks, problem, grounding).run()) is not None:
        ordered = (*found, *last)
        if (checked := replay(ordered, problem, grounding)).possible:
            return ordered, checked
    return tuple(steps), given


def ends_held(steps: Sequence[PlanStep], grounding: Grounding) -> bool:
    """Say whether a plan ends with an object in the hand."""
    return bool(steps) and not steps[-1].puts_down and is_lift(grounding.operator_named(steps[-1].base))


def _blocks(steps: Sequence[PlanStep]) -> list[_Block]:
    """Cut a plan before every step that an empty hand begins: a put-down stays with its lift."""
    blocks: list[_Block] = []
    for step in steps:
        if step.puts_down and blocks:
            blocks[-1] += (step,)
        else:
            blocks.append((step,))
    return blocks


@dataclass(frozen=True, slots=True, eq=False)
class _Effect:
    """What a block does: which object it moves, and by how much after each of its steps [m]."""

    moved: int
    shifts: tuple[Float[np.ndarray, "3"], ...]


class _Search:
    """Depth-first search among the orders of blocks, equal blocks counted."""

    def __init__(self, blocks: Sequence[_Block], problem: Problem, grounding: Grounding) -> None:
        self._kinds = list(dict.fromkeys(blocks))
        self._counts = tuple(blocks.count(kind) for kind in self._kinds)
        self._effects = [_effect(kind, problem, grounding) for kind in self._kinds]
        self._start = problem.scene().positions
        self._room, self._apart = problem.room(grounding.table), footprints_apart(problem)

    def run(self) -> tuple[PlanStep, ...] | None:
        """Return the steps in the first order that is possible, or None if there is none."""
        if self._ends_overlap():
            return None
        seen = {self._counts}
        waiting: list[tuple[tuple[int, ...], tuple[int, ...], Float[np.ndarray, "M 3"]]] = [
            ((), self._counts, self._start)
        ]
        while waiting and len(seen) < MOST_STATES:
            done, left, here = waiting.pop()
            if not any(left):
                return tuple(step for kind in done for step in self._kinds[kind])
            for kind in reversed(range(len(left))):
                fewer = (*left[:kind], left[kind] - 1, *left[kind + 1 :])
                if left[kind] and fewer not in seen and (after := self._after(here, kind)) is not None:
                    seen.add(fewer)
                    waiting.append(((*done, kind), fewer, after))
        return None

    def _ends_overlap(self) -> bool:
        """Say whether an object that is moved ends in another, which no order can help."""
        end = self._start.copy()
        for count, effect in zip(self._counts, self._effects, strict=True):
            end[effect.moved] += count * effect.shifts[-1]
        moved = {effect.moved for effect in self._effects}
        hits = (overlapping(end[one, :2], end[:, :2], self._apart[one]) for one in moved)
        return any(hit.any() for hit in hits)

    def _after(self, here: Float[np.ndarray, "M 3"], kind: int) -> Float[np.ndarray, "M 3"] | None:
        """Return where the objects are after a block, or None if it is impossible."""
        moved, shifts = self._effects[kind].moved, self._effects[kind].shifts
        low, high = self._room[:, moved]
        spots = [here[moved] + shift for shift in shifts]
        if not all(np.all((spot[:2] >= low) & (spot[:2] <= high)) for spot in spots):
            return None
        after = here.copy()
        after[moved] = spots[-1]
        hit = overlapping(after[moved, :2], after[:, :2], self._apart[moved])
        return None if hit.any() else after


def _effect(block: _Block, problem: Problem, grounding: Grounding) -> _Effect:
    operator = grounding.operator_named(block[0].base)
    shifts = [np.array(grounding.displacement(operator))]
    if len(block) > 1:
        shifts.append(shifts[0] + np.array(grounding.put_down_displacement(operator)))
    return _Effect(problem.object_names.index(block[0].object), tuple(shifts))
