"""Printing a learned domain as PDDL, in two encodings that one problem file serves.

`operators` has one action for each primitive and category; it reads best. Its ground actions multiply over
the axes, so fine grids take planners long to ground. `stepwise` moves one axis at a time: the named action
moves the first axis and takes the `(ready)` lock, `finish-...` actions move the others, and the last gives
the lock back. Its ground actions add up over the axes, so it stays small on fine grids.

Both are positive STRIPS with types and action costs, and equal groundings give equal bytes.
"""

import textwrap

from neurosym.errors import UnknownChoice
from neurosym.operators import Effect
from neurosym.pddl.grid import AXES, grid_of
from neurosym.pddl.grounding import Grounding
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

Parts = tuple[tuple[str, tuple[int, ...]], ...]

_ABOUT = {
    "stepwise": "One action moves one axis: the named action the first, finish-... the others.",
    "operators": "One action moves all axes.",
}


def domain_text(grounding: Grounding, encoding: Encoding = "stepwise") -> str:
    """Print the domain.

    Args:
        grounding: The learned domain.
        encoding: `stepwise` for planners on fine grids, `operators` for people and for coarse grids.

    Raises:
        UnknownChoice: If there is no such encoding.
    """
    if encoding not in ENCODINGS:
        raise UnknownChoice("encoding", encoding, ENCODINGS)
    moves = moves_of(grounding)
    blocks = [
        _header(grounding, encoding),
        f"(define (domain {grounding.name})\n  (:requirements :strips :typing :action-costs)",
        _types(grounding),
        _predicates(grounding, moves, encoding),
        "  (:functions (total-cost) - number)",
        *(_action_block(move, grounding, encoding) for move in moves),
        _reach_goal(),
        _left_out(grounding),
    ]
    return "\n\n".join(blocks) + ")\n"


def _header(grounding: Grounding, encoding: Encoding) -> str:
    grid = grid_of(grounding)
    lines = [
        f"Learned domain {grounding.name}, encoding {encoding}. Printed by neurosym; do not edit.",
        _ABOUT[encoding],
        f"Cells of {_mm(grounding.cell)} mm: {grid.last[0] + 1} along x, {grid.last[1] + 1} along y, "
        f"{grid.last[2] + 1} along z (counted from where an object rests).",
        "(x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.",
        "After a lift the hand is full: only the put-down of that lift applies.",
        "Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.",
    ]
    if grounding.operators.measured == "data":
        lines.append("Nothing was rehearsed: by rehearsals, rows of the data are meant.")
    return _comment(lines, "")


def _types(grounding: Grounding) -> str:
    names = sorted(category.name for category in grounding.operators.categories)
    return f"  (:types\n    movable x-cell y-cell z-cell - object\n    {' '.join(names)} - movable)"


def _predicates(grounding: Grounding, moves: tuple[Move, ...], encoding: Encoding) -> str:
    lines = ["(hand-empty)", "(ready)"]
    lines += [f"(at-{axis} ?o - movable ?c - {axis}-cell)" for axis in AXES]
    lines += ["(goal-xy ?o - movable ?x - x-cell ?y - y-cell)", "(goal-z ?o - movable ?z - z-cell)"]
    lines += ["(done ?o - movable)"]
    lines += [f"(held-by-{m.operator.name} ?o - {m.category})" for m in moves if m.kind == "lift"]
    if encoding == "stepwise":
        lines += [f"(moving-{m.name}-{AXES[axis]} ?o - {m.category})" for m in moves for axis in m.axes[1:]]
    for axis, cells in shifts_of(grounding):
        lines.append(f"({shift_predicate(axis, cells)} ?from ?to - {AXES[axis]}-cell)")
    return "  (:predicates\n" + "\n".join(f"    {line}" for line in lines) + ")"


def _action_block(move: Move, grounding: Grounding, encoding: Encoding) -> str:
    about = [f"Put down what {move.operator.name} lifted."]
    if move.kind != "put-down":
        about = _about(move, grounding)
    parts = parts_of(move, encoding)
    return "\n".join([_comment(about, "  "), *(_part(move, number, parts) for number in range(len(parts)))])


