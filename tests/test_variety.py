"""Variety: what is sure and unlike the others counts, and carrying is unlike pushing."""

from dataclasses import replace
from functools import cache
from itertools import product
from math import log, sqrt

import numpy as np
import pytest
import torch
from toy_learning import BRIEF

from neurosym.choosing import audition, shortlist
from neurosym.direct_model import DirectModel
from neurosym.fitting import reproducible
from neurosym.model_config import Dimensions, DirectConfig
from neurosym.operators import Primitive
from neurosym.recipes import fit_direct
from neurosym.samples import Samples
from neurosym.toy_world import PUSH_LENGTH, ToyWorld, make_world
from neurosym.variety import LITTLE, best_set, profile, worth_in_place, worths

PUSH = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.04, 0.0, 0.1)
CARRY = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.08, 0.1, 0.0, 0.04, 0.0, 0.1)  # the same by way of a height
HEIGHT = 0.08


class Carrier(ToyWorld):
    """A toy world in which an object that is pushed follows the second waypoint up on its way."""

    def interact(self, scene, action, target, **options):  # noqa: D102
        outcome = super().interact(scene, action, target, **options)
        moved = bool(np.any(outcome.effect))
        return replace(outcome, peak_height=float(action[6]) if moved else 0.0)


class BlindCarrier(Carrier):
    """The same, and nobody looks at heights."""

    def interact(self, scene, action, target, **options):  # noqa: D102
        return replace(super().interact(scene, action, target, **options), peak_height=0.0)


def naive_worths(scores, profiles):
    found = []
    for i, (score, mine) in enumerate(zip(scores, profiles, strict=True)):
        distance = sqrt(sum(x * x for x in mine))
        for j, other in enumerate(profiles):
            if j != i:
                distance = min(distance, sqrt(sum((x - y) ** 2 for x, y in zip(mine, other, strict=True))))
        found.append(score * score * log(1 + distance / LITTLE))
    return found


def some_rivals(seed):
    """Draw candidates of four symbols, some of them doing nearly the same."""
    rng = np.random.default_rng(seed)
    sizes = rng.integers(1, 5, size=4)
    numbers = rng.permutation(sizes.sum()).tolist()
    ends = np.cumsum(sizes).tolist()
    rivals = [numbers[end - size : end] for size, end in zip(sizes.tolist(), ends, strict=True)]
    kinds = rng.normal(size=(5, 6)) * 0.1
    profiles = kinds[rng.integers(5, size=len(numbers))] + rng.normal(size=(len(numbers), 6)) * 0.01
    return rivals, rng.uniform(size=len(numbers)), profiles


def total(chosen, scores, profiles):
    return sum(naive_worths(scores[list(chosen)], profiles[list(chosen)]))


@pytest.mark.parametrize("count", [1, 2, 7])
def test_worths_agree_with_a_naive_computation(count):
    rng = np.random.default_rng(count)
    scores, profiles = rng.uniform(size=count), rng.normal(size=(count, 5)) * 0.05
    np.testing.assert_allclose(worths(scores, profiles), naive_worths(scores, profiles), rtol=1e-9)


def test_doing_nothing_is_worth_nothing_however_sure():
    profiles = np.array([[0.0, 0.0], [0.1, 0.0]])
    assert worths(np.array([1.0]), profiles[:1]).tolist() == [0.0]
    assert worths(np.ones(2), profiles)[0] == 0
    assert worths(np.ones(2), profiles)[1] > 0


def test_a_duplicate_is_worth_nothing_extra():
    rng = np.random.default_rng(3)
    scores, profiles = rng.uniform(0.5, 1, size=4), rng.normal(size=(4, 3)) * 0.1
    again = [0, 1, 2, 3, 2]
    found = worths(scores[again], profiles[again])
    assert found[4] == 0
    assert found.sum() <= worths(scores, profiles).sum()


def test_something_else_is_preferred_to_doing_the_same_more_surely():
    profiles = np.array([[0.1, 0.0], [0.1, 0.0], [0.0, 0.1], [0.0, 0.0]])
    scores = np.array([0.9, 1.0, 0.7, 0.0])
    assert best_set([[0], [1, 2]], scores, profiles) == [0, 2]
    assert best_set([[0], [1, 3]], scores, profiles) == [0, 3]  # even to do nothing


def test_worth_in_place_is_that_of_the_whole_set_with_each_candidate_in_turn():
    rivals, scores, profiles = some_rivals(8)
    chosen = [group[0] for group in rivals]
    for place, group in enumerate(rivals):
        found = worth_in_place(chosen, place, group, scores, profiles)
        for value, rival in zip(found, group, strict=True):
            exchanged = [rival if n == place else number for n, number in enumerate(chosen)]
            assert value == pytest.approx(total(exchanged, scores, profiles))
    assert chosen == [group[0] for group in rivals]


@pytest.mark.parametrize("seed", range(20))
def test_no_single_exchange_makes_the_best_set_better(seed):
    rivals, scores, profiles = some_rivals(seed)
    chosen = best_set(rivals, scores, profiles)
    assert all(number in group for number, group in zip(chosen, rivals, strict=True))
    worth = total(chosen, scores, profiles)
    surest = [max(group, key=lambda number: scores[number]) for group in rivals]
    assert worth >= total(surest, scores, profiles) - 1e-9
    for place, group in enumerate(rivals):
        for rival in group:
            assert total([*chosen[:place], rival, *chosen[place + 1 :]], scores, profiles) <= worth + 1e-8


