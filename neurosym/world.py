"""The world a robot acts in: scenes, outcomes, the table, actions, and the protocol every world keeps."""

import math
import reprlib
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import cycle, islice
from typing import Any, Literal, Protocol, TypeGuard, runtime_checkable

import numpy as np

from neurosym.checks import Bool, Float, UInt8, check_array, check_kind
from neurosym.errors import InvalidValue

# The table, and what actions may be aimed at besides their target: places on it, and other objects


def _check_number(name: str, value: object) -> None:
    if isinstance(value, bool) or not isinstance(value, int | float | np.number):
        raise InvalidValue(f"{name} = {value!r} must be a number [m].")
    if not math.isfinite(value):
        raise InvalidValue(f"{name} = {value} must be finite.")


@dataclass(frozen=True, slots=True)
class Table:
    """The part of the table that objects must stay on: `x` and `y` are (least, greatest) coordinates [m]."""

    x: tuple[float, float]
    y: tuple[float, float]

    def __post_init__(self) -> None:
        for name, side in (("x", self.x), ("y", self.y)):
            if not (isinstance(side, tuple | list) and len(side) == 2):
                raise InvalidValue(f"table.{name} = {side!r} must be two numbers [m], the smaller first.")
            for edge in side:
                _check_number(f"table.{name}", edge)
            if not side[0] < side[1]:
                raise InvalidValue(f"table.{name} = {[*side]} is empty; the first number must be smaller.")

    def nearest(self, x: float, y: float) -> "Place":
        """Return the place on the table that is nearest to a point [m]."""
        return Place(min(max(x, self.x[0]), self.x[1]), min(max(y, self.y[0]), self.y[1]))

    def contains(self, position: Float[np.ndarray, "3"]) -> bool:
        """Say whether a centre lies over the table."""
        x, y = float(position[0]), float(position[1])
        return self.x[0] <= x <= self.x[1] and self.y[0] <= y <= self.y[1]

    def check(self, name: str, x: float, y: float) -> None:
        """Raise `InvalidValue` unless a place of that name lies on the table, at x and y [m]."""
        if not self.contains(np.array([x, y, 0.0])):
            raise InvalidValue(
                f"The place {name} lies at x = {x:g}, y = {y:g} m, off the table; valid: "
                f"x {self.x[0]:g} to {self.x[1]:g}, y {self.y[0]:g} to {self.y[1]:g} m."
            )


@dataclass(frozen=True, slots=True)
class Place:
    """A point on the table that an action may be aimed at besides its target; it has no size."""

    x: float  #: Where it lies away from the robot's base [m]
    y: float  #: Where it lies to the robot's left [m]
    #: How what is set down there shall be turned about the vertical, its x axis from that of the world and
    #: modulo half a turn [rad]; straight if not given. Worlds that turn nothing heed it not
    heading: float | None = None

    def __post_init__(self) -> None:
        _check_number("Place.x", self.x)
        _check_number("Place.y", self.y)
        if self.heading is not None:
            _check_number("Place.heading", self.heading)

    @property
    def centre(self) -> Float[np.ndarray, "3"]:
        """The point in the world frame, at the height of the table [m]."""
        return np.array([self.x, self.y, 0.0])


@dataclass(frozen=True, slots=True)
class OtherObject:
    """Another object of the scene that an action may be aimed at besides its target, by its index."""

    index: int

    def __post_init__(self) -> None:
        if isinstance(self.index, bool) or not isinstance(self.index, int | np.integer):
            raise InvalidValue(f"OtherObject.index = {self.index!r} must be the number of an object.")


STRAIGHT = math.radians(1)
"""An object that is turned by less than this about the vertical, beyond quarters, lies straight [rad]."""


def heading(orientation: Float[np.ndarray, "4"]) -> float:
    """Return how far an object is turned about the vertical beyond quarters, from -pi/4 to pi/4 [rad].

    Its orientation is a quaternion (x, y, z, w). A motion is performed turned by as much, so that what was
    learned of objects that lie straight holds for one at any angle.
    """
    x, y, z, w = np.asarray(orientation, dtype=float) / np.linalg.norm(orientation)
    axes = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
    ])  # fmt: skip  # x and y of the object's axes in the world
    level = axes[:, np.hypot(*axes).argmax()]
    angle = math.atan2(level[1], level[0])
    turned = (angle + math.pi / 4) % (math.pi / 2) - math.pi / 4
    return turned if abs(turned) >= STRAIGHT else 0.0


