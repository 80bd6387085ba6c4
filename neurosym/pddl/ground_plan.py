"""A plan as ground actions of the printed domain, and what the printed problem must have for it.

A problem is printed before anybody plans. Goal regions leave out the edge of what the tolerance allows, since
grids round, and only some places are drawn. So the exact replay may take a plan that ends a cell beside the
region, or that uses a spot of the table that has no name yet. Such a plan says here which facts it needs; the
problem beside it is then printed with them (`problem_text`), and any validator takes the two together.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.grid import AXES, Grid, grid_of
from neurosym.pddl.moves import (
    BY_RELATIONS,
    CARRIERS,
    MOVE,
    NUMERIC,
    PLACES,
    REACH_GOAL,
    RELATIONAL,
    Encoding,
    move_constant,
    parts_of,
)
from neurosym.pddl.own_steps import step_name
from neurosym.pddl.place_problem import PlaceNotes, place_facts
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.relational_replay import print_relational_plan
from neurosym.problems import Problem
from neurosym.related import is_relational, relating
from neurosym.spots import spot_named
from neurosym.tasks.moves import Move, moves_for, moves_of
from neurosym.tasks.places import with_places


@dataclass(frozen=True, slots=True)
class GroundPlan:
    """A plan as ground actions.

    Attributes:
        encoding: The encoding of the domain that has these actions.
        lines: The ground actions, one a line.
        facts: What must hold in the problem at the start beside what any plan may count on.
        spots: Names of the spots that the problem must declare.
    """

    encoding: Encoding
    lines: tuple[str, ...]
    facts: tuple[str, ...] = ()
    spots: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The plan in IPC form."""
        return "\n".join(self.lines) + "\n"

    def missing(self, problem: str) -> tuple[str, ...]:
        """Return the facts that the text of a problem lacks."""
        return tuple(fact for fact in self.facts if fact not in problem)


def ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding = "stepwise"
) -> GroundPlan:
    """Turn a plan into ground actions of the domain, cells and all, such that plan validators take it.

    Args:
        steps: The plan; every operator in it must be in the domain.
        problem: The problem it solves.
        grounding: The learned domain.
        encoding: The encoding of the domain. Whatever it is, what carries is printed in `places`, and what
            puts objects on each other in `relational`.

    Raises:
        InvalidValue: If an operator is not in the domain, or not for its object, or leads off the grid.
    """
    steps = tuple(steps)
    by_relations = encoding in BY_RELATIONS or is_relational(problem, grounding)
    if by_relations or any(relating(step.base, grounding) for step in steps):
        rows = [(step.operator, step.object, step.place) for step in steps]
        chosen = encoding if encoding in BY_RELATIONS else RELATIONAL
        text = print_relational_plan(rows, problem, grounding, chosen)
        return GroundPlan(chosen, tuple(text.splitlines()))
    if any(step.place for step in steps):
        encoding = PLACES
    if encoding == PLACES:
        problem = with_places(problem, grounding)
    printing = _Printing(problem, grounding, encoding)
    for number, step in enumerate(steps):
        is_last = not any(later.object == step.object for later in steps[number + 1 :])
        printing.take(step, is_last=is_last)
    if encoding != NUMERIC:
        printing.reach_goals()
    return GroundPlan(
        encoding,
        tuple(printing.lines),
        tuple(dict.fromkeys(printing.facts)),
        tuple(dict.fromkeys(step.place for step in steps if step.place and spot_named(step.place))),
    )


def print_ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding = "stepwise"
) -> str:
    """Print a plan as ground actions; see `ground_plan`."""
    return ground_plan(steps, problem, grounding, encoding).text


