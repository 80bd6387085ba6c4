"""The table, and what actions may be aimed at besides their target: places on it, and other objects."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from neurosym.arrays import Float
from neurosym.checks import check_kind
from neurosym.errors import InvalidValue


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
