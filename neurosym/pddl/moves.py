"""What PDDL actions do: every live operator as a displacement in cells, and the names of its parts."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from neurosym.cells import Cells
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE, Operator
from neurosym.pddl.grid import AXES
from neurosym.problems import SceneObject
from neurosym.promises import usable

Encoding = Literal["sas", "stepwise", "operators", "numeric", "places", "relational", "relational-lifted"]
ENCODINGS: tuple[Encoding, ...] = ("stepwise", "operators", "numeric")

NUMERIC: Encoding = "numeric"
"""Positions are numbers, and no cells."""
PLACES: Encoding = "places"
"""Objects that can be carried stand at places; the others are led over cells as in `stepwise`."""
RELATIONAL: Encoding = "relational"
"""Objects stand at places or are borne by one another; what bears how many is counted."""
LIFTED: Encoding = "relational-lifted"
"""The same with `not` and `exists` in the place of counting, for planners that take these."""
BY_RELATIONS = (RELATIONAL, LIFTED)
DURATIVE = "durative"
"""Objects are carried by actions that take time; no command plans in it."""
LED: tuple[Encoding, ...] = ("stepwise", PLACES)
"""Encodings that lead objects over cells, one axis at a time."""
SAS: Encoding = "sas"
"""No PDDL, but what Fast Downward makes of `stepwise` before it searches."""
ON_GRID: tuple[Encoding, ...] = (SAS, "stepwise", "operators")
"""Encodings that share the text of a problem, and so the name of the domain."""

PUT_DOWN = "put-down-"
"""What the name of an operator is preceded by where the object it lifted is put down again."""
FINISH = "finish-"
"""What the names of the parts of a move after its first are preceded by."""
MOVE = "a-"
"""What the name of a move is preceded by where it is a constant of PDDL."""
CARRIED = (2, 0, 1)
"""The axes in the order in which objects with steps of their own are led along them."""
CARRIERS = frozenset(f"move-{axis}" for axis in AXES)
"""The actions that lead objects with steps of their own along an axis."""
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

    @property
    def all_axes(self) -> tuple[int, ...]:
        """The axes that some object may move along: what is not lifted stays at its height."""
        return (0, 1) if self.kind == "rest" else (0, 1, 2)


def domain_name(grounding: Grounding, encoding: str) -> str:
    """Name the domain in an encoding, like `tabletop-numeric`; encodings that share problems share a name.

    Args:
        grounding: The learned domain.
        encoding: The encoding, or `durative`.
    """
    return grounding.name if encoding in ON_GRID else f"{grounding.name}-{encoding}"


def moves_of(grounding: Grounding) -> tuple[Move, ...]:
    """List what the live operators do on average, by name, each lift followed by its put-down."""
    return as_moves(grounding.live, grounding)


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
    """Return what operators promise as moves, each lift followed by its put-down.

    Args:
        operators: The operators.
        grounding: What they are counted in, in its cells.
    """
    moves: list[Move] = []
    for operator in operators:
        category = grounding.category(operator.category).name
        kind: Literal["rest", "lift"] = "lift" if is_lift(operator) else "rest"
        cells = grounding.cells(operator)
        moves.append(Move(operator.name, category, cells, step_cost(operator, grounding), kind, operator))
        if kind == "lift":
            back = grounding.put_down_cells(operator)
            moves.append(Move(PUT_DOWN + operator.name, category, back, 0, "put-down", operator))
    return tuple(moves)


def parts_of(
    move: Move, encoding: Encoding, *, has_own: bool = False
) -> tuple[tuple[str, tuple[int, ...]], ...]:
    """List the PDDL actions that a move consists of, with its name and the axes of which it names cells.

    Args:
        move: The move.
        encoding: The encoding.
        has_own: Whether objects have steps of their own, so that `stepwise` leads them along every axis.
    """
    if encoding == "numeric":
        return ((move.name, ()),)
    if has_own and encoding in LED:
        return ((move.name, ()), *((carrier(axis), (axis,)) for axis in carried(move)))
    axes = move.axes
    if encoding == "operators" or len(axes) < 2:
        return ((move.name, axes),)
    others = ((f"{FINISH}{move.name}-{AXES[axis]}", (axis,)) for axis in axes[1:])
    return ((move.name, axes[:1]), *others)


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


def carried(move: Move) -> tuple[int, ...]:
    """Return the axes along which a move leads objects that have steps of their own, in order."""
    return CARRIED[1:] if move.kind == "rest" else CARRIED


def carrier(axis: int) -> str:
    """Name the action that leads objects with steps of their own along an axis."""
    return f"move-{AXES[axis]}"


def move_constant(move: Move) -> str:
    """Name the constant that stands for a move, like `a-push-left-001-cube`."""
    return f"{MOVE}{move.name}"


def own_name(move: Move, axis: int) -> str:
    """Name the function that says by how much a move leads an object, like `x-of-push-left-001-cube`."""
    return f"{AXES[axis]}-of-{move.name}"


def cost_name(move: Move) -> str:
    """Name the function that says what a move of an object costs."""
    return f"cost-of-{move.name}"


def shifts_of(grounding: Grounding) -> tuple[tuple[int, int], ...]:
    """List the pairs (axis, cells) that the moves need, in order."""
    return tuple(sorted({(axis, move.cells[axis]) for move in moves_of(grounding) for axis in move.axes}))
