"""What codes stand for at first: planted kinds are found, and names cost what they should."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import torch
from toy_learning import BRIEF

from neurosym.data.origin import Dimensions
from neurosym.learning.losses import Samples
from neurosym.learning.network import DirectModel
from neurosym.learning.recipes import _costs, _some_of_each, find_code_targets
from neurosym.learning.training_config import ModelConfig

ALONG_ACTIONS = torch.tensor([[0.0, 0.0], [0.0, 3.0], [2.0, 0.0], [5.0, 5.0]])
ALONG_OBJECTS = torch.tensor([[0.0, 0.0], [1.0, -1.0]])


def kinds_of_actions(actions):
    return 2 * (actions[:, 0] > 0).long() + (actions[:, 1] > 0).long()


class Planted(DirectModel):
    """Says an effect that depends on which of four kinds an action is and which of two an object is.

    Behind it is a peak height that depends on something else; meanings are about effects alone.
    """

    def forward(self, features, actions):  # noqa: D102
        effects = ALONG_ACTIONS[kinds_of_actions(actions)] + ALONG_OBJECTS[(features[:, 0] > 0).long()]
        return torch.cat([effects, 9 * actions[:, :1] * actions[:, 1:]], dim=1)


def planted_targets():
    generator = torch.Generator().manual_seed(0)
    features, actions = (torch.rand(200, width, generator=generator) * 2 - 1 for width in (1, 2))
    samples = Samples(features, actions, torch.zeros(200, 2), torch.zeros(200), -torch.ones(2), torch.ones(2))
    teacher = Planted(Dimensions(1, 2, 2, ()), BRIEF.teacher.network).eval()
    config = replace(BRIEF, naming=replace(BRIEF.naming, table_restarts=5))
    return find_code_targets(teacher, ModelConfig(object_bits=1, action_bits=2), samples, config, generator)


def test_planted_kinds_of_action_and_object_each_get_a_code():
    targets = planted_targets()
    planted = ALONG_ACTIONS[:, None] + ALONG_OBJECTS
    for code in range(4):
        assert any(
            torch.allclose(targets.effects[code][list(order)], planted[kind], atol=1e-5)
            for kind in range(4)
            for order in ((0, 1), (1, 0))
        )
    codes, kinds = targets.action_costs.argmin(1), kinds_of_actions(targets.actions)
    assert len(set(zip(codes.tolist(), kinds.tolist(), strict=True))) == len(set(codes.tolist())) == 4
    object_codes = targets.object_costs.argmin(1)
    is_positive = (targets.features[:, 0] > 0).long()
    assert torch.equal(object_codes, is_positive) or torch.equal(object_codes, 1 - is_positive)


def test_names_cost_the_squared_distance_of_what_they_say():
    targets = planted_targets()
    said = targets.effects.mean(1) - ALONG_OBJECTS.mean(0)  # of each code of actions
    true = ALONG_ACTIONS[kinds_of_actions(targets.actions)]
    expected = ((true[:, None] - said) ** 2).sum(2)
    torch.testing.assert_close(targets.action_costs, expected / expected.mean(), atol=1e-4, rtol=1e-4)


def test_codes_one_bit_apart_are_more_alike_than_those_two_bits_apart():
    effects = planted_targets().effects
    apart = {
        (a, b): float(((effects[a] - effects[b]) ** 2).sum()) * (a ^ b).bit_count()
        for a, b in combinations(range(4), 2)
    }
    far = [value / 2 for (a, b), value in apart.items() if (a ^ b).bit_count() == 2]
    assert max(apart.values()) / 2 in far  # the most different pair is not made neighbours


def test_costs_agree_with_a_naive_computation():
    rng = np.random.default_rng(1)
    table, effects = rng.normal(size=(5, 9, 3)), rng.normal(size=(4, 2, 3))
    codes, whole = np.array([0, 1, 1, 0, 0, 1, 1, 1, 0]), np.array([0, 0, 0, 1])
    costs = np.zeros((5, 4))
    for row in range(5):
        for name in range(4):
            for code, share in ((0, 0.75), (1, 0.25)):
                members = [table[row, column] for column in range(9) if codes[column] == code]
                mean = sum(members) / len(members)
                costs[row, name] += share * sum(
                    (mean[axis] - effects[name, code, axis]) ** 2 for axis in range(3)
                )
        costs[row] -= min(costs[row])
    expected = costs / costs.mean()
    np.testing.assert_allclose(_costs(table, effects, codes, whole), expected, rtol=1e-5)


def test_equally_many_of_each_kind_are_asked_even_of_a_rare_one():
    labels = np.array([0] * 50 + [1] + [3] * 9)
    chosen = _some_of_each(labels, 24, np.random.default_rng(0))
    assert np.bincount(labels[chosen]).tolist() == [8, 8, 0, 8]
