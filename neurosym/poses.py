"""Poses: where every part of the robot and every object is while a motion happens.

Pictures show a motion from one side. A page in a browser draws it from any side, and asks a world for poses
instead. A world need not know them; one that does is `Posed`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, Protocol, runtime_checkable

import numpy as np

from neurosym.arrays import Float

PartKind = Literal["box", "cylinder", "sphere"]
PARTS: tuple[PartKind, ...] = ("box", "cylinder", "sphere")
"""The kinds of a part: its size is its edges [m], its radius and length [m], or its radius [m]."""
POSE_SECONDS = 1 / 30
"""Time of the simulation between two poses [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """Where everything is at one moment of an interaction, in the world frame.

    Attributes:
        seconds: Time of the simulation since the interaction began [s].
        phase: Name of the phase of the motion, as `FrameSink` is given it.
        links: Of each link of the robot, its base first: position [m], and orientation as (x, y, z, w).
        positions: Centre of each object [m].
        orientations: Orientation of each object, as a quaternion (x, y, z, w).
    """

    seconds: float
    phase: str
    links: Float[np.ndarray, "L 7"]
    positions: Float[np.ndarray, "M 3"]
    orientations: Float[np.ndarray, "M 4"]


PoseSink = Callable[[Pose], None]
"""Takes a pose as soon as it is there; the motion goes on when it returns."""


@dataclass(frozen=True, slots=True)
class Part:
    """One simple body that a link of the robot, or an object, is drawn with.

    Attributes:
        kind: One of `PARTS`.
        size: Its size, as its kind says [m].
        position: Its centre in the frame of the link or the object [m].
        orientation: Its orientation there, as a quaternion (x, y, z, w); a cylinder lies along its z axis.
        link: Number of the link, the base being 0; 0 for an object.
        colour: Red, green and blue from 0 to 1; None where nothing is said.
    """

    kind: PartKind
    size: tuple[float, ...]
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    link: int = 0
    colour: tuple[float, float, float] | None = None


@runtime_checkable
class Posed(Protocol):
    """A world that says where everything is while it moves, and what it looks like.

    Attributes:
        on_pose: Called with a pose each `POSE_SECONDS` of an interaction, if set; it changes nothing.
    """

    on_pose: PoseSink | None

    def robot_parts(self) -> tuple[Part, ...]:
        """Return what the robot is drawn with."""
        ...

    def robot_at_rest(self) -> Float[np.ndarray, "L 7"]:
        """Return the poses of the robot's links while it waits; see `Pose.links`."""
        ...

    def object_parts(self, features: Float[np.ndarray, "F"]) -> tuple[Part, ...]:
        """Return what an object is drawn with.

        Args:
            features: What it is.
        """
        ...
