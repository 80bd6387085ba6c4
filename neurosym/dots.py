"""Dots that mark the waypoints of an action in a picture, as in the paper: blue, green, red."""

import numpy as np
from jaxtyping import Float

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
    picture = frame.astype(float)
    rows, columns = np.indices(frame.shape[:2]) + 0.5
    for number, (x, y) in enumerate(places):
        distance = np.hypot(columns - x, rows - y)
        for reach, colour in (
            ((1 + _RIM) * radius, _RIM_COLOUR),
            (radius, DOT_COLOURS[number % len(DOT_COLOURS)]),
        ):
            cover = np.clip(reach - distance + 0.5, 0, 1)[:, :, None]  # (height, width, 1)
            picture += cover * (np.array(colour) - picture)
    return np.asarray(np.rint(picture), dtype=np.uint8)
