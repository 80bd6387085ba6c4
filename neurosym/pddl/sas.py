"""Printing objects that are led over cells in SAS+, which Fast Downward's search reads.

It says what the page says of them, an axis at a time, on the domain's own cells, and with the height as a
variable. Fast Downward's translator would have to find out what we know: which facts exclude each other, and
which ground actions there are. That takes it half a second an object. On the same cells both have plans of
the same cost.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from neurosym.grounding import Grounding
from neurosym.pddl.grid import AXES, Grid, goal_region, grid_of
from neurosym.pddl.problem import check_object
from neurosym.pddl.strips_problem import STEPS
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.moves import Move, moves_for

_FREE = "Atom ready()"
_EMPTY = "Atom hand-empty()"
REACH_GOAL = "reach-goal"
_FINISH = "finish-"
_ANY = -1  # the value of a variable before an effect that does not ask for one


@dataclass(frozen=True, slots=True)
class _Variable:
    """A variable of SAS+: its number among all, and the facts that its values stand for."""

    number: int
    values: Sequence[str]

    def index(self, value: str) -> int:
        return self.values.index(value)

    def text(self) -> str:
        about = ["begin_variable", f"var{self.number}", "-1", str(len(self.values))]
        return "\n".join([*about, *self.values, "end_variable"])


class _Operator(NamedTuple):
    """A ground action: what must hold and stays, and which variables change from what to what."""

    name: str
    prevail: tuple[tuple[int, int], ...]
    changes: tuple[tuple[int, int, int], ...]
    cost: int

    def text(self) -> str:
        prevail = "".join([f"\n{variable} {value}" for variable, value in sorted(self.prevail)])
        changes = "".join(
            [f"\n0 {variable} {before} {after}" for variable, before, after in sorted(self.changes)]
        )
        return (
            f"begin_operator\n{self.name}\n{len(self.prevail)}{prevail}\n{len(self.changes)}{changes}\n"
            f"{self.cost}\nend_operator"
        )


def sas_text(problem: Problem, grounding: Grounding, *, steps: int = STEPS, margin: int = 0) -> str:
    """Print a problem with its domain.

    Objects without a goal are left out, for in the encoding they are in nobody's way.

    Args:
        problem: The problem.
        grounding: The learned domain.
        steps: How many steps the rounding of is taken off the goal regions.
        margin: How many cells at either edge of the table no step may end in.

    Raises:
        InvalidValue: If an object stands off the table, or its name means something else in the domain.
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    for item in problem.objects:
        check_object(item, grounding)
    task = _Task(problem, grounding, steps, margin)
    operators = sorted(task.operators(), key=lambda one: one.name)
    lines = ["begin_version", "3", "end_version", "begin_metric", "1", "end_metric"]
    lines += [str(len(task.variables)), *(variable.text() for variable in task.variables)]
    lines += ["0"]  # groups of facts that exclude each other beside those of a variable
    lines += ["begin_state", *map(str, task.start()), "end_state"]
    goals = [f"{task.done[name].number} 0" for name in task.names]
    lines += ["begin_goal", str(len(goals)), *goals, "end_goal"]
    lines += [str(len(operators)), *(operator.text() for operator in operators)]
    return "\n".join([*lines, "0", ""])  # no axioms


