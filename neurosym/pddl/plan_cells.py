"""Where objects are while a written plan is followed over cells, and the ground actions of its steps."""

from collections.abc import Mapping, Sequence
from functools import cached_property

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.grid import AXES, Grid, grid_of
from neurosym.pddl.ground_plan import led_actions
from neurosym.pddl.moves import CARRIERS, FINISH, REACH_GOAL, Encoding
from neurosym.pddl.plan_lines import WrittenAction
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem
from neurosym.tasks.moves import Move, moves_for, moves_of

Words = tuple[str, ...]
"""Name and arguments of a ground action."""


def without_part(name: str) -> str:
    """Turn `finish-NAME-y` into `NAME`, and leave other names as they are.

    Args:
        name: Name of an action.
    """
    if name.startswith(FINISH) and name[-2:] in {f"-{axis}" for axis in AXES}:
        return name.removeprefix(FINISH)[:-2]
    return name


class Cells:
    """The cells that objects are in.

    Args:
        actions: The actions of a plan.
        problem: The problem it is for.
        grounding: The learned domain, on the grid that cells in the plan are of.
        encoding: How the plan names cells: `operators` all of a step in one action, and `stepwise` an axis
            at a time, as `sas` and `places` do.
    """

    def __init__(
        self, actions: Sequence[WrittenAction], problem: Problem, grounding: Grounding, encoding: Encoding
    ):
        self._actions, self._problem, self._grounding = actions, problem, grounding
        self._encoding: Encoding = encoding
        self._led = {one.name for one in grounding.operators.operators}
        self._cells: dict[str, list[int] | None] = {}
        self._moves: dict[str, Mapping[str, Move]] = {}

    def is_carrier(self, name: str) -> bool:
        """Say whether an action leads any object along an axis, as where objects have steps of their own."""
        return self._grounding.is_refined and name in CARRIERS

    @cached_property
    def _has_carriers(self) -> bool:
        return any(self.is_carrier(one.name) for one in self._actions)

    @cached_property
    def are_written(self) -> bool:
        """Whether the steps over cells are written with their cells, and are no steps in short."""
        return self._has_carriers or any(map(self._names_cells, self._actions))

    @cached_property
    def _are_asked(self) -> bool:
        """Whether the plan says anything of cells."""
        return self.are_written or any(one.name == REACH_GOAL and one.arguments for one in self._actions)

    def _names_cells(self, action: WrittenAction) -> bool:
        begun = without_part(action.name)
        is_led = PlanStep(begun, "").base in self._led
        return is_led and (begun != action.name or len(action.arguments) > 1)

    def lead(self, step: PlanStep) -> tuple[Words, ...]:
        """Lead an object by a step over cells, and return the ground actions of that.

        Args:
            step: The step.

        Raises:
            InvalidValue: If it leads nowhere that is known.
        """
        if not self._are_asked:
            return ()
        move, here = self._move(step), self._here(step.object)
        if not self.are_written and (move is None or here is None):
            self._cells[step.object] = None
            return ()
        if move is None:
            raise InvalidValue(f"it is not in the domain for {step.object}, so it leads to no cell")
        return tuple(self._parts(move, step.object, self.known(step.object)))

    def spot(self, name: str) -> Words:
        """Return the names of the cells that an object is in.

        Args:
            name: The object.

        Raises:
            InvalidValue: If they are not known.
        """
        return tuple(self._grid.cell_name(axis, index) for axis, index in enumerate(self.known(name)))

    def known(self, name: str) -> list[int]:
        """Return the cells that an object is in, by their numbers.

        Args:
            name: The object.

        Raises:
            InvalidValue: If they are not known.
        """
        here = self._here(name)
        if here is None:
            raise InvalidValue(f"it is not known in which cell {name} is by then")
        return here

    @property
    def _grid(self) -> Grid:
        return grid_of(self._grounding)

    def _move(self, step: PlanStep) -> Move | None:
        """Return the move of a step as the domain of the encoding has it; None if it does not."""
        if step.object not in self._moves:
            item, grounding = self._problem.object_named(step.object), self._grounding
            is_mean = self._encoding == "operators"
            moves = moves_of(grounding) if is_mean else moves_for(item, grounding, self._problem.tolerance)
            self._moves[step.object] = {move.name: move for move in moves}
        return self._moves[step.object].get(step.operator)

    def _parts(self, move: Move, name: str, here: list[int]) -> list[Words]:
        """List the ground actions of a move, and lead its object along."""
        if not self.are_written:
            here[:] = [cell + by for cell, by in zip(here, move.cells, strict=True)]
            return []
        has_own = self._has_carriers
        return list(led_actions(move, name, here, self._grid, self._encoding, has_own=has_own))

    def _here(self, name: str) -> list[int] | None:
        if name not in self._cells:
            self._cells[name] = list(self._grid.anchor(self._problem.object_named(name).position))
        return self._cells[name]
