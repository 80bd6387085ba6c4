"""Curiosity chooses what a naive reading of its definition chooses, and disagreement gets over noise."""

import numpy as np
import pytest
import torch

from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidValue
from neurosym.exploration.curiosity import Curiosity, LearningConfig, make_curiosity
from neurosym.exploration.loop import ExplorationConfig, choose_action
from neurosym.learning.training_config import ModelConfig
from neurosym.world import Mirror
from neurosym.worlds.toy import make_world

CONFIG = ExplorationConfig(candidates=50)
BRIEF = LearningConfig(epochs=1, ensemble=3, ensemble_hidden=16)


def curious(about, mirrors=(), seed=0, config=BRIEF, dimensions=None, network=None):
    return make_curiosity(
        about, dimensions or Dimensions(), network or ModelConfig(hidden=16), config, mirrors, seed
    )


def drawn(number, seed=7):
    """The scene and the candidates of an interaction."""
    return drawn_with(np.random.default_rng([seed, number]))


def drawn_with(rng):
    scene = make_world().sample_scene(rng, 1)
    return scene, make_world().action_box.sample(rng, CONFIG.candidates).astype(np.float32)


def toy_data(rows=200):
    world, rng = make_world(), np.random.default_rng(1)
    actions = world.action_box.sample(rng, rows)
    scenes = [world.sample_scene(rng, 1) for _ in range(rows)]
    outcomes = [world.interact(scene, action, 0) for scene, action in zip(scenes, actions, strict=True)]
    return Interactions.from_outcomes(outcomes, actions, {})


def naive_entropy(curiosity, features, candidate):
    """Algorithm 1, lines 5-9."""
    _, variance = curiosity.networks[0].predict(features, candidate[None])
    return sum(0.5 * np.log(2 * np.pi * np.e * v) for v in variance[0]) / 3


def naive_disagreement(curiosity, features, candidate):
    """The variance of what the networks say, each axis in units of its standard deviation."""
    total = 0.0
    for axis in range(3):
        answers = [
            float(network.predict(features, candidate[None])[0, axis] / network.effect_std[axis])
            for network in curiosity.networks
        ]
        total += sum((answer - sum(answers) / len(answers)) ** 2 for answer in answers) / len(answers)
    return total / 3


NAIVE = {"entropy": naive_entropy, "disagreement": naive_disagreement}


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
        curiosity.learn(toy_data(), 1)
    for number in range(4):
        task = choose_action(make_world(), curiosity, CONFIG, 7, number)
        rng = np.random.default_rng([7, number])
        scene, candidates = drawn_with(rng)
        scores = [NAIVE[about](curiosity, scene.features, candidate) for candidate in candidates]
        np.testing.assert_array_equal(task.action, candidates[naive_pick(about, scores, rng)])
        np.testing.assert_array_equal(task.scene.positions, scene.positions)


def test_disagreement_of_networks_draws_in_proportion_and_never_what_they_agree_on():
    disagreement, rng = curious("disagreement"), np.random.default_rng(0)
    variances = np.array([0.0, 1e-7, 3e-7, 0.0, 6e-7], dtype=np.float32)
    counts = np.bincount([disagreement.pick(variances, rng) for _ in range(20_000)], minlength=5)
    np.testing.assert_allclose(counts / 20_000, [0, 0.1, 0.3, 0, 0.6], atol=0.01)
    assert disagreement.pick(np.zeros(3), rng) in range(3)  # they agree on everything


def test_without_curiosity_the_first_candidate_is_taken():
    task = choose_action(make_world(), None, CONFIG, 7, 0)
    np.testing.assert_array_equal(task.action, drawn(0)[1][0])


@pytest.mark.parametrize("about", NAIVE)
def test_expected_sizes_are_sums_of_absolute_mean_predictions(about):
    curiosity = curious(about)
    curiosity.learn(toy_data(), 1)
    scene, candidates = drawn(0)
    for candidate, size in zip(
        candidates, curiosity.expected_sizes(scene.features[0], candidates), strict=True
    ):
        answers = [network.predict(scene.features, candidate[None]) for network in curiosity.networks]
        means = [answer[0] if about == "entropy" else answer for answer in answers]
        assert size == pytest.approx(np.abs(sum(means) / len(means)).sum(), rel=1e-4)


