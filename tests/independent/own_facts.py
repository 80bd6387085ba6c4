"""What a printed problem says of its objects' own steps, read from docs/pddl.md alone."""

import re
from decimal import Decimal

from independent.ground_pddl import Fact, Task, read_task
from independent.replay import PUT_DOWN, Json, Point, Step, lifts, promise_of

_UNIT = Decimal("0.0001")
_SHIFT = re.compile(r"\(assign \([xyz] \?o\) \(- \(\+ \([xyz] \?o\) \([^)]*\)\) (\d+)\)\)")
_CELLS = re.compile(r"^; Cells of ([\d.]+) mm\.", re.MULTILINE)
_LABEL = re.compile(r"m-([01]+[a-z]*)")
_BEGUN = ("pushes", "lifts")


def moves_in_numbers(domain: str, problem: str, grounding: Json) -> dict[Step, Point]:
    """Return by how much each operator moves each object it is for, from the encoding `numeric` [m]."""
    shifts = set(map(int, _SHIFT.findall(domain)))
    if not shifts:
        return {}
    (shift,), task, names = shifts, read_task(domain, problem), _operators(grounding)
    motions = {
        fact[2]: (names[task.types[fact[1]], _label(fact[2]), fact[0] == "lifts"], fact[1])
        for fact in task.facts
        if fact[0] in _BEGUN
    }
    motions |= {
        fact[1]: (PUT_DOWN + motions[fact[2]][0], motions[fact[2]][1])
        for fact in task.facts
        if fact[0] == "lowers"
    }
    declared = {name for name, kind in task.types.items() if kind == "motion"}
    assert motions.keys() == declared, "every motion has a role"
    return {step: _along(motion, shift, task) for motion, step in motions.items()}


def moves_in_cells(domain: str, problem: str, grounding: Json) -> dict[Step, tuple[int, int]]:
    """Return by how many cells each operator moves each object that is led over them, along x and y."""
    task, names = read_task(domain, problem), _operators(grounding)
    moves: dict[Step, tuple[int, int]] = {}
    for fact in task.facts:
        if fact[0] in (*_BEGUN, "lowers"):
            step, moved = _told(fact, task, names)
            assert step not in moves, f"{step} leads two ways"
            moves[step] = moved
    return moves


def cell_of(problem: str) -> float:
    """Return how long the cells of a printed problem are [m]."""
    (told,) = _CELLS.findall(problem)
    return float(told) / 1000


def _told(fact: Fact, task: Task, names: dict[tuple[str, str, bool], str]) -> tuple[Step, tuple[int, int]]:
    role, thing, motion, dx, dy, *_ = fact
    name = names[task.types[thing], _label(motion), role != "pushes"]
    return (PUT_DOWN * (role == "lowers") + name, thing), (int(dx[2:]), int(dy[2:]))


def _along(motion: str, shift: int, task: Task) -> Point:
    x, y, z = (_UNIT * (task.numbers[f"along-{axis}", motion] - shift) for axis in "xyz")
    return x, y, z


def _label(motion: str) -> str:
    (label,) = _LABEL.match(motion).groups()
    return label


def _operators(grounding: Json) -> dict[tuple[str, str, bool], str]:
    """Name the operators by their category, by their symbol, as motions are called, and whether they lift."""
    table = grounding["operators"]
    categories = {one["symbol"]: one["name"] for one in table["categories"]}
    return {
        (categories[one["category"]], one["primitive"] + one.get("variant", ""), lifts(one)): one["name"]
        for one in table["operators"]
        if promise_of(one) is not None
    }
