"""The objects: boxes, open-topped boxes, planks and rings, built from their features (s_x, s_y, d, t)."""

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from neurosym.arrays import Float
from neurosym.object_limits import Range

FEATURE_NAMES = ("s_x", "s_y", "d", "t")
"""Size along x, size along y, height [m], and type: 0 solid, 1 open at the top, 2 open at both ends."""
SOLID, OPEN_TOP, OPEN_THROUGH = 0.0, 1.0, 2.0
RING_SEGMENTS = 12

Box = tuple[tuple[float, float, float], tuple[float, float, float], float]
"""Half extents [m], centre in the object's frame [m], and turn about the object's z axis [rad]."""


def boxes_of(features: Float[np.ndarray, "F"], wall: float) -> list[Box]:
    """List the boxes that an object is built from.

    Args:
        features: s_x, s_y, d [m] and t.
        wall: Thickness of walls and floors [m].
    """
    x, y, z = (float(size) / 2 for size in features[:3])
    if features[3] < (SOLID + OPEN_TOP) / 2:
        return [((x, y, z), (0.0, 0.0, 0.0), 0.0)]
    if features[3] < (OPEN_TOP + OPEN_THROUGH) / 2:
        return _open_box(x, y, z, wall / 2)
    return _ring(x, y, z, wall / 2)


def _open_box(x: float, y: float, z: float, t: float) -> list[Box]:
    return [
        ((x, y, t), (0.0, 0.0, t - z), 0.0),
        ((t, y, z - t), (x - t, 0.0, t), 0.0),
        ((t, y, z - t), (t - x, 0.0, t), 0.0),
        ((x - 2 * t, t, z - t), (0.0, y - t, t), 0.0),
        ((x - 2 * t, t, z - t), (0.0, t - y, t), 0.0),
    ]


def _ring(x: float, y: float, z: float, t: float) -> list[Box]:
    """Build a ring (an ellipse, if x and y differ) of straight segments."""
    corners = [
        np.array([(x - t) * math.cos(angle), (y - t) * math.sin(angle)])
        for angle in np.linspace(0, 2 * math.pi, RING_SEGMENTS + 1)
    ]
    boxes: list[Box] = []
    for start, end in pairwise(corners):
        middle, along = (start + end) / 2, end - start
        half = float(np.linalg.norm(along)) / 2
        turn = math.atan2(along[1], along[0])
        boxes.append(((half, t, z), (float(middle[0]), float(middle[1]), 0.0), turn))
    return boxes


def _part(whole: Range, low: float, high: float) -> Range:
    """Return the part of a range between two shares of its length."""
    least, greatest = whole
    return least + low * (greatest - least), least + high * (greatest - least)


def _box(rng: np.random.Generator, size: Range, height: Range) -> tuple[float, ...]:
    return rng.uniform(*size), rng.uniform(*size), rng.uniform(*height), SOLID


def _open_topped(rng: np.random.Generator, size: Range, height: Range) -> tuple[float, ...]:
    return rng.uniform(*size), rng.uniform(*size), rng.uniform(*height), OPEN_TOP


def _plank(rng: np.random.Generator, size: Range, height: Range) -> tuple[float, ...]:
    sides = [rng.uniform(*_part(size, 0.5, 1.0)), rng.uniform(*_part(size, 0.0, 0.25))]
    if rng.random() < 0.5:
        sides.reverse()
    return *sides, rng.uniform(*_part(height, 0.0, 0.25)), SOLID


def _round(rng: np.random.Generator, size: Range, height: Range) -> tuple[float, ...]:
    diameter = rng.uniform(*_part(size, 0.5, 1.0))
    return diameter, diameter, rng.uniform(*_part(height, 0.0, 0.5)), OPEN_THROUGH


TYPES = {"box": SOLID, "open-box": OPEN_TOP, "plank": SOLID, "ring": OPEN_THROUGH}
"""The type of each shape."""
SHAPES: dict[str, Callable[[np.random.Generator, Range, Range], tuple[float, ...]]] = {
    "box": _box,
    "open-box": _open_topped,
    "plank": _plank,
    "ring": _round,
}
"""Draws the features of an object of each shape from the ranges of sizes and heights [m].

A plank is a flat solid box, one side in the upper half of the sizes and the other in the lowest quarter; a
ring is round, in the upper half of the sizes and the lower half of the heights.
"""
