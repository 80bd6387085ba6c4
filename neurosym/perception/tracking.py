"""Which region is which object: what was known of objects meets what is seen now."""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.optimize import linear_sum_assignment
from scipy.spatial.transform import Rotation

from neurosym.checks import Float
from neurosym.perception.regions import Region

FITS = 0.015
"""A region is not of an object if their extents differ by more along any axis [m]."""
_ALIKE = 0.004  # ways to lie whose extents differ by no more than this are not told apart by them [m]
_MOVED = 0.2  # how much the distance from where it was counts of what was acted upon, beside others


@dataclass(frozen=True, slots=True, eq=False)
class Tracked:
    """Where known objects are seen."""

    positions: Float[np.ndarray, "M 3"]  #: Their middles [m]; as they were where nothing was seen
    orientations: Float[np.ndarray, "M 4"]  #: As quaternions (x, y, z, w); likewise
    is_seen: tuple[bool, ...]  #: Which objects are told apart from all others


def track(
    found: list[Region],
    sizes: Float[np.ndarray, "M 3"],
    positions: Float[np.ndarray, "M 3"],
    orientations: Float[np.ndarray, "M 4"],
    target: int | None = None,
) -> Tracked:
    """Find objects that are known among regions.

    An object and a region belong together if their extents fit, however the object lies; of several, those
    near to where it was. Objects that touch make one region that fits none of them, and are not told apart.

    Args:
        found: What is seen.
        sizes: Sizes of objects along their own axes [m].
        positions: Where they were [m].
        orientations: How they lay.
        target: Which object was acted upon, if any; it may be far from where it was.
    """
    misfits = np.array([[_misfit(one, size) for one in found] for size in sizes]).reshape(len(sizes), -1)
    apart = np.array([[math.dist(one.position[:2], at[:2]) for one in found] for at in positions])
    apart = apart.reshape(misfits.shape)
    if target is not None:
        apart[target] *= _MOVED
    costs = np.where(misfits <= FITS, apart + misfits, 1e3)
    placed, lying = positions.copy(), orientations.copy()
    seen = [False] * len(sizes)
    for row, column in zip(*linear_sum_assignment(costs), strict=True):
        if costs[row, column] < 1e3:
            one = found[column]
            lying[row] = _lying(one, sizes[row], orientations[row])
            placed[row], seen[row] = one.position, True
    return Tracked(placed, lying, tuple(seen))


def _misfit(region: Region, size: Float[np.ndarray, "3"]) -> float:
    """Return by how much the extents of a region differ from those of an object, however it lies [m]."""
    return float(_misfits(region, size).min())


def _misfits(region: Region, size: Float[np.ndarray, "3"]) -> Float[np.ndarray, "24"]:
    extents = np.abs(_quarters().as_matrix()) @ size  # (24, 3)
    return np.asarray(np.abs(extents - region.size).max(1))


def _lying(
    region: Region, size: Float[np.ndarray, "3"], before: Float[np.ndarray, "4"]
) -> Float[np.ndarray, "4"]:
    """Return how an object lies that is seen as a region: of all ways that fit, the one nearest to before."""
    misfits = _misfits(region, size)
    ways = Rotation.from_euler("z", region.heading) * _quarters()
    away = (ways * Rotation.from_quat(before).inv()).magnitude()
    away[misfits > misfits.min() + _ALIKE] = np.inf
    return np.asarray(ways[int(away.argmin())].as_quat(canonical=True))


@cache
def _quarters() -> Rotation:
    """All turns by quarters about any axes."""
    return Rotation.create_group("O")