class FirstNumberUnknown(Curiosity):
    """Knows least where an action's first number is greatest, and expects effects as great as its second."""

    def __init__(self):
        super().__init__((), BRIEF, (), 0)

    def uncertainties(self, features, candidates):  # noqa: ARG002, D102
        return candidates[:, 0]

    def expected_sizes(self, features, candidates):  # noqa: ARG002, D102
        return np.abs(candidates[:, 1])

    def loss(self, samples, generator):  # noqa: ARG002, D102
        raise AssertionError("knows all it ever will")


@pytest.mark.parametrize("least", [0.0, 0.02, 0.045, 1.0])
def test_only_candidates_of_the_predicted_size_are_chosen_from_if_there_are_any(least):
    config = ExplorationConfig(candidates=50, min_predicted_effect=least)
    for number in range(10):
        action = choose_action(make_world(), FirstNumberUnknown(), config, 7, number).action
        _, candidates = drawn(number)
        fitting = [candidate for candidate in candidates if abs(candidate[1]) >= least]
        best = max(fitting or list(candidates), key=lambda candidate: candidate[0])
        np.testing.assert_array_equal(action, best)


def test_the_filter_sometimes_has_candidates_to_choose_from_and_sometimes_none():
    sizes = [np.abs(drawn(number)[1][:, 1]) for number in range(10)]
    assert all((size >= 0.02).any() and not (size >= 0.02).all() for size in sizes)
    assert not any((size >= 1.0).any() for size in sizes)


def test_networks_that_shall_disagree_begin_differently_and_those_of_a_seed_alike():
    one, again, other = curious("disagreement"), curious("disagreement"), curious("disagreement", seed=1)
    names = [name for name in one.state() if name.startswith("0/") and name.endswith("1.weight")]
    assert names
    for name in names:
        assert not np.array_equal(one.state()[name], one.state()[name.replace("0/", "1/", 1)])
        assert np.array_equal(one.state()[name], again.state()[name])
        assert not np.array_equal(one.state()[name], other.state()[name])


@pytest.mark.parametrize("about", NAIVE)
def test_what_was_restored_goes_on_learning_to_the_same_bits(about):
    data, curiosity, restored = toy_data(), curious(about), curious(about, seed=0)
    curiosity.learn(data, 1)
    restored.restore(curiosity.state())
    for each in (curiosity, restored):
        each.learn(data, 2)
    assert all(np.array_equal(array, restored.state()[name]) for name, array in curiosity.state().items())


@pytest.mark.parametrize("about", NAIVE)
def test_mirrors_change_what_is_learned_and_axes_they_turn_round_have_no_mean(about):
    mirrors = (Mirror(actions=(0, 4, 8), effects=(0,)),)
    plain, mirrored = curious(about), curious(about, mirrors)
    data = toy_data()
    for curiosity in (plain, mirrored):
        curiosity.learn(data, 1)
    means = mirrored.networks[0].effect_mean.numpy()
    np.testing.assert_allclose(means, [0.0, *data.effects.mean(0)[1:]], atol=1e-6)
    features, candidates = drawn(0)[0].features[0], drawn(0)[1]
    known = [curiosity.uncertainties(features, candidates) for curiosity in (plain, mirrored)]
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
    config = LearningConfig(epochs=16_000 // rows, batch=64, learning_rate=5e-3, ensemble=3)
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


@pytest.mark.parametrize(
    "option", [{"epochs": 0}, {"batch": 0}, {"ensemble": 1}, {"learning_rate": 0.0}, {"clip_norm": -1.0}]
)
def test_impossible_options_are_refused(option):
    with pytest.raises(InvalidValue, match=next(iter(option))):
        LearningConfig(**option)


def test_asking_leaves_the_state_of_torch_as_it_was():
    before = torch.random.get_rng_state()
    curious("disagreement").learn(toy_data(50), 1)
    assert torch.equal(before, torch.random.get_rng_state())
