"""How wide the hand opens around what it carries to a place, so that it leaves the neighbours alone."""

from neurosym.sim.bullet import pybullet
from neurosym.sim.simulation import Simulation

MARGIN = 0.006
"""How far each finger stays from the object that it comes down beside [m]."""
WIDE_RELEASE = (0.005, 0.015)
"""How far each finger opens, first to let a standing object fall flat, then to leave it behind [m]."""
NARROW_RELEASE = (0.005, 0.005)
"""The same where neighbours may stand close by [m]."""


def grasp_opening(simulation: Simulation, target: int, y: float, widest: float) -> float:
    """Return how far each finger opens to come down on both sides of an object [m].

    If the object is too wide for that, one finger comes down beside it and the other inside or on it.

    Args:
        simulation: The scene.
        target: Index of the object.
        y: Where the middle of the hand is, along which axis the fingers open [m].
        widest: How far each finger opens at most [m].
    """
    low, high = pybullet.getAABB(simulation.bodies[target], physicsClientId=simulation.client)
    nearest, farthest = sorted((abs(low[1] - y), abs(high[1] - y)))
    around = farthest + MARGIN
    return float(around if around <= widest else min(nearest + MARGIN, widest))
