"""How the hand moves in the simulator: how fast, and how high it carries things.

A straight way begins and ends at rest, by a quintic profile whose peak speed is 1.875 times its mean speed.
"""

PEAK_SPEED = 0.45
"""Greatest speed of the hand [m/s]; faster pushes make objects coast on."""
LOWERING_SPEED = 0.25
"""Greatest speed of a held object on its way down [m/s]."""
FINGER_SPEED = 0.25
"""Greatest speed of a finger [m/s]."""
CLEARANCE = 0.005
"""The hand starts at least this far above whatever it would otherwise touch [m]."""
GRASP_TEST = 0.03
"""How far the hand rises to find whether the target hangs from it, before it carries it away [m]."""
TRANSIT_CLEARANCE = 0.02
"""What is carried passes at least this far above everything else [m]."""
_PEAK_OVER_MEAN = 1.875


def way_seconds(metres: float, peak_speed: float = PEAK_SPEED) -> float:
    """Return how long a straight way takes from rest to rest [s].

    Args:
        metres: Its length [m].
        peak_speed: Greatest speed on the way [m/s].
    """
    return metres * _PEAK_OVER_MEAN / peak_speed
