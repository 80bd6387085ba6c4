"""States of pairs: in numbers, what is told apart, what is borne, how called, how likely they are."""

import numpy as np
import pytest

from neurosym.data.interactions import Interactions
from neurosym.learning.state_codes import ended_in, fit_chances, foreseen_by, learn_states, name_state
from neurosym.learning.training_config import regime_named
from neurosym.pair_operators import (
    FARTHEST,
    PairState,
    PairStates,
    describe_pair,
    extent,
    tilt,
    touching_units,
)
from neurosym.world import Scene

APART, ON, UNDER, IN = (
    (1.6, 0.0, 0.0, 0.0, 0.0),
    (0.2, 1.0, 1.0, 0.0, 0.0),
    (0.2, -1.0, 1.0, 0.0, 0.0),
    (0.1, 0.1, 1.0, 0.0, 0.0),
)


def around(centre: tuple[float, ...], count: int, rng: np.random.Generator) -> np.ndarray:
    """Draw descriptions as far away and as high as a centre, or nearly so."""
    return np.array(centre) + rng.normal(0.0, 0.02, (count, len(centre))) * (1, 1, 0, 0, 0)


def states():
    """States of pairs that nobody touched, that were put on and into others, and the other way round."""
    rng = np.random.default_rng(0)
    ends = np.concatenate([around(ON, 80, rng), around(IN, 40, rng)])
    turned = np.concatenate([around(UNDER, 80, rng), around((0.1, -0.1, 1.0, 0.0, 0.0), 40, rng)])
    return learn_states(around(APART, 200, rng), ends, turned, 2, rng)


def test_states_that_differ_have_codes_and_what_only_actions_bring_about_is_borne():
    found = states()
    assert found == states()
    codes = [found.of(centre).symbol for centre in (APART, ON, UNDER, IN)]
    assert len(set(codes)) == 4
    assert [one.symbol for one in found.states] == sorted(one.symbol for one in found.states)
    assert [found.of(centre).bears for centre in (APART, ON, UNDER, IN)] == [False, True, False, True]
    assert sum(one.share for one in found.states) == 1
    above = (0.2, 1.4, 0.0, 0.0, 0.0)
    assert found.of((0.2, 1.4, 1.0, 0.0, 0.0)) == found.of(ON)
    assert found.of(above) != found.of(ON)
    assert set(found.bearing) == {one.symbol for one in found.states if one.bears}


def test_what_sits_in_a_ring_is_in_one_state_whether_it_touches_it_or_not():
    rng = np.random.default_rng(1)
    touching, free = around(IN, 60, rng), around((*IN[:2], 0.0, 0.0, 0.0), 60, rng)
    ends = np.concatenate([around(ON, 200, rng), touching, free])
    found = learn_states(around(APART, 300, rng), ends, ends * (1, -1, 1, 1, 1), 2, rng)
    assert found.of(touching[0].tolist()) == found.of(free[0].tolist()) != found.of(ON)


def test_names_say_what_is_typical():
    names = [name_state(centre) for centre in (APART, ON, UNDER, IN)]
    assert names == ["apart-from", "rests-on", "lies-under", "sits-in"]
    assert name_state((0.2, 0.5, 1.0, 0.8, 0.0)) == "leans-on"
    assert name_state((0.2, -0.5, 1.0, 0.0, 0.8)) == "props-up"
    assert name_state((1.0, 0.0, 1.0, 0.0, 0.0)) == "touches"
    assert name_state((1.2, 0.0, 0.0, 0.0, 0.0)) == "beside"


# The chances of states are learned from what happened to pairs

STATES = PairStates(
    (
        PairState("00", "apart-00", (1.5, 0.0, 0.0, 0.0, 0.0), 0.9, False),
        PairState("01", "rests-on-01", (0.1, 1.0, 1.0, 0.0, 0.0), 0.0, True),
        PairState("10", "sits-in-10", (0.1, 0.0, 1.0, 0.0, 0.0), 0.0, True),
    ),
    (0.5, 0.5, 0.5, 0.5, 0.5),
)
ENDS_ON, ENDS_IN, ENDS_APART, MISSED = (
    (0.0, 0.1, 1.0, 1.0, 0.0, 1.0),
    (0.1, 0.0, 0.0, 1.0, 0.0, 1.0),
    (1.6, 0.0, 0.0, 0.0, 0.0, 1.0),
    (0.0,) * 6,
)


