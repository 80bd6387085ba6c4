"""What a plan is worth: its chance to come true, against normal errors, and its costs."""

import math
import re
from functools import partial

import numpy as np
import pytest
import tables
import toy_domain
from msgspec.structs import replace
from places import ROOT
from tables import LIFT, PULL, PUSH

from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl.compiler import problem_text
from neurosym.planners import plan
from neurosym.planners.pddl_search import _aim
from neurosym.problems import Problem
from neurosym.tasks import transition
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep, expected_success, validate


@pytest.mark.parametrize("tolerance", [0.005, 0.01, 0.02, 0.05])
def test_centred_plane_error_ends_inside_as_rayleigh_says(tolerance: float):
    found = transition.chance_inside(np.zeros(3), np.array([0.01, 0.01, 0.0]), tolerance)
    assert found == pytest.approx(1 - math.exp(-(tolerance**2) / 2e-4), abs=0.02)


def test_error_in_space_ends_inside_more_rarely():
    flat, solid = (
        transition.chance_inside(np.zeros(3), np.array([0.01, 0.01, z]), 0.015) for z in (0.0, 0.01)
    )
    maxwell = math.erf(1.5 / math.sqrt(2)) - math.sqrt(2 / math.pi) * 1.5 * math.exp(-(1.5**2) / 2)
    assert flat > solid == pytest.approx(maxwell, abs=0.03)


def test_the_edge_is_less_likely_than_the_middle_and_certain_without_spread():
    spread = np.array([0.01, 0.01, 0.0])
    chances = [
        transition.chance_inside(np.array([miss, 0.0, 0.0]), spread, 0.05)
        for miss in (0.0, 0.03, 0.049, 0.09)
    ]
    assert chances == sorted(chances, reverse=True)
    assert chances[0] > 0.99
    assert chances[2] == pytest.approx(0.5, abs=0.06)
    assert chances[3] < 0.01
    assert transition.chance_inside(np.array([0.049, 0.0, 0.0]), np.zeros(3), 0.05) == 1.0


def test_spreads_add_up_like_variances_and_a_put_down_belongs_to_its_lift():
    task, learned = tables.problem(), tables.grounding()
    one = transition.spread_of([PULL], task, learned)
    assert transition.spread_of([PULL] * 4, task, learned) == pytest.approx(2 * one)
    in_the_air, down = (transition.spread_of(steps, task, learned) for steps in ([LIFT], [LIFT, tables.DOWN]))
    assert in_the_air[2] > 0 == down[2]


def test_what_is_carried_to_a_place_scatters_as_if_nothing_was_done_to_it_before():
    learned = Grounding.load(ROOT / "domains/places/grounding.json")
    task = Problem.load(ROOT / "domains/places/problems/row-4-12.scene.json")
    carried = next(step for step in plan(task, learned).steps if step.place)
    once = transition.spread_of([carried], task, learned)
    assert once[:2].min() > 0
    assert transition.spread_of([carried] * 3, task, learned).tolist() == once.tolist()


def test_a_second_try_is_as_likely_and_what_is_lost_stays_lost():
    item, lost = tables.item("item-01", 0.45, 0.0), tables.mode((0.5, 0.0, -0.5), kind="lost", count=5)
    rests = tables.mode((0.0713, -0.0124, 0.0), count=15, near=13)
    learned = tables.with_modes(PUSH.operator, rests, lost)
    task = Problem("p", (item,), {"item-01": (0.45 + 0.0713, -0.0124, 0.025)})
    kept = expected_success([tables.PUSH], task, learned)
    again = 1 - kept - lost.share
    assert transition.expected_within([tables.PUSH], task, learned, 3) == pytest.approx(
        kept * (1 + again + again**2)
    )
    assert transition.expected_within([], task, learned, 0) == 1.0
    assert transition.expected_within([tables.PUSH] * 2, task, learned, 1) == 0.0


def test_plan_comes_true_if_all_steps_are_kept_and_all_objects_end_inside():
    learned = tables.grounding()
    item = tables.item("item-01", 0.45, 0.0)
    at, edge = ((0.45 + 0.0713 + off, -0.0124, 0.025) for off in (0.0, 0.0475))
    both = (Problem("p", (item,), {"item-01": goal}) for goal in (at, edge))
    centred, outer = (expected_success([PUSH], one, learned) for one in both)
    assert centred == pytest.approx(19 / 22, abs=1e-6)
    assert outer < 0.8 * centred


