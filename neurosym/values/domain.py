"""A learned domain of values: its axes cut into cells, and what each action symbol does in these.

An outcome is a step along each axis: so many cells, to one cell, or none. Where features show values, the
category of a thing changes with them, and each state of a thing has its own.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import TypeVar

import numpy as np

from neurosym.checks import Document, Float
from neurosym.data.axes import Axis, legal_name
from neurosym.data.cells import Cells, Step
from neurosym.errors import one_called
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
_Any = TypeVar("_Any")
MOST_STATES = 20_000
"""So many states a thing may be in at most, counted by the axes that features show."""


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

    def __post_init__(self) -> None:
        super().__post_init__()
        for axis in self.axes:
            axis.check_cells()

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
        return self.of_shown(self.cells)

    def of_shown(self, along: Sequence[_Any]) -> tuple[_Any, ...]:
        """Return what belongs to the axes that features show, of something for each axis."""
        return tuple(one for one, by in zip(along, self.shown, strict=True) if by is not None)

    @property
    def hidden(self) -> tuple[str, ...]:
        """The names of the axes that no feature shows."""
        return tuple(axis.name for axis, by in zip(self.axes, self.shown, strict=True) if by is None)

    def values_of(self, features: Sequence[float], hidden: Mapping[str, float]) -> list[float]:
        """Return what a thing is along the axes: by its features where these show it, else as said, or 0."""
        shown = zip(self.axes, self.shown, strict=True)
        return [hidden.get(axis.name, 0.0) if by is None else features[by] for axis, by in shown]

    def in_words(self, operator: ValueOperator) -> str:
        """Say what an operator does in units of the data, like `temperature +1.98 C, window becomes yes`."""
        said = list[str]()
        outcome = operator.outcome
        for cells, step, mean in zip(self.cells, outcome.steps, outcome.means, strict=True):
            if step.to is not None:
                said.append(f"{cells.axis.name} becomes {cells.in_words(step.to)}")
            elif not step.stays:
                said.append(cells.axis.with_unit(f"{cells.axis.name} {mean:+.3g}"))
        return ", ".join(said)

    def operator_named(self, name: str) -> ValueOperator:
        """Return the operator of that name; `UnknownChoice` if there is none."""
        return one_called("operator", name, self.operators)

    def category(self, symbol: Symbol) -> Category:
        """Return the category of a symbol; `UnknownChoice` if there is none."""
        return one_called("category", symbol, self.categories, by="symbol")

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
        shown = zip(self.of_shown(self.shown), self.shown_cells, strict=True)
        for number, (by, cells) in enumerate(shown):
            found[:, by] = [cells.centre(state[number]) for state in states]
        return found


def shown_by(axes: Sequence[Axis], features: Sequence[str]) -> tuple[int | None, ...]:
    """Return which feature shows each axis, by its name; None where none does."""
    names = [legal_name(name) for name in features]
    return tuple(names.index(axis.name) if axis.name in names else None for axis in axes)
