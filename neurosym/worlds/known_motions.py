"""Motions that are known to carry an object to a place, to be tried with other objects as references.

They are a start for exploring what can be done with pairs: how to grasp need not be found out once more.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Float

from neurosym.actions import ActionBox
from neurosym.place_operators import PlaceOperators
from neurosym.symbols import Categorise, Symbol, symbols_of

JITTER = 0.003
"""Standard deviation by which their lengths are changed [m]."""
_LAST = 4  # parameters of the last waypoint, which is relative to the reference


@dataclass(frozen=True)
class KnownMotions:
    """Draws motions that carry objects of a target's category, the last waypoint at random.

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
        table, found = self.places.operators, dict[Symbol, list[tuple[float, ...]]]()
        actions = {one.label: one.action for one in table.primitives}
        for one in table.operators:
            if one.promise and one.promise.kind == "carried" and 2 * one.successes > one.trials:
                found.setdefault(one.category, []).append(actions[one.label])
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
        first = known[rng.integers(len(known), size=count), :-_LAST]
        length = ~self.box.gripper[:-_LAST]
        drawn[:, :-_LAST] = first + rng.normal(0.0, JITTER, first.shape) * length
        inside: np.ndarray = np.clip(drawn, self.box.low, self.box.high)
        return inside
