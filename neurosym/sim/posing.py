"""Poses of the simulation, and the simple bodies that the robot and the objects are drawn with."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.poses import POSE_SECONDS, Part, PartKind, Pose, PoseSink
from neurosym.sim.arm import Arm
from neurosym.sim.bullet import Client, pybullet
from neurosym.sim.robot import Robot
from neurosym.sim.shapes import boxes_of
from neurosym.sim.simulation import Simulation
from neurosym.sim.urdf import loaded

REST_HEIGHT = 0.35
"""How far above the tallest object there can be a hand waits that is only looked at [m]."""


class Poser:
    """Hands the poses of an interaction to a sink; it only looks, so nothing happens otherwise.

    Args:
        simulation: The scene.
        robot: The robot in it.
        sink: Takes the poses.
    """

    def __init__(self, simulation: Simulation, robot: Robot, sink: PoseSink):
        self._simulation, self._body, self._sink = simulation, robot.body, sink
        self._every = max(1, round(POSE_SECONDS / simulation.config.time_step))
        self._links = [*range(simulation.client.getNumJoints(robot.body))]

    def look(self, phase: str) -> None:
        """Hand over a pose, if it is time for one.

        Args:
            phase: Name of the phase of the motion.
        """
        simulation = self._simulation
        if simulation.ticks % self._every:
            return
        scene, links = simulation.observe(), _links(self._body, self._links, simulation.client)
        seconds = simulation.ticks * simulation.config.time_step
        self._sink(Pose(seconds, phase, links, scene.positions, scene.orientations))


def links_at_rest(simulation: Simulation, arm: Arm) -> Float[np.ndarray, "L 7"]:
    """Return the poses of the links of an arm that waits above the near edge of the table.

    Args:
        simulation: A scene of its own.
        arm: The arm.
    """
    c, robot = simulation.config, Robot(simulation, arm)
    point = np.array([c.table_x[0], sum(c.table_y) / 2, c.height[1] + REST_HEIGHT])
    robot.place_at(point, arm.half_opening)
    links = [*range(simulation.client.getNumJoints(robot.body))]
    return _links(robot.body, links, simulation.client)


def _links(body: int, links: list[int], client: Client) -> Float[np.ndarray, "L 7"]:
    """Return where the frames of the base and of all links are."""
    base = client.getBasePositionAndOrientation(body)
    inertial = client.getDynamicsInfo(body, -1)[3:5]
    frame = pybullet.multiplyTransforms(*base, *pybullet.invertTransform(*inertial))
    states = client.getLinkStates(body, links)
    return np.array([[*frame[0], *frame[1]], *([*state[4], *state[5]] for state in states)])


def object_parts(features: Float[np.ndarray, "F"], wall: float) -> tuple[Part, ...]:
    """Return the boxes that an object is drawn with.

    Args:
        features: s_x, s_y, d [m] and t.
        wall: Thickness of walls and floors [m].
    """
    return tuple(
        Part(
            "box",
            tuple(2 * edge for edge in half),
            centre,
            (0.0, 0.0, math.sin(turn / 2), math.cos(turn / 2)),
        )
        for half, centre, turn in boxes_of(features, wall)
    )


def robot_parts(arm: Arm) -> tuple[Part, ...]:
    """Return the simple bodies that the file of an arm draws it with; meshes are left out.

    Args:
        arm: The arm. Its links are numbered as the simulator does, the base being 0.
    """
    with loaded(arm.urdf, arm.base, visible=True) as (client, body):
        found = client.getVisualShapeData(body)
    return tuple(
        Part(*_KINDS[kind](size), place, turn, link + 1, colour[:3])
        for _, link, kind, size, _, place, turn, colour, *_ in found
        if kind in _KINDS
    )


_KINDS: dict[int, Callable[[Sequence[float]], tuple[PartKind, tuple[float, ...]]]] = {
    pybullet.GEOM_BOX: lambda size: ("box", tuple(size)),
    pybullet.GEOM_CYLINDER: lambda size: ("cylinder", (size[1], size[0])),
    pybullet.GEOM_SPHERE: lambda size: ("sphere", (size[0],)),
}
"""What PyBullet's shapes are as parts; it gives a cylinder's length before its radius."""
