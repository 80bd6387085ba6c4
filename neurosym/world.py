"""The world a robot acts in: scenes, outcomes, the table, actions, and the protocol every world keeps."""

import math
import reprlib
from collections.abc import Callable, Collection
from dataclasses import dataclass
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
        """Raise `InvalidValue` unless a place lies on the table.

        Args:
            name: What the place is called.
            x: Where it lies [m].
            y: The same for the other axis [m].
        """
        if not self.contains(np.array([x, y, 0.0])):
            raise InvalidValue(
                f"The place {name} lies at x = {x:g}, y = {y:g} m, off the table; valid: "
                f"x {self.x[0]:g} to {self.x[1]:g}, y {self.y[0]:g} to {self.y[1]:g} m."
            )


@dataclass(frozen=True, slots=True)
class Place:
    """A point on the table that an action may be aimed at besides its target; it has no size.

    Attributes:
        x: Where it lies away from the robot's base [m].
        y: Where it lies to the robot's left [m].
    """

    x: float
    y: float

    def __post_init__(self) -> None:
        _check_number("Place.x", self.x)
        _check_number("Place.y", self.y)

    @property
    def centre(self) -> Float[np.ndarray, "3"]:
        """The point in the world frame, at the height of the table [m]."""
        return np.array([self.x, self.y, 0.0])


@dataclass(frozen=True, slots=True)
class OtherObject:
    """Another object of the scene that an action may be aimed at besides its target.

    Attributes:
        index: Which object of the scene, counted from 0.
    """

    index: int

    def __post_init__(self) -> None:
        if isinstance(self.index, bool) or not isinstance(self.index, int | np.integer):
            raise InvalidValue(f"OtherObject.index = {self.index!r} must be the number of an object.")


Reference = Place | OtherObject
"""What an action may be relative to besides its target."""
ReferenceKind = Literal["place", "object"]


def centre_of(reference: Reference, positions: Float[np.ndarray, "M 3"]) -> Float[np.ndarray, "3"]:
    """Return what an action is relative to in the world frame [m].

    Args:
        reference: What it is aimed at besides its target.
        positions: Where the centres of all objects are [m].
    """
    return reference.centre if isinstance(reference, Place) else np.asarray(positions[reference.index])


def kind_of_reference(reference: Reference) -> ReferenceKind:
    """Say of which kind a reference is.

    Raises:
        InvalidValue: If it is none.
    """
    check_kind("reference", reference, Reference, "a Place or an OtherObject")
    return "place" if isinstance(reference, Place) else "object"


def check_reference(reference: Reference, table: Table, objects: int, target: int) -> None:
    """Raise `InvalidValue` unless an action can be relative to that.

    Args:
        reference: What it should be relative to besides its target.
        table: Where objects may stand.
        objects: How many objects the scene has.
        target: Index of the target.
    """
    if isinstance(reference, OtherObject):
        if not 0 <= reference.index < objects:
            raise InvalidValue(
                f"There is no object {reference.index} to aim at; the scene has objects 0 to {objects - 1}."
            )
        if reference.index == target:
            raise InvalidValue(f"Object {target} is the target; it cannot be the reference, too.")
    elif not table.contains(reference.centre):
        (left, right), (near, far) = table.y, table.x
        raise InvalidValue(
            f"The place ({reference.x:g}, {reference.y:g}) lies off the table; valid: x from {near:g} to "
            f"{far:g} m and y from {left:g} to {right:g} m."
        )


# The actions a world takes: the box they are drawn from, and the mirrors in which it looks the same

EFFECT_AXES = 3
"""Axes of a displacement in a world."""


@dataclass(frozen=True, slots=True)
class Mirror:
    """A mirror in which the world looks the same: what happens there is again what the world does.

    Attributes:
        actions: Numbers of the action parameters whose sign it changes.
        effects: Numbers of the effect axes whose sign it changes.
    """

    actions: tuple[int, ...]
    effects: tuple[int, ...]


@dataclass(frozen=True, slots=True, eq=False)
class ActionBox:
    """The box that actions are drawn from, and which of their numbers are gripper values.

    Attributes:
        low: Smallest value of each action parameter ([m] for coordinates).
        high: Largest value of each action parameter.
        gripper: True where the parameter is a gripper value, which acts only through being >= 0.5 (open).
        mirrors: Mirrors that the world looks the same in; none where that is not known.

    Raises:
        InvalidValue: If the arrays are not of one shape, the box is empty or not finite, or a mirror names
            what is not there.
    """

    low: Float[np.ndarray, "A"]
    high: Float[np.ndarray, "A"]
    gripper: Bool[np.ndarray, "A"]
    mirrors: tuple[Mirror, ...] = ()

    def __post_init__(self) -> None:
        if problem := box_problem(self):
            raise InvalidValue(f"An ActionBox cannot be made with {problem}.")

    def sample(self, rng: np.random.Generator, count: int) -> Float[np.ndarray, "{count} A"]:
        """Draw actions uniformly from the box.

        Args:
            rng: Source of randomness, owned by the caller.
            count: How many actions.
        """
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
    return ActionBox(
        low=np.where(gripper, 0.0, -reach),
        high=np.where(gripper, 1.0, reach),
        gripper=gripper,
        mirrors=mirrors,
    )


