"""How long it takes to carry an object to a place, in the simulator's own time.

Rehearsals do not record seconds, so they follow from the waypoints and from how the hand moves (`motion`):
down beside the object, to where it is gripped, up, over the table, down with the object, and up again.
The way over the table counts as its diagonal, so that no carry takes much longer than it is said to.
"""

import math

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.motion import (
    CLEARANCE,
    FINGER_SPEED,
    GRASP_TEST,
    LOWERING_SPEED,
    TRANSIT_CLEARANCE,
    way_seconds,
)
from neurosym.operators import Operator

STROKE = 0.07
"""How far a finger travels at most; that of the UR10's hand [m]."""
_NUMBERS = 12  # three waypoints (x, y, z, g)
_HEIGHT = 2  # number of the feature that says how tall an object is


def carry_seconds(operator: Operator, grounding: Grounding) -> float:
    """Estimate how long an operator takes to carry an object of its category, rounded up to 0.1 s [s].

    Objects count as tall as the mean of the tallest category, since they pass over one another.

    Args:
        operator: The operator.
        grounding: The learned domain.

    Raises:
        InvalidValue: If its actions are not three waypoints, or objects have no height.
    """
    action = grounding.primitive_of(operator).action
    tallest = _tallest(grounding)
    if len(action) != _NUMBERS or not tallest:
        raise InvalidValue(
            f"How long {operator.name} takes cannot be known: its action is not three waypoints for objects "
            "with a height; give its seconds."
        )
    first, second = action[:4], action[4:8]
    above = max(GRASP_TEST, tallest + TRANSIT_CLEARANCE)
    (left, right), (near, far) = grounding.table.x, grounding.table.y
    ways = [
        max(0.0, tallest / 2 + CLEARANCE - first[2]),
        math.dist(first[:3], second[:3]),
        GRASP_TEST,
        above - GRASP_TEST,
        math.hypot(right - left, far - near),
        grounding.lift_height,
    ]
    seconds = sum(map(way_seconds, ways)) + way_seconds(above + tallest / 2, LOWERING_SPEED)
    changes = 1 + ((first[3] >= 0.5) != (second[3] >= 0.5))  # it lets go in the end
    return math.ceil(10 * (seconds + changes * STROKE / FINGER_SPEED) - 1e-9) / 10


def _tallest(grounding: Grounding) -> float:
    """Return the greatest mean height of the objects of a category, or 0 if none has one [m]."""
    means = (category.feature_means for category in grounding.operators.categories)
    return max((features[_HEIGHT] for features in means if len(features) > _HEIGHT), default=0.0)
