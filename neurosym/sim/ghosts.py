"""Ghosts: objects drawn transparently where they shall come to be.

TinyRenderer draws nothing transparently. So the ghosts stand in a physics client of their own, are rendered
once, and are blended into each picture wherever nothing in it is nearer to the camera. The world that is
pictured never holds them, so they cannot change what happens in it.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Float
from neurosym.sim.bullet import pybullet
from neurosym.sim.lens import Lens
from neurosym.sim.shapes import boxes_of
from neurosym.world import Frame, Scene

OPACITY = 0.45

Colour = tuple[float, float, float, float]
Depths = Float[np.ndarray, "height width"]


@dataclass(frozen=True, slots=True, eq=False)
class Ghosts:
    """The ghosts as the camera sees them, and nothing else.

    Attributes:
        colours: Their picture.
        depths: Its depth buffer; 1 where there is no ghost.
    """

    colours: Frame
    depths: Depths

    def over(self, frame: Frame, depths: Depths) -> Frame:
        """Blend the ghosts into a picture.

        Args:
            frame: The picture.
            depths: Its depth buffer.
        """
        rows, columns = np.nonzero((self.depths < 1) & (self.depths <= depths))
        behind = (1 - OPACITY) * frame[rows, columns]
        blended = frame.copy()
        blended[rows, columns] = np.rint(behind + OPACITY * self.colours[rows, columns])
        return blended


def draw_ghosts(
    scene: Scene, centres: Float[np.ndarray, "M 3"], colours: Sequence[Colour], wall: float, lens: Lens
) -> Ghosts:
    """Render the objects of a scene at other places, in a physics client of their own.

    Args:
        scene: The objects.
        centres: Where to show them [m]; NaN for an object that is not shown.
        colours: Of each object.
        wall: Thickness of walls and floors [m].
        lens: The camera.
    """
    client = pybullet.connect(pybullet.DIRECT)
    try:
        add_ghosts(client, scene, centres, colours, wall)
        return Ghosts(*lens.draw(client))
    finally:
        pybullet.disconnect(physicsClientId=client)


def add_ghosts(
    client: int, scene: Scene, centres: Float[np.ndarray, "M 3"], colours: Sequence[Colour], wall: float
) -> None:
    """Add bodies that can be seen and not touched.

    Args:
        client: The physics client.
        scene: The objects.
        centres: Where to show them [m]; NaN for an object that is not shown.
        colours: Of each object.
        wall: Thickness of walls and floors [m].
    """
    for index in np.flatnonzero(np.all(np.isfinite(centres), axis=1)).tolist():
        boxes = boxes_of(scene.features[index], wall)
        shape = pybullet.createVisualShapeArray(
            shapeTypes=[pybullet.GEOM_BOX] * len(boxes),
            halfExtents=[list(half) for half, _, _ in boxes],
            visualFramePositions=[list(centre) for _, centre, _ in boxes],
            visualFrameOrientations=[pybullet.getQuaternionFromEuler((0, 0, turn)) for *_, turn in boxes],
            rgbaColors=[list(colours[index])] * len(boxes),
            physicsClientId=client,
        )
        pybullet.createMultiBody(
            0, -1, shape, centres[index].tolist(), scene.orientations[index].tolist(), physicsClientId=client
        )
