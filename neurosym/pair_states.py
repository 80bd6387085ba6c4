"""How one object stands to another, in numbers that do not depend on how large the two are.

Distances are measured in touching units: along each axis in sums of the half sizes of both, so that 1 means
that they touch. What a robot sees besides: whether they touch anywhere, and how far the target is tilted.
"""

import numpy as np

from neurosym.arrays import Float
from neurosym.world import Scene

DESCRIPTION = ("away", "above", "touching", "tilted", "reference tilted")
"""What the numbers of a description are. Along x or y, whichever is more, the target is so far away from the
reference; along z it is so far above it [touching units]. They touch or not; and the target and the reference
are tilted by so much, as shares of the greatest tilt that counts."""
FARTHEST = 2.5
"""Farther apart than this objects have nothing to do with one another [touching units]."""
STEEPEST = 0.35
"""The tilt of an object counts up to this [rad]."""
LEANING = 0.4
"""What is tilted by more than this share of `STEEPEST` leans."""


def describe_pair(
    scene: Scene, target: int, reference: int, contacts: tuple[tuple[int, int], ...]
) -> Float[np.ndarray, "5"]:
    """Describe how a target stands to a reference, in the numbers of `DESCRIPTION`.

    Args:
        scene: The objects, at rest.
        target: Index of the one.
        reference: Index of the other.
        contacts: Pairs of objects that touch, each with the smaller index first.
    """
    units = touching_units(scene, target, reference)
    away = min(float(np.abs(units[:2]).max()), FARTHEST)
    up = np.clip(units[2], -FARTHEST, FARTHEST)
    pair = (min(target, reference), max(target, reference))
    tilts = (tilt(scene, index) / STEEPEST for index in (target, reference))
    return np.array([away, up, float(pair in contacts), *tilts])


def touching_units(scene: Scene, target: int, reference: int) -> Float[np.ndarray, "3"]:
    """Return where a target is relative to a reference, in sums of their half sizes along each axis.

    Args:
        scene: The objects.
        target: Index of the one.
        reference: Index of the other.
    """
    reach = (extent(scene, target) + extent(scene, reference)) / 2
    away: np.ndarray = (scene.positions[target] - scene.positions[reference]) / reach
    return away


def extent(scene: Scene, index: int) -> Float[np.ndarray, "3"]:
    """Return the sizes of an object along the axes of the world as it lies [m].

    Args:
        scene: The objects.
        index: Which one.
    """
    sizes: np.ndarray = np.abs(rotation(scene.orientations[index])) @ scene.features[index][:3]
    return sizes


def tilt(scene: Scene, index: int) -> float:
    """Return how far an object is tilted from lying on a face, at most `STEEPEST` [rad].

    Args:
        scene: The objects.
        index: Which one.
    """
    steepest = float(np.abs(rotation(scene.orientations[index])[2]).max())
    return min(float(np.arccos(min(1.0, steepest))), STEEPEST)


def rotation(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3 3"]:
    """Return the matrix of a rotation, whose columns are the axes of the object.

    Args:
        quaternion: The rotation, as (x, y, z, w), of any length but 0.
    """
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
