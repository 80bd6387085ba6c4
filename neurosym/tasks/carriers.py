"""What carries objects to places, and how that turns out where objects rest on one another."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.place_operators import Kept
from neurosym.problems import SceneObject
from neurosym.promises import LEAST_CHANCE, promised
from neurosym.tasks.moves import chance, smoothed, step_cost
from neurosym.tasks.puts import LEAST_SHARE

_UNTRIED = Kept("never", 0, 0)
_NEVER = 0.01  # as how rare counts what was never seen


@lru_cache(maxsize=8)
def carriers_of(grounding: Grounding) -> tuple[Operator, ...]:
    """List the operators of the domain that carry objects to places, by name.

    Args:
        grounding: The learned domain.
    """
    if grounding.places is None:
        return ()
    every = grounding.places.operators.operators
    worthy = (one for one in every if grounding.why_left_out(one) is None)
    return tuple(sorted(worthy, key=lambda one: one.name))


def carriers_for(item: SceneObject, grounding: Grounding, tolerance: float) -> tuple[Operator, ...]:
    """List the operators that carry an object to places, as they promise for it, the surest first.

    How sure they are counts what rehearsals beside others showed, since a scene may hold others.

    Args:
        item: The object.
        grounding: The learned domain.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
    of_item = promised(grounding, item, tolerance)
    found = [of_item[one.name] for one in carriers_of(grounding) if one.category == item.category]
    fit = [one for one in found if one.successes >= LEAST_CHANCE * one.trials and one.successes]
    beside = {one.name: one.share for one in grounding.places.beside} if grounding.places else {}
    costs = {one.name: step_cost(one, grounding) / (beside.get(one.name, 1.0) or _NEVER) for one in fit}
    return tuple(sorted(fit, key=lambda one: (costs[one.name], one.name)))


@dataclass(frozen=True, slots=True)
class Carrier:
    """What was seen of stacks with an operator that carries objects to places.

    Attributes:
        borne: How it turned out where the object rested on another one.
        laden: How it turned out where another one rested on the object.
    """

    borne: Kept
    laden: Kept

    @property
    def takes_borne(self) -> bool:
        """Whether the object may rest on another one; where that was never tried it may."""
        return self.borne.share >= LEAST_SHARE

    @property
    def takes_laden(self) -> bool:
        """Whether another object may rest on it; where that was never tried it may not."""
        return bool(self.laden.trials) and self.laden.share >= LEAST_SHARE

    def cost(self, operator: Operator, grounding: Grounding, *, borne: bool) -> int:
        """Return what a step costs.

        Args:
            operator: The operator as it promises for the object.
            grounding: The learned domain.
            borne: Whether the object rests on another one.
        """
        usual = step_cost(operator, grounding)
        if not (borne and self.borne.trials) or grounding.unit_costs:
            return usual
        kept = smoothed(self.borne.kept, self.borne.trials)
        return usual + round(max(0.0, -100 * math.log(kept / chance(operator))))


def relational_carriers(grounding: Grounding) -> Mapping[str, Carrier]:
    """Return what was seen of stacks with the operators that carry objects to places, by name."""
    if (places := grounding.places) is None:
        return {}
    borne, laden = ({one.name: one for one in table or ()} for table in (places.borne, places.laden))
    return {
        one.name: Carrier(borne.get(one.name, _UNTRIED), laden.get(one.name, _UNTRIED))
        for one in carriers_of(grounding)
    }
