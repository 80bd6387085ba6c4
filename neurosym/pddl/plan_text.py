"""Plans as text: the IPC form that planners write, read into steps, and steps printed again.

A step is one primitive on one object. Planners write ground actions with cells as further arguments, and in
the `stepwise` encoding several for one step; reading folds them into steps.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from neurosym.checks import check_kind
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.grid import Grid, grid_of
from neurosym.pddl.moves import (
    BY_RELATIONS,
    PLACES,
    PUT_DOWN,
    REACH_GOAL,
    Encoding,
    Move,
    carrier,
    move_constant,
    moves_for,
    moves_of,
    parts_of,
)
from neurosym.pddl.own_steps import step_name
from neurosym.pddl.place_problem import PlaceNotes
from neurosym.pddl.places import with_places
from neurosym.pddl.relational_replay import print_relational_plan
from neurosym.problems import Problem, SceneObject
from neurosym.reading import MEGABYTE
from neurosym.related import is_relational, relating
from neurosym.wording import counted

MOST_PLAN = 16 * MEGABYTE
"""Greater files are no plans [bytes]."""
LONGEST_LINE = 10_000
"""Longer lines are no steps."""
_CARRIERS = frozenset(carrier(axis) for axis in range(3))
_TIME = re.compile(r"^\d+(\.\d+)?\s*:\s*")
_DURATION = re.compile(r"\s*\[\s*\d+(\.\d+)?\s*\]$")


@dataclass(frozen=True, slots=True)
class PlanStep:
    """One step of a plan.

    Attributes:
        operator: Name of an operator, or `put-down-` and the name of the operator that lifted the object.
        object: Name of the object.
        place: Name of the place that the object is carried to, or of the other object that it is put on or
            into; empty if it is neither. Places and objects of a problem share no name.
    """

    operator: str
    object: str
    place: str = ""

    def __post_init__(self) -> None:
        for name in ("operator", "object", "place"):
            check_kind(f"{name} of a step", getattr(self, name), str, "its name")

    @property
    def puts_down(self) -> bool:
        """Whether the step puts an object down."""
        return self.operator.startswith(PUT_DOWN)

    @property
    def base(self) -> str:
        """Name of the operator in the table of operators."""
        return self.operator.removeprefix(PUT_DOWN)


Steps = tuple[tuple[str, ...], ...]
"""Operator and object of each step of a plan, and the place if it has one, as records hold it."""


def named_steps(steps: Iterable[PlanStep]) -> Steps:
    """Return the operator and the object of each step, and the place if it has one."""
    return tuple((step.operator, step.object, *filter(None, (step.place,))) for step in steps)


def primitives(steps: Iterable[PlanStep]) -> int:
    """Count the primitives of a plan: putting down belongs to its lift, and is counted nowhere."""
    return sum(not step.puts_down for step in steps)


def print_plan(steps: Sequence[PlanStep], comment: str = "") -> str:
    """Print a plan in IPC form, one `(operator object)` a line.

    Args:
        steps: The plan.
        comment: What the last line says; by default how many steps there are.
    """
    lines = [f"({' '.join(words)})" for words in named_steps(steps)]
    said = comment or counted(primitives(steps), "primitive")
    return "\n".join([*lines, f"; {' '.join(said.split())}"]) + "\n"


def print_ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding = "stepwise"
) -> str:
    """Print a plan as ground actions of the domain, cells and all, such that plan validators take it.

    Args:
        steps: The plan; every operator in it must be in the domain.
        problem: The problem it solves.
        grounding: The learned domain.
        encoding: The encoding of the domain.

    Raises:
        InvalidValue: If an operator is not in the domain, or not for its object.
    """
    steps = tuple(steps)
    is_asked = encoding in BY_RELATIONS or is_relational(problem, grounding)
    if is_asked or any(relating(step.base, grounding) for step in steps):
        rows = [(step.operator, step.object, step.place) for step in steps]
        return print_relational_plan(rows, problem, grounding, encoding)
    if any(step.place for step in steps):
        problem, encoding = with_places(problem, grounding), PLACES
    notes = PlaceNotes(problem, grounding) if encoding == PLACES else None
    grid, has_own = grid_of(grounding), grounding.is_refined
    moves = {item.name: _moves_of(item, problem, grounding, encoding) for item in problem.objects}
    cells = {item.name: list(grid.anchor(item.position)) for item in problem.objects}
    lines: list[str] = []
    for number, step in enumerate(steps):
        if step.place and notes:
            lines += notes.carry(step.operator, step.object, step.place)
            continue
        if step.operator not in moves[step.object]:
            of_whom = f" for {step.object}" if has_own else ""
            raise InvalidValue(
                f"{step.operator} is not in the domain{of_whom}, so the plan cannot be printed with cells."
            )
        move, here = moves[step.object][step.operator], cells[step.object]
        for name, axes in parts_of(move, encoding, has_own=has_own):
            is_carried = name in _CARRIERS
            words = [name, *([move_constant(move)] if is_carried else []), step.object]
            for axis in axes:
                words += [step_name(axis, move.cells[axis])] if is_carried else []
                words += [
                    grid.cell_name(axis, here[axis]),
                    grid.cell_name(axis, here[axis] + move.cells[axis]),
                ]
                here[axis] += move.cells[axis]
            lines.append(f"({' '.join(words)})")
        if notes and not any(later.object == step.object for later in steps[number + 1 :]):
            lines += [_reached(step.object, cells, grid), notes.leave(step.object)]
    for name in sorted(problem.goals) if encoding != "numeric" else ():
        line = notes.reach(name) if notes and name in notes.carried else _reached(name, cells, grid)
        lines += [line] if line not in lines else []
    return "\n".join(lines) + "\n"


def _reached(name: str, cells: Mapping[str, Sequence[int]], grid: Grid) -> str:
    spot = " ".join(grid.cell_name(axis, index) for axis, index in enumerate(cells[name]))
    return f"({REACH_GOAL} {name} {spot})"


def _moves_of(
    item: SceneObject, problem: Problem, grounding: Grounding, encoding: Encoding
) -> dict[str, Move]:
    """Return the moves of an object by name, as the domain of an encoding has them."""
    is_mean = encoding == "operators" or not grounding.is_refined
    moves = moves_of(grounding) if is_mean else moves_for(item, grounding, problem.tolerance)
    return {move.name: move for move in moves}