def interactions(rows: list[tuple[float, ...]], features: np.ndarray) -> Interactions:
    """Interactions that ended so, all by the same action."""
    count, effects = len(rows), np.array(rows)
    flags = np.zeros(count, dtype=bool)
    return Interactions(
        features, np.zeros((count, 12)), effects, effects, flags, flags, flags, np.zeros(count), {}
    )


def test_only_states_that_bear_and_were_carried_to_count():
    rows = interactions([ENDS_ON, ENDS_IN, ENDS_APART, MISSED], np.zeros((4, 8)))
    np.testing.assert_array_equal(ended_in(rows, STATES), [[1, 0], [0, 1], [0, 0], [0, 0]])


def test_what_decides_between_states_is_learned_from_the_pair_itself_as_chances():
    rng = np.random.default_rng(0)
    features = rng.uniform(size=(400, 8))
    fits = features[:, 0] < features[:, 4]
    ends = [ENDS_IN if fit else ENDS_ON if rng.random() < 0.5 else MISSED for fit in fits]
    config = regime_named("quick").training
    data = interactions(ends, features)
    foresee = foreseen_by(fit_chances(data, STATES, config, seed=0, progress=lambda *_: None))
    features = np.random.default_rng(1).uniform(size=(300, 8))
    apart = features[:, 4] - features[:, 0]
    foreseen = foresee(features, np.zeros((300, 12)))
    on, inside = foreseen[:, 0], foreseen[:, 1]
    assert inside[apart > 0.2].mean() > 0.8 > 0.2 > inside[apart < -0.2].mean()
    assert on[apart > 0.2].mean() < 0.2
    assert 0.3 < on[apart < -0.2].mean() < 0.7
    anywhere = np.random.default_rng(1).uniform(-3, 4, (200, 20))
    far = foresee(anywhere[:, :8], anywhere[:, 8:])
    assert far.shape == (200, 2)
    assert 0 <= far.min() <= far.max() <= 1


# How one object stands to another, in numbers: hand-made scenes

UPRIGHT = (0.0, 0.0, 0.0, 1.0)
CUBE, PLATE = (0.04, 0.04, 0.04, 0.0), (0.16, 0.12, 0.02, 0.0)


def scene(*rows: tuple[tuple[float, ...], tuple[float, ...], tuple[float, ...]]) -> Scene:
    """Make a scene of objects with features, position and orientation."""
    return Scene(*(np.array(column, dtype=float) for column in zip(*rows, strict=True)))


STACK = scene((CUBE, (0.5, 0.0, 0.04), UPRIGHT), (PLATE, (0.5, 0.0, 0.01), UPRIGHT))


def test_what_stands_on_another_is_one_touching_unit_above_it():
    np.testing.assert_allclose(touching_units(STACK, 0, 1), (0, 0, 1), atol=1e-9)
    np.testing.assert_allclose(describe_pair(STACK, 0, 1, ((0, 1),)), (0, 1, 1, 0, 0), atol=1e-6)
    np.testing.assert_allclose(describe_pair(STACK, 1, 0, ((0, 1),)), (0, -1, 1, 0, 0), atol=1e-6)


def test_what_is_far_away_is_no_farther_than_the_most():
    apart = scene((CUBE, (0.3, 0.3, 0.02), UPRIGHT), (CUBE, (0.9, -0.3, 0.02), UPRIGHT))
    np.testing.assert_allclose(describe_pair(apart, 0, 1, ()), (FARTHEST, 0, 0, 0, 0), atol=1e-9)


def test_sizes_are_those_along_the_axes_of_the_world():
    quarter = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
    np.testing.assert_allclose(extent(scene((PLATE, (0, 0, 0), quarter)), 0), (0.12, 0.16, 0.02), atol=1e-9)


@pytest.mark.parametrize(("degrees", "expected"), [(0, 0.0), (5, 5.0), (90, 0.0), (45, 20.05)])
def test_tilt_is_counted_from_the_nearest_face_and_bounded(degrees: float, expected: float):
    half = np.radians(degrees) / 2
    leaning = scene((CUBE, (0, 0, 0), (np.sin(half), 0.0, 0.0, np.cos(half))))
    assert np.degrees(tilt(leaning, 0)) == pytest.approx(expected, abs=0.01)
