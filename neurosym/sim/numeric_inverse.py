"""Inverse kinematics of any arm that a URDF describes, by Newton's method on all points of a path at once.

The forward kinematics is a product of exponentials (R. W. Brockett, 1984): with all joints at zero the file
says where each axis lies and where the tool is; a joint angle turns all that follows about its axis.

Every point is solved for on its own, always from the same home posture, so the angles are a function of the
point: the same in any path and after any other. Of the many postures that an arm of more than six joints can
reach a point in, the one nearest to home is taken; that makes them a smooth function, too.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from neurosym.checks import Bool, Float
from neurosym.errors import InvalidArm, InvalidValue
from neurosym.sim.config import TOOL_DOWN, loaded, pybullet

MOST_STEPS = 100
LARGEST_STEP = 0.5
"""No joint goes further in one step of Newton's method [rad]; larger steps lose their way far from home."""
TOLERANCE, STILL = 1e-7, 1e-5
"""A point is solved for when its pose is this exact [m], [rad] and no joint wants to move by more [rad]."""
_DAMPING = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Chain:
    """The joints between an arm's base and its tool, while all joints are at zero, in the world."""

    slides: Bool[np.ndarray, "J"]  # which joints slide; the others turn
    axes: Float[np.ndarray, "J 3"]  # their directions
    origins: Float[np.ndarray, "J 3"]  # a point on each axis [m]
    limits: Float[np.ndarray, "J 2"]  # least and greatest angle of each joint [rad]; for sliding ones [m]
    tool: Float[np.ndarray, "4 4"]  # pose of the tool


@dataclass(frozen=True, slots=True)
class NumericInverse:
    """Inverse kinematics of an arm, for `Arm.inverse_kinematics`: the hand points down.

    Attributes:
        urdf: File that describes the arm.
        base: Where its base stands in the world [m].
        joints: Indices of the J joints of the arm, in PyBullet's count.
        tool: Index of the link whose frame is the tool point: its z axis points out of the hand, and the
            fingers open along its y axis.
        home: Joint angles [rad] of a posture above the table with the hand about downwards.
    """

    urdf: str
    base: tuple[float, float, float]
    joints: tuple[int, ...]
    tool: int
    home: tuple[float, ...]

    def __post_init__(self) -> None:
        if len(self.home) != len(self.joints):
            raise InvalidValue(f"home has {len(self.home)} angles; the arm has {len(self.joints)} joints.")

    def __call__(self, points: Float[np.ndarray, "N 3"]) -> Float[np.ndarray, "N J"]:
        """Return the joint angles [rad] that put the tool point at each point, the hand pointing down.

        Args:
            points: Tool points in the world [m].

        Raises:
            InvalidValue: If a point is out of the arm's reach.
        """
        chain = read_chain(self.urdf, self.base, self.joints, self.tool)
        home = np.array(self.home, dtype=float)
        joints, left = np.tile(home, (len(points), 1)), np.arange(len(points))  # points not solved for yet
        for _ in range(MOST_STEPS):
            pose, jacobian = forward(chain, joints[left])
            turn = _turn_left(pose[:, :3, :3])
            error = np.concatenate([points[left] - pose[:, :3, 3], turn], axis=1)  # (N, 6)
            step = _step(jacobian, error, home - joints[left])
            largest = np.abs(step).max(axis=1)
            joints[left] += step * np.minimum(1.0, LARGEST_STEP / np.maximum(largest, LARGEST_STEP))[:, None]
            left = left[(np.abs(error).max(axis=1) > TOLERANCE) | (largest > STILL)]
            if not len(left):
                break
        beyond = np.any((joints < chain.limits[:, 0]) | (joints > chain.limits[:, 1]), axis=1)
        beyond[left] = True
        if beyond.any():
            x, y, z = points[int(np.argmax(beyond))]
            raise InvalidValue(f"The point ({x:.3f}, {y:.3f}, {z:.3f}) m is out of the arm's reach.")
        return joints


def _step(
    jacobian: Float[np.ndarray, "N 6 J"], error: Float[np.ndarray, "N 6"], homeward: Float[np.ndarray, "N J"]
) -> Float[np.ndarray, "N J"]:
    """Return the step that mends the error and, of all that do, ends nearest to home."""
    rest = error - (jacobian @ homeward[..., None])[..., 0]
    transposed = jacobian.transpose(0, 2, 1)
    square = jacobian @ transposed + _DAMPING * np.eye(6)
    return np.asarray(homeward + (transposed @ np.linalg.solve(square, rest[..., None]))[..., 0])