def _part(move: Move, number: int, parts: Parts) -> str:
    """Print the action for one of the parts of a move."""
    name, axes = parts[number]
    before, after = _locks(move, number, parts)
    if number == 0:
        needed, gone = _hand_before(move)
        before, after = before + needed, [*after, *gone, "(not (done ?o))"]
    if number == len(parts) - 1:
        after += _hand_after(move)
    for axis in axes:
        letter, shift = AXES[axis], shift_predicate(axis, move.cells[axis])
        before += [f"(at-{letter} ?o ?{letter})", f"({shift} ?{letter} ?to-{letter})"]
        after += [f"(not (at-{letter} ?o ?{letter}))", f"(at-{letter} ?o ?to-{letter})"]
    after += [f"(increase (total-cost) {move.cost if number == 0 else 0})"]
    parameters = "".join(f" ?{AXES[axis]} ?to-{AXES[axis]} - {AXES[axis]}-cell" for axis in axes)
    return _action(name, f"?o - {move.category}{parameters}", before, after)


def _locks(move: Move, number: int, parts: Parts) -> tuple[list[str], list[str]]:
    """Say which lock a part of a move takes, and which it leaves: `(ready)` at either end of the move."""
    locks = [f"(moving-{move.name}-{AXES[axes[0]]} ?o)" for _, axes in parts[1:]]
    locks = ["(ready)", *locks, "(ready)"]
    taken, left = locks[number], locks[number + 1]
    return [taken], [] if taken == left else [f"(not {taken})", left]


def _hand_before(move: Move) -> tuple[list[str], list[str]]:
    """Say what the hand must be like for a move to begin, and what it no longer is from then on."""
    if move.kind == "put-down":
        holding = f"(held-by-{move.operator.name} ?o)"
        return [holding], [f"(not {holding})"]
    return ["(hand-empty)"], ["(not (hand-empty))"] if move.kind == "lift" else []


def _hand_after(move: Move) -> list[str]:
    held = f"(held-by-{move.operator.name} ?o)"
    return {"rest": [], "lift": [held], "put-down": ["(hand-empty)"]}[move.kind]


def _reach_goal() -> str:
    at_goal = "(at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z)"
    parameters = "?o - movable ?x - x-cell ?y - y-cell ?z - z-cell"
    action = _action(REACH_GOAL, parameters, ["(ready)", at_goal], ["(done ?o)", "(increase (total-cost) 0)"])
    return _comment(["Note that an object is within its goal region."], "  ") + "\n" + action


def _action(name: str, parameters: str, before: list[str], after: list[str]) -> str:
    return "\n".join(
        [
            f"  (:action {name}",
            f"    :parameters ({parameters})",
            f"    :precondition (and {' '.join(before)})",
            f"    :effect (and {' '.join(after)}))",
        ]
    )


def _about(move: Move, grounding: Grounding) -> list[str]:
    operator, promise = move.operator, move.operator.promise
    assert promise is not None
    held = move.kind == "lift"
    action = " ".join(f"{value:.4f}" for value in grounding.primitive(operator.primitive).action)
    return [
        f"Primitive {operator.primitive} on category {operator.category} ({move.category}); ends "
        f"{'held' if held else 'at rest'} in {promise.count} of {operator.trials} rehearsals "
        f"({promise.share:.0%}).",
        f"Effect {_vector(promise.outcome)} mm, spread {_vector(promise.scatter)} mm; "
        f"{operator.successes} of {operator.trials} rehearsals as promised: cost {move.cost}.",
        f"Action parameters: {action}",
    ]


def _left_out(grounding: Grounding) -> str:
    lines = [f"{name}: {reason}." for name, reason in grounding.left_out.items()]
    return _comment(["Left out:", *lines] if lines else ["No operator is left out."], "  ") + "\n"


def _comment(lines: list[str], indent: str) -> str:
    wrapped = [part for line in lines for part in textwrap.wrap(line, 106 - len(indent))]
    return "\n".join(f"{indent}; {line}" for line in wrapped)


def _vector(vector: Effect) -> str:
    return "(" + ", ".join(_mm(value) for value in vector) + ")"


def _mm(value: float) -> str:
    return f"{round(value * 1000, 1) + 0.0:g}"
