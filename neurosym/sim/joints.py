"""The joints of an arm and its fingers in PyBullet: put somewhere, driven, and asked where they are."""

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from neurosym.checks import Float
from neurosym.contract import FINGER_SPEED
from neurosym.sim.config import Arm, Client, pybullet

FINGER_FRICTION = 0.9
FINGER_TWISTING_FRICTION = 0.03
"""Resistance of a soft fingertip to twisting [m]; without it, objects held by an edge swing and tilt."""


class Joints(Protocol):
    """The joints of an arm and of its two fingers, which open alike.

    Attributes:
        body: The arm among the bodies of its simulation.
    """

    body: int

    def put(self, joints: Sequence[int], positions: Sequence[float], speeds: Sequence[float]) -> None:
        """Put some joints somewhere at once [rad], [m], with some speeds; they are counted as `Arm` does."""

    def tool_point(self) -> Float[np.ndarray, "3"]:
        """Return where the tool point is in the world [m]."""

    def half_opening(self) -> float:
        """Return how far each finger stands from the middle [m]."""

    def drive_arm(self, angles: Sequence[float], speeds: Sequence[float]) -> None:
        """Drive the arm's joints towards angles [rad], at which they shall have some speeds [rad/s]."""

    def drive_fingers(self, half_opening: float, force: float) -> None:
        """Drive each finger towards where it shall stand [m], with at most some force [N]."""


class BulletJoints:
    """The joints in PyBullet.

    Args:
        client: Where the arm is loaded.
        arm: What it is.
        visible: Whether it is loaded with its looks, which takes longer.
    """

    def __init__(self, client: Client, arm: Arm, *, visible: bool = False):
        self._client, self._arm = client, arm
        flags = pybullet.URDF_USE_INERTIA_FROM_FILE
        flags |= 0 if visible else pybullet.URDF_IGNORE_VISUAL_SHAPES
        self.body = body = client.loadURDF(arm.urdf, arm.base, useFixedBase=True, flags=flags)
        for link in range(client.getNumJoints(body) if arm.mass_scale != 1.0 else 0):
            info = client.getDynamicsInfo(body, link)
            mass, inertia = info[0] * arm.mass_scale, [arm.mass_scale * axis for axis in info[2]]
            client.changeDynamics(body, link, mass=mass, localInertiaDiagonal=inertia)
        frictions = {"lateralFriction": FINGER_FRICTION, "spinningFriction": FINGER_TWISTING_FRICTION}
        for finger in arm.fingers:
            client.changeDynamics(body, finger, jointLowerLimit=0.0, **frictions)
        left, right = arm.fingers
        axis, middle = [0, 1, 0], [0, 0, 0]
        gear = client.createConstraint(body, left, body, right, pybullet.JOINT_GEAR, axis, middle, middle)
        client.changeConstraint(gear, gearRatio=-1, maxForce=200, erp=0.5)

    def put(self, joints: Sequence[int], positions: Sequence[float], speeds: Sequence[float]) -> None:
        """Put some joints somewhere at once (see `Joints.put`)."""
        for joint, position, speed in zip(joints, positions, speeds, strict=True):
            self._client.resetJointState(self.body, joint, position, speed)

    def tool_point(self) -> Float[np.ndarray, "3"]:
        """Return where the tool point is in the world [m]."""
        state = self._client.getLinkState(self.body, self._arm.tool)
        return np.array(state[4])

    def half_opening(self) -> float:
        """Return how far each finger stands from the middle [m]."""
        return float(self._client.getJointState(self.body, self._arm.fingers[0])[0])

    def drive_arm(self, angles: Sequence[float], speeds: Sequence[float]) -> None:
        """Drive the arm's joints (see `Joints.drive_arm`)."""
        self._client.setJointMotorControlArray(
            self.body,
            self._arm.joints,
            pybullet.POSITION_CONTROL,
            targetPositions=angles,
            targetVelocities=speeds,
            forces=self._arm.forces,
        )

    def drive_fingers(self, half_opening: float, force: float) -> None:
        """Drive each finger (see `Joints.drive_fingers`)."""
        for finger in self._arm.fingers:
            self._client.setJointMotorControl2(
                self.body,
                finger,
                pybullet.POSITION_CONTROL,
                targetPosition=half_opening,
                force=force,
                maxVelocity=FINGER_SPEED,
            )
