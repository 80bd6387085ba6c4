"""Motions that are known to carry an object to a place, to be tried with other objects as references.

They are a start for exploring what can be done with pairs: how to grasp need not be found out once more. A
place is a reference without size, so that what ends there ends on or in an object instead.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from neurosym.actions import ActionBox
from neurosym.arrays import Float
from neurosym.place_operators import PlaceOperators
from neurosym.symbols import Categorise, Symbol, symbols_of

JITTER = 0.003
"""Standard deviation by which their lengths are changed [m]."""
TO_THE_MIDDLE = 0.5
"""Share of the motions that end where the reference is; the others end at random."""
_LAST = 4  # parameters of the last waypoint, which is relative to the reference


@dataclass(frozen=True)
class KnownMotions:
    """Draws motions that carry objects of a target's category, to the reference or with a random end.

    Attributes:
        places: What carries objects to places.
        categorise: Gives the object symbols of features.
        box: What actions must stay inside.
    """

    places: PlaceOperators
    categorise: Categorise
    box: ActionBox

    @cached_property
    def _of_category(self) -> dict[Symbol, Float[np.ndarray, "P A"]]:
        table, found = self.places.operators, dict[Symbol, list[Float[np.ndarray, "A"]]]()
        actions = {one.label: one.action for one in table.primitives}
        for one in table.operators:
            if one.promise and one.promise.kind == "carried" and 2 * one.successes > one.trials:
                to_the_middle = np.array(actions[one.label])
                to_the_middle[-_LAST:][:2] -= one.promise.resting_effect[:2]
                found.setdefault(one.category, []).append(to_the_middle)
        return {category: np.array(rows) for category, rows in found.items()}

    def __call__(
        self, rng: np.random.Generator, features: Float[np.ndarray, "F"], count: int
    ) -> Float[np.ndarray, "_ A"]:
        """Draw motions; none if nothing is known to carry such an object.

        Args:
            rng: Source of randomness, owned by the caller.
            features: Features of the target.
            count: How many.
        """
        (category,) = symbols_of(self.categorise, features[None])
        known = self._of_category.get(category)
        drawn = self.box.sample(rng, count)
        if known is None:
            return drawn[:0]
        motions = known[rng.integers(len(known), size=count)]
        motions += rng.normal(0.0, JITTER, motions.shape) * ~self.box.gripper
        elsewhere = rng.random(count) >= TO_THE_MIDDLE
        motions[elsewhere, -_LAST:] = drawn[elsewhere, -_LAST:]
        inside: np.ndarray = np.clip(motions, self.box.low, self.box.high)
        return inside
