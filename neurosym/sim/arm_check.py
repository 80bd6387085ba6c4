"""Whether an arm is as its file says: driven as `robot.py` drives it, its tool moves and its fingers part.

Each finger is set to what it will be told, and what that moves is looked at in the tool's frame.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, product

import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidArm
from neurosym.sim.config import (
    TOOL_DOWN,
    Arm,
    Client,
    TabletopConfig,
    check_reach,
    corners,
    loaded,
    pybullet,
)
from neurosym.sim.interaction import MARGIN, Interaction
from neurosym.sim.numeric_inverse import forward, read_chain
from neurosym.sim.robot import LOWEST_TOOL_POINT
from neurosym.sim.shapes import SOLID
from neurosym.sim.simulation import Simulation
from neurosym.world import Scene

OFF, OFF_TURN = 0.001, 0.01
"""How far the tool may be from where it is wanted [m], [rad], and a finger from its way [m]."""
LOOSE = 0.01
"""How far closed fingers may stay apart or overlap [m]; shapes that collide are often coarse."""
BESIDE = 0.005
"""How far the fingertips may be beside the tool point [m]."""
_FARTHEST = 10.0
_LEAST_LIFTED = 0.8  # share of the way of the hand by which the plain box must rise


@dataclass(frozen=True, slots=True)
class _Link:
    """A link with the joint that it hangs on; both have the same index, and `above` are those of links above.

    The least limit [m], [rad] is greater than the greatest if there are none.
    """

    index: int
    name: str
    kind: int
    limits: tuple[float, float]
    above: tuple[int, ...]

    def __str__(self) -> str:
        return f"{self.name} ({self.index})"

    @property
    def moves(self) -> bool:
        return bool(self.kind != pybullet.JOINT_FIXED)


def check_arm(config: TabletopConfig, arm: Arm) -> None:
    """Raise `InvalidArm` unless an arm is as its file says, or `InvalidValue` if it reaches too little."""
    _check_file(arm)
    check_reach(config, arm)
    points = corners(config)
    angles = np.asarray(arm.inverse_kinematics(points), dtype=float)
    if angles.shape != (shape := (len(points), len(arm.joints))) or not np.isfinite(angles).all():
        raise InvalidArm(
            f"of {arm.urdf} has inverse_kinematics that gives {angles.shape} for {len(points)} points; "
            f"valid: finite angles, {shape}"
        )
    geometry = read_chain(arm.urdf, arm.base, tuple(arm.joints), arm.tool)
    for point, pose in zip(points, forward(geometry, angles)[0], strict=True):
        away, turned = np.linalg.norm(pose[:3, 3] - point), np.abs(pose[:3, :3] - TOOL_DOWN).max()
        if away > OFF or turned > OFF_TURN:
            raise InvalidArm(
                f"of {arm.urdf} has inverse_kinematics that brings the tool to {_said(pose[:3, 3])} m, its z "
                f"axis along {_said(pose[:3, 2])}, where {_said(point)} m and (0, 0, -1) are asked for, y "
                "along the world's -y; valid: angles for the same file, base, joints and tool"
            )


def _check_file(arm: Arm) -> None:
    with loaded(arm.urdf) as (client, body):
        links: list[_Link] = []
        for index in range(client.getNumJoints(body)):
            info = client.getJointInfo(body, index)
            above = () if info[16] < 0 else (*links[info[16]].above, info[16])
            links.append(_Link(index, info[1].decode(errors="replace"), info[2], info[8:10], above))
        problems = chain(_problems(links, arm), _motions(client, body, links, arm))
        if problem := next(problems, None):  # the first: each check relies on those before
            raise InvalidArm(f"of {arm.urdf} {problem}")


def _problems(links: Sequence[_Link], arm: Arm) -> Iterator[str]:
    """Tell what is wrong with the joints."""
    for index in (*arm.joints, *arm.fingers, arm.tool):
        if not 0 <= index < len(links):
            yield f"has no joint or link {index}; valid: 0 to {len(links) - 1}, as getJointInfo counts them"
    for link in (links[index] for index in arm.joints):
        if link.kind not in (pybullet.JOINT_REVOLUTE, pybullet.JOINT_PRISMATIC):
            yield f"has the joint {link}, which neither turns nor slides; valid: one that does"
    if [*arm.joints] != sorted(arm.joints):
        yield f"has joints = {arm.joints}; valid: in the order from base to tool"
    for link in (links[index] for index in arm.fingers):
        yield from _finger(links, link, arm)
    tool = links[arm.tool]
    for finger in arm.fingers:
        if finger in (tool.index, *tool.above):
            yield f"has the tool {tool}, which the finger {links[finger]} moves; valid: a link of the palm"
    yield from _not_driven(links, (*tool.above, tool.index), arm.joints, f"the tool {tool}")


def _finger(links: Sequence[_Link], finger: _Link, arm: Arm) -> Iterator[str]:
    if finger.kind != pybullet.JOINT_PRISMATIC:
        how = "is fixed" if not finger.moves else "does not slide"
        yield f"has the finger {finger}, whose joint {how}; valid: two fingers on sliding joints"
    (least, greatest), wanted = finger.limits, arm.half_opening
    if least > OFF or greatest < wanted - OFF:
        yield (
            f"has the finger {finger}, whose limits are {least:g} and {greatest:g} m; valid: from 0 (or "
            f"less) to half_opening = {wanted:g} m (or more), opening in the positive sense"
        )
    yield from _not_driven(links, finger.above, arm.joints, f"the finger {finger}")
    for link in links:
        if finger.index in link.above and link.moves:
            yield f"has the joint {link} on the finger {finger}, which nothing drives; valid: a fixed joint"


def _not_driven(
    links: Sequence[_Link], way: Sequence[int], joints: Sequence[int], what: str
) -> Iterator[str]:
    """Tell which joints move something and are not the arm's, or the other way round."""
    for index in way:
        if links[index].moves and index not in joints:
            yield f"has the joint {links[index]}, which moves {what} and is none of joints = {tuple(joints)}"
    for index in joints:
        if index not in way:
            yield f"has the joint {links[index]} among its joints, which does not move {what}"