def box_problem(box: ActionBox) -> str | None:
    """Say what is wrong with the columns or the mirrors of an action box, or return None.

    Args:
        box: The action box.
    """
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
    if not (np.all(np.isfinite(low)) and np.all(np.isfinite(high)) and np.all(low <= high)):
        return "bounds that are empty or not finite; valid: low <= high"
    return _mirrors_problem(box)


def _mirrors_problem(box: ActionBox) -> str | None:
    if not isinstance(box.mirrors, tuple) or not all(isinstance(mirror, Mirror) for mirror in box.mirrors):
        return f"mirrors = {reprlib.repr(box.mirrors)}; valid: a tuple of Mirror"
    grippers = np.flatnonzero(box.gripper).tolist()
    for mirror in box.mirrors:
        if problem := column_problem(mirror, len(box.low), EFFECT_AXES, grippers):
            return f"{mirror}; {problem}"
        for number in mirror.actions:
            low, high = box.low[number], box.high[number]
            if low != -high:
                return (
                    f"{mirror}, but action parameter {number} goes from {low:g} to {high:g}; "
                    "valid: as far below 0 as above"
                )
    return None


def column_problem(mirror: Mirror, actions: int, effects: int, grippers: Collection[int]) -> str | None:
    """Say what a mirror must name, if it does not, or return None.

    Args:
        mirror: The mirror.
        actions: How many action parameters there are.
        effects: How many effect axes there are.
        grippers: Which action parameters are gripper values, whose sign cannot change.
    """
    valid = set(range(actions)) - set(grippers)
    if mirror.actions and _are_from(mirror.actions, valid) and _are_from(mirror.effects, set(range(effects))):
        return None
    return (
        f"valid: different action parameters from 0 to {actions - 1}, at least one and no gripper value, "
        f"and different effect axes from 0 to {effects - 1}"
    )


