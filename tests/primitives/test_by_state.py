"""Judging actions on pairs by the state that they end in."""

import numpy as np
import pytest

from neurosym.primitives.by_state import sureness
from neurosym.primitives.judging import Performance


def ended(state: str, /, **changes: object) -> Performance:
    """Describe how an action turned out: straight above the reference."""
    values = {"kind": "carried", "outcome": (0.0, 0.0, 1.0), "peak_height": 0.2, "turn": 0.0, "state": state}
    return Performance(**(values | changes))  # type: ignore[arg-type]


def test_sure_is_what_always_ends_in_the_state():
    assert sureness([ended("01")] * 4, "01") == pytest.approx(1.0)
    assert sureness([ended("01")] * 3 + [ended("10")], "01") == pytest.approx(0.75)
    assert sureness([ended("01")] * 3 + [ended("10")], "10") == pytest.approx(0.25)
    assert sureness([ended("01")] * 4, "10") == 0


@pytest.mark.parametrize("spoilt", [{"disturbs": True}, {"turn": 1.0}, {"state": ""}])
def test_what_moves_others_or_turns_over_does_not_count(spoilt: dict[str, object]):
    assert sureness([ended("01"), ended("01", **spoilt)], "01") == pytest.approx(0.5)


def test_ends_that_differ_in_one_state_are_less_sure():
    spread = [ended("01", outcome=(x, 0.0, 1.0)) for x in (-0.5, 0.5)]
    assert sureness(spread, "01") == pytest.approx(1 / np.sqrt(2))