def heading_to(orientation: Float[np.ndarray, "4"], wanted: float) -> float:
    """Return by how much an object is to be turned to a heading, the nearer way, modulo half a turn [rad]."""
    x, y, z, w = np.asarray(orientation, dtype=float) / np.linalg.norm(orientation)
    now = math.atan2(2 * (x * y + z * w), 1 - 2 * (y * y + z * z))
    return (wanted - now + math.pi / 2) % math.pi - math.pi / 2


def turned_by(angle: float, offsets: Float[np.ndarray, "*n K"]) -> Float[np.ndarray, "*n K"]:
    """Return offsets [m] turned about the vertical by an angle [rad]; their first two numbers are x and y."""
    if angle == 0.0:
        return offsets
    x, y, *rest = np.moveaxis(offsets, -1, 0)
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.stack([cosine * x - sine * y, sine * x + cosine * y, *rest], axis=-1)


Reference = Place | OtherObject  # what an action may be relative to besides its target
ReferenceKind = Literal["place", "object"]


def centre_of(reference: Reference, positions: Float[np.ndarray, "M 3"]) -> Float[np.ndarray, "3"]:
    """Return what an action is relative to in the world frame, a place at the height of the table [m]."""
    return reference.centre if isinstance(reference, Place) else np.asarray(positions[reference.index])


# The actions a world takes: the box they are drawn from, and the mirrors in which it looks the same

EFFECT_AXES = 3  # axes of a displacement in a world


@dataclass(frozen=True, slots=True)
class Mirror:
    """A mirror in which the world looks the same: what happens there is again what the world does."""

    actions: tuple[int, ...]  #: Numbers of the action parameters whose sign it changes
    effects: tuple[int, ...]  #: Numbers of the effect axes whose sign it changes


@dataclass(frozen=True, slots=True, eq=False)
class ActionBox:
    """The box that actions are drawn from, and which of their numbers are gripper values."""

    low: Float[np.ndarray, "A"]  #: Smallest value of each action parameter ([m] for coordinates)
    high: Float[np.ndarray, "A"]  #: Largest value of each action parameter
    #: True where the parameter is a gripper value, which acts only through being >= 0.5 (open)
    gripper: Bool[np.ndarray, "A"]
    #: Mirrors that the world looks the same in; none where that is not known
    mirrors: tuple[Mirror, ...] = ()

    def __post_init__(self) -> None:
        if problem := box_problem(self):
            raise InvalidValue(f"An ActionBox cannot be made with {problem}.")

    def sample(self, rng: np.random.Generator, count: int) -> Float[np.ndarray, "{count} A"]:
        """Draw so many actions uniformly from the box."""
        return rng.uniform(self.low, self.high, size=(count, len(self.low)))

    def contains(self, action: Float[np.ndarray, "A"]) -> bool:
        """Say whether an action lies in the box."""
        return bool(np.all(action >= self.low) and np.all(action <= self.high))


def three_waypoints() -> ActionBox:
    """Return the paper's action box (eq. 1): three waypoints (x, y, z, g) around the target's centre.

    x and y lie within 5 cm of it, z within 2.5, 2.5 and 5 cm, and g between 0 and 1. Left and right are
    alike, and so are forward and back: hand and objects are, and the arm is free to move either way.
    """
    reach = np.array([0.05, 0.05, 0.025, 0.0] * 2 + [0.05, 0.05, 0.05, 0.0])
    gripper = np.array([False, False, False, True] * 3)
    mirrors = tuple(Mirror(actions=(axis, axis + 4, axis + 8), effects=(axis,)) for axis in (0, 1))
    return ActionBox(np.where(gripper, 0.0, -reach), np.where(gripper, 1.0, reach), gripper, mirrors)


