"""What codes stand for at first: planted blocks are found, and codes one bit apart are alike."""

from dataclasses import replace
from itertools import combinations, permutations, product

import numpy as np
import torch
from toy_learning import BRIEF

from neurosym.data.origin import Dimensions
from neurosym.learning.coclustering import cocluster, gray_order
from neurosym.learning.losses import Samples
from neurosym.learning.network import DirectModel
from neurosym.learning.recipes import _costs, find_code_targets
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


def test_costs_count_each_code_of_objects_as_often_as_in_the_whole_table():
    rng, codes = np.random.default_rng(1), np.array([0, 1, 1, 0, 0, 1, 1, 1, 0])
    table, effects = rng.normal(size=(5, 9, 3)), rng.normal(size=(4, 2, 3))
    means = np.stack([table[:, codes == code].mean(1) for code in (0, 1)], axis=1)
    costs = ((means[:, None] - effects) ** 2).sum(3) @ [0.75, 0.25]
    costs -= costs.min(1, keepdims=True)
    found = _costs(table, effects, codes, np.array([0, 0, 0, 1]))
    np.testing.assert_allclose(found, costs / costs.mean(), rtol=1e-5)


# Co-clustering


def planted(rng, noise=0.05):
    rows, columns = rng.integers(4, size=120), rng.integers(2, size=30)
    blocks = rng.normal(size=(4, 2, 3))
    return blocks[rows][:, columns] + noise * rng.normal(size=(120, 30, 3)), rows, columns


def same_partition(first, second):
    pairs = set(zip(first.tolist(), second.tolist(), strict=True))
    return len(pairs) == len(set(first.tolist())) == len(set(second.tolist()))


def test_planted_blocks_are_found_and_more_kinds_than_points_survived():
    rng = np.random.default_rng(0)
    table, rows, columns = planted(rng)
    found = cocluster(table, 4, 2, rng)
    assert same_partition(found.rows, rows)
    assert same_partition(found.columns, columns)
    found = cocluster(np.zeros((3, 2, 1)), 8, 4, rng)
    assert found.error == 0


def test_the_error_is_the_distance_to_block_means():
    rng = np.random.default_rng(1)
    table, _, _ = planted(rng, noise=0.5)
    found = cocluster(table, 3, 2, rng)
    kinds = product(range(3), range(2))
    blocks = [table[found.rows == r][:, found.columns == c].reshape(-1, 3) for r, c in kinds]
    total = sum(((block - block.mean(0)) ** 2).sum() for block in blocks if len(block))
    np.testing.assert_allclose(found.error, total / (120 * 30))


def test_gray_order_is_the_best_of_all_orders_of_four_and_no_swap_helps_among_more():
    def cost(codes):
        pairs = [
            (a, b) for a, b in combinations(range(len(codes)), 2) if (codes[a] ^ codes[b]).bit_count() == 1
        ]
        return sum(((centres[a] - centres[b]) ** 2).sum() for a, b in pairs)

    for seed, kinds in ((4, 4), (5, 4), (6, 16)):
        rng = np.random.default_rng(seed)
        centres = rng.normal(size=(kinds, 2))
        centres[2] = centres[1]  # two kinds alike, as empty ones are
        found = gray_order(centres, rng).tolist()
        assert sorted(found) == list(range(kinds))
        pairs = combinations(range(kinds), 2)
        swaps = ([{a: b, b: a}.get(code, code) for code in found] for a, b in pairs)
        others = permutations(found) if kinds == 4 else swaps
        assert cost(found) <= min(map(cost, others)) + 1e-9
