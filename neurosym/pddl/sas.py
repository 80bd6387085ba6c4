"""Printing objects that are led over cells in SAS+, which Fast Downward's search reads.

It says what the page says of them, an axis at a time, on the domain's own cells, and with the height as a
variable. Fast Downward's translator would have to find out which facts exclude each other, and which ground
actions there are. So the shipped problems of eight objects take half the time, and six objects at once, which
take 2 s so, are not solved on the page in 60. On the same cells both have plans of the same cost.
"""

from collections.abc import Iterator, Mapping, Sequence

from neurosym.data.cells import Step
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import check_object
from neurosym.pddl.grid import AXES, anchor, goal_region, grid_of
from neurosym.pddl.strips_problem import STEPS
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.options import Move, moves_for

_FREE, _EMPTY = "Atom ready()", "Atom hand-empty()"
_ANY = -1  # the value of a variable before an effect that does not ask for one
_Change = tuple[int, int, int]
"""A variable, its value before and its value after."""


def sas_text(problem: Problem, grounding: Grounding, *, steps: int = STEPS, margin: int = 0) -> str:
    """Print a problem with its domain; steps and margin are those of `StripsProblem`.

    Objects without a goal are left out, for in the encoding they are in nobody's way.
    """
    for item in problem.objects:
        check_object(item, grounding)
    task = _Task(problem, grounding, margin)
    operators = sorted(task.operators(steps))
    lines = ["begin_version", "3", "end_version", "begin_metric", "1", "end_metric", str(len(task.values))]
    for number, values in enumerate(task.values.values()):
        lines += ["begin_variable", f"var{number}", "-1", str(len(values)), *values, "end_variable"]
    lines += ["0"]  # groups of facts that exclude each other beside those of a variable
    lines += ["begin_state", *map(str, task.start()), "end_state"]
    goals = [f"{task.numbers['done', item.name]} 0" for item in task.items]
    lines += ["begin_goal", str(len(goals)), *goals, "end_goal", str(len(operators)), *operators]
    return "\n".join([*lines, "0", ""])  # no axioms


class _Task:
    """The variables of a problem, each with what its values stand for, and what operators do with them."""

    def __init__(self, problem: Problem, grounding: Grounding, margin: int) -> None:
        self.items = [problem.object_named(name) for name in sorted(problem.goals)]
        self._problem, self._grounding, self._margin = problem, grounding, margin
        self._grid = grid_of(grounding)
        self._cells = [cells.names for cells in self._grid]
        self._moves = [
            (item, move) for item in self.items for move in moves_for(item, grounding, problem.tolerance)
        ]
        held = [_holding(item, move) for item, move in self._moves if move.kind == "lift"]
        moving = [_lock(item, move, axis) for item, move in self._moves for axis in move.axes[1:]]
        done = {
            ("done", item.name): [f"Atom done({item.name})", f"NegatedAtom done({item.name})"]
            for item in self.items
        }
        self.values: Mapping[tuple[str, str], Sequence[str]] = {
            **self._places(2),
            ("hand", ""): [_EMPTY, *held],
            **self._places(0),
            **self._places(1),
            ("ready", ""): [*moving, _FREE],
            **done,
        }
        self.numbers = {about: number for number, about in enumerate(self.values)}

    def _places(self, axis: int) -> dict[tuple[str, str], list[str]]:
        """Return the variables for where objects are along an axis."""
        letter = AXES[axis]
        return {
            (letter, item.name): [f"Atom at-{letter}({item.name}, {cell})" for cell in self._cells[axis]]
            for item in self.items
        }

    def _value(self, about: str, fact: str) -> int:
        """Return the value of the hand or the lock that a fact is."""
        return self.values[about, ""].index(fact)

    def start(self) -> list[int]:
        """Return the value of each variable at the start."""
        values = dict.fromkeys(self.numbers, 0) | {("ready", ""): self._value("ready", _FREE)}
        for item in self.items:
            here = anchor(self._grid, item.position)
            values |= {(letter, item.name): cell for letter, cell in zip(AXES, here, strict=True)}
            values["done", item.name] = 1
        return list(values.values())

    def operators(self, steps: int) -> Iterator[str]:
        """Print all ground actions."""
        for item, move in self._moves:
            yield from self._parts(item, move)
        ready = {self.numbers["ready", ""]: self._value("ready", _FREE)}
        for item in self.items:
            goal, tolerance = self._problem.goals[item.name], self._problem.tolerance
            region = goal_region(item, goal, tolerance, self._grounding, steps=steps)
            noted = [(self.numbers["done", item.name], _ANY, 0)]
            for cells in ((*xy, z) for xy, zone in region.zone.items() for z in region.heights[:zone]):
                words = [names[cell] for names, cell in zip(self._cells, cells, strict=True)]
                at = {self.numbers[axis, item.name]: cell for axis, cell in zip(AXES, cells, strict=True)}
                yield _operator(["reach-goal", item.name, *words], ready | at, noted, 0)

    def _parts(self, item: SceneObject, move: Move) -> Iterator[str]:
        """Print the ground actions of a move: of one with its name, and of one for each further axis."""
        locks = [_FREE, *(_lock(item, move, axis) for axis in move.axes[1:]), _FREE]
        hand, ready = self.numbers["hand", ""], self.numbers["ready", ""]
        for number in range(max(len(move.axes), 1)):
            name, asked, changed = move.name, dict[int, int](), list[_Change]()
            lock, then = (self._value("ready", one) for one in locks[number : number + 2])
            if lock == then:
                asked[ready] = lock
            else:
                changed.append((ready, lock, then))
            if number:
                name = f"finish-{move.name}-{AXES[move.axes[number]]}"
            else:
                changed.append((self.numbers["done", item.name], _ANY, 1))
                empty = self._value("hand", _EMPTY)
                if move.kind == "rest":
                    asked[hand] = empty
                else:
                    held = self._value("hand", _holding(item, move))
                    changed.append((hand, empty, held) if move.kind == "lift" else (hand, held, empty))
            for words, shifted in self._shifts(item, move, number):
                cost = 0 if number else move.cost
                yield _operator([name, item.name, *words], asked, [*changed, *shifted], cost)

    def _shifts(
        self, item: SceneObject, move: Move, number: int
    ) -> Iterator[tuple[list[str], list[_Change]]]:
        """List from which cells to which a part leads: as words of a name, and as a change."""
        if not move.axes:
            yield [], []
            return
        axis = move.axes[number]
        names, variable = self._cells[axis], self.numbers[AXES[axis], item.name]
        for before, after in self._grid[axis].leads(Step(move.cells[axis]), self._margin * (axis < 2)):
            yield [names[before], names[after]], [(variable, before, after)]


def _operator(words: Sequence[str], asked: Mapping[int, int], changed: Sequence[_Change], cost: int) -> str:
    """Print a ground action: what must hold and stays, and which variables change from what to what."""
    lines = ["begin_operator", " ".join(words), str(len(asked))]
    lines += [f"{variable} {value}" for variable, value in sorted(asked.items())]
    lines += [str(len(changed)), *(f"0 {variable} {old} {new}" for variable, old, new in sorted(changed))]
    return "\n".join([*lines, str(cost), "end_operator"])


def _lock(item: SceneObject, move: Move, axis: int) -> str:
    return f"Atom moving-{move.name}-{AXES[axis]}({item.name})"


def _holding(item: SceneObject, move: Move) -> str:
    return f"Atom held-by-{move.operator.name}({item.name})"