def box_problem(box: ActionBox) -> str | None:
    """Say what is wrong with the columns or the mirrors of an action box, or return None."""
    low, high, gripper = box.low, box.high, box.gripper
    for name, column, kinds in (("low", low, "fiu"), ("high", high, "fiu"), ("gripper", gripper, "b")):
        valid = "bool" if kinds == "b" else "an array of numbers"
        if not isinstance(column, np.ndarray):
            return f"{name} of type {type(column).__name__}; valid: a numpy array, {valid}"
        if column.dtype.kind not in kinds:
            return f"{name} of {column.dtype}; valid: {valid}"
    if low.ndim != 1 or not len(low) or not low.shape == high.shape == gripper.shape:
        shapes = f"low {low.shape}, high {high.shape} and gripper {gripper.shape}"
        return f"{shapes}; valid: one shape (A,) for all three"
    if not (np.isfinite([low, high]).all() and np.all(low <= high)):
        return "bounds that are empty or not finite; valid: low <= high"
    if not isinstance(box.mirrors, tuple) or not all(isinstance(mirror, Mirror) for mirror in box.mirrors):
        return f"mirrors = {reprlib.repr(box.mirrors)}; valid: a tuple of Mirror"
    grippers = np.flatnonzero(gripper).tolist()
    for mirror in box.mirrors:
        if problem := column_problem(mirror, len(low), EFFECT_AXES, grippers):
            return f"{mirror}; {problem}"
        for number in mirror.actions:
            if low[number] != -high[number]:
                bounds = f"action parameter {number} goes from {low[number]:g} to {high[number]:g}"
                return f"{mirror}, but {bounds}; valid: as far below 0 as above"
    return None


def column_problem(mirror: Mirror, actions: int, effects: int, grippers: Collection[int]) -> str | None:
    """Say what a mirror must name of so many columns, none a gripper value, or None if it does."""

    def are_from(numbers: Any, valid: set[int]) -> bool:
        are_numbers = isinstance(numbers, tuple) and all(type(number) is int for number in numbers)
        return are_numbers and len(valid.intersection(numbers)) == len(numbers)

    signed = set(range(actions)) - set(grippers)
    if mirror.actions and are_from(mirror.actions, signed) and are_from(mirror.effects, set(range(effects))):
        return None
    return (
        f"valid: different action parameters from 0 to {actions - 1}, at least one and no gripper value, "
        f"and different effect axes from 0 to {effects - 1}"
    )


# The world a robot acts in: scenes, outcomes, and the protocol every world implements.
#
# A world is a function without memory: a scene goes in, an outcome comes out, and the outcome's last scene
# can go in again. So an interaction has the same result in any order and in any process, and a plan is
# executed by feeding each outcome's end into the next interaction.

Disturbance = Literal["moved", "toppled", "lost"]
OutcomeKind = Literal["resting", "held", "toppled", "lost", "carried", "missed"]
"""How a target ends. What is aimed at a reference is carried there or missed, if not toppled or lost."""
Frame = UInt8[np.ndarray, "height width 3"]
FrameSink = Callable[[Frame, str], None]
"""Takes a picture of the motion and the name of the phase it belongs to (`waypoint 1`, `rise`, ...)."""


