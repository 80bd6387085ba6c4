"""Curiosity chooses what a naive reading of its definition chooses, and disagreement gets over noise."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from toy_learning import toy_data

from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions
from neurosym.exploration.curiosity import LearningConfig, make_curiosity
from neurosym.exploration.loop import ExplorationConfig, choose_action
from neurosym.learning.training_config import ModelConfig
from neurosym.worlds.toy import make_world

CONFIG = ExplorationConfig(candidates=50)
BRIEF = LearningConfig(epochs=1, ensemble=3, ensemble_hidden=16)


def curious(about, seed=0, config=BRIEF, dimensions=None, network=None):
    return make_curiosity(about, dimensions or Dimensions(), network or ModelConfig(hidden=16), config, seed)


def drawn_with(rng):
    scene = make_world().sample_scene(rng, 1)
    return scene, make_world().action_box.sample(rng, CONFIG.candidates).astype(np.float32)


def some_data():
    return replace(toy_data(200), origin={})


def naive_score(about, networks, features, candidate):
    """Algorithm 1, lines 5-9; or the variance of answers, each axis in units of its standard deviation."""
    answers = [network.predict(features, candidate[None]) for network in networks]
    if about == "entropy":
        ((_, variance),) = answers
        return np.mean(0.5 * np.log(2 * np.pi * np.e * variance))
    scaled = [one[0] / network.effect_std.numpy() for one, network in zip(answers, networks, strict=True)]
    return np.var(scaled, axis=0).mean()


NAIVE = ("entropy", "disagreement")


def naive_pick(about, scores, rng):
    """The most entropy, or a draw in proportion to the disagreement."""
    if about == "entropy":
        return max(range(len(scores)), key=scores.__getitem__)
    left = rng.random() * sum(scores)
    return next(number for number in range(len(scores)) if (left := left - scores[number]) < 0)


@pytest.mark.parametrize("about", NAIVE)
@pytest.mark.parametrize("learned", [False, True])
def test_curiosity_chooses_what_a_naive_loop_over_the_candidates_chooses(about, learned):
    curiosity = curious(about)
    if learned:
        curiosity.learn(some_data(), 1)
    for number in range(4):
        task = choose_action(make_world(), curiosity, CONFIG, 7, number)
        rng = np.random.default_rng([7, number])
        scene, candidates = drawn_with(rng)
        scores = [naive_score(about, curiosity.networks, scene.features, one) for one in candidates]
        np.testing.assert_array_equal(task.action, candidates[naive_pick(about, scores, rng)])
        np.testing.assert_array_equal(task.scene.positions, scene.positions)


def test_disagreement_of_networks_draws_in_proportion_and_never_what_they_agree_on():
    disagreement, rng = curious("disagreement"), np.random.default_rng(0)
    variances = np.array([0.0, 1e-7, 3e-7, 0.0, 6e-7], dtype=np.float32)
    counts = np.bincount([disagreement.pick(variances, rng) for _ in range(20_000)], minlength=5)
    np.testing.assert_allclose(counts / 20_000, [0, 0.1, 0.3, 0, 0.6], atol=0.01)
    assert disagreement.pick(np.zeros(3), rng) in range(3)  # they agree on everything


@pytest.mark.parametrize("about", NAIVE)
def test_what_was_restored_goes_on_learning_to_the_same_bits(about):
    before = torch.random.get_rng_state()
    data, curiosity, restored = some_data(), curious(about), curious(about, seed=0)
    curiosity.learn(data, 1)
    assert torch.equal(before, torch.random.get_rng_state())
    restored.restore(curiosity.state())
    for each in (curiosity, restored):
        each.learn(data, 2)
    assert all(np.array_equal(array, restored.state()[name]) for name, array in curiosity.state().items())


@pytest.mark.parametrize("about", NAIVE)
def test_mirrors_change_what_is_learned_and_axes_they_turn_round_have_no_mean(about):
    data, (plain, mirrored) = some_data(), (curious(about), curious(about))
    origin = {"mirrors": [{"actions": [0, 4, 8], "effects": [0]}]}
    plain.learn(data, 1)
    mirrored.learn(replace(data, origin=origin), 1)
    means = mirrored.networks[0].effect_mean.numpy()
    np.testing.assert_allclose(means, [0.0, *data.effects.mean(0)[1:]], atol=1e-6)
    scene, candidates = drawn_with(np.random.default_rng(7))
    known = [one.uncertainties(scene.features[0], candidates) for one in (plain, mirrored)]
    assert not np.allclose(*known)


def gamble(rows, rng):
    """Effects that depend on the first number of the action, and where it is above 0 on luck alone."""
    actions = rng.uniform(-1, 1, size=(rows, 2)).astype(np.float32)
    luck = rng.choice([-0.1, 0.1], size=rows)
    effects = np.where(actions[:, 0] > 0, luck, 0.1 * np.sign(actions[:, 1]))[:, None].astype(np.float32)
    flags, zeros = np.zeros(rows, dtype=bool), np.zeros(rows, dtype=np.float32)
    features = rng.uniform(size=(rows, 1)).astype(np.float32)
    return Interactions(features, actions, effects, effects, flags, flags, flags, zeros)


def unknown_of(about, rows, seed=0):
    """How little is known where there is luck and where there is none; as many steps for any rows."""
    rng = np.random.default_rng(seed)
    config = LearningConfig(epochs=8_000 // rows, batch=64, learning_rate=5e-3, ensemble=3)
    network = ModelConfig(hidden=32, dropout=0.0)
    curiosity = curious(about, config=config, seed=seed, dimensions=Dimensions(1, 2, 1, ()), network=network)
    curiosity.learn(gamble(rows, rng), 1)
    candidates = rng.uniform(-1, 1, size=(400, 2)).astype(np.float32)
    candidates = candidates[np.abs(candidates).min(1) > 0.2]
    found = curiosity.uncertainties(np.full(1, 0.5), candidates)
    return found[candidates[:, 0] > 0].mean(), found[candidates[:, 0] < 0].mean()


def test_disagreement_falls_where_only_luck_decides_and_entropy_stays():
    (few, _), (many, _) = (unknown_of("disagreement", rows) for rows in (200, 4000))
    assert many < 0.25 * few
    (few, _), (many, elsewhere) = (unknown_of("entropy", rows) for rows in (200, 4000))
    assert many > few - 0.3
    assert many > elsewhere + 1.0