def _motions(client: Client, body: int, links: Sequence[_Link], arm: Arm) -> Iterator[str]:
    """Tell what the fingers do amiss in the tool's frame, which is made the world's."""
    wanted, fingers = arm.half_opening, arm.fingers
    named = " and ".join(str(links[finger]) for finger in fingers)
    parts: list[list[int]] = []  # links that move with each finger and can touch something
    for finger in fingers:
        moving = [link.index for link in links if finger in (link.index, *link.above)]
        parts.append([link for link in moving if client.getCollisionShapeData(body, link)])
        if not parts[-1]:
            yield f"has the finger {links[finger]}, which has no collision shape; valid: one that touches"
    for link in links:
        client.resetJointState(body, link.index, 0.0)
    tool = client.getLinkState(body, arm.tool, computeForwardKinematics=1)[4:6]
    base = client.getBasePositionAndOrientation(body)
    home = pybullet.multiplyTransforms(*pybullet.invertTransform(*tool), *base)
    client.resetBasePositionAndOrientation(body, *home)
    closed, gap, middle = _fingers_at(client, body, arm, parts, 0.0)
    boxes = np.array([client.getAABB(body, part) for part in chain(*parts)])  # (P, 2, 3)
    low, high = boxes[:, 0].min(0), boxes[:, 1].max(0)
    opened, open_gap, _ = _fingers_at(client, body, arm, parts, wanted)
    ways = opened - closed  # (2, 3)
    for finger, way in zip(fingers, ways, strict=True):
        if abs(abs(way[1]) - wanted) > OFF or np.abs(way[[0, 2]]).max() > OFF:
            yield (
                f"has the finger {links[finger]}, which goes by {_said(way)} m in the frame of the tool "
                f"{links[arm.tool]} when its joint goes by {wanted:g} m; valid: by that along the y axis"
            )
    if ways[0, 1] * ways[1, 1] > 0:
        yield f"has the fingers {named}, which both open to one side; valid: axes that point apart"
    if abs(gap) > LOOSE or abs(open_gap - 2 * wanted) > LOOSE:
        yield (
            f"has the fingers {named}, which are {gap:.3f} m apart at 0 and {open_gap:.3f} m at half_opening "
            f"= {wanted:g} m; valid: they meet at 0, and part in the positive sense to {2 * wanted:g} m"
        )
    is_around = low[0] <= BESIDE and high[0] >= -BESIDE and low[2] <= BESIDE
    if abs(middle) > BESIDE or not is_around or not -BESIDE <= high[2] <= LOWEST_TOOL_POINT + BESIDE:
        yield (
            f"has the tool {links[arm.tool]}, in whose frame the fingers reach from {_said(low)} to "
            f"{_said(high)} m; valid: the point where the tips meet, at most {LOWEST_TOOL_POINT:g} m before "
            "their ends, z pointing out of the hand"
        )