def forward(
    chain: Chain, joints: Float[np.ndarray, "N J"]
) -> tuple[Float[np.ndarray, "N 4 4"], Float[np.ndarray, "N 6 J"]]:
    """Return the tool's pose in the world and the geometric Jacobian of its point and orientation."""
    slides, slide = chain.slides, chain.slides[:, None]
    twists = np.zeros((len(slides), 4, 4))  # the motions about, or along, the axes are their exponentials
    turning = np.where(slide, 0.0, chain.axes)
    twists[:, :3, :3] = np.cross(np.eye(3), turning[:, None])  # x -> axis x x
    twists[:, :3, 3] = np.where(slide, chain.axes, np.cross(chain.origins, turning))
    first = np.where(slides, joints, np.sin(joints))[..., None, None]
    second = np.where(slides, 0.0, 1 - np.cos(joints))[..., None, None]
    motions = np.eye(4) + first * twists + second * (twists @ twists)  # (N, J, 4, 4), Rodrigues
    before = np.empty_like(motions)  # the motion of all joints before each
    pose = np.broadcast_to(np.eye(4), (len(joints), 4, 4))
    for joint in range(joints.shape[1]):
        before[:, joint] = pose
        pose = pose @ motions[:, joint]
    pose = pose @ chain.tool
    axes = (before[..., :3, :3] @ chain.axes[..., None])[..., 0]  # (N, J, 3)
    origins = (before[..., :3, :3] @ chain.origins[..., None])[..., 0] + before[..., :3, 3]
    swept = np.cross(axes, pose[:, None, :3, 3] - origins)
    jacobian = np.concatenate([np.where(slide, axes, swept), np.where(slide, 0.0, axes)], axis=2)
    return pose, jacobian.transpose(0, 2, 1)


def _turn_left(turn: Float[np.ndarray, "N 3 3"]) -> Float[np.ndarray, "N 3"]:
    """Return the rotation vector in the world that leads from each orientation to `TOOL_DOWN` [rad]."""
    between = TOOL_DOWN @ turn.transpose(0, 2, 1)
    twice_sine = np.stack([between[:, i, j] - between[:, j, i] for i, j in ((2, 1), (0, 2), (1, 0))], axis=1)
    sine = np.linalg.norm(twice_sine, axis=1) / 2
    angle = np.arctan2(sine, (np.trace(between, axis1=1, axis2=2) - 1) / 2)
    return np.asarray(twice_sine / 2 * np.where(sine > 1e-9, angle / np.maximum(sine, 1e-9), 1.0)[:, None])


@lru_cache
def read_chain(urdf: str, base: tuple[float, float, float], joints: tuple[int, ...], tool: int) -> Chain:
    """Read the geometry of an arm from its file, with its base there in the world [m].

    Raises `InvalidValue`, of which `InvalidArm` is one, if the file cannot be read, or a joint cannot be.
    """
    with loaded(urdf, base, collides=False) as (client, body):
        count = client.getNumJoints(body)
        for number in (*joints, tool):
            if not 0 <= number < count:
                raise InvalidArm(f"has no joint or link {number}; valid: 0 to {count - 1}")
        infos = [client.getJointInfo(body, joint) for joint in joints]
        for info in infos:
            if info[2] not in (pybullet.JOINT_REVOLUTE, pybullet.JOINT_PRISMATIC):
                raise InvalidValue(f"Joint {info[0]} ({info[1].decode()}) neither turns nor slides.")
        for joint in range(count):
            client.resetJointState(body, joint, 0.0)
        states = client.getLinkStates(body, (*joints, tool), computeForwardKinematics=1)
    frames = np.tile(np.eye(4), (len(states), 1, 1))  # (J + 1, 4, 4)
    for frame, state in zip(frames, states, strict=True):
        frame[:3, :3] = np.reshape(pybullet.getMatrixFromQuaternion(state[5]), (3, 3))
        frame[:3, 3] = state[4]
    limits = np.array([info[8:10] for info in infos])
    limits[limits[:, 0] >= limits[:, 1]] = -np.inf, np.inf  # as PyBullet says it of continuous joints
    return Chain(
        slides=np.array([info[2] == pybullet.JOINT_PRISMATIC for info in infos]),
        axes=(frames[:-1, :3, :3] @ np.array([info[13] for info in infos])[..., None])[..., 0],
        origins=frames[:-1, :3, 3],
        limits=limits,
        tool=frames[-1],
    )
