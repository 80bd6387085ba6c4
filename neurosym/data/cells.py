"""Cells: an axis of which everything is known, cut up for plans, and steps from one cell to another."""

import math
from collections.abc import Sequence

from neurosym.checks import Document
from neurosym.data.axes import Axis
from neurosym.errors import InvalidValue


class Step(Document, frozen=True, omit_defaults=True):
    """What an outcome does along one axis: so many cells, or to one cell; it stays if neither."""

    by: int = 0  # so many cells
    to: int | None = None  # to the cell of that number

    @property
    def stays(self) -> bool:
        """Whether it does nothing."""
        return not self.by and self.to is None


class Cells:
    """The cells of an axis; their names have so many digits, or as many as their numbers need.

    Attributes:
        low: The middle of the first cell.
        size: How large a cell is.
        count: How many there are.
    """

    def __init__(self, axis: Axis, digits: int = 0):
        self.axis, self.low, self.size = axis, axis.low or 0.0, axis.cell or 1.0
        if axis.kind == "flag":
            self.count = 2
        elif axis.period is not None:
            self.count = max(2, round(axis.period / (axis.cell or axis.period)))
            self.size = axis.period / self.count
        else:
            self.count = math.floor((axis.span or 0.0) / self.size + 1e-6) + 1
        self._digits = digits or len(str(self.count - 1))

    def _number(self, value: float) -> int:
        return math.floor((value - self.low) / self.size + 0.5)

    def index(self, value: float) -> int:
        """Return the cell of a value; `InvalidValue` if it lies outside of the bounds."""
        number = self._number(value)
        if self.axis.period is not None:
            return number % self.count
        if not 0 <= number < self.count:
            valid = f"{self.low:g} to {self.centre(self.count - 1):g}"
            raise InvalidValue(f"{self.axis.name} = {value:g} lies out of bounds; valid: {valid}.")
        return number

    def clipped(self, value: float) -> int:
        """Return the cell that is nearest to a value."""
        number = self._number(value)
        return number % self.count if self.axis.period is not None else min(max(number, 0), self.count - 1)

    def centre(self, number: int) -> float:
        """Return the value in the middle of a cell."""
        return self.low + number * self.size

    def in_words(self, number: int) -> str:
        """Say what a value in a cell is: `no` or `yes` of a flag, else the middle of the cell."""
        return ("no", "yes")[number] if self.axis.kind == "flag" else f"{self.centre(number):g}"

    def led(self, here: int, step: Step) -> int | None:
        """Return where a step leads from a cell; None if that is out of bounds."""
        if step.to is not None:
            return step.to
        there = here + step.by
        if self.axis.period is not None:
            return there % self.count
        return there if 0 <= there < self.count else None

    def leads(self, step: Step, margin: int = 0) -> list[tuple[int, int]]:
        """List from which cells to which a step leads; none ends so near to the bounds."""
        inside = range(margin, self.count - margin)
        every = ((here, self.led(here, step)) for here in range(self.count))
        return [(here, there) for here, there in every if there is not None and there in inside]

    def shift(self, change: float) -> int:
        """Round a change to whole cells, the shorter way round for an angle."""
        return round(self.axis.apart(change, 0.0) / self.size)

    def near(self, goal: float | tuple[float, float]) -> tuple[int, ...]:
        """Return the cells that meet a goal: a value, within the tolerance, or bounds.

        These are the cells that lie in it whole, or else those of which the middle does; a value has one.
        """
        if self.axis.kind == "flag" and goal not in (0, 1, (0, 0), (0, 1), (1, 1)):
            raise InvalidValue(f"{self.axis.name} cannot be {goal}; valid: 0 and 1, or no and yes.")
        middle, room = self._around(goal)
        off = [abs(self.axis.apart(self.centre(n), middle)) for n in range(self.count)]
        found = [n for n in range(self.count) if off[n] + self.size / 2 <= room]
        if not found:  # the middle of a cell is in it, or else a value lies in a cell
            most = room if isinstance(goal, tuple) else min(off) if min(off) <= self.size / 2 else room
            found = [n for n in range(self.count) if off[n] <= most + 1e-9]
        if not found:
            raise InvalidValue(f"No cell of {self.axis.name} meets the goal {goal}; its cells are {self}.")
        return tuple(found)

    def meets(self, goal: float | tuple[float, float], value: float) -> bool:
        """Say whether a value itself meets a goal: within bounds, or within its tolerance or half a cell."""
        middle, room = self._around(goal)
        least = 1e-6 if isinstance(goal, tuple) or self.axis.kind == "flag" else self.size / 2
        return abs(self.axis.apart(value, middle)) <= max(room, least)

    def _around(self, goal: float | tuple[float, float]) -> tuple[float, float]:
        """Return the middle of a goal, and how far from it is near enough."""
        if isinstance(goal, tuple):
            low, high = goal
            high += (self.axis.period or 0.0) * (high < low)  # over the seam of an angle
            return (low + high) / 2, (high - low) / 2 + 1e-9
        return goal, self.axis.tolerance or 0.0

    def name(self, number: int) -> str:
        """Name a cell, like `speed12`, or `open-yes` for a flag, such that names sort like cells."""
        if self.axis.kind == "flag":
            return f"{self.axis.name}-{self.in_words(number)}"
        return f"{self.axis.name}{'-' * self.axis.name[-1].isdigit()}{number:0{self._digits}d}"

    def step_name(self, step: Step) -> str:
        """Name a step as no cell of any axis is called, like `speed-by-m3`, `speed-by-0` or `to-gear2`."""
        if step.to is not None:
            return f"to-{self.name(step.to)}"
        return f"{self.axis.name}-by-{step.by}".replace("--", "-m")

    @property
    def names(self) -> Sequence[str]:
        """The names of all cells, in their order."""
        return [*map(self.name, range(self.count))]

    def __str__(self) -> str:
        if self.axis.kind == "flag":
            return "no and yes"
        most = self.centre(self.count - 1)
        return f"{self.axis.with_unit(f'{self.low:g} to {most:g}')} by {self.size:g}"
