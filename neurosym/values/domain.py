"""A learned domain of values: its axes cut into cells, and what each action symbol does in these.

An outcome is a step along each axis: so many cells, to one cell, or none. Where features show values, the
category of a thing changes with them, and each state of a thing has its own.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from neurosym.checks import Document, Float
from neurosym.data.axes import Axis, legal_name
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import (
    Category,
    Count,
    LegalName,
    Primitive,
    Share,
    Symbol,
    Versioned,
    labelled,
    smoothed,
)

FORMAT = "neurosym-values-1"
MOST_STATES = 20_000
"""So many states a thing may be in at most, counted by the axes that features show."""


class Step(Document, frozen=True, omit_defaults=True):
    """What an outcome does along one axis: so many cells, or to one cell; it stays if neither."""

    by: int = 0  # so many cells
    to: int | None = None  # to the cell of that number

    @property
    def stays(self) -> bool:
        """Whether it does nothing."""
        return not self.by and self.to is None


class Cells:
    """The cells of an axis of which everything is known."""

    def __init__(self, axis: Axis):
        self.axis = axis
        if axis.kind == "flag":
            self.low, self.size, self.count = 0.0, 1.0, 2
        elif axis.period is not None:
            self.count = max(2, round(axis.period / (axis.cell or axis.period)))
            self.low, self.size = axis.low or 0.0, axis.period / self.count
        else:
            self.low, self.size = axis.low or 0.0, axis.cell or 1.0
            self.count = math.floor((axis.span or 1.0) / self.size + 1e-6) + 1

    def index(self, value: float) -> int:
        """Return the cell of a value; `InvalidValue` if it lies outside of the bounds."""
        number = round((value - self.low) / self.size)
        if self.axis.period is not None:
            return number % self.count
        if not 0 <= number < self.count:
            least, most = self.low, self.low + (self.count - 1) * self.size
            raise InvalidValue(
                f"{self.axis.name} = {value:g} lies out of bounds; valid: {least:g} to {most:g}."
            )
        return number

    def clipped(self, value: float) -> int:
        """Return the cell that is nearest to a value."""
        number = round((value - self.low) / self.size)
        return number % self.count if self.axis.period is not None else min(max(number, 0), self.count - 1)

    def centre(self, number: int) -> float:
        """Return the value in the middle of a cell."""
        return self.low + number * self.size

    def led(self, here: int, step: Step) -> int | None:
        """Return where a step leads from a cell; None if that is out of bounds."""
        if step.to is not None:
            return step.to
        there = here + step.by
        if self.axis.period is not None:
            return there % self.count
        return there if 0 <= there < self.count else None

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
        """Name a cell, like `speed12`, or `open-yes` for a flag."""
        said = ("-no", "-yes")[number] if self.axis.kind == "flag" else str(number)
        return f"{self.axis.name}{'-' * self.axis.name[-1].isdigit() if said[0] != '-' else ''}{said}"

    def step_name(self, step: Step) -> str:
        """Name a step, like `speed-by-m3`, `gear-to-2` or `speed-by-0`."""
        if step.to is not None:
            return f"to-{self.name(step.to)}"
        return f"{self.axis.name}-by-{step.by}".replace("--", "-m")

    def __str__(self) -> str:
        unit = f" {self.axis.unit}" if self.axis.unit else ""
        if self.axis.kind == "flag":
            return "no and yes"
        most = self.low + (self.count - 1) * self.size
        return f"{self.low:g} to {most:g}{unit} by {self.size:g}"


class Outcome(Document, frozen=True):
    """One way that an action turns out on a category."""

    steps: tuple[Step, ...]  # what it does along each axis, in cells
    count: Count  # how many trials ended so
    share: Share  # the same as a share of all trials
    means: tuple[float, ...]  # by how much the value on each axis changed, in the mean; 0 where it is set


class ValueOperator(Document, frozen=True, omit_defaults=True):
    """What one action does to the things of one category, if it turns out in one of its ways."""

    name: LegalName  #: Unique in the domain
    category: Symbol  #: Symbol of the category that the thing must be of
    primitive: Symbol  #: Symbol of the action
    trials: Count  #: How often it was tried, or rows of the data
    outcome: Outcome  #: What it promises
    variant: str = ""  #: Which of the parameters of its symbol it is performed with

    @property
    def label(self) -> str:
        """The action symbol and the variant."""
        return self.primitive + self.variant

    @property
    def chance(self) -> float:
        """The chance that it turns out so."""
        return smoothed(self.outcome.count, self.trials)

    @property
    def cost(self) -> int:
        """What it costs in a plan."""
        return 1 + round(-100 * math.log(self.chance))


class ValueDomain(Versioned, frozen=True, omit_defaults=True):
    """Everything that planning, replay and execution know of a learned domain of values."""

    format: str  #: Version of its file
    name: LegalName  #: Name of the PDDL domain
    features: tuple[str, ...]  #: Names of the features of a thing
    axes: tuple[Axis, ...]  #: All is known of each
    categories: tuple[Category, ...]  #: In the order of their symbols
    primitives: tuple[Primitive, ...]  #: Parameters of the action symbols
    operators: tuple[ValueOperator, ...]  #: All that was seen often enough, by name
    readable = (FORMAT,)

    @property
    def cells(self) -> tuple[Cells, ...]:
        """The cells of each axis."""
        return tuple(map(Cells, self.axes))

    @property
    def shown(self) -> tuple[int | None, ...]:
        """Which feature shows each axis; None where none does."""
        return shown_by(self.axes, self.features)

    @property
    def shown_cells(self) -> tuple[Cells, ...]:
        """The cells of the axes that features show, which a state of a thing is made of."""
        return tuple(cells for cells, by in zip(self.cells, self.shown, strict=True) if by is not None)

    def told(self, operator: ValueOperator) -> str:
        """Say what an operator does, like `speed-by-2, to-open-yes`."""
        pairs = zip(self.cells, operator.outcome.steps, strict=True)
        return ", ".join(cells.step_name(step) for cells, step in pairs if not step.stays)

    def in_words(self, operator: ValueOperator) -> str:
        """Say what an operator does in units of the data, like `temperature +1.98 C, window becomes yes`."""
        said = list[str]()
        outcome = operator.outcome
        for cells, step, mean in zip(self.cells, outcome.steps, outcome.means, strict=True):
            name, unit = cells.axis.name, f" {cells.axis.unit}" if cells.axis.unit else ""
            if step.to is not None:
                is_flag = cells.axis.kind == "flag"
                said.append(
                    f"{name} becomes {('no', 'yes')[step.to] if is_flag else f'{cells.centre(step.to):g}'}"
                )
            elif not step.stays:
                said.append(f"{name} {mean:+.3g}{unit}")
        return ", ".join(said)

    def operator_named(self, name: str) -> ValueOperator:
        """Return the operator of that name; `UnknownChoice` if there is none."""
        if found := next((one for one in self.operators if one.name == name), None):
            return found
        raise UnknownChoice("operator", name, (one.name for one in self.operators))

    def category(self, symbol: Symbol) -> Category:
        """Return the category of a symbol; `UnknownChoice` if there is none."""
        if found := next((one for one in self.categories if one.symbol == symbol), None):
            return found
        raise UnknownChoice("category", symbol, (one.symbol for one in self.categories))

    def primitive_of(self, operator: ValueOperator) -> Primitive:
        """Return what an operator is performed with."""
        return labelled(self.primitives, operator.label)

    def states(self) -> Iterator[tuple[int, ...]]:
        """List the cells that shown axes can have together, the last one running first."""
        yield from product(*(range(cells.count) for cells in self.shown_cells))

    def features_at(
        self, features: Sequence[float], states: Sequence[Sequence[int]]
    ) -> Float[np.ndarray, "S F"]:
        """Return the features that a thing would have in some states, see `states`."""
        found = np.tile(np.array(features, dtype=float), (len(states), 1))
        columns = [(by, cells) for by, cells in zip(self.shown, self.cells, strict=True) if by is not None]
        for number, (by, cells) in enumerate(columns):
            found[:, by] = [cells.centre(state[number]) for state in states]
        return found


def shown_by(axes: Sequence[Axis], features: Sequence[str]) -> tuple[int | None, ...]:
    """Return which feature shows each axis, by its name; None where none does."""
    names = [legal_name(name) for name in features]
    return tuple(names.index(axis.name) if axis.name in names else None for axis in axes)
