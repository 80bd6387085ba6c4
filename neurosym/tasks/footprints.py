"""Footprints: how far apart objects must be, not to stand in one another."""

from collections.abc import Collection

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.problems import ROUNDED, Problem


def footprints_apart(problem: Problem, borne: Collection[str] = ()) -> Float[np.ndarray, "M M 2"]:
    """Return how far apart the centres of two objects must be on x or y, not to stand in each other [m].

    Footprints count as boxes along the axes, which may touch, whatever binary numbers make of their sizes. Of
    two that stand on the table and overlap at the start already nothing is asked.

    Args:
        problem: The problem.
        borne: Names of the objects that rest on others.
    """
    sizes = np.array([item.features[:2] for item in problem.objects], dtype=float)
    apart = (sizes[:, None] + sizes) / 2 - ROUNDED
    spots = problem.scene().positions[:, :2]
    stands = np.array([name not in borne for name in problem.object_names])
    overlap = np.all(np.abs(spots[:, None] - spots) < apart, axis=-1)
    apart[overlap & stands[:, None] & stands] = 0.0
    return np.asarray(apart)


def overlapping(
    spot: Float[np.ndarray, "2"], others: Float[np.ndarray, "M 2"], apart: Float[np.ndarray, "M 2"]
) -> Bool[np.ndarray, " M"]:
    """Say which of some objects an object would stand in; see `footprints_apart`."""
    return np.asarray(np.all(np.abs(others - spot) < apart, axis=-1))


def near_some(
    spots: Float[np.ndarray, "N 2"], others: Float[np.ndarray, "K 2"], apart: Float[np.ndarray, "K 2"]
) -> Bool[np.ndarray, " N"]:
    """Say which of some spots are nearer to some other than they must be, on both axes.

    Args:
        spots: The spots [m].
        others: Where others are [m].
        apart: How far apart the centres must be, for each of the others [m].
    """
    return np.asarray(np.any(np.all(np.abs(spots[:, None] - others) < apart, axis=-1), axis=-1))
