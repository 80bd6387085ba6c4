"""Printing a learned domain as PDDL: two encodings on a grid here, the numeric one in its own module.

`operators` has one action for each primitive and category; it reads best. Its ground actions multiply over
the axes, so fine grids take planners long to ground. `stepwise` moves one axis at a time: the named action
moves the first axis and takes the `(ready)` lock, `finish-...` actions move the others, and the last gives
the lock back. Its ground actions add up over the axes, so it stays small on fine grids. One problem file
serves both, and both are positive STRIPS with types and action costs. Equal groundings give equal bytes.
Where operators promise something of its own to each object, `stepwise` reads that from the problem; three
actions then move all objects (see `leading` and `own_steps`). `operators` says what they do on average.
"""

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl import leading, own_steps, place_domain
from neurosym.pddl.grid import AXES, grid_of
from neurosym.pddl.moves import (
    BY_RELATIONS,
    ENCODINGS,
    LED,
    PLACES,
    REACH_GOAL,
    Encoding,
    parts_of,
    shift_predicate,
    shifts_of,
)
from neurosym.pddl.numeric import numeric_domain_text
from neurosym.pddl.printing import (
    about_move,
    action_text,
    comment,
    hand_after,
    hand_before,
    header,
    held_predicates,
    left_out,
    millimetres,
    opening,
)
from neurosym.pddl.relational_domain import relational_domain_text
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.moves import Move, moves_of

Parts = tuple[tuple[str, tuple[int, ...]], ...]

_ABOUT = {
    "stepwise": "One action moves one axis: the named action the first, finish-... the others.",
    "operators": "One action moves all axes.",
}
_ABOUT_OWN = {
    "stepwise": "The named action begins a move, and move-z, move-x and move-y make it. By which steps, and "
    "what it costs, stands in the problem.",
    "places": "Objects that can be carried stand at places and are carried to others; the others are led "
    "over cells: the named action begins a move, and move-z, move-x and move-y make it.",
    "operators": "One action moves all axes. Steps and costs are those of the average object; what each does "
    "stands in the problem, and a replay must tell if plans come true.",
}


def domain_text(grounding: Grounding, encoding: Encoding = "stepwise") -> str:
    """Print the domain.

    Args:
        grounding: The learned domain.
        encoding: `stepwise` for planners on fine grids, `operators` for people and for coarse grids,
            `numeric` for planners that take numbers, `places` where objects are carried to places,
            `relational` or `relational-lifted` where they are put on and into one another.

    Raises:
        UnknownChoice: If there is no such encoding.
        InvalidValue: If it is `places`, and nothing in the domain carries objects, or one of relations, and
            nothing puts them in any.
    """
    if encoding in BY_RELATIONS:
        return relational_domain_text(grounding, encoding)
    if encoding not in (*ENCODINGS, PLACES):
        raise UnknownChoice("encoding", encoding, ENCODINGS)
    if encoding == PLACES and not (grounding.is_refined and carriers_of(grounding)):
        raise InvalidValue(f"Nothing in the domain {grounding.name} carries objects to places.")
    if encoding == "numeric":
        return numeric_domain_text(grounding)
    moves = moves_of(grounding)
    blocks = [
        _header(grounding, encoding),
        opening(grounding, encoding, ":strips :typing :action-costs"),
        *_types(grounding, encoding),
        _predicates(grounding, moves, encoding),
        _functions(grounding, moves, encoding),
        *(place_domain.actions(grounding) if encoding == PLACES else []),
        *(_action_block(move, grounding, encoding) for move in moves),
        *([leading.carriers()] if grounding.is_refined and encoding in LED else []),
        _reach_goal(),
        left_out(grounding),
    ]
    return "\n\n".join(blocks) + ")\n"


def _header(grounding: Grounding, encoding: Encoding) -> str:
    grid = grid_of(grounding)
    leads = "(x-leads x-plus-3 ?from ?to)" if grounding.is_refined else "(x-plus-3 ?from ?to)"
    about = [
        (_ABOUT_OWN if grounding.is_refined else _ABOUT)[encoding],
        f"Cells of {millimetres(grounding.cell)} mm: {grid.last[0] + 1} along x, {grid.last[1] + 1} along y, "
        f"{grid.last[2] + 1} along z (counted from where an object rests).",
        f"{leads}: ?to is 3 cells further along x than ?from, and on the table.",
    ]
    return header(grounding, encoding, about)