def _fingers_at(
    client: Client, body: int, arm: Arm, parts: Sequence[Sequence[int]], position: float
) -> tuple[Float[np.ndarray, "2 3"], float, float]:
    """Set both fingers; return where their frames are, their gap, and its middle along y [m]."""
    for finger in arm.fingers:
        client.resetJointState(body, finger, position)
    states = client.getLinkStates(body, arm.fingers, computeForwardKinematics=1)
    gap, middle = min(
        (point[8], (point[5][1] + point[6][1]) / 2)
        for pair in product(*parts)
        for point in client.getClosestPoints(body, body, _FARTHEST, *pair)
    )
    return np.array([state[4] for state in states]), gap, middle


def _said(point: Float[np.ndarray, "3"]) -> str:
    return f"({', '.join(f'{number:.3f}' for number in point + 0.0)})"


def check_lift(
    simulated: Callable[[TabletopConfig, Scene], Simulation], config: TabletopConfig, arm: Arm
) -> None:
    """Raise `InvalidArm` unless a hand closes on a plain box in the middle of the table and lifts it.

    The box has the usual mass and friction, so this judges the hand alone. If no object of the world fits
    between the fingers, nothing is tried.

    Args:
        simulated: Makes the simulation of a scene.
        config: The world's options.
        arm: Whose hand.
    """
    usual = TabletopConfig()
    config = replace(config, mass=usual.mass, friction=usual.friction)
    width = max(config.size[0], min(arm.half_opening, config.size[1]))
    height = max(config.height[0], min(width, config.height[1]))
    if width / 2 + MARGIN > arm.half_opening:
        return
    middle = [sum(side) / 2 for side in (config.table_x, config.table_y)]
    box = Scene(
        features=np.array([[width, width, height, SOLID]]),
        positions=np.array([[*middle, height / 2]]),
        orientations=np.array([[0.0, 0.0, 0.0, 1.0]]),
    )
    grasp = max(0.0, (height - arm.finger_length) / 2)  # no deeper than half the fingers are long
    lift = np.array([(0.0, 0.0, grasp, gripper) for gripper in (1.0, 0.0, 0.0)]).ravel()  # open, then close
    outcome = Interaction(simulated(config, box), arm, 0).perform(lift, put_down=True)
    x, y, z = (outcome.lifted.positions - outcome.start.positions)[0]
    if not (outcome.held and z >= _LEAST_LIFTED * config.lift_height):
        raise InvalidArm(
            f"of {arm.urdf} does not lift a plain box of {width:g} x {width:g} x {height:g} m: when the hand "
            f"had closed and risen by {config.lift_height:g} m, the box was {_metres(z)} m higher and "
            f"{_metres(np.hypot(x, y))} m aside; valid: fingers that hold it, and forces that fit the masses"
        )


def _metres(length: float) -> str:
    return f"{round(float(length), 3) + 0.0:g}"  # no -0
