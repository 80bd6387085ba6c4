"""Dragging on the table: a pointer that moves in the picture moves a thing at the height of its grab."""

from collections.abc import Sequence

import numpy as np

_LEVEL = 1e-6


def on_plane(eye: Sequence[float], point: Sequence[float], height: float) -> tuple[float, float] | None:
    """Return where the line of sight through a point meets a level plane; None if it does not.

    Args:
        eye: Where the camera is [m].
        point: A point that the pointer is over, at any distance [m].
        height: Of the plane [m].
    """
    start, ray = np.array(eye, dtype=float), np.array(point, dtype=float) - np.array(eye, dtype=float)
    if abs(ray[2]) < _LEVEL:
        return None
    share = (height - start[2]) / ray[2]
    if not (np.isfinite(share) and share > 0):
        return None
    x, y = (start + share * ray)[:2]
    return float(x), float(y)


class Grab:
    """One thing that is dragged: it keeps the offset from where it was grabbed.

    Args:
        eye: Where the camera is [m].
        point: Where the thing was grabbed [m].
        centre: Where the thing is [m].
    """

    def __init__(self, eye: Sequence[float], point: Sequence[float], centre: Sequence[float]):
        self._eye, self._height = eye, float(point[2])
        self._offset = (float(centre[0] - point[0]), float(centre[1] - point[1]))

    def to(self, point: Sequence[float]) -> tuple[float, float] | None:
        """Return where the centre comes to be, x and y [m], if the pointer is over a point."""
        at = on_plane(self._eye, point, self._height)
        return None if at is None else (at[0] + self._offset[0], at[1] + self._offset[1])
