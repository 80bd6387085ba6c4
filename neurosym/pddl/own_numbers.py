"""What differs by object, in numbers: functions that say by how much an operator moves which object.

The domain stays the same for all, and a problem gives the functions their values. PDDL of most readers has no
negative numbers, so a value is the displacement and a shift, which the domain takes off again. Positions are
assigned, not increased, for LPG takes it that what is increased becomes more.
"""

from collections.abc import Iterable, Iterator

from neurosym.grounding import Grounding
from neurosym.pddl.grid import AXES
from neurosym.pddl.moves import cost_name, own_name
from neurosym.pddl.own_steps import about, has_cost, left_alone, reasons
from neurosym.problems import SceneObject
from neurosym.promises import promised, usable
from neurosym.tasks.moves import Move, as_moves, step_cost

_LEAST_SHIFT = 10_000


def shift_of(grounding: Grounding) -> int:
    """Return what is added to all displacements: a power of ten, and more than any that was seen.

    Args:
        grounding: The learned domain, its cells the unit that is counted in.
    """
    farthest = 0.0
    for operator in grounding.live:
        seen = [(one.effect, one.resting_effect) for one in operator.rehearsals]
        seen += [(one.effect, one.resting_effect) for one in operator.modes]
        farthest = max([farthest, *(abs(part) for effects in seen for effect in effects for part in effect)])
    shift = _LEAST_SHIFT
    while shift <= 2 * farthest / grounding.cell:  # putting down can take back what a lift did
        shift *= 10
    return shift


def predicates(moves: Iterable[Move]) -> list[str]:
    """List the predicates that say for which objects a move is."""
    return [f"({_can(move)} ?o - {move.category})" for move in moves if has_cost(move)]


def functions(moves: Iterable[Move]) -> list[str]:
    """List the functions that say by how much a move leads an object, and what that costs."""
    lines = []
    for move in moves:
        names = [*(own_name(move, axis) for axis in move.all_axes), *_cost_names(move)]
        lines += [f"({name} ?o - {move.category}) - number" for name in names]
    return lines


def asked(move: Move, margin: int, last: tuple[int, int], shift: int) -> list[str]:
    """List what must hold for a move: that it is for the object, and does not lead off the table.

    Args:
        move: The move.
        margin: The least x and y that a step may end at.
        last: The greatest.
        shift: What is added to displacements.
    """
    bounds = []
    for axis in (0, 1):
        end = f"(+ ({AXES[axis]} ?o) ({own_name(move, axis)} ?o))"
        bounds += [f"(>= {end} {margin + shift})", f"(<= {end} {last[axis] + shift})"]
    return [*([f"({_can(move)} ?o)"] if has_cost(move) else []), *bounds]


def changes(move: Move, shift: int) -> list[str]:
    """List what a move changes: where the object is, and the cost."""
    moved = [
        f"(assign ({AXES[axis]} ?o) (- (+ ({AXES[axis]} ?o) ({own_name(move, axis)} ?o)) {shift}))"
        for axis in move.all_axes
    ]
    cost = f"({cost_name(move)} ?o)" if has_cost(move) else "0"
    return [*moved, f"(increase (total-cost) {cost})"]


def values_of(item: SceneObject, grounding: Grounding, units: Grounding, tolerance: float) -> Iterator[str]:
    """List what operators promise for an object, a line for each of its moves; every function has a value.

    Args:
        item: The object.
        grounding: The learned domain.
        units: The same, its cells the unit that is counted in.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
    names = {operator.name for operator in usable(grounding, item, tolerance)}
    operators, shift = promised(grounding, item, tolerance), shift_of(units)
    live = [operators[one.name] for one in grounding.live if one.category == item.category]
    yield from about(item, grounding)
    yield from reasons(left_alone(item, grounding, names), f"Not for {item.name}:")
    for move in as_moves(live, units):
        values = [(own_name(move, axis), move.cells[axis] + shift) for axis in move.all_axes]
        values += [(name, step_cost(move.operator, grounding)) for name in _cost_names(move)]
        is_for_it = has_cost(move) and move.name in names
        can = [f"({_can(move)} {item.name})"] if is_for_it else []
        yield " ".join([*can, *(f"(= ({name} {item.name}) {value})" for name, value in values)])


def _can(move: Move) -> str:
    return f"can-{move.name}"


def _cost_names(move: Move) -> list[str]:
    return [cost_name(move)] if has_cost(move) else []
