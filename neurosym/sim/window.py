"""A window that shows the simulation live, in real time."""

import ctypes
import sys
import time

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.sim.bullet import pybullet
from neurosym.sim.ghosts import OPACITY, Colour, add_ghosts
from neurosym.sim.lens import PITCH, YAW, Lens
from neurosym.sim.simulation import Simulation
from neurosym.waypoint_dots import DOT_COLOURS
from neurosym.world import Scene

DISTANCE = 1.0
"""Of the camera [m]: windows have a wider view than pictures."""
DOT_RADIUS = 0.007
NO_SCREEN = "No window can be opened here, for want of a screen; leave out --gui to have pictures written."


def open_window() -> int:
    """Open a window and return the physics client behind it.

    Raises:
        InvalidValue: If there is no screen.
    """
    if not _has_screen():
        raise InvalidValue(NO_SCREEN)
    try:
        client = pybullet.connect(pybullet.GUI)
    except pybullet.error as error:
        raise InvalidValue(NO_SCREEN) from error
    if client < 0:
        raise InvalidValue(NO_SCREEN)
    for panel in (pybullet.COV_ENABLE_GUI, pybullet.COV_ENABLE_KEYBOARD_SHORTCUTS):
        pybullet.configureDebugVisualizer(panel, 0, physicsClientId=client)
    return int(client)


def _has_screen() -> bool:
    """Say whether a window can be opened; PyBullet ends the whole process if it finds no X server."""
    if sys.platform != "linux":
        return True
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return False
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(ctypes.c_void_p(display))
    return bool(display)


def is_window(client: int) -> bool:
    """Say whether a physics client is shown in a window."""
    return bool(pybullet.getConnectionInfo(client)["connectionMethod"] == pybullet.GUI)


class Window:
    """What the window shows of one interaction.

    Args:
        simulation: The scene.
        lens: The camera, which the user can move.
        ghosts: The objects, where to show them transparently [m], their colours, and the walls' thickness
            [m], if any are shown.
    """

    def __init__(
        self,
        simulation: Simulation,
        lens: Lens,
        ghosts: tuple[Scene, Float[np.ndarray, "M 3"], list[Colour], float] | None,
    ):
        self._simulation = simulation
        self._client = simulation.client
        self._began = time.monotonic() - simulation.ticks * simulation.config.time_step
        pybullet.resetDebugVisualizerCamera(DISTANCE, YAW, PITCH, lens.target, physicsClientId=self._client)
        if ghosts:
            scene, centres, colours, wall = ghosts
            add_ghosts(self._client, scene, centres, [(*colour[:3], OPACITY) for colour in colours], wall)

    def mark(self, waypoints: Float[np.ndarray, "3 3"]) -> None:
        """Show the waypoints of an action as small balls.

        Args:
            waypoints: In the world [m].
        """
        for place, colour in zip(waypoints.tolist(), DOT_COLOURS, strict=True):
            ball = pybullet.createVisualShape(
                pybullet.GEOM_SPHERE,
                radius=DOT_RADIUS,
                rgbaColor=[*(part / 255 for part in colour), 1.0],
                physicsClientId=self._client,
            )
            pybullet.createMultiBody(0, -1, ball, place, physicsClientId=self._client)

    def keep_time(self) -> None:
        """Wait until as much time has passed as in the simulation."""
        due = self._began + self._simulation.ticks * self._simulation.config.time_step
        time.sleep(max(0.0, due - time.monotonic()))
