"""Variety: what is sure and unlike the others counts, for each category; and carrying is unlike pushing."""

from dataclasses import replace
from functools import cache
from itertools import product
from math import sqrt, tanh

import numpy as np
import pytest
import torch
from toy_learning import BRIEF, search

from neurosym.data.origin import Dimensions
from neurosym.learning.losses import Samples, reproducible
from neurosym.learning.network import DirectModel
from neurosym.learning.recipes import fit_direct
from neurosym.learning.training_config import DirectConfig
from neurosym.operators import Primitive
from neurosym.primitives.audition import audition, shortlist
from neurosym.primitives.reliability import (
    LITTLE,
    PLENTY,
    CandidateEffects,
    best_set,
    observe,
    worth_in_place,
    worths,
)
from neurosym.worlds.toy import PUSH_LENGTH, ToyWorld, make_world

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


def distance(one, other):
    return sqrt(sum((x - y) ** 2 for x, y in zip(one, other, strict=True)))


def naive_worths(effects, chosen):
    found = []
    for place, mine in enumerate(chosen):
        total = 0.0
        for category, share in enumerate(effects.shares):
            others = [effects.means[n, category] for at, n in enumerate(chosen) if at != place]
            here = effects.means[mine, category]
            nearest = min(distance(here, other) for other in [*others, np.zeros(len(here))])
            total += share * effects.sureness[mine, category] ** 2 * tanh(nearest / PLENTY)
        found.append(total)
    return found


def some_deeds(rng, count, categories=2):
    kinds = 0.1 * rng.normal(size=(5, categories, 4))
    means = kinds[rng.integers(5, size=count)] + 0.01 * rng.normal(size=(count, categories, 4))
    return CandidateEffects(means, rng.uniform(size=(count, categories)), rng.dirichlet(np.ones(categories)))


def some_rivals(seed):
    """Draw candidates of four symbols, some of them doing nearly the same."""
    rng = np.random.default_rng(seed)
    sizes = rng.integers(1, 5, size=4)
    numbers = rng.permutation(sizes.sum()).tolist()
    ends = np.cumsum(sizes).tolist()
    groups = [numbers[end - size : end] for size, end in zip(sizes.tolist(), ends, strict=True)]
    return groups, some_deeds(rng, len(numbers))


def total(chosen, effects):
    return sum(naive_worths(effects, chosen))


def seen(*values, sureness=None):
    """Say that actions do this to the one object there is."""
    means = np.array(values, dtype=float)[:, None]
    return CandidateEffects(means, np.array(sureness or np.ones(len(values)))[:, None], np.ones(1))


@pytest.mark.parametrize("count", [1, 2, 7])
def test_worths_agree_with_a_naive_computation(count):
    rng = np.random.default_rng(count)
    effects = some_deeds(rng, 9, categories=3)
    chosen = rng.permutation(9)[:count].tolist()
    np.testing.assert_allclose(worths(effects, chosen), naive_worths(effects, chosen), rtol=1e-9)


def test_doing_nothing_is_worth_nothing_however_sure():
    effects = seen([0.0, 0.0], [0.1, 0.0])
    assert worths(effects, [0]).tolist() == [0.0]
    assert worths(effects, [0, 1])[0] == 0
    assert worths(effects, [0, 1])[1] > 0


def test_a_duplicate_is_worth_nothing_extra():
    effects = some_deeds(np.random.default_rng(3), 4)
    found = worths(effects, [0, 1, 2, 3, 2])
    assert found[2] == found[4] == 0
    assert found.sum() <= worths(effects, [0, 1, 2, 3]).sum()


def test_something_else_is_preferred_to_doing_the_same_more_surely():
    effects = seen([0.1, 0.0], [0.1, 0.0], [0.0, 0.1], [0.0, 0.0], sureness=[0.9, 1.0, 0.7, 0.0])
    assert best_set([[0], [1, 2]], effects) == [0, 2]
    assert best_set([[0], [1, 3]], effects) == [0, 3]  # even to do nothing


def test_sure_is_preferred_to_far_but_not_to_hardly_anything():
    effects = seen([0.0, 0.08], [0.0, 0.2], [0.0, 0.01], sureness=[0.9, 0.7, 0.95])
    assert best_set([[0, 1]], effects) == [0]
    assert best_set([[0, 2]], effects) == [0]


def test_means_and_sureness_are_those_of_each_category():
    rng = np.random.default_rng(0)
    values = rng.normal(size=(2, 30, 4)) * 0.1
    symbols = rng.choice(["00", "01", "11"], size=30)
    effects = observe(values, symbols)
    for action in range(2):
        for column, symbol in enumerate(["00", "01", "11"]):
            rows = [values[action, i] for i in range(30) if symbols[i] == symbol]
            mean = sum(rows) / len(rows)
            square = sum(float(row @ row) for row in rows) / len(rows)
            np.testing.assert_allclose(effects.means[action, column], mean)
            sure = float(mean @ mean) / (square + LITTLE**2)
            assert effects.sureness[action, column] == pytest.approx(sure)
            assert effects.shares[column] == pytest.approx(len(rows) / 30)


