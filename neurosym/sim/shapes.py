"""The objects: boxes, solid or open-topped, built from their features (s_x, s_y, d, t)."""

import numpy as np
from jaxtyping import Float

FEATURE_NAMES = ("s_x", "s_y", "d", "t")
"""Size along x, size along y, height [m], and type: 0 solid, 1 hollow (open at the top)."""

Box = tuple[tuple[float, float, float], tuple[float, float, float]]


def boxes_of(features: Float[np.ndarray, "F"], wall: float) -> list[Box]:
    """List the boxes an object is built from, as (half extents, centre in the object's frame) [m].

    Args:
        features: s_x, s_y, d [m] and t.
        wall: Thickness of the walls and floor of a hollow object [m].
    """
    x, y, z = (float(size) / 2 for size in features[:3])
    if features[3] < 0.5:
        return [((x, y, z), (0.0, 0.0, 0.0))]
    t = wall / 2
    return [
        ((x, y, t), (0.0, 0.0, t - z)),
        ((t, y, z - t), (x - t, 0.0, t)),
        ((t, y, z - t), (t - x, 0.0, t)),
        ((x - 2 * t, t, z - t), (0.0, y - t, t)),
        ((x - 2 * t, t, z - t), (0.0, t - y, t)),
    ]