def test_chance_of_a_plan_is_the_product_over_its_primitives():
    names = ("lift-000-cube", "put-down-lift-000-cube", "push-left-001-cube")
    steps, asked = [PlanStep(name, "item-01") for name in names], toy_domain.problem({})
    assert expected_success(steps, asked, toy_domain.grounding()) == pytest.approx((21 / 22) ** 2)
    assert expected_success((), asked, toy_domain.grounding()) == 1.0
    lift = tables.grounding().operator_named("lift-010-block")
    assert math.exp(-(cost(lift) - 1) / 100) == pytest.approx(16 / 22, abs=0.005)


@pytest.mark.parametrize("planner", ["counting", "fast-downward"])
def test_without_costs_steps_are_few_rather_than_safe(planner: str):
    """Two safe pushes instead of one lift that fails as often as not."""
    learned = tables.grounding()
    lift = learned.operator_named("lift-010-block")
    rare = replace(
        lift.outcomes[0], near_mean=7, effect=(0.142, -0.02, 0.2), resting_effect=(0.142, -0.02, 0.0)
    )
    risky = tables.with_modes(lift.name, rare)
    cube = tables.item("item-01", 0.45, 0.0)
    away = Problem("p", (cube,), {"item-01": (0.592, -0.02, 0.025)}, tolerance=0.02)
    few = plan(away, risky, planner, costs=False)
    assert [step.operator for step in few.steps] == [lift.name, f"put-down-{lift.name}"]
    if planner == "fast-downward":
        safe = plan(away, risky, planner)
        assert [step.operator for step in safe.steps] == ["push-away-001-block"] * 2
        assert expected_success(safe.steps, away, risky) > expected_success(few.steps, away, risky)
    alike = problem_text(away, replace(risky, unit_costs=True))
    assert re.findall(r"\(= \(cost \S+\) \d+\)", alike) == ["(= (cost cost1) 1)"]


aim = partial(_aim, deadline=math.inf)

FARTHER = PlanStep("push-away-111-block", "item-01")


def learned(cost_of_farther: int) -> Grounding:
    """Add a second push away, 40 mm farther than the first, that keeps its promise so many times of 20."""
    known = tables.grounding()
    mode = tables.mode((0.1113, -0.0124, 0.0), near=cost_of_farther)
    farther = Operator(FARTHER.operator, "00", "111", 20, (mode,))
    table = replace(known.objects, operators=(*known.objects.operators, farther))
    return replace(known, objects=table)


def task(goal: float = 0.45 + 0.1113) -> Problem:
    return Problem("p", (tables.item("item-01", 0.45, 0.0),), {"item-01": (goal, -0.0124, 0.025)}, 0.042)


@pytest.mark.parametrize(
    ("steps", "goal", "cost", "found"),
    [
        ([PUSH], 0.5613, 18, (FARTHER,)),
        ([PUSH], 0.5213, 18, (PUSH,)),  # in the middle already
        ([PUSH], 0.5613, 12, (PUSH,)),  # its rival is dear
        ([], 0.46, 18, ()),
    ],
)
def test_plan_that_ends_at_the_edge_gives_way_to_one_in_the_middle(steps, goal, cost, found):
    assert aim(steps, task(goal), learned(cost)) == found
    chances = [expected_success(one, task(goal), learned(cost)) for one in (found, steps)]
    assert (chances[0] > chances[1]) == (found != tuple(steps))


def test_other_objects_keep_their_steps_and_the_plan_is_valid():
    known = learned(18)
    tray = tables.item("item-02", 0.7, 0.15, category="11")
    goals = {**task().goals, "item-02": (0.7, 0.21, 0.025)}
    both = replace(task(), objects=(*task().objects, tray), goals=goals)
    left = PlanStep("push-left-000-tray", "item-02")
    found = aim([PUSH, left], both, known)
    assert found == (FARTHER, left)
    assert validate(found, both, known).valid


@pytest.mark.parametrize("goal", [0.5, 0.6])
def test_fast_downward_aims_unless_costs_do_not_count(goal: float):
    known = learned(18)
    asked = task(goal)
    found, bare = (plan(asked, known, costs=costs).steps for costs in (True, False))
    assert validate(found, asked, known).valid
    assert expected_success(found, asked, known) >= expected_success(bare, asked, known)
