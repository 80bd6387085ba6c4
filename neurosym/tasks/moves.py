"""What is done to an object by itself: every live operator as a displacement, and what it costs."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from neurosym.cells import Cells
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE, Operator
from neurosym.problems import SceneObject
from neurosym.promises import usable

PUT_DOWN = "put-down-"
"""What the name of an operator is preceded by where the object it lifted is put down again."""


@dataclass(frozen=True, slots=True)
class Move:
    """One primitive on one category, or putting down what it lifted.

    Attributes:
        name: Name of the PDDL action.
        cells: Displacement of the object.
        cost: What the step costs.
        kind: Whether the hand is empty before and after ("rest"), holds the object after ("lift"), or
            held it before ("put-down").
        operator: The operator it comes from.
    """

    name: str
    cells: Cells
    cost: int
    kind: Literal["rest", "lift", "put-down"]
    operator: Operator

    @property
    def axes(self) -> tuple[int, ...]:
        """The axes that the object moves along."""
        return tuple(axis for axis in range(3) if self.cells[axis])


def moves_for(item: SceneObject, grounding: Grounding, tolerance: float = TOLERANCE) -> tuple[Move, ...]:
    """List what the operators of a domain promise for an object, by name, each lift followed by its put-down.

    Args:
        item: The object.
        grounding: The learned domain.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
    ordered = sorted(usable(grounding, item, tolerance), key=lambda operator: operator.name)
    return as_moves(ordered, grounding)


def as_moves(operators: Iterable[Operator], grounding: Grounding) -> tuple[Move, ...]:
    """Return what operators promise as moves, in cells of a grounding, each lift followed by its put-down."""
    moves: list[Move] = []
    for operator in operators:
        kind: Literal["rest", "lift"] = "lift" if is_lift(operator) else "rest"
        cells = grounding.cells(operator)
        moves.append(Move(operator.name, cells, step_cost(operator, grounding), kind, operator))
        if kind == "lift":
            back = grounding.put_down_cells(operator)
            moves.append(Move(PUT_DOWN + operator.name, back, 0, "put-down", operator))
    return tuple(moves)


def smoothed(kept: int, trials: int) -> float:
    """Return a chance from what was seen: (k + 1) / (n + 2), the rule of succession."""
    return (kept + 1) / (trials + 2)


def chance(operator: Operator) -> float:
    """Return the chance that a step goes as promised, from its rehearsals."""
    return smoothed(operator.successes, operator.trials)


def price(chance: float) -> int:
    """Return what goes as promised with a chance costs: 1 + round(-100 ln(chance))."""
    return 1 + round(-100 * math.log(chance))


def cost(operator: Operator) -> int:
    """Return what a step costs by its rehearsals."""
    return price(chance(operator))


def step_cost(operator: Operator, grounding: Grounding) -> int:
    """Return what a step costs in a domain: as much as any other if the domain has unit costs."""
    return 1 if grounding.unit_costs else cost(operator)
