"""Poses of the simulation, and the simple bodies that the robot and the objects are drawn with."""

import math
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from neurosym.arrays import Float
from neurosym.poses import POSE_SECONDS, Part, Pose, PoseSink
from neurosym.reading import read_text
from neurosym.sim.arm import Arm
from neurosym.sim.bullet import pybullet
from neurosym.sim.robot import Robot
from neurosym.sim.shapes import boxes_of
from neurosym.sim.simulation import Simulation

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
        self._links = [*range(pybullet.getNumJoints(robot.body, physicsClientId=simulation.client))]

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
    links = [*range(pybullet.getNumJoints(robot.body, physicsClientId=simulation.client))]
    return _links(robot.body, links, simulation.client)


def _links(body: int, links: list[int], client: int) -> Float[np.ndarray, "L 7"]:
    """Return where the frames of the base and of all links are."""
    base = pybullet.getBasePositionAndOrientation(body, physicsClientId=client)
    inertial = pybullet.getDynamicsInfo(body, -1, physicsClientId=client)[3:5]
    frame = pybullet.multiplyTransforms(*base, *pybullet.invertTransform(*inertial))
    states = pybullet.getLinkStates(body, links, physicsClientId=client)
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
    robot = ElementTree.fromstring(read_text(Path(arm.urdf)))
    colours = {
        one.get("name", ""): _colour(one) for one in robot.iter("material") if one.find("color") is not None
    }
    links = {link.get("name", ""): link for link in robot.iter("link")}
    parts = []
    for number, name in enumerate(_order(robot, [*links])):
        for visual in links[name].iter("visual"):
            if part := _part(visual, number, colours):
                parts.append(part)
    return tuple(parts)


def _order(robot: ElementTree.Element, links: list[str]) -> list[str]:
    """List the links as the simulator numbers them: from the root, each with all that hangs on it."""
    ends = [(one.find("parent"), one.find("child")) for one in robot.findall("joint")]
    pairs = [
        (above.get("link", ""), below.get("link", ""))
        for above, below in ends
        if above is not None and below is not None
    ]
    below = {child for _, child in pairs}
    ordered: list[str] = []
    waiting = [name for name in links if name not in below]
    while waiting:
        name = waiting.pop(0)
        ordered.append(name)
        waiting = [child for parent, child in pairs if parent == name] + waiting
    return ordered


def _part(
    visual: ElementTree.Element, link: int, colours: dict[str, tuple[float, float, float]]
) -> Part | None:
    shape, origin, material = visual.find("geometry/*"), visual.find("origin"), visual.find("material")
    place = origin.attrib if origin is not None else {}
    x, y, z = _numbers(place.get("xyz", "0 0 0"))
    turn = pybullet.getQuaternionFromEuler(_numbers(place.get("rpy", "0 0 0")))
    colour = colours.get(material.get("name", "")) if material is not None else None
    if shape is None:
        return None
    if shape.tag == "box":
        return Part("box", _numbers(shape.get("size", "")), (x, y, z), turn, link, colour)
    if shape.tag == "cylinder":
        size = (float(shape.get("radius", 0)), float(shape.get("length", 0)))
        return Part("cylinder", size, (x, y, z), turn, link, colour)
    if shape.tag == "sphere":
        return Part("sphere", (float(shape.get("radius", 0)),), (x, y, z), turn, link, colour)
    return None


def _colour(material: ElementTree.Element) -> tuple[float, float, float]:
    colour = material.find("color")
    red, green, blue, *_ = _numbers(colour.get("rgba", "") if colour is not None else "1 1 1")
    return red, green, blue


def _numbers(text: str) -> tuple[float, ...]:
    return tuple(float(word) for word in text.split())