_NOTHING = np.zeros((0, 0))


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """The objects on the table, at one moment."""

    #: What each object is, with size along x, size along y, height [m], and type; a world names its own
    features: Float[np.ndarray, "M F"]
    positions: Float[np.ndarray, "M 3"]  #: Centre of each object in the world frame [m]
    #: Orientation of each object in the world frame, as a quaternion (x, y, z, w)
    orientations: Float[np.ndarray, "M 4"]
    #: What only the world knows of each object, as it names that itself; mostly no column at all
    unseen: Float[np.ndarray, "M U"] = field(default_factory=lambda: _NOTHING, kw_only=True)

    def __post_init__(self) -> None:
        if self.unseen is _NOTHING:
            object.__setattr__(self, "unseen", np.zeros((len(self.features), 0)))

    def __len__(self) -> int:
        return len(self.features)


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """What one interaction did: the scene before it, at the end of the rise, and after the put-down."""

    start: Scene  #: Everything at rest, before the hand comes near
    lifted: Scene  #: At the end of the rise, a held object in mid-air
    #: Everything at rest again, hand empty. Equal to `lifted` when the caller asked for no put-down
    end: Scene
    target: int  #: Index of the object that the action was aimed at
    held: bool  #: Whether the target hung from the gripper at the end of the rise
    toppled: bool  #: Whether the target ended lying on another face than it started on
    lost: bool  #: Whether the target ended off the table
    peak_height: float  #: Greatest height of the target's centre above its start on the way [m]
    touched: tuple[int, ...] = ()  #: Indices of the bystanders that the robot itself touched
    #: Indices of the bystanders that ended elsewhere, each with how it ended
    disturbed: tuple[tuple[int, Disturbance], ...] = ()
    reference: Reference | None = None  #: What the action was relative to besides the target, if anything
    #: Whether the target hung from the hand until it was over the reference, and was set down
    carried: bool = False
    #: Pairs of objects that touch in the end, each with the smaller index first
    contacts: tuple[tuple[int, int], ...] = ()

    @property
    def kind(self) -> OutcomeKind:
        """How the target ended: with a reference carried there or missed; else held in the air or at rest."""
        if self.lost:
            return "lost"
        if self.toppled and (self.reference or not self.held):
            return "toppled"
        if self.reference:
            return "carried" if self.carried else "missed"
        return "held" if self.held else "resting"

    @property
    def effect(self) -> Float[np.ndarray, "3"]:
        """Displacement of the target at the end of the rise [m] (the paper's e); see `_origin`."""
        return np.asarray(self.lifted.positions[self.target] - self._origin)

    @property
    def resting_effect(self) -> Float[np.ndarray, "3"]:
        """Displacement of the target once everything is put down, from the reference if carried [m]."""
        return np.asarray(self.end.positions[self.target] - self._origin)

    @property
    def _origin(self) -> Float[np.ndarray, "3"]:
        """Where the target stood, or would have stood where the reference was that it was carried to [m]."""
        centre: np.ndarray = self.start.positions[self.target]
        if self.reference is None or not self.carried:
            return centre
        x, y, _ = centre_of(self.reference, self.start.positions)
        return np.array([x, y, centre[2]], dtype=float)

    @property
    def turn(self) -> float:
        """By what angle the target is turned in the end, about whatever axis [rad]."""
        before, after = self.start.orientations[self.target], self.end.orientations[self.target]
        lengths = float(np.linalg.norm(before) * np.linalg.norm(after))
        return 2 * math.acos(min(1.0, abs(float(before @ after)) / lengths)) if lengths else 0.0


