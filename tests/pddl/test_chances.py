"""The chance that a plan comes true, against what is known of normal errors."""

import math

import numpy as np
import pytest
import tables
from tables import LIFT, PULL

from neurosym.problems import Problem
from neurosym.tasks.chances import chance_inside, expected_success, expected_within, spread_of


@pytest.mark.parametrize("tolerance", [0.005, 0.01, 0.02, 0.05])
def test_centred_plane_error_ends_inside_as_rayleigh_says(tolerance: float):
    found = chance_inside(np.zeros(3), np.array([0.01, 0.01, 0.0]), tolerance)
    assert found == pytest.approx(1 - math.exp(-(tolerance**2) / 2e-4), abs=0.02)


def test_error_in_space_ends_inside_more_rarely():
    flat, solid = (chance_inside(np.zeros(3), np.array([0.01, 0.01, z]), 0.015) for z in (0.0, 0.01))
    maxwell = math.erf(1.5 / math.sqrt(2)) - math.sqrt(2 / math.pi) * 1.5 * math.exp(-(1.5**2) / 2)
    assert flat > solid == pytest.approx(maxwell, abs=0.03)


def test_the_edge_is_less_likely_than_the_middle_and_certain_without_spread():
    spread = np.array([0.01, 0.01, 0.0])
    chances = [chance_inside(np.array([miss, 0.0, 0.0]), spread, 0.05) for miss in (0.0, 0.03, 0.049, 0.09)]
    assert chances == sorted(chances, reverse=True)
    assert chances[0] > 0.99
    assert chances[2] == pytest.approx(0.5, abs=0.06)
    assert chances[3] < 0.01
    assert chance_inside(np.array([0.049, 0.0, 0.0]), np.zeros(3), 0.05) == 1.0


def test_spreads_add_up_like_variances_and_a_put_down_belongs_to_its_lift():
    task, learned = tables.problem(), tables.grounding()
    one = spread_of([PULL], task, learned)
    assert spread_of([PULL] * 4, task, learned) == pytest.approx(2 * one)
    in_the_air, down = (spread_of(steps, task, learned) for steps in ([LIFT], [LIFT, tables.DOWN]))
    assert in_the_air[2] > 0 == down[2]


def test_within_no_more_motions_than_steps_a_plan_must_go_as_promised():
    learned, item = tables.grounding(), tables.item("item-01", 0.45, 0.0)
    task = Problem("p", (item,), {"item-01": (0.45 + 2 * 0.0713, -0.0248, 0.025)})
    plan, chances = [tables.PUSH] * 2, []
    for motions in range(9):
        chances.append(expected_within(plan, task, learned, motions))
    assert chances[:2] == [0.0, 0.0]
    assert chances[2] == pytest.approx(expected_success(plan, task, learned))
    assert chances == sorted(chances)
    assert chances[3] > chances[2]


def test_a_second_try_is_as_likely_and_what_is_lost_stays_lost():
    learned, item = tables.grounding(), tables.item("item-01", 0.45, 0.0)
    task = Problem("p", (item,), {"item-01": (0.45 + 0.0713, -0.0124, 0.025)})
    kept = expected_success([tables.PUSH], task, learned)
    (lost,) = (
        sum(mode.share for mode in one.modes if mode.kind == "lost")
        for one in learned.operators.operators
        if one.name == tables.PUSH.operator
    )
    again = 1 - kept - lost
    assert expected_within([tables.PUSH], task, learned, 3) == pytest.approx(kept * (1 + again + again**2))
    assert expected_within([], task, learned, 0) == 1.0


def test_plan_comes_true_if_all_steps_are_kept_and_all_objects_end_inside():
    learned = tables.grounding()
    item = tables.item("item-01", 0.45, 0.0)
    at, edge = ((0.45 + 0.0713 + off, -0.0124, 0.025) for off in (0.0, 0.0475))
    centred, outer = (
        expected_success([tables.PUSH], Problem("p", (item,), {"item-01": goal}), learned)
        for goal in (at, edge)
    )
    assert centred == pytest.approx(19 / 22, abs=1e-6)
    assert outer < 0.8 * centred
