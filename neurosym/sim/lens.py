"""Where the camera stands, what it draws, and where a point in the world lies in its pictures."""

from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Float
from neurosym.sim.bullet import pybullet
from neurosym.sim.config import TabletopConfig
from neurosym.world import Frame

WIDTH, HEIGHT = 640, 480
DISTANCE, YAW, PITCH = 1.3, 52.0, -30.0
"""The camera looks at the robot over the table, from its right [m, degrees, degrees]."""
LOOKS_AT_HEIGHT = 0.12
FIELD_OF_VIEW = 36.0
LIGHT_FROM = (0.5, 0.7, 1.6)
LIGHT_DISTANCE = 4.0
"""Of the light from the origin [m]: near ones take longer to cast shadows, which are grown far too large."""

Pixels = Float[np.ndarray, "N 2"]


@dataclass(frozen=True, slots=True)
class Lens:
    """A camera that stands still.

    Attributes:
        target: The point it looks at [m].
        view: OpenGL's view matrix, column by column.
        projection: OpenGL's projection matrix, column by column.
    """

    target: tuple[float, float, float]
    view: tuple[float, ...]
    projection: tuple[float, ...]

    def pixels(self, points: Float[np.ndarray, "N 3"]) -> Pixels:
        """Return where points lie in a picture, rightwards and downwards from its upper left corner.

        Args:
            points: In the world [m], in front of the camera.
        """
        view, projection = (np.reshape(matrix, (4, 4)).T for matrix in (self.view, self.projection))
        clip = np.column_stack([points, np.ones(len(points))]) @ (projection @ view).T  # (N, 4)
        return np.asarray((clip[:, :2] / clip[:, 3:] * [1, -1] + 1) / 2 * [WIDTH, HEIGHT])

    def draw(self, client: int) -> tuple[Frame, Float[np.ndarray, "height width"]]:
        """Render what is in a physics client, without a screen.

        Args:
            client: The physics client.

        Returns:
            The picture, and the depth buffer: 0 near the camera, 1 where nothing is.
        """
        _, _, colours, depths, _ = pybullet.getCameraImage(
            WIDTH,
            HEIGHT,
            self.view,
            self.projection,
            lightDirection=LIGHT_FROM,
            lightDistance=LIGHT_DISTANCE,
            shadow=1,
            renderer=pybullet.ER_TINY_RENDERER,
            flags=pybullet.ER_NO_SEGMENTATION_MASK,
            physicsClientId=client,
        )
        frame = np.array(colours, dtype=np.uint8).reshape(HEIGHT, WIDTH, 4)[:, :, :3]
        return frame, np.array(depths, dtype=float).reshape(HEIGHT, WIDTH)


def lens_over(config: TabletopConfig) -> Lens:
    """Return the lens that has the whole table, the hand and the arm in view.

    Args:
        config: Where the table is.
    """
    target = (sum(config.table_x) / 2, sum(config.table_y) / 2, LOOKS_AT_HEIGHT)
    view = pybullet.computeViewMatrixFromYawPitchRoll(
        cameraTargetPosition=target, distance=DISTANCE, yaw=YAW, pitch=PITCH, roll=0, upAxisIndex=2
    )
    projection = pybullet.computeProjectionMatrixFOV(
        fov=FIELD_OF_VIEW, aspect=WIDTH / HEIGHT, nearVal=0.05, farVal=5
    )
    return Lens(target, view, projection)