class _Task:
    """The variables of a problem, and what its operators do with them."""

    def __init__(self, problem: Problem, grounding: Grounding, steps: int, margin: int) -> None:
        self.names = sorted(problem.goals)
        self._items = [problem.object_named(name) for name in self.names]
        self._problem, self._grounding = problem, grounding
        self._steps, self._margin = steps, margin
        self._grid: Grid = grid_of(grounding)
        self._cells = [self._grid.cell_names(axis) for axis in range(3)]
        of_item = [
            (item, move) for item in self._items for move in moves_for(item, grounding, problem.tolerance)
        ]
        held = [_holding(item, move) for item, move in of_item if move.kind == "lift"]
        moving = [_lock(item, move, axis) for item, move in of_item for axis in move.axes[1:]]
        self._moves = of_item
        self.variables: list[_Variable] = []
        self._at: dict[tuple[str, int], _Variable] = {}
        self._axis_variables(2)
        self._hand = self._variable([_EMPTY, *held])
        self._axis_variables(0)
        self._axis_variables(1)
        self._ready = self._variable([*moving, _FREE])
        self.done = {
            name: self._variable([f"Atom done({name})", f"NegatedAtom done({name})"]) for name in self.names
        }

    def _variable(self, values: Sequence[str]) -> _Variable:
        self.variables.append(_Variable(len(self.variables), values))
        return self.variables[-1]

    def _axis_variables(self, axis: int) -> None:
        for name in self.names:
            values = [f"Atom at-{AXES[axis]}({name}, {cell})" for cell in self._cells[axis]]
            self._at[name, axis] = self._variable(values)

    def start(self) -> list[int]:
        """Return the value of each variable at the start."""
        values = [0] * len(self.variables)
        for item in self._items:
            for axis, cell in enumerate(self._grid.anchor(item.position)):
                values[self._at[item.name, axis].number] = cell
            values[self.done[item.name].number] = 1
        values[self._ready.number] = self._ready.index(_FREE)
        return values

    def operators(self) -> Iterator[_Operator]:
        """List all ground actions."""
        for item, move in self._moves:
            yield from self._parts(item, move)
        for item in self._items:
            yield from self._reaching(item)

    def _parts(self, item: SceneObject, move: Move) -> Iterator[_Operator]:
        """List the ground actions of all parts of a move of an object."""
        parts = _parts_of(move)
        locks = [_FREE, *(_lock(item, move, axes[0]) for _, axes in parts[1:]), _FREE]
        for number, (name, axes) in enumerate(parts):
            asked, changed = [], []
            lock, then = (self._ready.index(locks[number + k]) for k in (0, 1))
            if lock == then:
                asked.append((self._ready.number, lock))
            else:
                changed.append((self._ready.number, lock, then))
            if number == 0:
                changed.append((self.done[item.name].number, _ANY, 1))
                empty, held = self._hand.index(_EMPTY), _holding(item, move)
                if move.kind == "rest":
                    asked.append((self._hand.number, empty))
                elif move.kind == "lift":
                    changed.append((self._hand.number, empty, self._hand.index(held)))
                else:
                    changed.append((self._hand.number, self._hand.index(held), empty))
            cost = move.cost if number == 0 else 0
            stays, begin = tuple(asked), f"{name} {item.name}"
            for words, shifted in self._shifts(item, move, axes):
                yield _Operator(begin + words, stays, (*changed, *shifted), cost)

    def _shifts(
        self, item: SceneObject, move: Move, axes: tuple[int, ...]
    ) -> Iterator[tuple[str, tuple[tuple[int, int, int], ...]]]:
        """List from which cells to which a part leads: as words of a name, and as a change."""
        if not axes:
            yield "", ()
        for axis in axes:
            number, names = self._at[item.name, axis].number, self._cells[axis]
            for before, after in self._grid.shifts(axis, move.cells[axis], self._margin):
                yield f" {names[before]} {names[after]}", ((number, before, after),)

    def _reaching(self, item: SceneObject) -> Iterator[_Operator]:
        """List the ground actions that note that an object is within its goal region."""
        goal, tolerance = self._problem.goals[item.name], self._problem.tolerance
        region = goal_region(item, goal, tolerance, self._grounding, steps=self._steps)
        ready = (self._ready.number, self._ready.index(_FREE))
        for xy in region.xy:
            for z in region.z:
                spot = tuple(enumerate((*xy, z)))
                words = " ".join([self._cells[axis][cell] for axis, cell in spot])
                at = tuple((self._at[item.name, axis].number, cell) for axis, cell in spot)
                noted = ((self.done[item.name].number, _ANY, 0),)
                yield _Operator(f"{REACH_GOAL} {item.name} {words}", (ready, *at), noted, 0)


def _parts_of(move: Move) -> tuple[tuple[str, tuple[int, ...]], ...]:
    """List the actions that a move consists of, with its name and the axes of which it names cells."""
    others = ((f"{_FINISH}{move.name}-{AXES[axis]}", (axis,)) for axis in move.axes[1:])
    return ((move.name, move.axes[:1]), *others)


def _lock(item: SceneObject, move: Move, axis: int) -> str:
    return f"Atom moving-{move.name}-{AXES[axis]}({item.name})"


def _holding(item: SceneObject, move: Move) -> str:
    return f"Atom held-by-{move.operator.name}({item.name})"
