"""Dots that mark the waypoints of an action in a picture, as in the paper: blue, green, red."""

import math

import numpy as np

from neurosym.arrays import Float, UInt8
from neurosym.world import Frame

DOT_COLOURS = ((31, 98, 224), (30, 160, 70), (222, 40, 45))
"""Of waypoints 1, 2 and 3: where the motion starts, its middle, its end."""
_RIM_COLOUR = (255, 255, 255)
_RIM = 0.25  # width of the rim, as a share of the radius


def draw_dots(frame: Frame, places: Float[np.ndarray, "N 2"], radius: float) -> Frame:
    """Draw a round dot with a white rim at each place, smooth at its edge; later dots lie on earlier ones.

    Args:
        frame: The picture, which is left as it is.
        places: Centres of the dots, rightwards and downwards from the upper left corner [pixels].
        radius: Of a dot without its rim [pixels].
    """
    picture = frame.copy()
    for number, (x, y) in enumerate(places.tolist()):
        for reach, colour in (
            ((1 + _RIM) * radius, _RIM_COLOUR),
            (radius, DOT_COLOURS[number % len(DOT_COLOURS)]),
        ):
            _draw_disc(picture, x, y, reach, np.array(colour, dtype=np.uint8))
    return picture


def _draw_disc(picture: Frame, x: float, y: float, radius: float, colour: UInt8[np.ndarray, "3"]) -> None:
    """Draw a disc into a picture, each pixel covered by as much of it as lies inside."""
    top, left = (max(0, math.floor(middle - radius - 1)) for middle in (y, x))
    part = picture[top : max(0, math.ceil(y + radius + 1)), left : max(0, math.ceil(x + radius + 1))]
    rows, columns = np.indices(part.shape[:2]) + 0.5
    distance = np.hypot(columns + left - x, rows + top - y)
    cover = np.clip(radius - distance + 0.5, 0, 1)[:, :, None]  # (rows, columns, 1)
    part[:] = np.rint((1 - cover) * part + cover * colour)