def _are_from(numbers: Any, valid: Collection[int]) -> bool:
    """Say whether something is a tuple of different numbers out of these."""
    return (
        isinstance(numbers, tuple)
        and all(isinstance(number, int) and not isinstance(number, bool) for number in numbers)
        and len(set(numbers) & set(valid)) == len(numbers)
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


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """The objects on the table, at one moment.

    Attributes:
        features: What each object is: size along x, size along y, height [m], and type; a world
            names its own.
        positions: Centre of each object in the world frame [m].
        orientations: Orientation of each object in the world frame, as a quaternion (x, y, z, w).
    """

    features: Float[np.ndarray, "M F"]
    positions: Float[np.ndarray, "M 3"]
    orientations: Float[np.ndarray, "M 4"]

    def __len__(self) -> int:
        return len(self.features)


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """What one interaction did: the scene before it, at the end of the rise, and after the put-down.

    Attributes:
        start: Everything at rest, before the hand comes near.
        lifted: At the end of the rise, a held object in mid-air.
        end: Everything at rest again, hand empty. Equal to `lifted` when the caller asked for no put-down.
        target: Index of the object that the action was aimed at.
        held: Whether the target hung from the gripper at the end of the rise.
        toppled: Whether the target ended lying on another face than it started on.
        lost: Whether the target ended off the table.
        peak_height: Greatest height of the target's centre above its start on the way [m].
        touched: Indices of the bystanders that the robot itself touched.
        disturbed: Indices of the bystanders that ended elsewhere, each with how it ended.
        reference: What the action was relative to besides the target, if anything.
        carried: Whether the target hung from the hand until it was over the reference, and was set down.
        contacts: Pairs of objects that touch in the end, each with the smaller index first.
    """

    start: Scene
    lifted: Scene
    end: Scene
    target: int
    held: bool
    toppled: bool
    lost: bool
    peak_height: float
    touched: tuple[int, ...] = ()
    disturbed: tuple[tuple[int, Disturbance], ...] = ()
    reference: Reference | None = None
    carried: bool = False
    contacts: tuple[tuple[int, int], ...] = ()

    @property
    def kind(self) -> OutcomeKind:
        """How the target ended: off the table, on another face, or else in the way that was asked for.

        With a reference that is carried there or missed; without, held in the air or at rest upright.
        """
        if self.lost:
            return "lost"
        if self.reference is not None:
            return "toppled" if self.toppled else "carried" if self.carried else "missed"
        if self.held:
            return "held"
        return "toppled" if self.toppled else "resting"

    @property
    def effect(self) -> Float[np.ndarray, "3"]:
        """Displacement of the target at the end of the rise [m] (the paper's e).

        If it was carried, that is from the reference, as if it had stood there before.
        """
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
        return np.array([float(x), float(y), float(centre[2])])

    @property
    def turn(self) -> float:
        """By what angle the target is turned in the end, about whatever axis [rad]."""
        before, after = self.start.orientations[self.target], self.end.orientations[self.target]
        lengths = float(np.linalg.norm(before) * np.linalg.norm(after))
        return 2 * math.acos(min(1.0, abs(float(before @ after)) / lengths)) if lengths else 0.0

    @property
    def displacements(self) -> Float[np.ndarray, "M 3"]:
        """Displacement of every object from the start to the end [m], bystanders included."""
        return np.asarray(self.end.positions - self.start.positions)


@runtime_checkable
class World(Protocol):
    """What exploration, rehearsal and execution need of a world."""

    @property
    def name(self) -> str:
        """Name of the world, a legal PDDL name."""
        ...

    @property
    def feature_names(self) -> tuple[str, ...]:
        """Names of the F object features, sizes along x, y, z first."""
        ...

    @property
    def action_box(self) -> ActionBox:
        """The box of the A action parameters."""
        ...

    @property
    def table(self) -> Table:
        """Where objects may stand."""
        ...

    @property
    def lift_height(self) -> float:
        """How far the hand rises after the last waypoint [m]."""
        ...

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene of objects at rest that do not overlap.

        Args:
            rng: Source of randomness, owned by the caller.
            objects: How many objects.

        Raises:
            InvalidValue: If so many objects do not fit on the table.
        """
        ...

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
        ...


REQUIRED = tuple(name for name in vars(World) if not name.startswith("_"))
"""What a world must have."""


def is_world(thing: object) -> TypeGuard[World]:
    """Say whether an object has what a world has, wherever it has it from.

    From Python 3.12 on, `isinstance` overlooks what `__getattr__` gives.

    Args:
        thing: The object.
    """
    return all(hasattr(thing, name) for name in REQUIRED)


WorldFactory = Callable[[], World]
"""Builds a world, in this process or another."""


@runtime_checkable
class Pictured(Protocol):
    """A world that can also show a scene without acting in it."""

    def picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        """Draw a scene.

        Args:
            scene: The objects.
            ghosts: Centres at which the objects are shown once more, transparently [m]; see `interact`.
        """
        ...


def references_of(world: World) -> tuple[ReferenceKind, ...]:
    """Return what actions of a world may be relative to besides their target; nothing if it does not say."""
    return tuple(getattr(world, "references", ()))


def relative_to(world: World, reference: Reference | None) -> dict[str, Any]:
    """Return what `interact` is given besides; a world that knows no references is never given any.

    Args:
        world: The world.
        reference: What the action is relative to besides its target, if anything.

    Raises:
        InvalidValue: If there is a reference, and the world does not take such.
    """
    if reference is None:
        return {}
    kind = kind_of_reference(reference)
    if kind not in references_of(world):
        raise InvalidValue(
            f"The {world.name} world takes no {kind} as a reference; valid: a world whose `references` "
            f"hold {kind!r}."
        )
    return {"reference": reference}


def check_action(
    world: World, scene: Scene, action: np.ndarray, target: int, reference: Reference | None = None
) -> None:
    """Raise `InvalidValue` unless the action can be performed on that target.

    Args:
        world: The world that is asked to perform it.
        scene: The scene it is performed in.
        action: The action parameters.
        target: Index of the target.
        reference: What it is relative to besides, if anything.
    """
    check_kind("scene", scene, Scene, "a Scene")
    check_array("Scene.features", scene.features, (None, len(world.feature_names)))
    for name, width in (("positions", 3), ("orientations", 4)):
        check_array(f"Scene.{name}", getattr(scene, name), (len(scene), width))
    size = len(world.action_box.low)
    if np.asarray(action).dtype.kind not in "fiu":
        raise InvalidValue(f"The action must be numbers, not {np.asarray(action).dtype}.")
    if np.shape(action) != (size,):
        raise InvalidValue(
            f"The action has shape {np.shape(action)}; the {world.name} world takes ({size},)."
        )
    if not np.all(np.isfinite(action)):
        raise InvalidValue(f"The action holds a value that is not finite: {np.asarray(action).tolist()}.")
    if not isinstance(target, int | np.integer) or isinstance(target, bool):
        raise InvalidValue(f"The target must be the number of an object, not {target!r}.")
    if not len(scene):
        raise InvalidValue("The scene is empty; there is nothing to act upon.")
    if not 0 <= target < len(scene):
        raise InvalidValue(f"There is no object {target}; the scene has objects 0 to {len(scene) - 1}.")
    if reference is not None:
        relative_to(world, reference)
        check_reference(reference, world.table, len(scene), target)
