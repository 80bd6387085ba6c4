"""Objects that stand on the table, and an action that grasps one and sets it down at a reference."""

import numpy as np

from neurosym.world import Place, Scene

OPEN, CLOSED = 1.0, 0.0
CARRY = np.array([0, 0, 0, OPEN, 0, 0, 0, CLOSED, 0, 0, 0, CLOSED])
FAR = Place(0.85, 0.2)


def boxes(*rows: tuple[float, float, float, float, float, float]) -> Scene:
    """A scene of boxes, each given as s_x, s_y, d, t and where it stands."""
    table = np.array(rows)
    return Scene(
        features=table[:, :4],
        positions=np.column_stack([table[:, 4:], table[:, 2] / 2]),
        orientations=np.tile([0.0, 0.0, 0.0, 1.0], (len(rows), 1)),
    )
