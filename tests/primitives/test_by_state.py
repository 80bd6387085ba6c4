"""Judging actions on pairs by the state that they end in."""

import numpy as np
import pytest

from neurosym.primitives.by_state import foresee_relating, judge_by_state
from neurosym.primitives.judging import Performance


def ended(state: str, /, **changes: object) -> Performance:
    """Describe how an action turned out: straight above the reference."""
    values = {"kind": "carried", "outcome": (0.0, 0.0, 1.0), "peak_height": 0.2, "turn": 0.0, "state": state}
    return Performance(**(values | changes))  # type: ignore[arg-type]


def test_sure_is_what_always_ends_in_one_state():
    assert judge_by_state([ended("01")] * 4).sureness == pytest.approx(1.0)
    assert judge_by_state([ended("01")] * 3 + [ended("10")]).sureness == pytest.approx(0.75)
    assert judge_by_state([ended("")] * 4).kind is None


@pytest.mark.parametrize("spoilt", [{"disturbs": True}, {"turn": 1.0}, {"state": ""}])
def test_what_moves_others_or_turns_over_does_not_count(spoilt: dict[str, object]):
    assert judge_by_state([ended("01"), ended("01", **spoilt)]).sureness == pytest.approx(0.5)


def test_ends_that_differ_in_one_state_are_less_sure():
    spread = [ended("01", outcome=(x, 0.0, 1.0)) for x in (-0.5, 0.5)]
    assert judge_by_state(spread).sureness == pytest.approx(1 / np.sqrt(2))


def test_foreseen_is_the_chance_to_be_carried_upright():
    sure = np.tile([0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.3], (6, 1))
    leaning, rare = sure.copy(), sure * 0.25
    leaning[:, 4] = 0.9
    assert foresee_relating(sure).sureness == pytest.approx(1.0)
    assert foresee_relating(leaning).sureness == pytest.approx(0.1)
    assert foresee_relating(rare).sureness == pytest.approx(0.25)
