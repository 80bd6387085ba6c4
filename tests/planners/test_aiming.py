"""Aiming: among plans of about the same cost, the likeliest to end inside the goal."""

import math
from functools import partial

import msgspec
import pytest
import tables
from tables import PUSH

from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.planners import plan
from neurosym.planners.pddl_search import _aim
from neurosym.problems import Problem
from neurosym.tasks.chances import expected_success
from neurosym.tasks.transition import PlanStep, validate

aim = partial(_aim, deadline=math.inf)

FARTHER = PlanStep("push-away-111-block", "item-01")


def learned(cost_of_farther: int) -> Grounding:
    """Add a second push away, 40 mm farther than the first, that keeps its promise so many times of 20."""
    known = tables.grounding()
    mode = tables.mode((0.1113, -0.0124, 0.0), near=cost_of_farther)
    farther = Operator(FARTHER.operator, "00", "111", 20, (mode,))
    table = msgspec.structs.replace(known.operators, operators=(*known.operators.operators, farther))
    return msgspec.structs.replace(known, operators=table)


def task(goal: float = 0.45 + 0.1113) -> Problem:
    return Problem("p", (tables.item("item-01", 0.45, 0.0),), {"item-01": (goal, -0.0124, 0.025)}, 0.042)


def test_plan_that_ends_at_the_edge_gives_way_to_one_in_the_middle():
    known = learned(18)
    found = aim([PUSH], task(), known)
    assert found == (FARTHER,)
    assert expected_success(found, task(), known) > expected_success([PUSH], task(), known)


def test_plan_in_the_middle_stays_and_so_does_one_whose_rivals_are_dear():
    assert aim([PUSH], task(0.45 + 0.0713), learned(18)) == (PUSH,)
    assert aim([PUSH], task(), learned(12)) == (PUSH,)


def test_other_objects_keep_their_steps_and_the_plan_is_valid():
    known = learned(18)
    tray = tables.item("item-02", 0.7, 0.15, category="11")
    both = msgspec.structs.replace(
        task(),
        objects=(*task().objects, tray),
        goals={**task().goals, "item-02": (0.7, 0.21, 0.025)},
    )
    left = PlanStep("push-left-000-tray", "item-02")
    found = aim([PUSH, left], both, known)
    assert found == (FARTHER, left)
    assert validate(found, both, known).valid


@pytest.mark.parametrize("goal", [0.5, 0.55, 0.6])
def test_fast_downward_aims_unless_costs_do_not_count(goal: float):
    known = learned(18)
    asked = task(goal)
    found, bare = (plan(asked, known, costs=costs).steps for costs in (True, False))
    assert validate(found, asked, known).valid
    assert expected_success(found, asked, known) >= expected_success(bare, asked, known)


def test_object_that_is_not_moved_is_left_alone():
    assert aim([], task(0.46), learned(18)) == ()
