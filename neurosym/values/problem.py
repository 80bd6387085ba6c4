"""Problems of values: things with features, and what some of their values shall become."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import prod
from pathlib import Path

import msgspec
import numpy as np

from neurosym.checks import as_path
from neurosym.errors import InvalidValue, UnknownChoice, blaming
from neurosym.files import read_json, write_json
from neurosym.operators import Categorise, Length, Symbol, Versioned
from neurosym.problems import check_names
from neurosym.tasks.transition import PlanStep
from neurosym.values.domain import MOST_STATES, ValueDomain, ValueOperator

FORMAT = "neurosym-value-problem-1"
Goal = float | tuple[float, float]
"""What an axis shall become: a value, or the least and greatest of some."""

Cell = tuple[int, ...]
"""The cell of a thing on each axis."""


class Thing(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """One thing: its features, what no feature shows of it, and its category in each state that it may be in.

    States are in the order of `ValueDomain.states`.
    """

    name: str  #: What plans call it
    features: tuple[Length, ...]  #: What it is like at the start
    values: dict[str, Length] = {}  #: What it is at the start on axes that no feature shows; 0 if not said
    categories: str = ""  #: Its object symbol in each state, with blanks between


class ValueProblem(Versioned, frozen=True, omit_defaults=True):
    """Things, and goals for some of their values."""

    format: str  #: Version of its file
    name: str  #: What the problem is called, a legal PDDL name
    things: tuple[Thing, ...]  #: At least one
    goals: dict[str, dict[str, Goal]]  #: What axes of things shall become, by thing and axis
    provenance: str = "by hand"  #: How the problem came about
    readable = (FORMAT,)

    def __post_init__(self) -> None:
        super().__post_init__()
        names = [thing.name for thing in self.things]
        check_names((self.name, *names))
        if not names or len({*names}) < len(names):
            raise InvalidValue("A problem needs one thing or more, each with a name of its own.")
        if wrong := next((name for name in self.goals if name not in names), None):
            raise InvalidValue(f"There is a goal for {wrong}, which is no thing; things: {', '.join(names)}.")
        if not any(self.goals.values()):
            raise InvalidValue(f"The problem {self.name} has no goal; say what some axis shall become.")

    def save(self, path: Path) -> None:
        """Write the problem to a file."""
        write_json(as_path(path), self)


def goal_in_words(goal: Goal) -> str:
    """Say what a goal asks for, like `0.5`, or `0.4 to 0.6`."""
    return f"{goal[0]:g} to {goal[1]:g}" if isinstance(goal, tuple) else f"{goal:g}"


def _check_features(thing: Thing, domain: ValueDomain) -> None:
    if len(thing.features) != len(domain.features):
        valid = ", ".join(domain.features)
        raise InvalidValue(f"{thing.name} has {len(thing.features)} features; valid: {valid}.")


def known_to(thing: Thing, domain: ValueDomain, categorise: Categorise) -> Thing:
    """Return a thing with its category in each state that it may be in."""
    _check_features(thing, domain)
    if (count := prod(cells.count for cells in domain.shown_cells)) > MOST_STATES:
        raise InvalidValue(
            f"A thing may be in {count:,} states, by the cells of its axes; valid: {MOST_STATES:,} at most. "
            "Make some cells larger in world.toml."
        )
    states = [*domain.states()]
    symbols = categorise(domain.features_at(thing.features, states).astype(np.float32))
    return msgspec.structs.replace(thing, categories=" ".join(symbols))


@dataclass(frozen=True, eq=False)
class ValueTask:
    """A problem and a learned domain, understood once: the one transition model of values.

    Raises:
        InvalidValue: If the problem cannot be one of the domain.
        UnknownChoice: If there is a goal for an axis that there is not.
    """

    problem: ValueProblem
    domain: ValueDomain

    def __post_init__(self) -> None:
        hidden, states = self.domain.hidden, len(self._places)
        for thing in self.problem.things:
            _check_features(thing, self.domain)
            if wrong := next((name for name in thing.values if name not in hidden), None):
                valid = ", ".join(hidden) or "none"
                raise InvalidValue(
                    f"{thing.name} has a value {wrong}; valid: axes that no feature shows: {valid}."
                )
            if (known := len(self.categories[thing.name])) != states:
                raise InvalidValue(
                    f"{thing.name} has categories for {known} states, and there are {states}; make the "
                    "problem anew."
                )
        for goals in self.problem.goals.values():
            if wrong := next((name for name in goals if name not in self._numbers), None):
                raise UnknownChoice("axis", wrong, self._numbers)
        _ = self.start, self.goals

    @classmethod
    def read(cls, path: Path, domain: ValueDomain) -> "ValueTask":
        """Read a problem of a domain; `InvalidFile` if the file holds none."""
        problem = read_json(path, ValueProblem)
        with blaming(path):
            return cls(problem, domain)

    @cached_property
    def _places(self) -> Mapping[Cell, int]:
        return {state: number for number, state in enumerate(self.domain.states())}

    @cached_property
    def _numbers(self) -> Mapping[str, int]:
        return {axis.name: number for number, axis in enumerate(self.domain.axes)}

    @cached_property
    def categories(self) -> Mapping[str, Sequence[Symbol]]:
        """The category of each thing in each state, see `ValueDomain.states`."""
        return {thing.name: thing.categories.split() for thing in self.problem.things}

    @cached_property
    def start(self) -> dict[str, Cell]:
        """The cells of each thing at the start."""
        return {thing.name: self.at(thing.features, thing.values) for thing in self.problem.things}

    def at(self, features: Sequence[float], values: Mapping[str, float]) -> Cell:
        """Return the cells of a thing; `InvalidValue` if it is out of bounds."""
        along = zip(self.domain.cells, self.domain.values_of(features, values), strict=True)
        return tuple(cells.index(value) for cells, value in along)

    @cached_property
    def goals(self) -> Mapping[tuple[str, int], tuple[int, ...]]:
        """Which cells meet the goal of a thing on the axis of a number."""
        cells, numbers = self.domain.cells, self._numbers
        return {
            (thing, numbers[axis]): cells[numbers[axis]].near(goal)
            for thing, goals in sorted(self.problem.goals.items())
            for axis, goal in goals.items()
        }

    def category(self, thing: str, state: Cell) -> Symbol:
        """Return the category of a thing in a state."""
        return self.categories[thing][self._places[self.domain.of_shown(state)]]

    def apply(self, state: Cell, operator: ValueOperator) -> Cell | None:
        """Return where an operator leads from a state; None if that is out of bounds."""
        led = [
            cells.led(here, step)
            for cells, here, step in zip(self.domain.cells, state, operator.outcome.steps, strict=True)
        ]
        return None if None in led else tuple(one for one in led if one is not None)

    def refusal(self, thing: str, state: Cell, operator: ValueOperator) -> str:
        """Say why an operator is not possible in a state, or nothing if it is."""
        if (found := self.category(thing, state)) != operator.category:
            return f"{operator.name} is for {operator.category}, and {thing} is of {found} there"
        if self.apply(state, operator) is None:
            return f"{operator.name} leads {thing} out of bounds"
        return ""

    def missed(self, states: Mapping[str, Cell]) -> Iterator[str]:
        """Say which goals are not met."""
        for (thing, number), meeting in self.goals.items():
            if (here := states[thing][number]) not in meeting:
                cells = self.domain.cells[number]
                asked = goal_in_words(self.problem.goals[thing][cells.axis.name])
                value, half = cells.centre(here), cells.size / 2
                whole = f", whose cell {value - half:g} to {value + half:g} must lie in it whole"
                is_partly = isinstance(self.problem.goals[thing][cells.axis.name], tuple) and cells.meets(
                    self.problem.goals[thing][cells.axis.name], value
                )
                said = f"{thing} ends with {cells.axis.name} = {value:g}"
                yield f"{said}, not {asked}{whole if is_partly else ''}"

    def replay(self, steps: Sequence[PlanStep]) -> tuple[dict[str, Cell], str]:
        """Follow a plan; returned are the states in the end, and why it is no plan, if it is none."""
        states = dict(self.start)
        for number, step in enumerate(steps, start=1):
            if step.object not in states:
                return states, f"step {number}: there is no {step.object}"
            operator = self.domain.operator_named(step.operator)
            if said := self.refusal(step.object, states[step.object], operator):
                return states, f"step {number}: {said}"
            states[step.object] = self.apply(states[step.object], operator) or ()
        return states, next(self.missed(states), "")

    def values(self, steps: Sequence[PlanStep] = ()) -> dict[str, list[float]]:
        """Follow a plan by mean changes, and not by cells, to where each thing comes to on each axis."""
        domain = self.domain
        values = {one.name: domain.values_of(one.features, one.values) for one in self.problem.things}
        for step in steps:
            outcome = domain.operator_named(step.operator).outcome
            values[step.object] = [
                value + mean if one.to is None else cells.centre(one.to)
                for value, one, mean, cells in zip(
                    values[step.object], outcome.steps, outcome.means, domain.cells, strict=True
                )
            ]
        return values

    def strays(self, steps: Sequence[PlanStep] = ()) -> str:
        """Say which goal a plan misses by mean changes, or nothing: rounding to cells may add up."""
        values = self.values(steps)
        for thing, goals in sorted(self.problem.goals.items()):
            for value, cells in zip(values[thing], self.domain.cells, strict=True):
                goal = goals.get(cells.axis.name)
                if goal is not None and not cells.meets(goal, value):
                    return f"{thing} ends with {cells.axis.name} = {value:.4g}, not {goal_in_words(goal)}"
        return ""

    def chance(self, steps: Sequence[PlanStep]) -> float:
        """Return the chance that all steps go as promised."""
        return prod(self.domain.operator_named(step.operator).chance for step in steps)

    def begun_from(self, changed: Thing) -> "ValueTask":
        """Return the task from where a thing is now: its features, and what none shows."""
        now = tuple(changed if one.name == changed.name else one for one in self.problem.things)
        return ValueTask(msgspec.structs.replace(self.problem, things=now), self.domain)
