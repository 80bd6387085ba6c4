"""Actions written by hand for the UR10's hand: what the world affords, without any learning.

A person who knows an object's size chooses among a few ways to push or grasp it; where none is left within
the action box, the object does not afford the primitive. They measure the world (does it do what is asked of
it?) and are never shown to the robot.
"""

from collections.abc import Callable, Iterable
from functools import partial
from typing import NamedTuple

import numpy as np
from jaxtyping import Float

from neurosym.sim.shapes import OPEN_TOP, SOLID
from neurosym.world import Outcome

Action = Float[np.ndarray, "12"]
Features = Float[np.ndarray, "F"]

REACH = 0.05  # how far from the target's centre a waypoint may lie along x and y [m]
HAND_HALF = np.array([0.011, 0.012])  # half the closed hand's size along x and y [m]
INNER, OUTER = 0.07, 0.082
"""From the middle of the open hand to the inner and the outer faces of its fingers [m]."""
GAP = 0.003  # space left between hand and object before a motion [m]
WALL = 0.006
LOW = -0.025
"""Pushes are as low as the action box allows, lest tall objects topple: height above the centre [m]."""
CARRY = 0.018  # how high pick-and-place carries [m]
LEAST_PUSH, LEAST_CARRY, LEAST_LIFT, LEAST_PEAK = 0.01, 0.03, 0.10, 0.008
"""What counts as pushed, carried (over the table), lifted, and carried in the air [m]."""
MOST_OFF_AXIS = 0.35  # greatest sideways share of a push
_OPEN, _CLOSED = 1.0, 0.0


_Waypoint = tuple[float, float, float, float]


def _action(*waypoints: _Waypoint) -> Action:
    return np.array(waypoints, dtype=float).ravel()


def _is_open(features: Features) -> bool:
    return bool(features[3] > (SOLID + OPEN_TOP) / 2)


def _is_spannable(features: Features) -> bool:
    return bool(features[1] / 2 <= INNER - 2 * GAP)


def push(features: Features, axis: int, sign: int) -> Action | None:
    """Push an object along x (axis 0) or y (axis 1); None if it does not afford that.

    Small objects are pushed from behind with the closed hand. Along y, wider ones are pushed by one finger
    of the open hand: from outside while it spans the object, else from inside. Along x, they are grasped and
    dragged, or pushed from inside.
    """
    half = float(features[axis]) / 2
    behind = half + HAND_HALF[axis] + GAP
    if behind <= REACH:
        return _straight(axis, -sign * behind, sign * REACH, _CLOSED)
    if axis == 1 and _is_spannable(features):
        return _straight(axis, 0.0, sign * REACH, _OPEN)
    if axis == 1 and _is_open(features):
        return _straight(axis, sign * (min(INNER - half, half - WALL - OUTER) - GAP), sign * REACH, _OPEN)
    if axis == 0 and _is_spannable(features):
        grip = (sign * REACH, 0.0, LOW, _CLOSED)
        return _action((0.0, 0.0, LOW, _OPEN), grip, (sign * REACH, 0.0, REACH, _OPEN))
    if axis == 0 and _is_open(features) and REACH - (half - WALL - HAND_HALF[0]) > 2 * LEAST_PUSH:
        return _straight(axis, 0.0, sign * REACH, _CLOSED)
    return None


def _straight(axis: int, start: float, end: float, gripper: float) -> Action:
    waypoints = np.zeros((3, 4))
    waypoints[:, axis] = start, (start + end) / 2, end
    waypoints[:, 2:] = LOW, gripper
    return waypoints.ravel()


def _gripped(features: Features, then: Callable[[float], Iterable[_Waypoint]]) -> Action | None:
    """Open the hand where along y it closes around an object or a wall, and go on; None if nowhere."""
    if _is_spannable(features):
        y = 0.0
    elif _is_open(features):
        y = min(REACH, float(features[1] - WALL) / 2)
    else:
        return None
    return _action((0.0, y, 0.0, _OPEN), *then(y))


def grasp(features: Features) -> Action | None:
    """Grasp an object, around it or by a wall; None if it does not afford that."""
    return _gripped(features, lambda y: ((0.0, y, 0.0, _CLOSED), (0.0, y, REACH, _CLOSED)))


def carry_to(features: Features) -> Action | None:
    """Grasp an object and set it down at a place, under where the hand holds it; None if it affords no grasp.

    For interactions with a place as reference: an object held by a wall is set down as far beside it.
    """
    return _gripped(features, lambda y: ((0.0, y, 0.0, _CLOSED), (0.0, y, 0.0, _CLOSED)))


def pick_and_place(features: Features) -> Action | None:
    """Carry an object through the air to another place; None if it does not afford that."""
    aside = (CARRY, _CLOSED), (REACH, _OPEN)
    return _gripped(features, lambda y: [(REACH, y - REACH, *how) for how in aside])


def _push_failure(outcome: Outcome, axis: int, sign: int) -> str:
    if outcome.kind != "resting":
        return outcome.kind
    along, aside = sign * outcome.effect[axis], abs(outcome.effect[1 - axis])
    if along < LEAST_PUSH:
        return "hardly moved"
    return "went aside" if aside > MOST_OFF_AXIS * along else ""


def _grasp_failure(outcome: Outcome) -> str:
    if outcome.kind != "held":
        return "not held"
    return "" if outcome.effect[2] >= LEAST_LIFT else "lifted askew"


def _carry_failure(outcome: Outcome) -> str:
    if outcome.kind != "resting":
        return outcome.kind
    if outcome.peak_height < LEAST_PEAK:
        return "not in the air"
    return "" if np.linalg.norm(outcome.effect[:2]) >= LEAST_CARRY else "hardly moved"


class HandWritten(NamedTuple):
    """A primitive written by hand."""

    action: Callable[[Features], Action | None]  # what to do with an object; None if it does not afford it
    failure: Callable[[Outcome], str]  # what went wrong, or an empty text


_WAYS = {"right": (1, -1), "left": (1, 1), "forward": (0, 1), "pull": (0, -1)}  # axis, sign
HAND_WRITTEN = {
    **{
        name: HandWritten(partial(push, axis=axis, sign=sign), partial(_push_failure, axis=axis, sign=sign))
        for name, (axis, sign) in _WAYS.items()
    },
    "grasp": HandWritten(grasp, _grasp_failure),
    "pick-and-place": HandWritten(pick_and_place, _carry_failure),
}  # the paper's six primitives
