"""Judging counts what ends alike, on a scale of its own, without turning, and goes somewhere."""

from math import pi, sqrt

import numpy as np
import pytest

from neurosym.primitives.reliability import EXACT, Performance, exactness, judge, sureness
from neurosym.world import Outcome, Scene


def ended(x, kind="resting", turn=0.0):
    return Performance(kind, (x, 0.0, 0.0), 0.0, turn)


def test_sureness_does_not_grow_with_how_far_an_object_goes():
    near, far = ([ended(x + d) for d in (-EXACT, EXACT)] for x in (0.2, 0.4))
    assert judge(near).sureness == pytest.approx(1 / sqrt(2), abs=0.01)
    assert judge(far).sureness == pytest.approx(1 / sqrt(2), abs=0.01)


def test_moving_little_is_worth_little():
    assert exactness(np.array([[0.01, 0.0, 0.0]])) == pytest.approx(0.5)
    assert exactness(np.zeros((3, 3))) == 0.0


def test_only_the_main_way_of_ending_is_averaged_and_its_share_counts():
    judged = judge([ended(0.2), ended(0.2), ended(0.2), ended(0.0, "held")])
    assert (judged.kind, judged.mean.tolist()) == ("resting", pytest.approx([0.2, 0, 0, 0]))
    assert judged.sureness == pytest.approx(0.75, abs=0.01)


def test_what_topples_or_falls_promises_nothing():
    assert judge([ended(0.2, "toppled"), ended(0.2, "lost")]).sureness == 0.0


def test_turning_counts_against_an_action():
    whole, half = judge([ended(0.2)] * 4), judge([ended(0.2), ended(0.2, turn=0.3)] * 2)
    assert half.sureness == pytest.approx(whole.sureness / 2)


def test_moving_something_else_counts_against_an_action():
    among = [ended(0.2), Performance("resting", (0.2, 0.0, 0.0), 0.0, 0.0, disturbs=True)]
    assert judge(among * 2).sureness == pytest.approx(judge([ended(0.2)] * 4).sureness / 2)


def test_turn_is_the_angle_between_start_and_end_whatever_the_sign_of_a_quaternion():
    def scene(*orientation):
        return Scene(np.ones((1, 4)), np.zeros((1, 3)), np.array([orientation]))

    start = scene(0.0, 0.0, 0.0, 1.0)
    for angle in (0.0, 0.4, pi):
        for sign in (1, -1):
            end = scene(0.0, 0.0, sign * np.sin(angle / 2), sign * np.cos(angle / 2))
            assert Outcome(start, end, end, 0, False, False, False, 0.0).turn == pytest.approx(
                angle, abs=1e-6
            )
    assert Outcome(start, start, scene(0.0, 0.0, 0.0, 0.0), 0, False, False, False, 0.0).turn == 0.0


def pair_ended(state: str, /, **changes: object) -> Performance:
    """Describe how an action turned out: straight above the reference."""
    values = {"kind": "carried", "outcome": (0.0, 0.0, 1.0), "peak_height": 0.2, "turn": 0.0, "state": state}
    return Performance(**(values | changes))  # type: ignore[arg-type]


def test_sure_is_what_always_ends_in_the_state():
    assert sureness([pair_ended("01")] * 4, "01") == pytest.approx(1.0)
    assert sureness([pair_ended("01")] * 3 + [pair_ended("10")], "01") == pytest.approx(0.75)
    assert sureness([pair_ended("01")] * 3 + [pair_ended("10")], "10") == pytest.approx(0.25)
    assert sureness([pair_ended("01")] * 4, "10") == 0


@pytest.mark.parametrize("spoilt", [{"disturbs": True}, {"turn": 1.0}, {"state": ""}])
def test_what_moves_others_or_turns_over_does_not_count(spoilt: dict[str, object]):
    assert sureness([pair_ended("01"), pair_ended("01", **spoilt)], "01") == pytest.approx(0.5)


def test_ends_that_differ_in_one_state_are_less_sure():
    spread = [pair_ended("01", outcome=(x, 0.0, 1.0)) for x in (-0.5, 0.5)]
    assert sureness(spread, "01") == pytest.approx(1 / sqrt(2))
