"""The world a robot acts in: scenes, outcomes, and the protocol every world implements.

A world is a function without memory: a scene goes in, an outcome comes out, and the outcome's last scene
can go in again. So an interaction has the same result in any order and in any process, and a plan is
executed by feeding each outcome's end into the next interaction.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, Protocol, TypeGuard, runtime_checkable

import numpy as np

from neurosym.actions import ActionBox
from neurosym.arrays import Float, UInt8
from neurosym.checks import check_array, check_kind
from neurosym.errors import InvalidValue
from neurosym.table import Reference, ReferenceKind, Table, centre_of, check_reference, kind_of_reference

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
