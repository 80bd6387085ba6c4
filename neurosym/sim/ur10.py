"""Kinematics of the UR10 in closed form, for whole trajectories at once.

Frames follow the Denavit-Hartenberg convention; the base stands `BASE_HEIGHT` above the table, at the
world's origin, so that the whole table is in reach also when an object is lifted. Of the eight branches
of the inverse, one is used throughout (shoulder left, elbow up, wrist fixed): with the tool pointing down
it is continuous over the whole table, so neighbouring points of a path get neighbouring joint angles.
"""

from importlib.resources import files

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.sim.arm import TOOL_DOWN, Arm

D = np.array([0.1273, 0.0, 0.0, 0.163941, 0.1157, 0.0922])
"""Link offsets d_1..d_6 [m], as the manufacturer publishes them."""
A = np.array([0.0, -0.612, -0.5723, 0.0, 0.0, 0.0])
"""Link lengths a_1..a_6 [m]."""
ALPHA = np.array([np.pi / 2, 0.0, 0.0, np.pi / 2, -np.pi / 2, 0.0])
"""Link twists alpha_1..alpha_6 [rad]."""
BASE_HEIGHT = 0.25
"""Height of the arm's base above the table [m]."""
TOOL_LENGTH = 0.19
"""From the flange to the point between the fingertips [m]."""


def joint_transform(joint: int, angle: Float[np.ndarray, "N"]) -> Float[np.ndarray, "N 4 4"]:
    """Return the transform across one joint and its link.

    Args:
        joint: 0 to 5.
        angle: Joint angles [rad].
    """
    c, s = np.cos(angle), np.sin(angle)
    ca, sa = np.cos(ALPHA[joint]), np.sin(ALPHA[joint])
    transform = np.zeros((len(angle), 4, 4))
    transform[:, 0] = np.stack([c, -s * ca, s * sa, A[joint] * c], axis=1)
    transform[:, 1] = np.stack([s, c * ca, -c * sa, A[joint] * s], axis=1)
    transform[:, 2] = [0.0, sa, ca, D[joint]]
    transform[:, 3, 3] = 1.0
    return transform


def tool_in_world(joints: Float[np.ndarray, "N 6"]) -> Float[np.ndarray, "N 4 4"]:
    """Return the pose of the tool point in the world.

    Args:
        joints: Joint angles [rad].
    """
    base = np.eye(4)
    base[2, 3] = BASE_HEIGHT
    pose = np.broadcast_to(base, (len(joints), 4, 4))
    for joint in range(6):
        pose = pose @ joint_transform(joint, joints[:, joint])  # (N, 4, 4)
    tool = np.eye(4)
    tool[2, 3] = TOOL_LENGTH
    return np.asarray(pose @ tool)


def joints_for(points: Float[np.ndarray, "N 3"]) -> Float[np.ndarray, "N 6"]:
    """Return the joint angles that put the tool point at each point, the hand pointing down.

    Args:
        points: Tool points in the world [m].

    Raises:
        InvalidValue: If a point is out of the arm's reach.
    """
    flange_in_base = np.zeros((len(points), 4, 4))
    flange_in_base[:, :3, :3] = TOOL_DOWN
    flange_in_base[:, :3, 3] = points - TOOL_LENGTH * TOOL_DOWN[:, 2] - [0.0, 0.0, BASE_HEIGHT]
    flange_in_base[:, 3, 3] = 1.0
    with np.errstate(invalid="ignore"):
        joints = _solve(flange_in_base)
    if not np.all(np.isfinite(joints)):
        x, y, z = points[int(np.argwhere(~np.isfinite(joints))[0][0])]
        raise InvalidValue(f"The point ({x:.3f}, {y:.3f}, {z:.3f}) m is out of the arm's reach.")
    return np.unwrap(joints, axis=0)


def _solve(flange_in_base: Float[np.ndarray, "N 4 4"]) -> Float[np.ndarray, "N 6"]:
    wrist = flange_in_base[:, :3, 3] - D[5] * flange_in_base[:, :3, 2]
    q1 = (
        np.arctan2(wrist[:, 1], wrist[:, 0])
        + np.arccos(D[3] / np.hypot(wrist[:, 0], wrist[:, 1]))
        + np.pi / 2
    )
    p = flange_in_base[:, :3, 3]
    q5 = np.arccos((p[:, 0] * np.sin(q1) - p[:, 1] * np.cos(q1) - D[3]) / D[5])
    flange_in_1 = _inverse(joint_transform(0, q1)) @ flange_in_base
    one_in_flange = _inverse(flange_in_1)
    q6 = np.arctan2(-one_in_flange[:, 1, 2] / np.sin(q5), one_in_flange[:, 0, 2] / np.sin(q5))
    four_in_1 = flange_in_1 @ _inverse(joint_transform(4, q5) @ joint_transform(5, q6))
    elbow = (four_in_1 @ np.array([0.0, -D[3], 0.0, 1.0]))[:, :3]
    reach = np.linalg.norm(elbow, axis=1)
    q3 = np.arccos((reach**2 - A[1] ** 2 - A[2] ** 2) / (2 * A[1] * A[2]))
    q2 = -np.arctan2(elbow[:, 1], -elbow[:, 0]) + np.arcsin(A[2] * np.sin(q3) / reach)
    q4 = np.arctan2(four_in_1[:, 1, 0], four_in_1[:, 0, 0]) - q2 - q3  # joints 2, 3, 4 are parallel
    return np.stack([q1, q2, q3, q4, q5, q6], axis=1)


def _inverse(pose: Float[np.ndarray, "N 4 4"]) -> Float[np.ndarray, "N 4 4"]:
    """Invert rigid transforms."""
    rotation = pose[:, :3, :3].transpose(0, 2, 1)
    inverse = np.zeros_like(pose)
    inverse[:, :3, :3] = rotation
    inverse[:, :3, 3] = -(rotation @ pose[:, :3, 3, None])[..., 0]
    inverse[:, 3, 3] = 1.0
    return inverse


UR10 = Arm(
    urdf=str(files("neurosym.sim") / "ur10.urdf"),
    base=(0.0, 0.0, BASE_HEIGHT),
    joints=(0, 1, 2, 3, 4, 5),
    fingers=(7, 8),
    tool=9,
    inverse_kinematics=joints_for,
    forces=(25.0, 25.0, 18.0, 6.0, 6.0, 6.0),
    half_opening=0.07,
    finger_length=0.09,
    finger_half_width=0.011,
    finger_thickness=0.012,
    palm_half_size=(0.025, 0.075),
)
"""The paper's arm with a hand of 140 mm opening; its file scales the masses by 0.03 already."""
