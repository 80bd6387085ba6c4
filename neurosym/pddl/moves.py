"""What PDDL actions do: every live operator as a displacement in cells, and the names of its parts."""

import math
from dataclasses import dataclass
from typing import Literal

from neurosym.grounding import Cells, Grounding, is_lift
from neurosym.operators import Operator
from neurosym.pddl.grid import AXES

Encoding = Literal["sas", "stepwise", "operators", "numeric"]
ENCODINGS: tuple[Encoding, ...] = ("stepwise", "operators", "numeric")

SAS: Encoding = "sas"
"""No PDDL, but what Fast Downward makes of `stepwise` before it searches."""

PUT_DOWN = "put-down-"
"""What the name of an operator is preceded by where the object it lifted is put down again."""
FINISH = "finish-"
"""What the names of the parts of a move after its first are preceded by."""
REACH_GOAL = "reach-goal"
"""The action, free of cost, that notes that an object is where its goal is."""


@dataclass(frozen=True, slots=True)
class Move:
    """One primitive on one category, or putting down what it lifted.

    Attributes:
        name: Name of the PDDL action.
        category: PDDL type of the object.
        cells: Displacement of the object.
        cost: What the step costs.
        kind: Whether the hand is empty before and after ("rest"), holds the object after ("lift"), or
            held it before ("put-down").
        operator: The operator it comes from.
    """

    name: str
    category: str
    cells: Cells
    cost: int
    kind: Literal["rest", "lift", "put-down"]
    operator: Operator

    @property
    def axes(self) -> tuple[int, ...]:
        """The axes that the object moves along."""
        return tuple(axis for axis in range(3) if self.cells[axis])


def moves_of(grounding: Grounding) -> tuple[Move, ...]:
    """List what the live operators do, by name, each lift followed by its put-down."""
    moves: list[Move] = []
    for operator in grounding.live:
        category = grounding.category(operator.category).name
        kind: Literal["rest", "lift"] = "lift" if is_lift(operator) else "rest"
        cells = grounding.cells(operator)
        moves.append(Move(operator.name, category, cells, step_cost(operator, grounding), kind, operator))
        if kind == "lift":
            back = grounding.put_down_cells(operator)
            moves.append(Move(PUT_DOWN + operator.name, category, back, 0, "put-down", operator))
    return tuple(moves)


def parts_of(move: Move, encoding: Encoding) -> tuple[tuple[str, tuple[int, ...]], ...]:
    """List the PDDL actions that a move consists of, with its name and the axes of which it names cells."""
    if encoding == "numeric":
        return ((move.name, ()),)
    if encoding == "operators" or len(move.axes) < 2:
        return ((move.name, move.axes),)
    others = ((f"{FINISH}{move.name}-{AXES[axis]}", (axis,)) for axis in move.axes[1:])
    return ((move.name, move.axes[:1]), *others)


def chance(operator: Operator) -> float:
    """Return the chance that a step goes as promised: (k + 1) / (n + 2), k successes in n rehearsals."""
    return (operator.successes + 1) / (operator.trials + 2)


def cost(operator: Operator) -> int:
    """Return what a step costs: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals."""
    return 1 + round(-100 * math.log(chance(operator)))


def step_cost(operator: Operator, grounding: Grounding) -> int:
    """Return what a step costs in a domain: as much as any other if the domain has unit costs."""
    return 1 if grounding.unit_costs else cost(operator)


def shift_predicate(axis: int, cells: int) -> str:
    """Name the static predicate of a displacement along an axis, like `x-minus-7`."""
    return f"{AXES[axis]}-{'plus' if cells > 0 else 'minus'}-{abs(cells)}"


def shifts_of(grounding: Grounding) -> tuple[tuple[int, int], ...]:
    """List the pairs (axis, cells) that the moves need, in order."""
    return tuple(sorted({(axis, move.cells[axis]) for move in moves_of(grounding) for axis in move.axes}))
