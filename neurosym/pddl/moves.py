"""What PDDL actions do: every live operator as a displacement in cells, and the names of its parts."""

from typing import Literal

from neurosym.grounding import Grounding
from neurosym.pddl.grid import AXES
from neurosym.tasks.moves import Move, moves_of

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


def domain_name(grounding: Grounding, encoding: str) -> str:
    """Name the domain in an encoding, like `tabletop-numeric`; encodings that share problems share a name.

    Args:
        grounding: The learned domain.
        encoding: The encoding, or `durative`.
    """
    return grounding.name if encoding in ON_GRID else f"{grounding.name}-{encoding}"


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
