"""What the simulator needs to know of an arm and its hand. The UR10 is one; yours can be another.

Every arm is driven alike (`robot.py`): the hand points down, its two fingers open along the world's y axis,
and its tool point, between the fingertips, follows straight lines.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import product

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidArm, InvalidValue
from neurosym.sim.config import TabletopConfig

TOOL_DOWN = np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]])
"""Orientation of the hand in the world: its z axis down, its fingers opening along the world's y axis."""

InverseKinematics = Callable[[Float[np.ndarray, "N 3"]], Float[np.ndarray, "N J"]]
"""Joint angles [rad] that bring the tool point to each point of a path in the world [m], the hand down.

Neighbouring points must get neighbouring angles; the same path must always get the same ones. Raises
`InvalidValue` if a point is out of reach.
"""


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm with a two-finger hand; lengths in metres.

    Attributes:
        urdf: File that describes it.
        base: Where its base stands in the world [m].
        joints: Indices of the J joints of the arm, in PyBullet's count, in the order from base to tool.
        fingers: Indices of the two sliding finger joints; both open in the positive sense, from 0.
        tool: Index of the link whose frame is the tool point.
        inverse_kinematics: From tool points to joint angles; must survive pickling for worker processes.
        forces: Largest torque of each joint [Nm]; a soft arm yields where a stiff one would crush.
        half_opening: Travel of each finger [m]; the hand opens to twice this.
        finger_length: From the palm to the tool point [m].
        finger_half_width: Half the extent of a finger along x [m].
        finger_thickness: Extent of a finger along y [m].
        palm_half_size: Half the palm's size along x and y [m].
        mass_scale: Factor on all masses, in place of gravity compensation where the file gives true masses.

    Raises:
        InvalidArm: If a length is not greater than 0, or what belongs together is not of one number. Whether
            it is as its file says is checked where a world is made with it (`arm_check.py`).
    """

    urdf: str
    base: tuple[float, float, float]
    joints: tuple[int, ...]
    fingers: tuple[int, int]
    tool: int
    inverse_kinematics: InverseKinematics
    forces: tuple[float, ...]
    half_opening: float
    finger_length: float
    finger_half_width: float
    finger_thickness: float
    palm_half_size: tuple[float, float]
    mass_scale: float = 1.0

    def __post_init__(self) -> None:
        given = (*self.joints, *self.fingers)
        for index in (*given, self.tool):
            if not isinstance(index, int | np.integer) or isinstance(index, bool):
                raise InvalidArm(f"of {self.urdf} has the index {index!r}; valid: whole numbers")
        if len(self.fingers) != 2:
            raise InvalidArm(f"of {self.urdf} has {len(self.fingers)} fingers; valid: two")
        if twice := [index for index in given if given.count(index) > 1]:
            raise InvalidArm(f"of {self.urdf} has joint {twice[0]} twice among its joints and fingers")
        if len(self.forces) != len(self.joints):
            raise InvalidArm(
                f"of {self.urdf} has {len(self.forces)} forces for {len(self.joints)} joints; valid: one each"
            )
        lengths = (
            "half_opening",
            "finger_length",
            "finger_half_width",
            "finger_thickness",
            "palm_half_size",
            "mass_scale",
            "forces",
        )
        for name in lengths:
            value = getattr(self, name)
            if not all(0 < number < math.inf for number in np.atleast_1d(value)):
                raise InvalidArm(f"of {self.urdf} has {name} = {value}; valid: greater than 0")


def check_reach(config: TabletopConfig, arm: Arm) -> None:
    """Raise `InvalidValue` unless an arm reaches over the whole table, as high as it lifts.

    Args:
        config: The world's options.
        arm: The arm.
    """
    for corner in corners(config):
        try:
            arm.inverse_kinematics(corner[None])
        except InvalidArm:
            raise
        except InvalidValue as error:
            raise InvalidValue(
                f"table_x = {list(config.table_x)}, table_y = {list(config.table_y)} and lift_height = "
                f"{config.lift_height} m ask for more than the arm reaches: {error} Lengths are in metres."
            ) from error


def corners(config: TabletopConfig) -> Float[np.ndarray, "8 3"]:
    """Return the corners of the space over the table that an arm must reach [m].

    Args:
        config: The world's options.
    """
    heights = config.height[0], config.height[1] + config.lift_height
    return np.array([*product(config.table_x, config.table_y, heights)])
