"""Symbols of one object and of one motion, as a page shows them: bits, operators, predictions, rehearsals."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import is_lift
from neurosym.operators import Operator, Vector
from neurosym.problems import SceneObject
from neurosym.promises import usable
from neurosym.studio.library import Library
from neurosym.tasks.moves import chance, step_cost

SAFE, OTHERWISE = (42, 157, 92), (217, 83, 79)
"""Colours of rehearsals that ended as promised, and otherwise."""


@dataclass(frozen=True, slots=True)
class Promise:
    """What an operator does to the object at hand.

    Attributes:
        operator: The operator, as it promises for this object.
        effect: Where it takes the object, at the end of the rise if it lifts [m].
        lifts: Whether it ends with the object in the air.
        chance: How likely it goes as promised.
        cost: What a step of it costs.
    """

    operator: Operator
    effect: Vector
    lifts: bool
    chance: float
    cost: int


@dataclass(frozen=True, slots=True)
class Motion:
    """What the network says of an action on an object.

    Attributes:
        symbol: The symbol that the action has.
        expected: Where the object goes by the bits alone [m].
        direct: Where it goes by the network before the bits [m].
    """

    symbol: str
    expected: tuple[float, ...]
    direct: tuple[float, ...]


def promises_for(item: SceneObject, library: Library) -> tuple[Promise, ...]:
    """List what the operators of the domain do to an object, the surest first."""
    grounding = library.grounding
    found = [
        Promise(one, one.promise.outcome, is_lift(one), chance(one), step_cost(one, grounding))
        for one in usable(grounding, item)
        if one.promise is not None and len(one.promise.outcome) == 3
    ]
    return tuple(sorted(found, key=lambda one: (-one.chance, one.operator.name)))


def motion_of(features: Sequence[float], action: Sequence[float], library: Library) -> Motion | None:
    """Say which symbol an action has, and what the network expects of it; None without a network.

    Args:
        features: What the object is.
        action: The action parameters.
        library: The domain.
    """
    answer = library.expect(np.array([features], dtype=float), np.array([action], dtype=float))
    return None if answer is None else Motion(*answer)


def rehearsal_dots(
    operator: Operator, start: Sequence[float], library: Library
) -> tuple[Float[np.ndarray, "N 3"], Float[np.ndarray, "N 3"]]:
    """Return where rehearsals of an operator ended, as if all had begun at one point, and their colours.

    Args:
        operator: An operator, by whose name the rehearsals are found.
        start: Where they begin [m].
        library: The domain.
    """
    learned = library.grounding.operator_named(operator.name)
    promise = learned.promise
    rows = [(one.outcome, promise is not None and one.kind == promise.kind) for one in learned.rehearsals]
    points = np.array([np.add(start, outcome) for outcome, _ in rows], dtype=float).reshape(-1, 3)
    colours = np.array([SAFE if kept else OTHERWISE for _, kept in rows], dtype=float).reshape(-1, 3)
    return points, colours


def nearest_flip(features: Sequence[float], library: Library) -> tuple[int, tuple[float, ...]] | None:
    """Find the least change of one size that changes the symbol of an object.

    Args:
        features: What the object is.
        library: The domain, whose world says which sizes there are.

    Returns:
        Which feature, counted from 0, and what the object is then; None if no size alone does it.
    """
    limits = library.limits
    rows, changed = [], []
    for axis, (low, high) in enumerate(limits.sizes if limits else ()):
        for value in np.arange(round(1000 * low), round(1000 * high) + 1) / 1000:
            row = np.array(features, dtype=float)
            row[axis] = value
            rows.append(row)
            changed.append((axis, abs(float(value) - features[axis])))
    if not rows:
        return None
    here, *symbols = library.categorise(np.array([features, *rows], dtype=float))
    flips = [(apart, number) for number, (_, apart) in enumerate(changed) if symbols[number] != here]
    if not flips:
        return None
    _, number = min(flips)
    return changed[number][0], tuple(rows[number].tolist())
