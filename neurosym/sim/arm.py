"""What the simulator needs to know of an arm and its hand. The UR10 is one; yours can be another.

Every arm is driven alike (`robot.py`): the hand points down, its two fingers open along the world's y axis,
and its tool point, between the fingertips, follows straight lines.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
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
        joints: Indices of the J joints of the arm, in PyBullet's count.
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


def check_reach(config: TabletopConfig, arm: Arm) -> None:
    """Raise `InvalidValue` unless an arm reaches over the whole table, as high as it lifts.

    Args:
        config: The world's options.
        arm: The arm.
    """
    high = config.height[1] + config.lift_height
    corners = [(x, y, z) for x in config.table_x for y in config.table_y for z in (config.height[0], high)]
    for corner in corners:
        try:
            arm.inverse_kinematics(np.array([corner]))
        except InvalidValue as error:
            raise InvalidValue(
                f"table_x = {list(config.table_x)}, table_y = {list(config.table_y)} and lift_height = "
                f"{config.lift_height} m ask for more than the arm reaches: {error} Lengths are in metres."
            ) from error
