"""The chances of states are learned from what happened to pairs."""

import numpy as np
import pytest

from neurosym.data.interactions import Interactions
from neurosym.learning.state_codes import ended_in, fit_chances, foreseen_by
from neurosym.learning.training_config import regime_named
from neurosym.pair_operators import PairState, PairStates

STATES = PairStates(
    (
        PairState("00", "apart-00", (1.5, 0.0, 0.0, 0.0, 0.0), 0.9, False),
        PairState("01", "rests-on-01", (0.1, 1.0, 1.0, 0.0, 0.0), 0.0, True),
        PairState("10", "sits-in-10", (0.1, 0.0, 1.0, 0.0, 0.0), 0.0, True),
    ),
    (0.5, 0.5, 0.5, 0.5, 0.5),
)
ON, IN, APART, MISSED = (
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
    rows = interactions([ON, IN, APART, MISSED], np.zeros((4, 8)))
    np.testing.assert_array_equal(ended_in(rows, STATES), [[1, 0], [0, 1], [0, 0], [0, 0]])


@pytest.fixture(scope="module")
def foresee():
    rng = np.random.default_rng(0)
    features = rng.uniform(size=(400, 8))
    fits = features[:, 0] < features[:, 4]
    ends = [IN if fit else ON if rng.random() < 0.5 else MISSED for fit in fits]
    config = regime_named("quick").training
    data = interactions(ends, features)
    return foreseen_by(fit_chances(data, STATES, config, seed=0, progress=lambda *_: None))


def test_what_decides_between_states_is_learned_from_the_pair_itself(foresee):
    features = np.random.default_rng(1).uniform(size=(300, 8))
    apart = features[:, 4] - features[:, 0]
    foreseen = foresee(features, np.zeros((300, 12)))
    on, inside = foreseen[:, 0], foreseen[:, 1]
    assert inside[apart > 0.2].mean() > 0.8 > 0.2 > inside[apart < -0.2].mean()
    assert on[apart > 0.2].mean() < 0.2
    assert 0.3 < on[apart < -0.2].mean() < 0.7


def test_chances_are_shares(foresee):
    rng = np.random.default_rng(1)
    found = foresee(rng.uniform(-3, 4, (200, 8)), rng.uniform(-1, 1, (200, 12)))
    assert found.shape == (200, 2)
    assert found.min() >= 0
    assert found.max() <= 1
