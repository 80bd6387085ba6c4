"""Putting steps in another order: whoever is in the way goes first, or makes way."""

import msgspec
import toy_domain
from tables import DOWN, LEFT, LIFT, PUSH, crossing, grounding, item, problem

from neurosym.grounding import Grounding
from neurosym.operators import Operator, Vector
from neurosym.planners.plan_order import ends_held, mend
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.transition import PlanStep


def test_steps_are_put_in_an_order_that_is_possible():
    behind, front = LEFT, PlanStep("push-left-000-block", "item-02")
    steps, checked = mend([behind, front], crossing(), grounding())
    assert steps == (front, behind)
    assert checked.valid


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
    task = msgspec.structs.replace(crossing(), goals={"item-02": (0.514, 0.1436, 0.025)})
    steps = [PlanStep(step.operator, "item-02") for step in (LIFT, DOWN, LEFT)]
    assert mend(steps, task, grounding())[0] == tuple(steps)


def test_plan_that_misses_its_goal_is_left_as_it_is():
    steps, checked = mend([LEFT], problem(), grounding())
    assert steps == (LEFT,)
    assert "mm from its goal" in checked.reason


def test_objects_that_change_places_make_way_for_each_other():
    """Neither can go all its way before the other: one must step aside and wait."""
    task = swap()
    steps = [PlanStep("push-left-001-cube", "one")]
    steps += [PlanStep(name, "two") for name in ("push-back-011-cube", "push-right-101-cube")]
    steps += [PlanStep("push-forward-010-cube", "two")]
    ordered, checked = mend(steps, task, four_ways())
    assert checked.valid, checked.reason
    assert sorted(map(str, ordered)) == sorted(map(str, steps))
    assert [step.object for step in ordered].index("one") in (1, 2)


def test_object_that_cannot_get_past_another_is_named():
    wall, free = item("wall", 0.5, 0.0832), item("item-02", 0.7, 0.0)
    goals = {"item-01": (0.4942, 0.1664, 0.025), "item-02": (0.7713, -0.0124, 0.025)}
    task = Problem("p", (item("item-01", 0.5, 0.0), wall, free), goals)
    given = (LEFT, LEFT, PlanStep("push-away-001-block", "item-02"))
    steps, checked = mend(given, task, grounding())
    assert (steps, checked.valid) == (given, False)
    assert checked.reason == "no order of the steps was found that brings item-01 past the others"
    assert checked.concerned == ("item-01",)


def swap() -> Problem:
    items = tuple(
        SceneObject(name, "00", (0.05, 0.05, 0.05, 0.0), (0.5, y, 0.025))
        for name, y in (("one", 0.0), ("two", 0.08))
    )
    return Problem("swap", items, {"one": items[1].position, "two": items[0].position}, tolerance=0.01)


def four_ways() -> Grounding:
    """The toy domain, with pushes back and to the right as well."""
    learned = toy_domain.grounding()
    left = learned.operator_named("push-left-001-cube")
    more = (
        turned(left, "push-right-101-cube", "101", (0.0, -0.08, 0.0)),
        turned(left, "push-back-011-cube", "011", (-0.08, 0.0, 0.0)),
    )
    table = msgspec.structs.replace(learned.operators, operators=(*learned.operators.operators, *more))
    return msgspec.structs.replace(learned, operators=table)


def turned(operator: Operator, name: str, primitive: str, effect: Vector) -> Operator:
    (mode,) = operator.modes
    mode = msgspec.structs.replace(mode, effect=effect, resting_effect=effect)
    return msgspec.structs.replace(operator, name=name, primitive=primitive, modes=(mode,))