def _types(grounding: Grounding, encoding: Encoding) -> list[str]:
    """Print the types, and the constants of one of them where there are such."""
    names = " ".join(sorted(category.name for category in grounding.operators.categories))
    if not grounding.is_refined:
        return [f"  (:types\n    movable x-cell y-cell z-cell - object\n    {names} - movable)"]
    steps = "x-step y-step z-step move" + " place" * (encoding == PLACES)
    types = f"  (:types\n    movable x-cell y-cell z-cell {steps} - object\n    {names} - movable)"
    named = own_steps.constants(grounding)
    named += place_domain.constants(grounding) if encoding == PLACES else []
    return [types, "\n".join(["  (:constants", *named]) + ")"]


def _predicates(grounding: Grounding, moves: tuple[Move, ...], encoding: Encoding) -> str:
    lines = ["(hand-empty)", "(ready)"]
    lines += [f"(at-{axis} ?o - movable ?c - {axis}-cell)" for axis in AXES]
    lines += ["(goal-xy ?o - movable ?x - x-cell ?y - y-cell)", "(goal-z ?o - movable ?z - z-cell)"]
    lines += ["(done ?o - movable)"]
    if grounding.is_refined:
        lines += leading.predicates() if encoding in LED else held_predicates(moves)
        lines += own_steps.predicates()
        lines += place_domain.predicates() if encoding == PLACES else []
    else:
        lines += held_predicates(moves)
        if encoding == "stepwise":
            lines += [
                f"(moving-{m.name}-{AXES[axis]} ?o - {m.category})" for m in moves for axis in m.axes[1:]
            ]
        lines += [
            f"({shift_predicate(axis, cells)} ?from ?to - {AXES[axis]}-cell)"
            for axis, cells in shifts_of(grounding)
        ]
    return "  (:predicates\n" + "\n".join(f"    {line}" for line in lines) + ")"


def _functions(grounding: Grounding, moves: tuple[Move, ...], encoding: Encoding) -> str:
    if not grounding.is_refined:
        return "  (:functions (total-cost) - number)"
    lines = ["(total-cost) - number", *own_steps.functions(moves)]
    lines += place_domain.functions(grounding) if encoding == PLACES else []
    return "  (:functions\n" + "\n".join(f"    {line}" for line in lines) + ")"


def _action_block(move: Move, grounding: Grounding, encoding: Encoding) -> str:
    if grounding.is_refined and encoding in LED:
        actions = [leading.beginning(move)]
    else:
        parts = parts_of(move, encoding)
        actions = [_part(move, number, parts, grounding) for number in range(len(parts))]
    return "\n".join([about_move(move, grounding), *actions])


def _part(move: Move, number: int, parts: Parts, grounding: Grounding) -> str:
    """Print the action for one of the parts of a move."""
    name, axes = parts[number]
    before, after = _locks(move, number, parts)
    if number == 0:
        needed, gone = hand_before(move)
        before, after = before + needed, [*after, *gone, "(not (done ?o))"]
    if number == len(parts) - 1:
        after += hand_after(move)
    parameters = f"?o - {move.category}"
    for axis in axes:
        letter = AXES[axis]
        found, asked = (own_steps.steps_along if grounding.is_refined else _shift_along)(move, axis)
        parameters += found
        before += [f"(at-{letter} ?o ?{letter})", *asked]
        after += [f"(not (at-{letter} ?o ?{letter}))", f"(at-{letter} ?o ?to-{letter})"]
    after += [f"(increase (total-cost) {move.cost if number == 0 else 0})"]
    return action_text(name, parameters, before, after)


def _shift_along(move: Move, axis: int) -> tuple[str, list[str]]:
    """Return the parameters by which an action moves any object along an axis, and what must hold of them."""
    letter, shift = AXES[axis], shift_predicate(axis, move.cells[axis])
    return f" ?{letter} ?to-{letter} - {letter}-cell", [f"({shift} ?{letter} ?to-{letter})"]


def _locks(move: Move, number: int, parts: Parts) -> tuple[list[str], list[str]]:
    """Say which lock a part of a move takes, and which it leaves: `(ready)` at either end of the move."""
    locks = [f"(moving-{move.name}-{AXES[axes[0]]} ?o)" for _, axes in parts[1:]]
    locks = ["(ready)", *locks, "(ready)"]
    taken, left = locks[number], locks[number + 1]
    return [taken], [] if taken == left else [f"(not {taken})", left]


def _reach_goal() -> str:
    at_goal = "(at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z)"
    parameters = "?o - movable ?x - x-cell ?y - y-cell ?z - z-cell"
    effects = ["(done ?o)", "(increase (total-cost) 0)"]
    about = comment(["Note that an object is within its goal region."], "  ")
    return about + "\n" + action_text(REACH_GOAL, parameters, ["(ready)", at_goal], effects)
