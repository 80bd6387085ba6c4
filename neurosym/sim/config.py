"""What the tabletop world is made of."""

import math
import os
import re
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from importlib.util import find_spec
from itertools import product
from pathlib import Path
from threading import Lock
from typing import Any
from xml.etree import ElementTree

import numpy as np

from neurosym.checks import Float
from neurosym.choices import ENGINES
from neurosym.contract import ObjectLimits
from neurosym.errors import NAME, InvalidArm, InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import read_text
from neurosym.sim.shapes import FEATURE_NAMES, LEARNED_SHAPES, SHAPES, UNSEEN
from neurosym.world import Table

# PyBullet, imported without the build time that its C code prints to standard error on every import.
#
# The rest of this folder takes it from here, so that sizes and shapes can be asked for without it.

_saved, _nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
try:
    os.dup2(_nowhere, 2)
    import pybullet
finally:
    os.dup2(_saved, 2)
    os.close(_saved)
    os.close(_nowhere)

__all__ = ["Client", "overheard", "pybullet"]
_HEARING = Lock()


class Client:
    """A physics client; its methods are PyBullet's functions of that name, for this client.

    Args:
        mode: How it connects: without a screen, or in a window.
    """

    def __init__(self, mode: int = pybullet.DIRECT):
        self.number = int(pybullet.connect(mode))

    def __getattr__(self, name: str) -> Any:
        """Return a function of PyBullet's, and keep it at hand."""
        method = self.__dict__[name] = partial(getattr(pybullet, name), physicsClientId=self.number)
        return method


@contextmanager
def overheard(words: list[str]) -> Iterator[None]:
    """Append to some words what PyBullet prints to standard output meanwhile, instead of showing it."""
    with _HEARING, tempfile.TemporaryFile() as file:
        shown = os.dup(1)
        os.dup2(file.fileno(), 1)
        try:
            yield
        finally:
            os.dup2(shown, 1)
            os.close(shown)
            file.seek(0)
            words.append(file.read().decode(errors="replace"))


# Frictions, the sliding ones without a unit; those of two that touch are combined by their products

TABLE_FRICTION = 0.6
OBJECT_TWISTING_FRICTION = 0.002
"""Resistance of objects to twisting [m]."""
ROLLING_FRICTION = 0.001
"""Of balls, that would else roll for ever."""
FINGER_FRICTION = 0.9
FINGER_TWISTING_FRICTION = 0.03
"""Resistance of a soft fingertip to twisting [m]; without it, objects held by an edge swing and tilt."""

_POSITIVE = ("size", "height", "wall", "mass", "friction", "lift_height", "time_step", "frame_every")
_NOT_NEGATIVE = ("spawn_margin", "spawn_gap")
MOST_OBJECTS = 8
"""Objects that one scene can be simulated with; larger problems are symbolic only."""


