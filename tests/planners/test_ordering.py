"""Putting steps in another order: whoever is in the way goes first, or makes way."""

import pytest
from msgspec.structs import replace
from tables import DOWN, LEFT, LIFT, PUSH, crossing, grounding, item, problem

from neurosym.planners.action_counts import ends_held, mend
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep, validate


def test_long_row_is_moved_from_its_front():
    """Eight blocks in a row, named from behind: only one of the 40320 orders is possible."""
    row = tuple(item(f"item-{n}", 0.35 + 0.06 * n, 0.0) for n in range(8))
    goals = {thing.name: (thing.position[0] + 0.0713, -0.0124, 0.025) for thing in row}
    steps = [PlanStep("push-away-001-block", thing.name) for thing in row]
    ordered, checked = mend(steps, Problem("row", row, goals), grounding())
    assert checked.valid, checked.reason
    assert list(ordered) == steps[::-1]


def test_put_down_stays_with_its_lift_and_a_held_object_comes_last():
    assert ends_held([PUSH, LIFT], grounding())
    assert not ends_held([LIFT, DOWN], grounding())
    task = replace(crossing(), goals={"item-02": (0.514, 0.1436, 0.025)})
    steps = [PlanStep(step.operator, "item-02") for step in (LIFT, DOWN, LEFT)]
    assert mend(steps, task, grounding())[0] == tuple(steps)
    steps, checked = mend([LEFT], problem(), grounding())
    assert steps == (LEFT,)
    assert "mm from its goal" in checked.reason


def of(name: str, *steps: PlanStep) -> tuple[PlanStep, ...]:
    return tuple(PlanStep(step.operator, name) for step in steps)


TWO = (item("item-01", 0.5, 0.0), item("item-02", 0.5, 0.0832))


@pytest.mark.parametrize(
    ("steps", "concerned"),
    [
        (of("item-02", LEFT), ()),
        (of("item-01", LEFT), ("item-01", "item-02")),  # where the other is
        ((*of("item-02", LIFT), *of("item-01", PUSH)), ("item-01", "item-02")),  # which is still held
        (of("item-01", *[LEFT] * 6), ("item-01", "item-02")),
        (of("item-02", *[LEFT] * 6), ("item-02",)),  # off the table
        (of("item-02", DOWN), ("item-02",)),
        ((), ("item-02",)),  # far from its goal
    ],
)
def test_replay_names_whom_its_reason_concerns(steps: tuple[PlanStep, ...], concerned: tuple[str, ...]):
    task = Problem("p", TWO, {"item-02": (0.5, 0.1664, 0.025)})
    assert validate(steps, task, grounding()).concerned == concerned
