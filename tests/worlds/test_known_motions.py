"""Motions that carry objects to places, to be tried with other objects as references."""

import numpy as np
import toy_places

from neurosym.worlds.aims import JITTER, TO_THE_MIDDLE, KnownMotions
from neurosym.worlds.toy import make_world

BOX = make_world().action_box
CUBE = np.array(toy_places.CUBE)
MOTIONS = KnownMotions(toy_places.grounding().places, lambda features: ["00"] * len(features), BOX)
FOUR_SIGMA = 4 * JITTER


def test_some_motions_bring_the_target_to_the_middle_of_the_reference_and_others_anywhere():
    drawn = MOTIONS(np.random.default_rng(0), CUBE, 400)
    middle = np.array(toy_places.CARRY[8:10]) - toy_places.OFFSET[:2]
    near = np.all(np.abs(drawn[:, 8:10] - middle) < FOUR_SIGMA, axis=1)
    assert abs(near.mean() - TO_THE_MIDDLE) < 0.1
    assert np.ptp(drawn[~near, 8:10], axis=0).min() > 0.08


def test_target_is_grasped_as_it_is_known_to_be():
    drawn = MOTIONS(np.random.default_rng(0), CUBE, 100)
    assert np.abs(drawn[:, :8] - toy_places.CARRY[:8]).max() < FOUR_SIGMA
    assert np.all((drawn >= BOX.low) & (drawn <= BOX.high))


def test_nothing_is_drawn_for_objects_that_nothing_carries():
    heavy = KnownMotions(toy_places.grounding().places, lambda features: ["11"] * len(features), BOX)
    assert heavy(np.random.default_rng(0), CUBE, 10).shape == (0, len(BOX.low))