@runtime_checkable
class World(Protocol):
    """What exploration, rehearsal and execution need of a world."""

    @property
    def name(self) -> str:
        """Name of the world, a legal PDDL name."""

    @property
    def feature_names(self) -> tuple[str, ...]:
        """Names of the F object features, sizes along x, y, z first."""

    @property
    def action_box(self) -> ActionBox:
        """The box of the A action parameters."""

    @property
    def table(self) -> Table:
        """Where objects may stand."""

    @property
    def lift_height(self) -> float:
        """How far the hand rises after the last waypoint [m]."""

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene of objects at rest that do not overlap.

        Args:
            rng: Source of randomness, owned by the caller.
            objects: How many objects.

        Raises:
            InvalidValue: If so many objects do not fit on the table.
        """

    def interact(
        self,
        scene: Scene,
        action: Float[np.ndarray, "A"],
        target: int,
        *,
        put_down: bool = True,
        on_frame: FrameSink | None = None,
        ghosts: Float[np.ndarray, "M 3"] | None = None,
        reference: Reference | None = None,
    ) -> Outcome:
        """Perform one action on one object, from empty hand to empty hand.

        A world that knows `references` may be given one, and others are never given any. The target is then
        carried over the reference if it hangs from the hand after the second waypoint.

        Args:
            scene: The objects, at rest.
            action: Action parameters, relative to the target's centre; the third waypoint is relative to
                the reference if there is one.
            target: Index of the object acted upon.
            put_down: Whether to lower and release an object that is held after the rise; without it the
                outcome ends in mid-air.
            on_frame: Called with pictures of the motion as it happens, if given.
            ghosts: Centres at which pictures show the objects once more, transparently, as at their
                goals [m]; NaN for an object without one.
            reference: What the action is relative to besides the target, if anything.

        Raises:
            InvalidValue: If the action has another shape, is not finite, the target does not exist, or the
                reference lies off the table, does not exist, or is the target.
        """


REQUIRED = tuple(name for name in vars(World) if not name.startswith("_"))  # what a world must have


def is_world(thing: object) -> TypeGuard[World]:
    """Say whether an object has what a world has; `isinstance` overlooks what `__getattr__` gives."""
    return all(hasattr(thing, name) for name in REQUIRED)


WorldFactory = Callable[[], World]  # builds a world, in this process or another


@runtime_checkable
class Pictured(Protocol):
    """A world that can also show a scene without acting in it."""

    def picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        """Draw a scene; ghosts are as those of `interact`."""


def references_of(world: World) -> tuple[ReferenceKind, ...]:
    """Return what actions of a world may be relative to; nothing if it does not say."""
    return tuple(getattr(world, "references", ()))


def turns(world: World) -> bool:
    """Say whether a world performs motions turned as objects lie (see `heading`); not if it does not say."""
    return bool(getattr(world, "turns", False))


def unshown_of(world: World) -> tuple[int, ...]:
    """Return the numbers of the features that networks are not shown; none if the world does not say.

    Of a pair of objects these are features of either.
    """
    if not (names := getattr(world, "unshown", ())):
        return ()
    return tuple(n for n, name in enumerate(world.feature_names) if name.split()[-1] in names)


def relative_to(world: World, reference: Reference | None) -> dict[str, Any]:
    """Return what `interact` is given besides; a world that knows no references is never given any.

    Raises:
        InvalidValue: If there is a reference, and the world does not take such.
    """
    if reference is None:
        return {}
    check_kind("reference", reference, Reference, "a Place or an OtherObject")
    kind: ReferenceKind = "place" if isinstance(reference, Place) else "object"
    if kind not in references_of(world):
        raise InvalidValue(
            f"The {world.name} world takes no {kind} as a reference; valid: a world whose `references` "
            f"hold {kind!r}."
        )
    return {"reference": reference}


def check_action(
    world: World, scene: Scene, action: np.ndarray, target: int, reference: Reference | None = None
) -> None:
    """Raise `InvalidValue` unless an action can be performed on that target; see `World.interact`."""
    check_kind("scene", scene, Scene, "a Scene")
    check_array("Scene.features", scene.features, (None, len(world.feature_names)))
    for name, width in (("positions", 3), ("orientations", 4)):
        check_array(f"Scene.{name}", getattr(scene, name), (len(scene), width))
    check_array("The action", np.asarray(action), (len(world.action_box.low),))
    if not isinstance(target, int | np.integer) or isinstance(target, bool):
        raise InvalidValue(f"The target must be the number of an object, not {target!r}.")
    if not 0 <= target < len(scene):
        raise InvalidValue(f"There is no object {target}; the scene has objects 0 to {len(scene) - 1}.")
    relative_to(world, reference)
    if isinstance(reference, Place):
        world.table.check(f"({reference.x:g}, {reference.y:g})", reference.x, reference.y)
    if isinstance(reference, OtherObject) and not 0 <= reference.index < len(scene):
        raise InvalidValue(
            f"There is no object {reference.index} to aim at; the scene has objects 0 to {len(scene) - 1}."
        )
    if isinstance(reference, OtherObject) and reference.index == target:
        raise InvalidValue(f"Object {target} is the target; it cannot be the reference, too.")


# Colours, each for one meaning wherever it is seen: categories of objects, in pictures, pages and films

Colour = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""
CATEGORY_COLOURS: tuple[Colour, ...] = (
    (0, 201, 158), (131, 29, 42), (174, 104, 236), (110, 0, 172),
    (66, 122, 115), (213, 231, 52), (255, 197, 253), (223, 84, 20),
)  # fmt: skip
"""Mint, maroon, lilac, purple, slate, lime, pink, orange: told apart under all three colour blindnesses."""
OTHER: Colour = (138, 138, 138)
"""Of rarer categories than there are colours, and of objects whose category nobody knows."""
NEUTRAL: tuple[Colour, ...] = ((112, 104, 94), (236, 233, 228), (78, 76, 74), (168, 158, 144))
"""Greys and beiges of objects, one after another, where a world is asked for no categories."""


class Palette:
    """The colours of the categories of a domain.

    Args:
        symbols: The object symbols, most frequent first; those beyond the eighth are all `OTHER`.
    """

    def __init__(self, symbols: Iterable[str] = ()):
        self._colours = dict(zip(dict.fromkeys(symbols), CATEGORY_COLOURS, strict=False))

    @classmethod
    def of(cls, categories: Iterable[Any]) -> "Palette":
        """Return the palette of categories, which have a `symbol` and a `share` of the objects."""
        ranked = sorted(categories, key=lambda one: (-one.share, one.symbol))
        return cls(one.symbol for one in ranked)

    def __call__(self, symbol: str) -> Colour:
        """Return the colour of an object symbol."""
        return self._colours.get(symbol, OTHER)

    def hex(self, symbol: str) -> str:
        """Return the colour of an object symbol as a page writes it: `#00c99e`."""
        return "#{:02x}{:02x}{:02x}".format(*self(symbol))

    def of_all(self, symbols: Sequence[str]) -> UInt8[np.ndarray, "M 3"]:
        """Return the colours of several object symbols."""
        return np.array([self(one) for one in symbols], dtype=np.uint8).reshape(-1, 3)


@runtime_checkable
class Painted(Protocol):
    """A world whose pictures can show objects in given colours.

    Attributes:
        painter: Gives the colours, 0 to 255, of objects with such features; None for the world's own.
    """

    painter: "Painter | None"


class Painter(Protocol):
    """Gives the colours of objects by their features."""

    def __call__(self, features: Float[np.ndarray, "M F"]) -> UInt8[np.ndarray, "M 3"]:
        """Return the colour of each object."""
        ...


def painted(painter: Painter | None, features: Float[np.ndarray, "M F"]) -> UInt8[np.ndarray, "M 3"]:
    """Return the colours of objects as a painter gives them, or neutral ones by their number."""
    if painter:
        return painter(features)
    return np.array([*islice(cycle(NEUTRAL), len(features))], dtype=np.uint8).reshape(-1, 3)


# Dots that mark the waypoints of an action in a picture, as in the paper: blue, green, red

DOT_COLOURS = ((31, 98, 224), (30, 160, 70), (222, 40, 45))
"""Of waypoints 1, 2 and 3: where the motion starts, its middle, its end."""
_RIM, _RIM_COLOUR = 0.25, (255, 255, 255)  # the rim's width, as a share of the radius, and its colour


def draw_dots(frame: Frame, places: Float[np.ndarray, "N 2"], radius: float) -> Frame:
    """Draw a round dot with a white rim at each place, smooth at its edge; later dots lie on earlier ones.

    Centres count rightwards and downwards from the upper left corner; the radius is without the rim [pixels].
    """
    picture = frame.copy()
    for number, (x, y) in enumerate(places.tolist()):
        colour = DOT_COLOURS[number % len(DOT_COLOURS)]
        for reach, paint in (((1 + _RIM) * radius, _RIM_COLOUR), (radius, colour)):
            top, left = (max(0, math.floor(middle - reach - 1)) for middle in (y, x))
            part = picture[top : max(0, math.ceil(y + reach + 1)), left : max(0, math.ceil(x + reach + 1))]
            rows, columns = np.indices(part.shape[:2]) + 0.5
            distance = np.hypot(columns + left - x, rows + top - y)
            cover = np.clip(reach - distance + 0.5, 0, 1)[:, :, None]  # (rows, columns, 1)
            part[:] = np.rint((1 - cover) * part + cover * np.array(paint, dtype=np.uint8))
    return picture
