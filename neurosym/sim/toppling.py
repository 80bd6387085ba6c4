"""How objects are turned, and whether they toppled."""

import math

import numpy as np

from neurosym.arrays import Float
from neurosym.sim.bullet import pybullet
from neurosym.world import Scene

TOPPLED_COSINE = math.cos(math.radians(30))
"""An object has toppled when its up axis has turned by more than 30 degrees."""


def has_toppled(start: Scene, end: Scene, target: int) -> bool:
    """Say whether an object of a scene lies on another face at the end.

    Args:
        start: The scene before.
        end: The scene after.
        target: Index of the object.
    """
    before, after = (rotation(scene.orientations[target])[:, 2] for scene in (start, end))
    return bool(before @ after < TOPPLED_COSINE)


def rotation(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3 3"]:
    """Return the matrix of an orientation."""
    return np.array(pybullet.getMatrixFromQuaternion(quaternion)).reshape(3, 3)
