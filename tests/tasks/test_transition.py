"""Replay: exact displacements, every way that a plan can be impossible, and a task understood once."""

import pytest
import tables
from msgspec.structs import replace
from places import ROOT
from tables import DOWN, LEFT, LIFT, PULL, PUSH, TRAY_LEFT, grounding, item, mode, problem

from neurosym.errors import in_millimetres
from neurosym.execution.record import Run, why_missed
from neurosym.grounding import Grounding
from neurosym.pddl import problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.planners import plan
from neurosym.problems import Problem
from neurosym.tasks import promises, supports, task
from neurosym.tasks.transition import PlanStep, expected_success, validate
from neurosym.world import Table


def test_right_plan_is_valid_and_its_positions_are_exact():
    found = validate([PULL, TRAY_LEFT, PUSH, LIFT], problem(), grounding())
    assert (found.valid, found.reason) == (True, "")
    assert found.positions.shape == (5, 2, 3)
    assert found.positions[-1][0] == pytest.approx([0.4512 + 0.0713 + 0.012, 0.0133 - 0.0124 - 0.021, 0.228])
    assert found.positions[-1][1] == pytest.approx([0.5468, -0.0862, 0.02])
    found = validate([LIFT, DOWN], problem(), grounding())
    assert found.positions[-1][0] == pytest.approx([0.4512 + 0.0141, 0.0133 - 0.0228, 0.025])


@pytest.mark.parametrize(
    ("steps", "reason"),
    [
        ([LIFT, PUSH], "step 2, push-away-001-block item-01: the hand still holds item-01"),
        ([LIFT, PULL], "step 2, pull-010-tray item-02: the hand still holds item-01"),
        ([DOWN], "step 1, put-down-lift-010-block item-01: item-01 is not held by lift-010-block"),
        ([LIFT, DOWN, DOWN], "step 1, put-down-lift-010-block item-01: item-01 is not held"),
        ([LEFT] * 4, "step 4, push-left-000-block item-01: item-01 leaves the table at x = 0.460"),
        ([LIFT], "item-01 ends 73 mm from its goal, 50 mm are allowed"),
        ([], "item-01 ends 222 mm from its goal"),
    ],
)
def test_impossible_plan_says_which_step_and_why(steps: list[PlanStep], reason: str):
    found = validate(steps, problem(), grounding())
    assert not found.valid
    assert found.reason.startswith(reason)


def test_miss_by_less_than_is_printed_does_not_look_allowed():
    assert in_millimetres(0.0503, 0.05) == "50.3 mm"
    assert in_millimetres(0.05004, 0.05) == "50.04 mm"
    assert (in_millimetres(0.0497, 0.05), in_millimetres(0.058, 0.05)) == ("50 mm", "58 mm")
    item = problem().object_named("item-01")
    x, y, z = item.position
    near = replace(problem(), goals={"item-01": (x + 0.0502, y, z)})
    assert validate([], near, grounding()).reason == "item-01 ends 50.2 mm from its goal, 50 mm are allowed"
    run = Run("", (), (), False, {"item-01": 0.0502}, "", ended="plan")
    assert why_missed(run, near, grounding()).startswith("item-01 is 50.2 mm from its goal (50 mm allowed)")


def test_object_must_not_rest_where_another_is():
    behind, front = LEFT, PlanStep("push-left-000-block", "item-02")
    found = validate([behind, front], tables.crossing(), grounding())
    assert found.reason == "step 1, push-left-000-block item-01: item-01 ends where item-02 is"
    assert validate([front, behind], tables.crossing(), grounding()).valid
    above = two((0.512, -0.06), (0.512, -0.021, 0.228))
    assert validate([LIFT], above, grounding()).valid, "a held object may be above another"
    assert "ends where" in validate([LIFT, DOWN], above, grounding()).reason
    overlapping = two((0.5, 0.04), (0.5, 0.0832, 0.025))
    assert validate([LEFT], overlapping, grounding()).valid, "as they are from the start"


def two(spot: tuple[float, float], goal: tuple[float, float, float]) -> Problem:
    """A block with a goal, and another that stands there."""
    return Problem("two", (item("item-01", 0.5, 0.0), item("item-02", *spot)), {"item-01": goal})


def test_object_may_come_to_the_very_edge_and_touch_another_whatever_binary_numbers_make_of_it():
    """0.14 + 0.04 is greater than 0.18 in binary, and 0.09 - 0.04 less than 0.05."""
    learned = tables.with_modes(LEFT.operator, mode((0.0, 0.04, 0.0)))
    small = replace(learned, table=Table(x=(0.3, 0.9), y=(-0.3, 0.18)))
    edge = Problem("edge", (item("item-01", 0.5, 0.14),), {"item-01": (0.5, 0.18, 0.025)}, tolerance=0.01)
    both = (item("item-01", 0.5, 0.0), item("item-02", 0.5, 0.09))
    touching = Problem("touching", both, {"item-01": (0.5, 0.04, 0.025)}, tolerance=0.01)
    assert 0.14 + 0.04 > 0.18
    assert abs(0.04 - 0.09) < 0.05
    for one in (edge, touching):
        assert validate([LEFT], one, small).valid
        assert plan(one, small, "counting").steps == (LEFT,)
        assert plan(one, small, "bfs-operators").steps == (LEFT,)


@pytest.mark.parametrize(("domain", "name"), [("places", "row-4-12"), ("towers", "tower-6-05")])
def test_a_task_is_understood_once(domain: str, name: str, monkeypatch: pytest.MonkeyPatch):
    folder, called = ROOT / "domains" / domain, list[str]()
    problem = Problem.load(folder / "problems" / f"{name}.scene.json")
    grounding = Grounding.load(folder / "grounding.json")
    for module, function in ((task, "goal_spots"), (supports, "describe_pair"), (supports, "nearest_kinds")):
        real = getattr(module, function)
        monkeypatch.setattr(
            module, function, lambda *given, of=function, do=real: called.append(of) or do(*given)
        )
    promises._promised.cache_clear()
    promises.refined.cache_clear()
    found = plan(problem, grounding)
    assert problem_text(problem, grounding, plans=[ground_plan(found.steps, problem, grounding)])
    assert validate(found.steps, problem, grounding).valid
    assert 0 < expected_success(found.steps, problem, grounding) <= 1
    objects, refined = len(problem.objects), promises.refined.cache_info()
    assert called.count("goal_spots") == 1
    assert called.count("describe_pair") in (0, objects * (objects - 1))
    assert called.count("nearest_kinds") <= 1
    every = sum(one.subject == item.category for item in problem.objects for one in grounding.operators)
    assert 0 < refined.hits + refined.misses <= every
