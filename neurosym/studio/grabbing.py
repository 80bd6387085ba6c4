"""Dragging on the table: a pointer that moves in the picture moves a thing at the height of its grab."""

from collections.abc import Sequence

import numpy as np

_LEVEL = 1e-6


class Grab:
    """One thing that is dragged: it keeps the offset from where it was grabbed.

    Args:
        eye: Where the camera is [m].
        point: Where the thing was grabbed [m].
        centre: Where the thing is [m].
    """

    def __init__(self, eye: Sequence[float], point: Sequence[float], centre: Sequence[float]):
        self._eye, self._height = np.array(eye, dtype=float), float(point[2])
        self._offset = np.subtract(centre, point)[:2]

    def to(self, point: Sequence[float]) -> tuple[float, float] | None:
        """Return where the centre comes to be, x and y [m], if the pointer is over a point at any distance.

        That is where the line of sight through the point meets the level of the grab; None if it does not.
        """
        ray = np.array(point, dtype=float) - self._eye
        if abs(ray[2]) < _LEVEL:
            return None
        share = (self._height - self._eye[2]) / ray[2]
        if not (np.isfinite(share) and share > 0):
            return None
        x, y = ((self._eye + share * ray)[:2] + self._offset).tolist()
        return x, y
