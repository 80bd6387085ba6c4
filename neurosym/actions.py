"""The actions a world takes: the box they are drawn from, and the mirrors in which it looks the same."""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Bool, Float


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
    """

    low: Float[np.ndarray, "A"]
    high: Float[np.ndarray, "A"]
    gripper: Bool[np.ndarray, "A"]
    mirrors: tuple[Mirror, ...] = ()

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