def led_actions(
    move: Move, name: str, here: list[int], grid: Grid, encoding: Encoding, *, has_own: bool
) -> Iterator[tuple[str, ...]]:
    """Lead an object over cells by a move, and yield the ground actions of that, each as its words.

    Args:
        move: The move.
        name: The object.
        here: The cells that it is in, which change.
        grid: The grid.
        encoding: The encoding of the domain.
        has_own: Whether objects have steps of their own, so that actions name the steps, too.

    Raises:
        InvalidValue: If it leads off the grid.
    """
    for action, axes in parts_of(move, encoding, has_own=has_own):
        is_carrier = has_own and action in CARRIERS
        words = [action, *([move_constant(move)] if is_carrier else []), name]
        for axis in axes:
            before, here[axis] = here[axis], here[axis] + move.cells[axis]
            if not 0 <= here[axis] <= grid.last[axis]:
                raise InvalidValue(f"{move.name} leads {name} off the grid along {AXES[axis]}.")
            words += [step_name(axis, move.cells[axis])] if is_carrier else []
            words += [grid.cell_name(axis, before), grid.cell_name(axis, here[axis])]
        yield tuple(words)


class _Printing:
    """The actions printed so far, and where objects are by then."""

    def __init__(self, problem: Problem, grounding: Grounding, encoding: Encoding):
        self._problem, self._grounding, self._encoding = problem, grounding, encoding
        self._grid: Grid = grid_of(grounding)
        self._notes = PlaceNotes(problem, grounding) if encoding == PLACES else None
        self._moves: dict[str, Mapping[str, Move]] = {}
        self._cells = {item.name: list(self._grid.anchor(item.position)) for item in problem.objects}
        self.lines: list[str] = []
        self.facts: list[str] = []

    def take(self, step: PlanStep, *, is_last: bool) -> None:
        """Print a step; `is_last` says that it is the last with its object."""
        if step.place and self._notes:
            self.lines += self._notes.carry(step.operator, step.object, step.place)
            self.facts += place_facts(step.object, step.place, self._problem)
            self.facts.append(f"(can {MOVE}{step.operator} {step.object})")
            return
        self._lead(step)
        if self._notes and is_last:
            self._note_goal(step.object)
            self.lines.append(self._notes.leave(step.object))

    def reach_goals(self) -> None:
        """Note of each object with a goal that it is there, where that was not noted yet."""
        for name in sorted(self._problem.goals):
            if self._notes and name in self._notes.carried:
                self.lines.append(self._notes.reach(name))
            elif self._reached(name) not in self.lines:
                self._note_goal(name)

    def _lead(self, step: PlanStep) -> None:
        of_whom = f" for {step.object}" if self._grounding.is_refined else ""
        move, here = self._moves_of(step.object).get(step.operator), self._cells[step.object]
        if move is None or (self._notes and step.object not in self._notes.led):
            raise InvalidValue(
                f"{step.operator} is not in the domain{of_whom}, so the plan cannot be printed with cells."
            )
        has_own = self._grounding.is_refined
        for words in led_actions(move, step.object, here, self._grid, self._encoding, has_own=has_own):
            self.lines.append(f"({' '.join(words)})")

    def _moves_of(self, name: str) -> Mapping[str, Move]:
        """Return the moves of an object by name, as the domain of the encoding has them."""
        if name not in self._moves:
            problem, grounding = self._problem, self._grounding
            is_mean = self._encoding == "operators" or not grounding.is_refined
            item = problem.object_named(name)
            moves = moves_of(grounding) if is_mean else moves_for(item, grounding, problem.tolerance)
            self._moves[name] = {move.name: move for move in moves}
        return self._moves[name]

    def _reached(self, name: str) -> str:
        return f"({REACH_GOAL} {name} {' '.join(self._where(name))})"

    def _note_goal(self, name: str) -> None:
        x, y, z = self._where(name)
        self.lines.append(self._reached(name))
        self.facts += [f"(goal-xy {name} {x} {y})", f"(goal-z {name} {z})"]

    def _where(self, name: str) -> Sequence[str]:
        return [self._grid.cell_name(axis, index) for axis, index in enumerate(self._cells[name])]
