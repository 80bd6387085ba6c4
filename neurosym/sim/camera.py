"""Pictures of the simulation, rendered without a screen."""

import numpy as np
import pybullet
from jaxtyping import Float

from neurosym.sim.simulation import Simulation
from neurosym.world import Frame

WIDTH, HEIGHT = 640, 480
OBJECT_COLOURS = (
    (0.26, 0.53, 0.82, 1.0),
    (0.36, 0.70, 0.36, 1.0),
    (0.80, 0.33, 0.36, 1.0),
    (0.58, 0.42, 0.75, 1.0),
)
"""Blue, green, red, purple: item-01, item-02, ..., over and over."""
TABLE_COLOUR = (0.86, 0.82, 0.76, 1.0)


class Camera:
    """A camera that looks down at the table from the robot's left.

    Args:
        simulation: The scene, whose objects are coloured by their number.
        ghosts: Centres at which the objects are shown once more, transparently [m].
    """

    def __init__(self, simulation: Simulation, ghosts: Float[np.ndarray, "M 3"] | None = None):
        self._client = client = simulation.client
        config = simulation.config
        centre = (sum(config.table_x) / 2, sum(config.table_y) / 2, 0.05)
        self._view = pybullet.computeViewMatrixFromYawPitchRoll(
            cameraTargetPosition=centre, distance=0.95, yaw=50, pitch=-35, roll=0, upAxisIndex=2
        )
        self._projection = pybullet.computeProjectionMatrixFOV(
            fov=45, aspect=WIDTH / HEIGHT, nearVal=0.05, farVal=5
        )
        pybullet.changeVisualShape(simulation.table, -1, rgbaColor=TABLE_COLOUR, physicsClientId=client)
        for index, body in enumerate(simulation.bodies):
            colour = OBJECT_COLOURS[index % len(OBJECT_COLOURS)]
            pybullet.changeVisualShape(body, -1, rgbaColor=colour, physicsClientId=client)

    def mark(self, waypoints: Float[np.ndarray, "3 3"]) -> None:
        """Show the waypoints of an action as dots in the pictures to come.

        Args:
            waypoints: In the world [m].
        """

    def picture(self) -> Frame:
        """Render what the camera sees now."""
        _, _, pixels, _, _ = pybullet.getCameraImage(
            WIDTH,
            HEIGHT,
            self._view,
            self._projection,
            lightDirection=(0.4, 0.6, 1.5),
            shadow=1,
            renderer=pybullet.ER_TINY_RENDERER,
            physicsClientId=self._client,
        )
        return np.array(pixels, dtype=np.uint8).reshape(HEIGHT, WIDTH, 4)[:, :, :3]
