"""Contests: whoever may become the best performs, and no one else."""

import numpy as np
import pytest

from neurosym.operators import Primitive
from neurosym.primitives.bandit import AT_ONCE, BLOCK, Contest, _expected_excess, hold, trusted
from neurosym.primitives.reliability import Judgement
from neurosym.world import Outcome, Scene

ONES = [Primitive("0", (float(n),), 0.0) for n in range(8)]


def contest(chances, foreseen, scenes=400, share=1.0):
    """Begin a contest in which candidates succeed that often, as is foreseen more or less."""
    prior = {one: Judgement("carried", np.zeros(4), sure) for one, sure in zip(ONES, foreseen, strict=False)}

    def judge(outcomes):
        return Judgement("carried", np.zeros(4), float(np.mean([one.held for one in outcomes])))

    numbered = [Scene(np.array([[float(n)]]), np.zeros((1, 3)), np.zeros((1, 4))) for n in range(scenes)]
    made = Contest(share, numbered, [[*prior]], prior, judge)
    return made, dict(zip(ONES, chances, strict=False))


def performer(chances, counts=None):
    def perform(asked):
        if counts is not None:
            counts.append(len(asked))
        return [succeeding(scene, draw(one, scene) < chances[one]) for one, scene in asked]

    return perform


def draw(one, scene):
    return np.random.default_rng([int(scene.features[0, 0]), int(one.action[0])]).random()


def succeeding(scene, held):
    return Outcome(scene, scene, scene, 0, held=bool(held), toppled=False, lost=False, peak_height=0.0)


@pytest.mark.parametrize("best", range(4))
def test_the_best_is_found_whatever_was_foreseen(best):
    chances = [0.9 if n == best else 0.3 for n in range(4)]
    one, known = contest(chances, [0.5, 0.4, 0.6, 0.5])
    hold([one], performer(known), budget=160, least=1e-6)
    assert one.best(1.0) == [ONES[best]]


def test_performances_go_to_rivals_and_not_to_who_is_foreseen_to_fail():
    one, known = contest([0.6, 0.55, 0.05, 0.0], [0.6, 0.6, 0.05, 0.0])
    hold([one], performer(known), budget=120, least=1e-6)
    counts = [len(one.seen.get(each, ())) for each in ONES[:4]]
    assert sum(counts) <= 120
    assert counts[0] + counts[1] > 0.8 * sum(counts)
    assert counts[3] == 0


def test_what_is_met_often_gets_more():
    often, known = contest([0.6, 0.5], [0.5, 0.5], share=0.9)
    rarely, _ = contest([0.6, 0.5], [0.5, 0.5], share=0.1)
    hold([often, rarely], performer(known), budget=80, least=1e-6)
    spent = [sum(map(len, each.seen.values())) for each in (often, rarely)]
    assert spent[0] > spent[1]


def test_it_ends_with_the_budget_the_scenes_or_when_nothing_is_worth_it():
    one, known = contest([0.6, 0.5], [0.5, 0.5])
    counts = []
    hold([one], performer(known, counts), budget=7, least=1e-6)
    assert counts == [AT_ONCE]
    few, _ = contest([0.6, 0.5], [0.5, 0.5], scenes=10)
    hold([few], performer(known), budget=500, least=0.0)
    assert sum(map(len, few.seen.values())) == 2 * 8  # whole bundles
    clear, known = contest([1.0, 0.0], [0.9, 0.1])
    hold([clear], performer(known), budget=500, least=1e-5)
    assert not clear.seen
    hold([], performer(known), budget=10, least=0.0)
    counts = []
    several, known = contest([0.6, 0.55], [0.5, 0.5])
    hold([several], performer(known, counts), budget=300, least=0.0)
    assert max(counts) <= BLOCK


def test_what_did_not_perform_can_be_left_out():
    one, known = contest([0.6, 0.5], [0.7, 0.9])
    one.seen[ONES[0]] = performer(known)([(ONES[0], scene) for scene in one.scenes[:8]])
    assert one.best(1.0) == [ONES[1]]
    assert one.best(1.0, is_seen=True) == [ONES[0]]


def test_predictions_are_trusted_as_far_as_they_came_true():
    one, known = contest([0.2, 0.2], [0.8, 0.8])
    assert trusted([one]) == 1.0
    hold([one], performer(known), budget=200, least=0.0)
    assert trusted([one]) < 0.5


@pytest.mark.parametrize(("ahead", "spread"), [(0.0, 1.0), (0.5, 0.3), (2.0, 1.5)])
def test_expected_excess_is_what_draws_exceed(ahead, spread):
    drawn = np.random.default_rng(0).normal(0, spread, 400_000)
    assert _expected_excess(ahead, spread) == pytest.approx(np.maximum(drawn - ahead, 0).mean(), abs=0.004)
    assert _expected_excess(ahead, 0.0) == 0.0
