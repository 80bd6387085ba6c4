"""Co-clustering: symbols for actions and for objects at once, from a table of predicted effects.

The bits can say no more than which of 2^Ka kinds an action is and which of 2^Ko kinds an object is. So the
best they can do is a partition of the rows (actions) and of the columns (objects) of the table of effects
such that each block of the table is as nearly constant as possible. It is found by alternation: with the
objects' kinds held fixed, k-means over the actions, and the other way round.
"""

from typing import NamedTuple

import numpy as np

from neurosym.checks import Float, Int

_ROUNDS = 12
_LLOYD_STEPS = 15
_LEAST_GAIN = 5e-13  # of a swap, so that rounding ends the search


class CoClustering(NamedTuple):
    """Kinds of the rows and columns of a table, and the mean squared distance of entries to block means."""

    rows: Int[np.ndarray, "R"]
    columns: Int[np.ndarray, "C"]
    error: float


def cocluster(
    table: Float[np.ndarray, "R C E"],
    row_kinds: int,
    column_kinds: int,
    rng: np.random.Generator,
    restarts: int = 5,
) -> CoClustering:
    """Partition rows and columns so that blocks are nearly constant; the best of several starts."""
    results = [_alternate(table, row_kinds, column_kinds, rng) for _ in range(restarts)]
    return min(results, key=lambda result: result.error)


def profiles(
    table: Float[np.ndarray, "R C E"], columns: Int[np.ndarray, "C"], kinds: int
) -> Float[np.ndarray, "R D"]:
    """Describe each row by its mean over each kind of column, weighted to keep the distances of the table."""
    members = np.eye(kinds)[columns]  # (C, kinds)
    weights = members / np.sqrt(np.maximum(members.sum(0), 1) * len(columns))
    means = np.tensordot(table, weights.astype(table.dtype), axes=(1, 0))  # (R, E, kinds)
    return means.transpose(0, 2, 1).reshape(len(table), -1)


def nearest(
    points: Float[np.ndarray, "N D"], centres: Float[np.ndarray, "L D"]
) -> tuple[Int[np.ndarray, "N"], Float[np.ndarray, "N"]]:
    """Find the nearest centre of each point, and the squared distance to it."""
    squares = (points**2).sum(1)[:, None] - 2 * points @ centres.T + (centres**2).sum(1)
    labels = squares.argmin(1)
    return labels, np.maximum(squares[np.arange(len(points)), labels], 0)


def kmeans(
    points: Float[np.ndarray, "N D"], kinds: int, rng: np.random.Generator, labels: np.ndarray | None = None
) -> Int[np.ndarray, "N"]:
    """Cluster points by Lloyd's steps, from given labels or from k-means++ seeds; returns labels.

    Args:
        points: What to cluster.
        kinds: How many clusters, at most.
        rng: Source of randomness, owned by the caller.
        labels: Where to begin.
    """
    if labels is None or len(np.unique(labels)) < kinds:
        labels, _ = nearest(points, _seeds(points, kinds, rng))
    for _ in range(_LLOYD_STEPS):
        members = np.eye(kinds)[labels]  # (N, kinds)
        counts = members.sum(0)
        centres = (members.T @ points) / np.maximum(counts, 1)[:, None]
        moved, distances = nearest(points, centres)
        for empty in np.flatnonzero(counts == 0):
            moved[np.argmax(distances)] = empty
            distances[np.argmax(distances)] = 0
        if np.array_equal(moved, labels):
            break
        labels = moved
    return labels


def gray_order(centres: Float[np.ndarray, "L D"], rng: np.random.Generator) -> Int[np.ndarray, "L"]:
    """Give each kind a code such that kinds one bit apart are alike, by swaps while they help.

    A bit that the encoder gets wrong then does little harm.
    """
    kinds = len(centres)
    distances = ((centres[:, None] - centres) ** 2).sum(2)
    codes = np.arange(kinds)
    neighbours = np.array([[(a ^ b).bit_count() == 1 for b in range(kinds)] for a in range(kinds)])
    best, best_cost = codes, np.inf
    for _ in range(20):
        order = rng.permutation(kinds)
        cost = _swap_until_best(order, distances, neighbours)
        if cost < best_cost:
            best, best_cost = order, cost
    return best


def _swap_until_best(order: np.ndarray, distances: np.ndarray, neighbours: np.ndarray) -> float:
    """Swap codes while that brings neighbours nearer; always the first swap in order that does."""
    near = neighbours[np.ix_(order, order)].astype(np.float64)  # (L, L), whose codes are one bit apart
    improved = True
    while improved:
        improved = False
        for a in range(len(order)):
            begin = 0
            while len(better := np.flatnonzero(_gains(a, distances, near)[begin:a] > _LEAST_GAIN)):
                b = begin + int(better[0])
                order[[a, b]] = order[[b, a]]
                near[[a, b]] = near[[b, a]]
                near[:, [a, b]] = near[:, [b, a]]
                begin, improved = b + 1, True
    return float((distances * near).sum())


def _gains(a: int, distances: np.ndarray, near: np.ndarray) -> Float[np.ndarray, "L"]:
    """Compute half of what the cost loses if `a` swaps its code with each other: sums over third kinds."""
    own = np.einsum("ij,ij->i", distances, near)
    swapped = near @ distances[a] + distances @ near[a]
    return np.asarray(own[a] + own - swapped - 2 * distances[a] * near[a])


def _alternate(
    table: np.ndarray, row_kinds: int, column_kinds: int, rng: np.random.Generator
) -> CoClustering:
    flipped = table.transpose(1, 0, 2)
    rows = kmeans(table.reshape(len(table), -1), row_kinds, rng)
    columns, error = np.zeros(len(flipped), dtype=int), np.inf
    for _ in range(_ROUNDS):
        columns = kmeans(profiles(flipped, rows, row_kinds), column_kinds, rng, columns)
        rows = kmeans(profiles(table, columns, column_kinds), row_kinds, rng, rows)
        previous, error = error, _block_error(table, rows, columns, row_kinds, column_kinds)
        if error > previous * (1 - 1e-4):
            break
    return CoClustering(rows=rows, columns=columns, error=error)


def _block_error(
    table: np.ndarray, rows: np.ndarray, columns: np.ndarray, row_kinds: int, column_kinds: int
) -> float:
    row_members, column_members = np.eye(row_kinds)[rows], np.eye(column_kinds)[columns]
    counts = np.outer(row_members.sum(0), column_members.sum(0))
    by_row = np.tensordot(row_members.astype(table.dtype), table, axes=(0, 0))  # (kinds, C, E)
    sums = np.tensordot(by_row, column_members, axes=(1, 0))  # (kinds, E, other kinds)
    explained = (sums**2 / np.maximum(counts, 1)[:, None]).sum()
    return float(((table**2).sum() - explained) / (table.shape[0] * table.shape[1]))


def _seeds(points: np.ndarray, kinds: int, rng: np.random.Generator) -> Float[np.ndarray, "L D"]:
    chosen = [points[rng.integers(len(points))]]
    for _ in range(kinds - 1):
        _, distances = nearest(points, np.array(chosen))
        total = distances.sum()
        share = distances / total if total > 0 else np.full(len(points), 1 / len(points))
        chosen.append(points[rng.choice(len(points), p=share)])
    return np.array(chosen)
