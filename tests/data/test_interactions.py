"""Rows of a data set are what outcomes say."""

import numpy as np
from toy_domain import LIFT, WORLD, problem

from neurosym.data.interactions import Interactions


def test_rows_hold_what_each_outcome_says_of_its_target():
    scene, action = problem({}).scene(), np.array(LIFT)
    outcomes = [WORLD.interact(scene, action, target) for target in (0, 1)]
    data = Interactions.from_outcomes(outcomes, np.stack([action, action]), {})
    for row, outcome in enumerate(outcomes):
        np.testing.assert_allclose(data.features[row], scene.features[outcome.target])
        np.testing.assert_allclose(data.effects[row], outcome.effect, atol=1e-7)
        np.testing.assert_allclose(data.resting_effects[row], outcome.resting_effect, atol=1e-7)
        assert (data.held[row], data.lost[row]) == (outcome.held, outcome.lost)
        assert data.peak_heights[row] == np.float32(outcome.peak_height)
    assert data.held.all()
    assert (data.effects[:, 2] > 0.1).all()  # in the air
    assert (np.abs(data.resting_effects) < 1e-6).all()  # and back where it was
