"""Pushes that stop on their way: where they end, and which of them are worth having."""

import numpy as np
import pytest
from places import ROOT

from neurosym.grounding import Grounding
from neurosym.operators import Rehearsal
from tools.benchmarks.objects.parts import CELL, STOPS, Move, average_cost, stopped, with_parts

ACTION = (-0.1, 0.0, 0.0, 0.1, -0.05, 0.0, 0.0, 0.1, 0.11, 0.0, 0.0, 0.9)


@pytest.mark.parametrize("stop", [0.1, *STOPS, 1.0])
def test_an_action_stops_at_a_share_of_the_way_between_its_waypoints(stop):
    action, points = np.array(ACTION).reshape(3, 4), np.array(stopped(ACTION, stop)).reshape(3, 4)
    np.testing.assert_array_equal(points[0], action[0])
    np.testing.assert_allclose(points[2, :3], (-0.1 + stop * 0.21, 0, 0), atol=1e-12)
    before_the_second = stop * 0.21 < 0.05
    np.testing.assert_allclose(points[1], points[2] if before_the_second else action[1], atol=1e-12)


def test_ways_get_cheaper_by_motions_that_lead_elsewhere_and_not_by_dearer_ones_that_lead_to_the_same():
    cross = [Move(x, y, 1.0) for x, y in ((0.05, 0), (-0.05, 0), (0, 0.05), (0, -0.05))]
    usual = average_cost(cross)
    assert average_cost([*cross, Move(0.05, 0, 2.0)]) == usual
    assert average_cost([*cross, Move(2 * CELL, 0, 1.0)]) < usual
    assert average_cost([]) > usual


def test_what_is_added_is_planned_with_and_leaves_the_rest_as_it_is():
    before = Grounding.load(ROOT / "domains" / "places" / "grounding.json")
    whole = next(one for one in before.objects.operators if one.promise and one.promise.kind == "resting")
    shift = (0.123, 0.0, 0.0)
    rows = [["resting", shift, shift, 0.0, 0.0]] * len(before.category(whole.subject).objects)
    after = with_parts(
        before, [{"subject": whole.subject, "whole": whole.label, "stop": 0.6, "rehearsals": rows}]
    )
    (new,) = set(after.objects.operators) - set(before.objects.operators)
    assert (new.subject, new.primitive) == (whole.subject, whole.primitive)
    assert new.rehearsals[0] == Rehearsal("resting", shift, shift, 0.0, 0.0)
    assert after.primitive_of(new).action == stopped(before.primitive_of(whole).action, 0.6)
    assert after.why_left_out(new) is None