def test_what_always_happens_is_sure_what_sometimes_happens_less_and_nothing_not_at_all():
    always = np.tile([0.1, 0.0, 0.0], (20, 1))
    sometimes = always * (np.arange(20) % 2)[:, None]
    hardly = np.full((20, 3), LITTLE / 10)
    sureness = observe(np.array([always, sometimes, hardly, 0 * always]), ["00"] * 20).sureness[:, 0]
    assert sureness[0] > 0.98
    assert sureness[1] == pytest.approx(0.5, abs=0.01)
    assert sureness[2] < 0.05
    assert sureness[3] == 0
    assert observe(sometimes[None], ["00", "01"] * 10).sureness[0].tolist() == [0, pytest.approx(sureness[0])]


def test_worth_in_place_is_that_of_the_whole_set_with_each_candidate_in_turn():
    groups, effects = some_rivals(8)
    chosen = [group[0] for group in groups]
    for place, group in enumerate(groups):
        found = worth_in_place(chosen, place, group, effects)
        for value, candidate in zip(found, group, strict=True):
            exchanged = [candidate if n == place else number for n, number in enumerate(chosen)]
            assert value == pytest.approx(total(exchanged, effects))
    assert chosen == [group[0] for group in groups]


@pytest.mark.parametrize("seed", range(20))
def test_no_single_exchange_makes_the_best_set_better(seed):
    groups, effects = some_rivals(seed)
    chosen = best_set(groups, effects)
    assert all(number in group for number, group in zip(chosen, groups, strict=True))
    worth = total(chosen, effects)
    surest = [max(group, key=lambda number: effects.sureness[number] @ effects.shares) for group in groups]
    assert worth >= total(surest, effects) - 1e-9
    for place, group in enumerate(groups):
        for candidate in group:
            assert total([*chosen[:place], candidate, *chosen[place + 1 :]], effects) <= worth + 1e-8


def test_best_set_is_nearly_always_the_best_of_all_and_never_far_from_it():
    shares = []
    for seed in range(60):
        groups, effects = some_rivals(seed)
        best = max(total(list(chosen), effects) for chosen in product(*groups))
        shares.append(total(best_set(groups, effects), effects) / best)
    assert np.mean(np.array(shares) > 1 - 1e-9) >= 0.9
    assert min(shares) > 0.9  # one exchange at a time can get stuck


def alike(features):
    return ("0",) * len(features)


def make_carrier():
    return Carrier(make_world().config)


def make_blind_carrier():
    return BlindCarrier(make_world().config)


@pytest.mark.parametrize(("first", "other"), [(PUSH, CARRY), (CARRY, PUSH)])
def test_audition_tells_carrying_from_pushing_equally_far(first, other):
    groups = (Primitive("0", first, 0.0), Primitive("1", first, 0.0), Primitive("1", other, 0.0))
    chosen = audition(search((), alike, make_carrier), groups)
    assert [one.action for one in chosen] == [first, other]
    chosen = audition(search((), alike, make_blind_carrier), groups)
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
        config = replace(BRIEF, teacher=replace(BRIEF.teacher, epochs=60, batch=60))
        fit_direct(network, samples, config, generator, lambda *_: None)
    return network.eval()


@pytest.mark.parametrize("peaks", [True, False])
def test_network_tells_carrying_from_pushing_by_the_peaks_it_predicts(peaks):
    network = a_network_that_saw_carrying(peaks=peaks)
    features = np.random.default_rng(1).uniform(size=(50, 4))

    def apart(predict):
        told = [predict(features, np.tile(action, (50, 1))) for action in (PUSH, CARRY)]
        return np.linalg.norm(told[0].mean(0) - told[1].mean(0))

    assert apart(network.predict) < LITTLE
    if peaks:
        assert apart(network.predict_outcomes) == pytest.approx(HEIGHT, rel=0.2)
    else:
        assert apart(network.predict_outcomes) < LITTLE


@pytest.mark.parametrize(("first", "other"), [(PUSH, CARRY), (CARRY, PUSH)])
def test_shortlist_by_predicted_outcomes_prefers_what_differs(first, other):
    network = a_network_that_saw_carrying(peaks=True)
    features = np.random.default_rng(1).uniform(size=(50, 4))
    groups = (Primitive("0", first, 0.0), Primitive("1", first, 0.0), Primitive("1", other, 0.0))
    chosen = shortlist(groups, network.predict_outcomes, features, alike, 1)
    assert [one.action for one in chosen] == [first, other]
