"""Printing domain and problem in the `numeric` encoding: PDDL 2.1 with numeric fluents, and no grid.

Where an object is, is three whole numbers of 0.1 mm: x and y count from the table's lowest corner, so none is
negative, and z from where the object rests. A step adds its displacement. So the text is small, nothing has
to be grounded cell by cell, and hardly anything is rounded.

An object's goal is a prism inside the ball around it: an interval of z, as on a grid, and for x and y an
octagon in the disc that is left of the ball. All conditions are linear with
whole coefficients. Each step errs by at most half a unit on each axis, so the disc is shrunk by sqrt(1/2)
units a step, and the table by half a unit a step: plans of no more than `STEPS` steps an object are true.
Where operators promise something of its own to each object, the problem says what (see `own_numbers`).
"""

import math
from collections.abc import Iterator
from functools import lru_cache

import msgspec

from neurosym.grounding import Grounding
from neurosym.pddl import own_numbers
from neurosym.pddl.grid import AXES, best_levels, levels
from neurosym.pddl.moves import NUMERIC, domain_name
from neurosym.pddl.printing import (
    about_move,
    action_text,
    hand_after,
    hand_before,
    header,
    held_predicates,
    left_out,
    opening,
)
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.moves import Move, moves_of

UNIT = 0.0001
"""What positions are counted in [m]."""
STEPS = 10
"""How many steps with an object the rounding of is reckoned with."""
_MARGIN = math.ceil((STEPS + 1) / 2)  # what so many steps and the start can err on an axis, in units
_NORMALS = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
_WIDEST = math.pi / 8  # half the widest angle between neighbouring normals
_EPSILON = 1e-6


def numeric_domain_text(grounding: Grounding) -> str:
    """Print the domain.

    Args:
        grounding: The learned domain; its cells do not matter, but for which operators are in the domain.
    """
    moves = _moves(grounding)
    names = sorted(category.name for category in grounding.operators.categories)
    predicates = ["(hand-empty)", *held_predicates(moves)]
    functions = [*(f"({axis} ?o - movable) - number" for axis in AXES), "(total-cost) - number"]
    if grounding.is_refined:
        predicates += own_numbers.predicates(moves)
        functions += own_numbers.functions(moves)
    blocks = [
        _domain_header(grounding),
        opening(grounding, NUMERIC, ":strips :typing :numeric-fluents :action-costs"),
        f"  (:types\n    movable - object\n    {' '.join(names)} - movable)",
        "  (:predicates\n" + "\n".join(f"    {line}" for line in predicates) + ")",
        "  (:functions\n" + "\n".join(f"    {line}" for line in functions) + ")",
        *(f"{about_move(move, grounding)}\n{_action(move, grounding)}" for move in moves),
        left_out(grounding),
    ]
    return "\n\n".join(blocks) + ")\n"


def numeric_problem_text(problem: Problem, grounding: Grounding, *, steps: int = STEPS) -> str:
    """Print a problem whose objects are known to be of the domain and on the table.

    Args:
        problem: The problem.
        grounding: The learned domain.
        steps: How many steps with an object the rounding of is taken off the goal regions.
    """
    things = [f"{item.name} - {grounding.category(item.category).name}" for item in problem.objects]
    sections = [
        f"; Problem {problem.name} of the learned domain {grounding.name}, for its encoding numeric.",
        f"; How it came about: {' '.join(problem.provenance.split())}.",
        f"; A goal is met within {problem.tolerance * 1000:g} mm; what is asked for here lies inside that",
        f"; by as much as {steps} step(s) with an object can err by rounding to 0.1 mm.",
        f"(define (problem {problem.name})\n  (:domain {domain_name(grounding, NUMERIC)})",
        "  (:objects\n" + "\n".join(f"    {line}" for line in things) + ")",
        "  (:init\n    (hand-empty) (= (total-cost) 0)",
        "\n".join(_start(item, grounding, problem.tolerance) for item in problem.objects) + ")",
        "  (:goal (and",
        *(_goal(problem, name, grounding, steps) for name in sorted(problem.goals)),
    ]
    return "\n".join(sections) + "))\n  (:metric minimize (total-cost)))\n"


def _moves(grounding: Grounding) -> tuple[Move, ...]:
    """List what the operators of the domain do, in units."""
    live = {operator.name for operator in grounding.live}
    return tuple(move for move in moves_of(_in_units(grounding)) if move.operator.name in live)


@lru_cache(maxsize=8)
def _in_units(grounding: Grounding) -> Grounding:
    return msgspec.structs.replace(grounding, cell=UNIT)


def _domain_header(grounding: Grounding) -> str:
    x, y = (round(size / UNIT) for size in _size(grounding))
    about = [
        "Positions are whole numbers of 0.1 mm: x and y from the table's lowest corner, z from where an "
        "object rests.",
        f"The table reaches to x = {x}, y = {y}; steps end {_MARGIN} inside its edges, for what "
        f"{STEPS} steps with an object can err by rounding.",
    ]
    if grounding.is_refined:
        shift = own_numbers.shift_of(_in_units(grounding))
        about += [
            f"By how much an operator moves an object stands in the problem, with {shift} added, for no "
            "number may be negative."
        ]
    return header(grounding, "numeric", about)


def _size(grounding: Grounding) -> tuple[float, float]:
    (x_low, x_high), (y_low, y_high) = grounding.table.x, grounding.table.y
    return x_high - x_low, y_high - y_low