def test_best_set_is_nearly_always_the_best_of_all_and_never_far_from_it():
    shares = []
    for seed in range(60):
        rivals, scores, profiles = some_rivals(seed)
        best = max(total(chosen, scores, profiles) for chosen in product(*rivals))
        shares.append(total(best_set(rivals, scores, profiles), scores, profiles) / best)
    assert np.mean(np.array(shares) > 1 - 1e-9) >= 0.8
    assert min(shares) > 0.75  # one exchange at a time can get stuck


def test_distances_of_profiles_are_rms_per_object_of_the_means_of_categories():
    rng = np.random.default_rng(4)
    symbols = rng.choice(["00", "01", "11"], size=25, p=[0.6, 0.3, 0.1])
    one, two = rng.normal(size=(2, 25, 4))
    squares = 0.0
    for symbol in symbols:  # each object stands for the mean of its category
        members = [i for i in range(25) if symbols[i] == symbol]
        for axis in range(4):
            squares += (sum(one[i, axis] - two[i, axis] for i in members) / len(members)) ** 2
    apart = np.linalg.norm(profile(one, symbols) - profile(two, symbols))
    assert apart == pytest.approx(sqrt(squares / 25))


def test_distance_of_what_does_the_same_to_all_does_not_depend_on_categories():
    shift = np.tile([0.03, 0.04, 0.0], (12, 1))
    for symbols in (["0"] * 12, ["0", "1"] * 6, [*["0"] * 11, "1"]):
        assert np.linalg.norm(profile(shift, np.array(symbols))) == pytest.approx(0.05)


def alike(features):
    return ("0",) * len(features)


def make_carrier():
    return Carrier(make_world().config)


def make_blind_carrier():
    return BlindCarrier(make_world().config)


@pytest.mark.parametrize(("first", "other"), [(PUSH, CARRY), (CARRY, PUSH)])
def test_audition_tells_carrying_from_pushing_equally_far(first, other):
    rivals = (Primitive("0", first, 0.0), Primitive("1", first, 0.0), Primitive("1", other, 0.0))
    chosen = audition(make_carrier, rivals, alike, seed=0)
    assert [one.action for one in chosen] == [first, other]
    chosen = audition(make_blind_carrier, rivals, alike, seed=0)
    assert [one.action for one in chosen] == [first, first]  # it is the height that tells


@cache
def a_network_that_saw_carrying(*, peaks):
    """Fit a network to actions like `PUSH` and `CARRY`, whose second waypoint is anywhere up to `HEIGHT`."""
    rng = np.random.default_rng(0)
    features = torch.tensor(rng.uniform(size=(600, 4)), dtype=torch.float32)
    actions = torch.tensor(np.tile(PUSH, (600, 1)), dtype=torch.float32)
    actions[:, 6] = torch.tensor(rng.uniform(0, HEIGHT, size=600))
    to_the_right = torch.arange(600) % 2 == 0
    actions[to_the_right] *= torch.tensor([1, -1, 1, 1] * 3)
    effects = torch.zeros(600, 3)
    effects[:, 1] = torch.where(to_the_right, -PUSH_LENGTH, PUSH_LENGTH)
    samples = Samples(features, actions, effects, actions[:, 6].clone(), None, None)
    with reproducible(0) as generator:
        network = DirectModel(Dimensions(), DirectConfig(hidden=32, dropout=0.0, peaks=peaks))
        network.set_scale(samples.outcomes(peaks=peaks))
        config = replace(BRIEF, direct_epochs=60, direct_batch=60)
        fit_direct(network, samples, config, generator, lambda *_: None)
    return network.eval()


@pytest.mark.parametrize("peaks", [True, False])
def test_network_tells_carrying_from_pushing_by_the_peaks_it_predicts(peaks):
    network = a_network_that_saw_carrying(peaks=peaks)
    features = np.random.default_rng(1).uniform(size=(50, 4))
    symbols = np.array(alike(features))

    def apart(predict):
        told = [predict(features, np.tile(action, (50, 1))) for action in (PUSH, CARRY)]
        return np.linalg.norm(profile(told[0], symbols) - profile(told[1], symbols))

    assert apart(network.predict) < LITTLE
    if peaks:
        assert apart(network.predict_outcomes) == pytest.approx(HEIGHT, rel=0.2)
    else:
        assert apart(network.predict_outcomes) < LITTLE


@pytest.mark.parametrize(("first", "other"), [(PUSH, CARRY), (CARRY, PUSH)])
def test_shortlist_by_predicted_outcomes_prefers_what_differs(first, other):
    network = a_network_that_saw_carrying(peaks=True)
    features = np.random.default_rng(1).uniform(size=(50, 4))
    rivals = (Primitive("0", first, 0.0), Primitive("1", first, 0.0), Primitive("1", other, 0.0))
    chosen = shortlist(rivals, network.predict_outcomes, features, alike, 1)
    assert [one.action for one in chosen] == [first, other]
