"""Co-clustering finds planted blocks, and codes that are one bit apart are alike."""

from itertools import combinations, permutations

import numpy as np

from neurosym.learning import coclustering
from neurosym.learning.coclustering import cocluster, gray_order, nearest, profiles


def planted(rng, noise=0.05):
    rows, columns = rng.integers(4, size=120), rng.integers(2, size=30)
    blocks = rng.normal(size=(4, 2, 3))
    return blocks[rows][:, columns] + noise * rng.normal(size=(120, 30, 3)), rows, columns


def same_partition(first, second):
    pairs = set(zip(first.tolist(), second.tolist(), strict=True))
    return len(pairs) == len(set(first.tolist())) == len(set(second.tolist()))


def test_planted_blocks_are_found():
    rng = np.random.default_rng(0)
    table, rows, columns = planted(rng)
    found = cocluster(table, 4, 2, rng)
    assert same_partition(found.rows, rows)
    assert same_partition(found.columns, columns)


def test_the_error_is_the_distance_to_block_means():
    rng = np.random.default_rng(1)
    table, _, _ = planted(rng, noise=0.5)
    found = cocluster(table, 3, 2, rng)
    total = 0.0
    for r in range(3):
        for c in range(2):
            block = table[found.rows == r][:, found.columns == c].reshape(-1, 3)
            total += ((block - block.mean(0)) ** 2).sum() if len(block) else 0
    np.testing.assert_allclose(found.error, total / (120 * 30))


def test_profiles_keep_the_distances_between_block_means():
    rng = np.random.default_rng(2)
    columns = np.repeat([0, 1], [10, 20])
    table = rng.normal(size=(5, 2, 3))[:, columns]  # constant within each kind of column
    described = profiles(table, columns, 2)
    for a in range(5):
        for b in range(5):
            expected = ((table[a] - table[b]) ** 2).sum(1).mean()
            np.testing.assert_allclose(((described[a] - described[b]) ** 2).sum(), expected, atol=1e-9)


def test_nearest_agrees_with_every_distance_computed():
    rng = np.random.default_rng(3)
    points, centres = rng.normal(size=(40, 5)), rng.normal(size=(6, 5))
    labels, squares = nearest(points, centres)
    distances = ((points[:, None] - centres) ** 2).sum(2)
    np.testing.assert_array_equal(labels, distances.argmin(1))
    np.testing.assert_allclose(squares, distances.min(1), atol=1e-9)


def test_gray_order_is_the_best_of_all_orders_of_four():
    rng = np.random.default_rng(4)
    centres = rng.normal(size=(4, 2))

    def cost(codes):
        pairs = [(a, b) for a in range(4) for b in range(4) if (codes[a] ^ codes[b]).bit_count() == 1]
        return sum(((centres[a] - centres[b]) ** 2).sum() for a, b in pairs)

    best = min(cost(order) for order in permutations(range(4)))
    np.testing.assert_allclose(cost([int(code) for code in gray_order(centres, rng)]), best)


def test_more_kinds_than_points_are_survived():
    rng = np.random.default_rng(5)
    found = cocluster(np.zeros((3, 2, 1)), 8, 4, rng)
    assert found.error == 0


def test_gray_order_swaps_as_if_the_whole_cost_were_summed_anew_each_time():
    for seed in range(3):
        rng = np.random.default_rng(seed)
        centres = rng.normal(size=(16, 3))
        centres[3] = centres[7]  # two kinds alike, as empty ones are
        distances = ((centres[:, None] - centres) ** 2).sum(2)
        near = np.array([[(a ^ b).bit_count() == 1 for b in range(16)] for a in range(16)])
        order = rng.permutation(16)
        found = order.copy()
        cost = coclustering._swap_until_best(found, distances, near)
        assert found.tolist() == _swapped_naively(order, distances, near).tolist()
        np.testing.assert_allclose(cost, (distances * near[np.ix_(found, found)]).sum())


def _swapped_naively(order, distances, near):
    def cost():
        return (distances * near[np.ix_(order, order)]).sum()

    now, improved = cost(), True
    while improved:
        improved = False
        for b, a in sorted(combinations(range(len(order)), 2), key=lambda pair: pair[::-1]):
            order[[a, b]] = order[[b, a]]
            if cost() < now - 1e-12:
                now, improved = cost(), True
            else:
                order[[a, b]] = order[[b, a]]
    return order
