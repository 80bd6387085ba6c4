"""Where an object comes to lie when it is set down tilted."""

import numpy as np

from neurosym.arrays import Float
from neurosym.sim.shapes import OPEN_THROUGH, OPEN_TOP

_ROUND_CORNERS = 24


def landing_shift(
    features: Float[np.ndarray, "F"], object_in_world: Float[np.ndarray, "3 3"]
) -> Float[np.ndarray, "2"]:
    """Say how far an object's centre moves over the table when it is let go standing on its lowest corner.

    It turns about that corner until the face that points down most lies flat.

    Args:
        features: s_x, s_y, d [m] and t.
        object_in_world: Its rotation, as a matrix.
    """
    corners = _corners(features) @ object_in_world.T  # (corners, 3)
    pivot = corners[np.argmin(corners[:, 2])]
    face = object_in_world[:, np.argmax(np.abs(object_in_world[2]))]
    return np.asarray((pivot - _upright(face * np.sign(face[2])) @ pivot)[:2])


def _corners(features: Float[np.ndarray, "F"]) -> Float[np.ndarray, "corners 3"]:
    x, y, z = features[:3] / 2
    if features[3] > (OPEN_TOP + OPEN_THROUGH) / 2:
        angles = np.linspace(0, 2 * np.pi, _ROUND_CORNERS, endpoint=False)
        outline = np.column_stack([x * np.cos(angles), y * np.sin(angles)])
    else:
        outline = np.array([[x, y], [x, -y], [-x, y], [-x, -y]])
    return np.vstack([np.column_stack([outline, np.full(len(outline), side)]) for side in (-z, z)])


def _upright(axis: Float[np.ndarray, "3"]) -> Float[np.ndarray, "3 3"]:
    """Return the smallest rotation that brings an upward axis to the vertical (Rodrigues' formula)."""
    x, y, z = axis
    cross = np.array([[0.0, 0.0, -x], [0.0, 0.0, -y], [x, y, 0.0]])  # of the axis and the vertical
    return np.asarray(np.eye(3) + cross + cross @ cross / (1 + z))
