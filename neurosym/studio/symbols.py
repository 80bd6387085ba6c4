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
from neurosym.tasks.moves import chance

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
    """

    operator: Operator
    effect: Vector
    lifts: bool
    chance: float


def promises_for(item: SceneObject, library: Library) -> tuple[Promise, ...]:
    """List what the operators of the domain do to an object, the surest first."""
    grounding = library.grounding
    found = [
        Promise(one, one.promise.outcome, is_lift(one), chance(one))
        for one in usable(grounding, item)
        if one.promise is not None and len(one.promise.outcome) == 3
    ]
    return tuple(sorted(found, key=lambda one: (-one.chance, one.operator.name)))


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