@dataclass(frozen=True, slots=True)
class TabletopConfig:
    """The options of the tabletop world, as they stand in `world.toml`; every length in metres.

    Attributes:
        table_x: Extent of the table away from the robot's base [m].
        table_y: Extent of the table to the robot's right (-) and left (+) [m].
        spawn_margin: One or two objects start at least this far inside the table's edge [m].
        spawn_gap: Objects start at least this far apart [m].
        size: Least and greatest s_x and s_y [m].
        height: Least and greatest d [m].
        shapes: How often an object is of each shape, relative to the others; see
            `neurosym.sim.shapes`.
        wall: Thickness of the walls and floors of open objects [m].
        mass: Mass of every object [kg].
        friction: Lateral friction of objects; the table's is 0.6, a finger's 0.9, and the products count.
        lift_height: How far the hand rises after the last waypoint [m].
        time_step: Step of the simulation [s].
        frame_every: Steps between two pictures, when pictures are asked for.
        engine: What simulates: `pybullet`, or `mujoco`, which the extra of that name installs.
    """

    table_x: tuple[float, float] = (0.35, 0.95)
    table_y: tuple[float, float] = (-0.3, 0.3)
    spawn_margin: float = 0.12
    spawn_gap: float = 0.04
    size: tuple[float, float] = (0.03, 0.18)
    height: tuple[float, float] = (0.02, 0.10)
    shapes: dict[str, float] = field(default_factory=lambda: dict.fromkeys(LEARNED_SHAPES, 1.0))
    wall: float = 0.006
    mass: float = 0.1
    friction: float = 0.8
    lift_height: float = 0.20
    time_step: float = 1 / 240
    frame_every: int = 12
    engine: str = ENGINES[0]

    def __post_init__(self) -> None:
        tables = {"table_x": self.table_x, "table_y": self.table_y}
        for name, (least, greatest) in {**tables, "size": self.size, "height": self.height}.items():
            if least > greatest or (least == greatest and name in tables):
                raise InvalidValue(f"{name} = [{least}, {greatest}] is empty; put the smaller number first.")
        _check_engine(self.engine)
        for name in (*_POSITIVE, *_NOT_NEGATIVE):
            value = getattr(self, name)
            if not np.min(value) >= 0 or (name in _POSITIVE and np.min(value) == 0):
                valid = "be greater than 0" if name in _POSITIVE else "not be negative"
                raise InvalidValue(f"{name} = {value} must {valid}.")
        if not 1 / 2000 <= self.time_step <= 1 / 120:
            raise InvalidValue(f"time_step = {self.time_step} s must lie between 1/2000 and 1/120 s.")
        if not (self.size[0] > 2 * self.wall and self.height[0] > self.wall):
            raise InvalidValue(f"wall = {self.wall} leaves no room inside the smallest object.")
        needed = max(self.size[1], 2 * self.spawn_margin)
        for name, (least, greatest) in tables.items():
            if greatest - least < needed:
                raise InvalidValue(
                    f"{name} = [{least}, {greatest}] is shorter than the {needed} m that objects of size "
                    f"{self.size[1]} m and spawn_margin {self.spawn_margin} m need; lengths are in metres."
                )
        for name, share in self.shapes.items():
            if name not in SHAPES:
                raise UnknownChoice("shape", name, SHAPES)
            if not share >= 0:
                raise InvalidValue(f"shapes.{name} = {share} must not be negative.")
        (wide, high), balls = (self.size, self.height), self.shapes.get("ball", 0)
        if balls and max(wide[0], high[0]) > min(wide[1], high[1]):
            raise InvalidValue(
                f"shapes.ball = {balls}, and size = {[*wide]} and height = {[*high]} have nothing in common; "
                "a ball is as high as wide."
            )
        if not sum(self.shapes.values()) > 0:
            raise InvalidValue(f"shapes must give one of {', '.join(SHAPES)} a share greater than 0.")

    @property
    def object_limits(self) -> ObjectLimits:
        """Which objects the world makes."""
        types = {SHAPES[name] for name, share in self.shapes.items() if share > 0}
        sizes = self.size, self.size, self.height
        return ObjectLimits(FEATURE_NAMES, sizes, tuple(sorted(types)), MOST_OBJECTS, UNSEEN)

    @property
    def table_box(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """The middle and the half sizes of the table, which is larger than where objects must stay [m]."""
        x, y = self.table_x, self.table_y
        half = float(np.ptp(x)) / 2 + 0.25, float(np.ptp(y)) / 2 + 0.25, 0.02
        return (sum(x) / 2, sum(y) / 2, -0.02), half

    @property
    def table(self) -> Table:
        """The part of the table that objects must stay on."""
        return Table(self.table_x, self.table_y)


def _check_engine(name: str) -> None:
    if name not in ENGINES:
        raise UnknownChoice("engine", name, ENGINES)
    if name == "mujoco" and find_spec("mujoco") is None:
        raise InvalidValue(
            f"engine = mujoco, and MuJoCo is not installed; install it with: pip install '{NAME}[mujoco]'."
        )


# What the simulator needs to know of an arm and its hand. The UR10 is one; yours can be another.
#
# Every arm is driven alike (`robot.py`): the hand points down, its two fingers open along the world's y
# axis, and its tool point, between the fingertips, follows straight lines.

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
        joints: Indices of the J joints of the arm, in PyBullet's count, in the order from base to tool.
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
        wrist: Which of the joints, by its place among these, turns the hand about the vertical when the hand
            points down. If None, the hand does not turn with objects that lie turned.

    Raises:
        InvalidArm: If a length is not greater than 0, or what belongs together is not of one number. Whether
            it is as its file says is checked where a world is made with it (`arm_check.py`).
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
    wrist: int | None = None

    def __post_init__(self) -> None:
        given = (*self.joints, *self.fingers)
        for index in (*given, self.tool):
            if not isinstance(index, int | np.integer) or isinstance(index, bool):
                raise InvalidArm(f"of {self.urdf} has the index {index!r}; valid: whole numbers")
        if len(self.fingers) != 2:
            raise InvalidArm(f"of {self.urdf} has {len(self.fingers)} fingers; valid: two")
        if twice := [index for index in given if given.count(index) > 1]:
            raise InvalidArm(f"of {self.urdf} has joint {twice[0]} twice among its joints and fingers")
        if len(self.forces) != len(self.joints):
            raise InvalidArm(
                f"of {self.urdf} has {len(self.forces)} forces for {len(self.joints)} joints; valid: one each"
            )
        for name in _LENGTHS:
            value = getattr(self, name)
            if not all(0 < number < math.inf for number in np.atleast_1d(value)):
                raise InvalidArm(f"of {self.urdf} has {name} = {value}; valid: greater than 0")


_LENGTHS = (
    *("half_opening", "finger_length", "finger_half_width", "finger_thickness", "palm_half_size"),
    *("mass_scale", "forces"),
)


def check_reach(config: TabletopConfig, arm: Arm) -> None:
    """Raise `InvalidValue` unless an arm reaches over the whole table, as high as it lifts."""
    for corner in corners(config):
        try:
            arm.inverse_kinematics(corner[None])
        except InvalidArm:
            raise
        except InvalidValue as error:
            raise InvalidValue(
                f"table_x = {list(config.table_x)}, table_y = {list(config.table_y)} and lift_height = "
                f"{config.lift_height} m ask for more than the arm reaches: {error} Lengths are in metres."
            ) from error


def corners(config: TabletopConfig) -> Float[np.ndarray, "8 3"]:
    """Return the corners of the space over the table that an arm must reach [m]."""
    heights = config.height[0], config.height[1] + config.lift_height
    return np.array([*product(config.table_x, config.table_y, heights)])


# A robot's file, read by PyBullet; what cannot be read is told in one sentence, with the reason

_HEADINGS = re.compile(r"b3\w+\[[^\]]*\]:\s*")
"""What PyBullet puts before each piece of what it says: where in its sources it says it."""
_MESH = re.compile(r"cannot find '[^']+' in any directory|cannot extract mesh from")


@contextmanager
def loaded(
    urdf: str,
    base: tuple[float, float, float] = (0.0, 0.0, 0.0),
    *,
    collides: bool = True,
    visible: bool = False,
) -> Iterator[tuple[Client, int]]:
    """Load a robot into a simulation that is used for nothing else, and yield that and the robot.

    Its base stands there in the world [m]; what it collides with and looks like is loaded if asked for.
    Raises `InvalidArm` if the file cannot be read.
    """
    flags = pybullet.URDF_USE_INERTIA_FROM_FILE
    flags |= 0 if collides else pybullet.URDF_IGNORE_COLLISION_SHAPES
    flags |= 0 if visible else pybullet.URDF_IGNORE_VISUAL_SHAPES
    client = Client()
    try:
        client.setPhysicsEngineParameter(enableFileCaching=0)  # it may be mended
        yield client, _load(client, urdf, base, flags)
    finally:
        client.disconnect()


def _load(client: Client, urdf: str, base: tuple[float, float, float], flags: int) -> int:
    try:
        robot = ElementTree.fromstring(read_text(Path(urdf)))
    except InvalidFile as error:
        raise _unreadable(urdf, str(error).removeprefix(f"{Path(urdf)} cannot be used: ")) from error
    except ElementTree.ParseError as error:
        raise _unreadable(urdf, f"it is no whole XML ({error})") from error
    if not _is_tree(robot):  # which would end the process
        raise _unreadable(urdf, "its joints make no tree of its links; valid: each but one is a child")
    said: list[str] = []
    try:
        with overheard(said):
            body = client.loadURDF(urdf, base, useFixedBase=True, flags=flags)
    except pybullet.error:
        body = None
    if body is None or _MESH.search(said[0]):
        words = " ".join(_HEADINGS.sub(" ", said[0]).split())
        raise _unreadable(urdf, f"PyBullet says: {words}" if words else "it describes no robot")
    return int(body)


def _is_tree(robot: ElementTree.Element) -> bool:
    """Say whether joints lead from one link to all others, to each by one way."""
    links = {link.get("name") for link in robot.findall("link")}
    ends = [(joint.find("parent"), joint.find("child")) for joint in robot.findall("joint")]
    pairs = [(a.get("link"), b.get("link")) for a, b in ends if a is not None and b is not None]
    reached = front = links - {child for _, child in pairs}
    while front:
        front = {child for parent, child in pairs if parent in front} - reached
        reached = reached | front
    return not links or (reached == links and len(pairs) == len(links) - 1)


def _unreadable(urdf: str, why: str) -> InvalidArm:
    return InvalidArm(f"cannot be read from {urdf}: {why.rstrip('.')}")
