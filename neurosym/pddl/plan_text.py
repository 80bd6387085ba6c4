"""Plans as text: the IPC form that planners write, read into steps, and steps printed again.

A step is one primitive on one object. Planners write ground actions with cells as further arguments, and in
the `stepwise` encoding several for one step; reading folds them into steps.
"""

import dataclasses
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from neurosym.checks import check_kind
from neurosym.errors import InvalidPlan, InvalidValue, UnknownChoice, shortened
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.pair_sight import with_pairs
from neurosym.pddl.grid import AXES, Grid, grid_of
from neurosym.pddl.moves import (
    BY_RELATIONS,
    FINISH,
    MOVE,
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
from neurosym.pddl.place_domain import NOTES
from neurosym.pddl.place_problem import START, PlaceNotes
from neurosym.pddl.places import with_places
from neurosym.pddl.relational_domain import FROM_OBJECT, FROM_PLACE, LADEN, LEAVE
from neurosym.pddl.relational_replay import print_relational_plan
from neurosym.pddl.relational_task import flattened
from neurosym.problems import Problem, SceneObject
from neurosym.reading import MEGABYTE, read_text
from neurosym.related import bearers_of, is_relational, relating
from neurosym.relation_goals import pair_key
from neurosym.relation_operators import RelationOperator
from neurosym.table import Table
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
    led = {step.object for step in steps if not step.place}
    moves = {
        item.name: _moves_of(item, problem, grounding, encoding)
        for item in problem.objects
        if item.name in led
    }
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


def read_plan(path: Path, grounding: Grounding, problem: Problem) -> tuple[PlanStep, ...]:
    """Read a plan file that any planner wrote.

    Args:
        path: The plan file, in IPC form; time stamps, durations, comments and capitals are taken in stride.
        grounding: The learned domain; every operator of its table may occur, in the domain or not.
        problem: The problem that the plan is for.

    Raises:
        InvalidPlan: If a line cannot be read, or names an operator, object or pair that does not exist.
        InvalidFile: If the file is far too large, or no text.
    """
    text = read_text(path, MOST_PLAN)
    return parse_plan(text, path, grounding, problem)


def parse_plan(text: str, path: Path, grounding: Grounding, problem: Problem) -> tuple[PlanStep, ...]:
    """Read the text of a plan; see `read_plan`.

    Args:
        text: The text.
        path: What errors name as its origin.
        grounding: The learned domain.
        problem: The problem that the plan is for.

    Raises:
        InvalidPlan: If a line cannot be read, or names an operator, object or pair that does not exist.
    """
    steps = []
    for number, raw in enumerate(text.splitlines(), start=1):
        line = raw.split(";")[0].strip().lower()
        if not line:
            continue
        try:
            step = _read_line(line, grounding, problem)
        except (InvalidValue, UnknownChoice) as error:
            raise InvalidPlan(path, number, str(error).rstrip(".")) from error
        steps += [step] if step else []
    return tuple(steps)


def _read_line(line: str, grounding: Grounding, problem: Problem) -> PlanStep | None:
    """Read one line; None if it is only a later part of a step."""
    bare = _DURATION.sub("", _TIME.sub("", line)) if len(line) <= LONGEST_LINE else ""
    words = bare[1:-1].split()
    if not re.fullmatch(r"\([^()]*\)", bare) or len(words) < 2:
        raise InvalidValue(f"{shortened(line)!r} is not of the form (operator object ...)")
    name, thing = words[:2]
    is_carried = name in _CARRIERS and len(words) > 2
    if is_carried:
        name, thing = words[1].removeprefix(MOVE), words[2]
    if thing not in problem.object_names:
        raise UnknownChoice("object", thing, problem.object_names)
    if name in (REACH_GOAL, *NOTES) or (grounding.relations and name.startswith(LEAVE)):
        return None
    if put := relating(name, grounding) or relating(name.removesuffix(LADEN), grounding):
        return _putting(put, words[1:], grounding, problem)
    step = PlanStep(_without_part(name), thing)
    operator = grounding.operator_named(step.base)
    _check_fit(step, operator, grounding, problem)
    if grounding.carries(operator):
        places = [word for word in words[2:] if word not in (FROM_PLACE, FROM_OBJECT)]
        return _carrying(step, places, with_places(_flat(problem, grounding), grounding), grounding.table)
    return None if is_carried or name.startswith(FINISH) else step


def _carrying(step: PlanStep, places: list[str], problem: Problem, table: Table) -> PlanStep:
    """Return a step with the place that it carries its object to: the only one named, or the second."""
    place = places[min(1, len(places) - 1)] if places else ""
    if place.startswith(START):
        raise InvalidValue(
            f"Nothing is carried to {place}: no object goes back to where one stood at the start"
        )
    table.check(place, *problem.place_named(place))
    return dataclasses.replace(step, place=place)


def _flat(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with the heights that objects have on the table, as places are drawn for them."""
    bearers = bearers_of(problem, grounding.relations) if grounding.relations else {}
    return flattened(problem, bearers) if bearers else problem


def _putting(
    operator: RelationOperator, words: list[str], grounding: Grounding, problem: Problem
) -> PlanStep:
    """Return a step with the object that it puts its target on or into."""
    target, reference = words[0], words[1] if len(words) > 1 else ""
    if reference not in problem.object_names or reference == target:
        valid = [name for name in problem.object_names if name != target]
        raise UnknownChoice("other object", reference, valid)
    kinds = with_pairs(problem, grounding.relations).pairs
    kind = kinds.get(pair_key(target, reference)) if isinstance(kinds, dict) else None
    if not operator.is_for(kind):
        raise InvalidValue(
            f"{operator.name} is for pairs of the kind {operator.pair}, and {target} with {reference} is of "
            f"the kind {kind}"
        )
    return PlanStep(operator.name, target, reference)


def _without_part(name: str) -> str:
    """Turn `finish-NAME-y` into `NAME`, and leave other names as they are."""
    if name.startswith(FINISH) and name[-2:] in {f"-{axis}" for axis in AXES}:
        return name.removeprefix(FINISH)[:-2]
    return name


def _check_fit(step: PlanStep, operator: Operator, grounding: Grounding, problem: Problem) -> None:
    category = problem.object_named(step.object).category
    if operator.category != category:
        raise InvalidValue(
            f"{operator.name} is for objects of category {grounding.category(operator.category).name}, and "
            f"{step.object} is of category {grounding.category(category).name}"
        )
    if step.puts_down and not is_lift(operator):
        raise InvalidValue(f"{operator.name} does not end with the object held, so nothing can be put down")
