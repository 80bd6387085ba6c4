"""What a printed problem says of its objects' own steps, read from docs/pddl.md alone."""

import re
from collections import defaultdict
from decimal import Decimal

from independent.replay import PUT_DOWN, Point, Step

_UNIT = Decimal("0.0001")
_VALUE = re.compile(r"\(= \(([xyz])-of-(\S+) (\S+)\) (\d+)\)")
_STEP = re.compile(r"\(([xyz])-of a-(\S+) (\S+) [xyz]-(plus|minus)-(\d+)\)")
_CAN = re.compile(r"\(can-(\S+) (\S+)\)")
_SHIFT = re.compile(r"\(assign \([xyz] \?o\) \(- \(\+ \([xyz] \?o\) \([^)]*\)\) (\d+)\)\)")


def moves_in_numbers(domain: str, problem: str) -> dict[Step, Point]:
    """Return by how much each operator moves each object it is for, from the encoding `numeric` [m]."""
    shifts = set(map(int, _SHIFT.findall(_code(domain))))
    if not shifts:
        return {}
    (shift,) = shifts
    text = _code(problem)
    can = set(_CAN.findall(text))
    values = [(axis, (name, of), int(value) - shift) for axis, name, of, value in _VALUE.findall(text)]
    moves = _by_step(values)
    return {
        (name, of): tuple(_UNIT * part for part in moved)
        for (name, of), moved in moves.items()
        if (name.removeprefix(PUT_DOWN), of) in can
    }


def moves_in_cells(problem: str) -> dict[Step, tuple[int, ...]]:
    """Return by how many cells each operator moves each object it is for, from an encoding on a grid."""
    found = _STEP.findall(_code(problem))
    signed = [
        (axis, (name, of), int(cells) * (1 if sign == "plus" else -1))
        for axis, name, of, sign, cells in found
    ]
    return _by_step(signed)


def _by_step(values: list[tuple[str, Step, int]]) -> dict[Step, tuple[int, ...]]:
    moves: dict[Step, dict[str, int]] = defaultdict(dict)
    for axis, step, value in values:
        assert axis not in moves[step], f"{step} has two values along {axis}"
        moves[step][axis] = value
    return {step: tuple(moved.get(axis, 0) for axis in "xyz") for step, moved in moves.items()}


def _code(text: str) -> str:
    return re.sub(r";[^\n]*", "", text)
