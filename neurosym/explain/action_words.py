"""Points, displacements and actions in words that can be followed without a picture.

Forward is +x (away from the robot), back is -x, left is +y, right is -y. Where vectors are not x, y, z, or
action parameters not waypoints of a hand, nothing is known of what they mean, and they stay plain numbers.
"""

from collections.abc import Sequence

from neurosym.operators import Primitive

AXES = 3
"""Vectors of this many numbers are taken for x, y, z [m]."""

_WAYPOINT = (False, False, False, True)  # x, y, z and a gripper value
_OPEN = 0.5


def displacement_in_words(vector: Sequence[float]) -> str:
    """Say how far and where to something moved: `57 mm forward, 90 mm right, 213 mm up`.

    Args:
        vector: Displacement along x, y, z [m], or along axes of another number and meaning.
    """
    if len(vector) != AXES:
        return _numbers(vector)
    return ", ".join(_parts(vector, "up", "down")) or "nowhere"


def spread_in_words(vector: Sequence[float]) -> str:
    """Say how far something scatters on each axis: `± 24, 11, 2 mm`."""
    if len(vector) != AXES:
        return f"± {_numbers(vector)}"
    return f"± {', '.join(str(_millimetres(value)) for value in vector)} mm"


def distance_in_words(distance: float, axes: int) -> str:
    """Say how long a vector of so many axes is."""
    return f"{1000 * distance:.0f} mm" if axes == AXES else f"{distance:.3g}"


def action_in_words(action: Sequence[float], gripper: Sequence[bool] = ()) -> tuple[str, ...]:
    """Say in sentences what the hand does.

    Args:
        action: The action parameters.
        gripper: Which of them are gripper values, as the world's action box says; empty if nobody knows.
    """
    if not action or len(action) % len(_WAYPOINT) or tuple(gripper) != _WAYPOINT * (len(action) // 4):
        return (f"Its parameters are {_numbers(action)}.",)
    points = [action[i : i + AXES] for i in range(0, len(action), len(_WAYPOINT))]
    hands = ["open" if value >= _OPEN else "closed" for value in action[AXES :: len(_WAYPOINT)]]
    moves = [
        f"{_gripper_in_words(before, after)} {place_in_words(point, 'the centre')}."
        for point, before, after in zip(points[1:], hands, hands[1:], strict=False)
    ]
    travel = [end - start for start, end in zip(points[0], points[-1], strict=True)]
    start = place_in_words(points[0], "the object's centre")
    return (
        f"The hand starts {hands[0]}, {start}.",
        *moves,
        f"It rises {hands[-1]}; from start to end it has moved {displacement_in_words(travel)}.",
    )


def aimed_action_in_words(
    primitive: Primitive, gripper: Sequence[bool], reference: str = "the place"
) -> tuple[str, ...]:
    """Say what the hand does: two waypoints are relative to the object, the third to what it is aimed at.

    Args:
        primitive: The action.
        gripper: Which action parameters are gripper values, as the world says; empty if nobody knows.
        reference: What it is aimed at besides the object.
    """
    told = action_in_words(primitive.action, gripper)
    if len(told) <= AXES:  # plain numbers
        return told
    spot = place_in_words(primitive.action[-4:-1], reference)
    return (*told[:2], f"What it grips then it lifts, carries to {spot}, lowers and lets go.")


def place_in_words(point: Sequence[float], what: str) -> str:
    """Say where a point lies: `42 mm back and 44 mm left of the centre, 25 mm below it`.

    Args:
        point: x, y, z relative to what it is near [m].
        what: What it is near.
    """
    level = " and ".join(_parts((*point[:2], 0.0)))
    (height,) = _parts((0.0, 0.0, point[2]), "above", "below") or [""]
    if not level:
        return f"{height or 'at'} {what}"
    return f"{level} of {what}" + (f", {height} it" if height else ", level with it")


def _numbers(values: Sequence[float]) -> str:
    return ", ".join(f"{value:.3g}" for value in values)


def _gripper_in_words(before: str, after: str) -> str:
    if before == after:
        return f"Still {after}, it moves to"
    return f"It {'opens' if after == 'open' else 'closes'} there and moves to"


def _parts(vector: Sequence[float], up: str = "up", down: str = "down") -> list[str]:
    words = (("forward", "back"), ("left", "right"), (up, down))
    return [
        f"{abs(_millimetres(value))} mm {more if value > 0 else less}"
        for value, (more, less) in zip(vector, words, strict=True)
        if _millimetres(value)
    ]


def _millimetres(value: float) -> int:
    return round(1000 * value)
