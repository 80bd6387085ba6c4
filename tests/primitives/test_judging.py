"""Judging and variety: what ends alike is sure; what is sure and unlike the others counts."""

from dataclasses import replace
from itertools import product
from math import pi, sqrt, tanh

import numpy as np
import pytest
from toy_learning import LEFT, alike

from neurosym.operators import Primitive
from neurosym.primitives.audition import choose
from neurosym.primitives.reliability import (
    EXACT,
    PLENTY,
    CandidateEffects,
    Performance,
    best_set,
    exactness,
    judge,
)
from neurosym.world import Outcome, Scene
from neurosym.worlds.toy import PUSH_LENGTH


def ended(x, kind="resting", turn=0.0, **more):
    return Performance(kind, (x, 0.0, 0.0), 0.0, turn, **more)


SURE = judge([ended(0.2)] * 4).sureness


@pytest.mark.parametrize(
    ("performances", "sure"),
    [
        ([ended(0.2 + d) for d in (-EXACT, EXACT)], 1 / sqrt(2)),
        ([ended(0.4 + d) for d in (-EXACT, EXACT)], 1 / sqrt(2)),  # however far an object goes
        ([ended(0.2), ended(0.2), ended(0.2), ended(0.0, "held")], 0.75),  # the main way of ending
        ([ended(0.2, "toppled"), ended(0.2, "lost")], 0.0),
        ([ended(0.2), ended(0.2, turn=0.3)] * 2, SURE / 2),
        ([ended(0.2), ended(0.2, disturbs=True)] * 2, SURE / 2),
    ],
)
def test_sure_is_what_ends_alike_without_turning_or_moving_anything_else(performances, sure):
    assert judge(performances).sureness == pytest.approx(sure, abs=0.01)


def test_only_the_main_way_of_ending_is_averaged_and_moving_little_is_worth_little():
    judged = judge([ended(0.2), ended(0.2), ended(0.2), ended(0.0, "held")])
    assert (judged.kind, judged.mean.tolist()) == ("resting", pytest.approx([0.2, 0, 0, 0]))
    assert exactness(np.array([[0.01, 0.0, 0.0]])) == pytest.approx(0.5)
    assert exactness(np.zeros((3, 3))) == 0.0


def test_turn_is_the_angle_between_start_and_end_whatever_the_sign_of_a_quaternion():
    def scene(*orientation):
        return Scene(np.ones((1, 4)), np.zeros((1, 3)), np.array([orientation]))

    def turn(end):
        start = scene(0.0, 0.0, 0.0, 1.0)
        return Outcome(start, end, end, 0, False, False, False, 0.0).turn

    for angle in (0.0, 0.4, pi):
        for sign in (1, -1):
            end = scene(0.0, 0.0, sign * np.sin(angle / 2), sign * np.cos(angle / 2))
            assert turn(end) == pytest.approx(angle, abs=1e-6)
    assert turn(scene(0.0, 0.0, 0.0, 0.0)) == 0.0


CARRY = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.08, 0.1, 0.0, 0.04, 0.0, 0.1)  # the same by way of a height


def risen(action, outcome):
    """Say that an object which is pushed follows the second waypoint up on its way."""
    return replace(outcome, peak_height=float(action[6]) if np.any(outcome.effect) else 0.0)


def naive_worths(effects, chosen):
    found = []
    for place, mine in enumerate(chosen):
        total = 0.0
        for category, share in enumerate(effects.shares):
            others = [effects.means[n, category] for at, n in enumerate(chosen) if at != place]
            here = effects.means[mine, category]
            nearest = min(np.linalg.norm(here - other) for other in [*others, np.zeros(len(here))])
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


def test_best_set_is_nearly_always_the_best_of_all_and_no_single_exchange_makes_it_better():
    shares = []
    for seed in range(30):
        groups, effects = some_rivals(seed)
        chosen = best_set(groups, effects)
        assert all(number in group for number, group in zip(chosen, groups, strict=True))
        worth = total(chosen, effects)
        for place, group in enumerate(groups):
            for candidate in group:
                assert total([*chosen[:place], candidate, *chosen[place + 1 :]], effects) <= worth + 1e-8
        shares.append(worth / max(total(list(every), effects) for every in product(*groups)))
    assert np.mean(np.array(shares) > 1 - 1e-9) >= 0.9
    assert min(shares) > 0.9  # one exchange at a time can get stuck


@pytest.mark.parametrize(("first", "other"), [(LEFT, CARRY), (CARRY, LEFT)])
def test_choices_tell_carrying_from_pushing_equally_far_by_the_height(first, other):
    def outcomes(_, actions):
        return np.column_stack([np.tile([0.0, PUSH_LENGTH, 0.0], (len(actions), 1)), actions[:, 6]])

    rivals = Primitive("0", first, 0.0), Primitive("1", first, 0.0), Primitive("1", other, 0.0)
    options = {"predict": outcomes, "features": np.zeros((50, 4)), "categorise": alike, "seed": 0}
    chosen = choose(rivals, "predictable", world_factory=None, **options).primitives
    assert [one.action for one in chosen] == [first, other]