def _action(move: Move, grounding: Grounding) -> str:
    before, gone = hand_before(move)
    parameters = f"?o - {move.category}"
    if grounding.is_refined:
        shift = own_numbers.shift_of(_in_units(grounding))
        before += own_numbers.asked(move, _MARGIN, _last(grounding), shift)
        after = [*gone, *hand_after(move), *own_numbers.changes(move, shift)]
        return action_text(move.name, parameters, before, after)
    before = [*before, *_bounds(move, grounding)]
    verbs = ((AXES[axis], move.cells[axis]) for axis in move.axes)
    moved = [f"({'increase' if by > 0 else 'decrease'} ({axis} ?o) {abs(by)})" for axis, by in verbs]
    after = [*gone, *hand_after(move), *moved, f"(increase (total-cost) {move.cost})"]
    return action_text(move.name, parameters, before, after)


def _bounds(move: Move, grounding: Grounding) -> Iterator[str]:
    """List what keeps a move on the table: only the edge that it leads towards matters."""
    for axis, last in enumerate(_last(grounding)):
        by = move.cells[axis]
        if by > 0:
            yield _at_most((f"({AXES[axis]} ?o)",), last - by)
        elif by < 0:
            yield f"(>= ({AXES[axis]} ?o) {_MARGIN - by})"


def _last(grounding: Grounding) -> tuple[int, int]:
    """Return the greatest x and y that a step may end at."""
    x, y = (math.floor(size / UNIT + _EPSILON) - _MARGIN for size in _size(grounding))
    return x, y


def _start(item: SceneObject, grounding: Grounding, tolerance: float) -> str:
    position = ", ".join(f"{value:.4f}" for value in item.position)
    values = zip(AXES, (*_anchor(item, grounding), 0), strict=True)
    facts = " ".join(f"(= ({axis} {item.name}) {value})" for axis, value in values)
    lines = [f"; {item.name} starts at ({position}) m", facts]
    if grounding.is_refined:
        lines += own_numbers.values_of(item, grounding, _in_units(grounding), tolerance)
    return "\n".join(f"    {line}" for line in lines)


def _anchor(item: SceneObject, grounding: Grounding) -> tuple[int, int]:
    """Return what stands for exactly where an object starts on x and y."""
    lows = (grounding.table.x[0], grounding.table.y[0])
    x, y = (round((value - low) / UNIT) for value, low in zip(item.position[:2], lows, strict=True))
    return x, y


def _goal(problem: Problem, name: str, grounding: Grounding, steps: int) -> str:
    item, goal = problem.object_named(name), problem.goals[name]
    position = ", ".join(f"{value:.4f}" for value in goal)
    away = math.dist(goal, item.position) * 1000
    dx, dy, height = ((end - start) / UNIT for end, start in zip(goal, item.position, strict=True))
    tolerance = problem.tolerance / UNIT
    (low, high), off = _heights(item, height, tolerance, grounding)
    radius = math.sqrt(max(tolerance**2 - off**2, 0.0)) - steps * math.sqrt(0.5)
    start_x, start_y = _anchor(item, grounding)
    lines = [f"; {name} shall come to ({position}) m, {away:.0f} mm from where it starts"]
    lines += _polygon(name, (start_x + dx, start_y + dy), max(radius, 0.0))
    lines.append(f"(>= (z {name}) {low}) (<= (z {name}) {high})")
    return "\n".join(f"    {line}" for line in lines)


def _heights(
    item: SceneObject, height: float, tolerance: float, grounding: Grounding
) -> tuple[tuple[int, int], float]:
    """Choose an interval of z, and say how far from the goal's height it can be, all in units.

    The heights in it are those that the cells of a goal would be chosen for. If all are too far from the
    goal, it is an interval that no object comes to.
    """
    possible = levels(item, _in_units(grounding))
    misses = {z: abs(z - height) + (0.5 if z else 0.0) for z in possible}
    chosen = best_levels(misses, tolerance)
    if not chosen:
        nowhere = max(possible) + 1
        return (nowhere, nowhere), tolerance
    return (min(chosen), max(chosen)), misses[chosen[-1]]


def _polygon(name: str, centre: tuple[float, float], radius: float) -> Iterator[str]:
    """List the conditions for being in the polygon in a disc, all in units; opposite edges share a line."""
    reach = radius * math.cos(_WIDEST)

    def edge(normal: tuple[int, int]) -> str:
        by_axis = list(zip(AXES, normal, strict=False))
        along = math.fsum(part * value for part, value in zip(normal, centre, strict=True))
        limit = math.floor(along + reach * math.hypot(*normal) + _EPSILON)
        plus = tuple(f"({axis} {name})" for axis, part in by_axis if part > 0)
        minus = tuple(f"({axis} {name})" for axis, part in by_axis if part < 0)
        return _at_most(plus, limit, minus)

    half = len(_NORMALS) // 2
    for one, other in zip(_NORMALS[:half], _NORMALS[half:], strict=True):
        yield f"{edge(one)} {edge(other)}"


def _at_most(terms: tuple[str, ...], limit: int, others: tuple[str, ...] = ()) -> str:
    """Print that the sum of some terms is at most a limit plus the sum of others, with no negative number."""
    left = _sum((*terms, *([str(-limit)] if limit < 0 else [])))
    right = _sum((*others, *([str(limit)] if limit > 0 else [])))
    return f"(<= {left} {right})" if terms else f"(>= {right} {left})"


def _sum(terms: tuple[str, ...]) -> str:
    if len(terms) < 2:
        return terms[0] if terms else "0"
    return f"(+ {_sum(terms[:-1])} {terms[-1]})"
