"""The joints of an arm and its fingers, in any engine: put somewhere, driven, and asked where they are."""

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from neurosym.checks import Float


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
