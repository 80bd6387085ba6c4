"""Printing a learned domain as PDDL: two encodings on a grid here, the numeric one in its own module.

`operators` has one action for each primitive and category; it reads best. Its ground actions multiply over
the axes, so fine grids take planners long to ground. `stepwise` moves one axis at a time: the named action
moves the first axis and takes the `(ready)` lock, `finish-...` actions move the others, and the last gives
the lock back. Its ground actions add up over the axes, so it stays small on fine grids. One problem file
serves both, and both are positive STRIPS with types and action costs. Equal groundings give equal bytes.
"""

from neurosym.errors import UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl.grid import AXES, grid_of
from neurosym.pddl.moves import (
    ENCODINGS,
    REACH_GOAL,
    Encoding,
    Move,
    moves_of,
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
)

Parts = tuple[tuple[str, tuple[int, ...]], ...]

_ABOUT = {
    "stepwise": "One action moves one axis: the named action the first, finish-... the others.",
    "operators": "One action moves all axes.",
}


def domain_text(grounding: Grounding, encoding: Encoding = "stepwise") -> str:
    """Print the domain.

    Args:
        grounding: The learned domain.
        encoding: `stepwise` for planners on fine grids, `operators` for people and for coarse grids,
            `numeric` for planners that take numbers.

    Raises:
        UnknownChoice: If there is no such encoding.
    """
    if encoding not in ENCODINGS:
        raise UnknownChoice("encoding", encoding, ENCODINGS)
    if encoding == "numeric":
        return numeric_domain_text(grounding)
    moves = moves_of(grounding)
    blocks = [
        _header(grounding, encoding),
        f"(define (domain {grounding.name})\n  (:requirements :strips :typing :action-costs)",
        _types(grounding),
        _predicates(grounding, moves, encoding),
        "  (:functions (total-cost) - number)",
        *(_action_block(move, grounding, encoding) for move in moves),
        _reach_goal(),
        left_out(grounding),
    ]
    return "\n\n".join(blocks) + ")\n"


def _header(grounding: Grounding, encoding: Encoding) -> str:
    grid = grid_of(grounding)
    about = [
        _ABOUT[encoding],
        f"Cells of {millimetres(grounding.cell)} mm: {grid.last[0] + 1} along x, {grid.last[1] + 1} along y, "
        f"{grid.last[2] + 1} along z (counted from where an object rests).",
        "(x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.",
    ]
    return header(grounding, encoding, about)


def _types(grounding: Grounding) -> str:
    names = sorted(category.name for category in grounding.operators.categories)
    return f"  (:types\n    movable x-cell y-cell z-cell - object\n    {' '.join(names)} - movable)"


def _predicates(grounding: Grounding, moves: tuple[Move, ...], encoding: Encoding) -> str:
    lines = ["(hand-empty)", "(ready)"]
    lines += [f"(at-{axis} ?o - movable ?c - {axis}-cell)" for axis in AXES]
    lines += ["(goal-xy ?o - movable ?x - x-cell ?y - y-cell)", "(goal-z ?o - movable ?z - z-cell)"]
    lines += ["(done ?o - movable)"]
    lines += held_predicates(moves)
    if encoding == "stepwise":
        lines += [f"(moving-{m.name}-{AXES[axis]} ?o - {m.category})" for m in moves for axis in m.axes[1:]]
    for axis, cells in shifts_of(grounding):
        lines.append(f"({shift_predicate(axis, cells)} ?from ?to - {AXES[axis]}-cell)")
    return "  (:predicates\n" + "\n".join(f"    {line}" for line in lines) + ")"


def _action_block(move: Move, grounding: Grounding, encoding: Encoding) -> str:
    parts = parts_of(move, encoding)
    return "\n".join([about_move(move, grounding), *(_part(move, n, parts) for n in range(len(parts)))])


def _part(move: Move, number: int, parts: Parts) -> str:
    """Print the action for one of the parts of a move."""
    name, axes = parts[number]
    before, after = _locks(move, number, parts)
    if number == 0:
        needed, gone = hand_before(move)
        before, after = before + needed, [*after, *gone, "(not (done ?o))"]
    if number == len(parts) - 1:
        after += hand_after(move)
    for axis in axes:
        letter, shift = AXES[axis], shift_predicate(axis, move.cells[axis])
        before += [f"(at-{letter} ?o ?{letter})", f"({shift} ?{letter} ?to-{letter})"]
        after += [f"(not (at-{letter} ?o ?{letter}))", f"(at-{letter} ?o ?to-{letter})"]
    after += [f"(increase (total-cost) {move.cost if number == 0 else 0})"]
    parameters = "".join(f" ?{AXES[axis]} ?to-{AXES[axis]} - {AXES[axis]}-cell" for axis in axes)
    return action_text(name, f"?o - {move.category}{parameters}", before, after)


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
