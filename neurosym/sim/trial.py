"""One lift of a plain box, which tells whether a hand grips."""

from dataclasses import replace

import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidArm
from neurosym.sim.arm import Arm
from neurosym.sim.config import TabletopConfig
from neurosym.sim.interaction import Interaction
from neurosym.sim.opening import MARGIN
from neurosym.sim.shapes import SOLID
from neurosym.sim.simulation import Simulation
from neurosym.world import Scene

LEAST_LIFTED = 0.8
"""The box must rise by this share of the way of the hand."""
_OPEN, _CLOSED = 1.0, 0.0


def check_lift(client: int, config: TabletopConfig, arm: Arm) -> None:
    """Raise unless a hand closes on a plain box in the middle of the table and lifts it.

    The box has the usual mass and friction, so this judges the hand alone. If no object of the world fits
    between the fingers, nothing is tried.

    Args:
        client: The physics client; everything in it is replaced.
        config: The world's options.
        arm: The arm.

    Raises:
        InvalidArm: If it does not.
    """
    usual = TabletopConfig()
    config = replace(config, mass=usual.mass, friction=usual.friction)
    width = max(config.size[0], min(arm.half_opening, config.size[1]))
    height = max(config.height[0], min(width, config.height[1]))
    if width / 2 + MARGIN > arm.half_opening:
        return
    interaction = Interaction(Simulation(client, config, _box(config, width, height)), arm, 0)
    outcome = interaction.perform(_lift(height, arm.finger_length), put_down=True)
    x, y, z = (outcome.lifted.positions - outcome.start.positions)[0]
    if not (outcome.held and z >= LEAST_LIFTED * config.lift_height):
        raise InvalidArm(
            f"of {arm.urdf} does not lift a plain box of {width:g} x {width:g} x {height:g} m: when the hand "
            f"had closed and risen by {config.lift_height:g} m, the box was {_said(z)} m higher and "
            f"{_said(np.hypot(x, y))} m aside; valid: fingers that hold it, and forces that fit the masses"
        )


def _box(config: TabletopConfig, width: float, height: float) -> Scene:
    x, y = (sum(side) / 2 for side in (config.table_x, config.table_y))
    return Scene(
        features=np.array([[width, width, height, SOLID]]),
        positions=np.array([[x, y, height / 2]]),
        orientations=np.array([[0.0, 0.0, 0.0, 1.0]]),
    )


def _lift(height: float, finger_length: float) -> Float[np.ndarray, "12"]:
    """Open around the box and close there, no deeper than half the fingers are long."""
    grasp = max(0.0, (height - finger_length) / 2)
    return np.array([(0.0, 0.0, grasp, gripper) for gripper in (_OPEN, _CLOSED, _CLOSED)]).ravel()


def _said(length: float) -> str:
    return f"{round(float(length), 3) + 0.0:g}"  # no -0
