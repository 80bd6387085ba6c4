"""What touches what, and so what stands on the table or hangs from the hand."""

from collections.abc import Mapping


def connected(body: int, touching: Mapping[int, set[int]]) -> set[int]:
    """Return the objects that touch a body, those that touch them, and so on.

    Args:
        body: The table or the robot.
        touching: What each object touches.
    """
    found: set[int] = set()
    front = {body}
    while front:
        front = {other for other, touched in touching.items() if touched & front} - found
        found |= front
    return found
