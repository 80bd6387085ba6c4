"""States of pairs: what is told apart, what is borne, and how states are called."""

import numpy as np

from neurosym.learning.state_codes import learn_states, name_state

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


def test_states_that_differ_have_codes_of_their_own():
    found = states()
    codes = [found.of(centre).symbol for centre in (APART, ON, UNDER, IN)]
    assert len(set(codes)) == 4
    assert [one.symbol for one in found.states] == sorted(one.symbol for one in found.states)


def test_what_only_actions_bring_about_is_borne():
    found = states()
    assert [found.of(centre).bears for centre in (APART, ON, UNDER, IN)] == [False, True, False, True]
    assert sum(one.share for one in found.states) == 1


def test_what_does_not_touch_rests_on_nothing():
    found = states()
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


def test_same_draws_give_the_same_states():
    assert states() == states()


def test_names_say_what_is_typical():
    names = [name_state(centre) for centre in (APART, ON, UNDER, IN)]
    assert names == ["apart-from", "rests-on", "lies-under", "sits-in"]
    assert name_state((0.2, 0.5, 1.0, 0.8, 0.0)) == "leans-on"
    assert name_state((0.2, -0.5, 1.0, 0.0, 0.8)) == "props-up"
    assert name_state((1.0, 0.0, 1.0, 0.0, 0.0)) == "touches"
    assert name_state((1.2, 0.0, 0.0, 0.0, 0.0)) == "beside"
