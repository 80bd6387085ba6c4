"""The actions a world takes: the box they are drawn from, and the mirrors in which it looks the same."""

import reprlib
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.errors import InvalidValue

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
