"""Axes: what effects are measured along, each a named value of a thing that actions change."""

import re
from collections.abc import Sequence
from typing import Any, Literal

import msgspec
import numpy as np

from neurosym.checks import Bool, Document, Float
from neurosym.errors import InvalidValue
from neurosym.operators import LegalName

AxisKind = Literal["length", "angle", "value", "flag"]
"""A *length* is anything that adds up. An *angle* does, and comes round. A *value* is set to what it is
afterwards, whatever it was before. A *flag* is a value that is 0 or 1, for no or yes."""
_MOST_CELLS = 1000  # of an axis: each is an object of PDDL
_GREATEST = 1e9


class Axis(Document, frozen=True, omit_defaults=True):
    """One axis; what is not said of it is measured on the data when a domain is compiled.

    Raises:
        InvalidValue: If there can be no such axis; the message names it.
    """

    #: What plans call it. If a feature has this name, it says what the value is before an action. Effects are
    #: changes then, of whatever kind the axis is; else they are what a value or flag is afterwards
    name: LegalName
    kind: AxisKind = "length"  #: How actions change it
    unit: str = ""  #: Unit of all its numbers
    cell: float | None = None  #: Size of its cells in PDDL; of a value, the least difference of two
    low: float | None = None  #: Least value that a plan may lead to; of an angle, where it begins
    high: float | None = None  #: Greatest value that a plan may lead to
    tolerance: float | None = None  #: How near an outcome must come to count as the one that was promised
    period: float | None = None  #: Of an angle, after how much it is the same again

    def __post_init__(self) -> None:
        super().__post_init__()
        for what, number in (("cell", self.cell), ("tolerance", self.tolerance), ("period", self.period)):
            if number is not None and not 0 < number <= _GREATEST:
                raise self._wrong(f"a {what} of {number:g}", "a number above 0")
        if (self.period is None) == (self.kind == "angle"):
            said = "no period" if self.period is None else f"a period, and is a {self.kind}"
            raise self._wrong(said, "a period for each angle, and for nothing else")
        if self.period and self.high is not None:
            raise self._wrong("a high bound, and is an angle", "where it begins, as it comes round")
        for what, number in (("cell", self.cell), ("tolerance", self.tolerance)):
            if self.period and number and number > self.period / 2:
                said = f"a {what} of {number:g}, beyond half of its period of {self.period:g}"
                raise self._wrong(said, "at most half of it")
        if self.kind == "flag" and not {self.cell, self.low, self.high, self.tolerance} <= {None}:
            raise self._wrong("a cell, bounds or a tolerance, and is a flag", "none of these for 0 and 1")
        if self.low is not None and self.high is not None and not self.low < self.high:
            raise self._wrong(f"bounds from {self.low:g} to {self.high:g}", "the first below the second")
        if self.cell and self.tolerance and self.tolerance < self.cell / 2:
            said = f"a tolerance of {self.tolerance:g}, under half of its cell of {self.cell:g}"
            raise self._wrong(said, "half a cell or more")

    def check_cells(self) -> None:
        """Raise `InvalidValue` if there is no room for a cell, or room for more than can be printed."""
        if self.cell and self.span and self.cell > self.span:
            room = f"a cell of {self.cell:g} between bounds from {self.low:g} to {self.high:g}"
            raise self._wrong(room, "bounds with room for one cell or more")
        if self.cell and self.span and self.span / self.cell > _MOST_CELLS:
            raise self._wrong(f"{self.span / self.cell:.0f} cells", f"at most {_MOST_CELLS}")

    def _wrong(self, said: str, valid: str) -> InvalidValue:
        return InvalidValue(f"The axis {self.name} has {said}; valid: {valid}.")

    @property
    def is_set(self) -> bool:
        """Whether actions set it, and do not add to it."""
        return self.kind in ("value", "flag")

    @property
    def span(self) -> float | None:
        """How far it reaches, if that is known."""
        if self.period is not None:
            return self.period
        return None if self.low is None or self.high is None else self.high - self.low

    def with_unit(self, number: str) -> str:
        """Return a number with the unit, if there is one."""
        return f"{number} {self.unit}" if self.unit else number

    def difference(
        self, after: Float[np.ndarray, "..."], before: Float[np.ndarray, "..."]
    ) -> Float[np.ndarray, "..."]:
        """Return how far values are from others, the shorter way round for an angle."""
        apart = np.asarray(after, dtype=float) - before
        return np.asarray(apart - self.period * np.round(apart / self.period) if self.period else apart)

    def are_near(
        self, values: Float[np.ndarray, "..."], others: Float[np.ndarray, "..."]
    ) -> Bool[np.ndarray, "..."]:
        """Say which values are within the tolerance of others."""
        return np.asarray(np.abs(self.difference(values, others)) <= (self.tolerance or 0.0))

    def apart(self, after: float, before: float) -> float:
        """Return how far one value is from another; see `difference`."""
        return float(self.difference(np.array(after), np.array(before)))


def axes_in(tables: Any, width: int | None = None) -> tuple[Axis, ...]:
    """Return the axes that a table in a file describes, in the order of the columns of effects.

    Args:
        tables: What a file has under `axes`.
        width: How many columns there are, if that is known.

    Raises:
        InvalidValue: If there can be no such axes, or not as many; the message names the column.
    """
    if not isinstance(tables, list | tuple):
        raise InvalidValue("axes must be a list of tables, one for each column of effects.")
    found = list[Axis]()
    for number, one in enumerate(tables):
        try:
            found.append(msgspec.convert(one, Axis))
            found[-1].check_cells()
        except msgspec.ValidationError as error:
            if isinstance(error.__cause__, InvalidValue):
                raise error.__cause__ from None
            raise InvalidValue(f"The axis of effects[:, {number}] {_problem(one, str(error))}.") from error
    names = [axis.name for axis in found]
    if doubled := next((name for name in names if names.count(name) > 1), None):
        raise InvalidValue(f"Two axes are called {doubled}; give each a name of its own.")
    if width is not None and len(found) != width:
        listed = ", ".join(names) or "none"
        raise InvalidValue(
            f"There are {len(found)} axes ({listed}), and the effects have {width} columns; name each."
        )
    return tuple(found)


_VALID = {
    "name": "a lower-case letter, then a-z, 0-9 and hyphens",
    "kind": "length, angle, value or flag",
    "unit": "text",
}  # the others are numbers


def _problem(given: Any, said: str) -> str:
    """Say what is wrong with the table of an axis, by what `msgspec` says of it."""
    if not isinstance(given, dict):
        return f'is {given!r}; valid: a table, like {{ name = "x" }}'
    if (unknown := {*given} - {*Axis.__struct_fields__}) or "name" not in given:
        wrong = f"has a {min(unknown)}" if unknown else "has no name"
        return f"{wrong}; valid: {', '.join(Axis.__struct_fields__)}"
    key = said.rpartition("$.")[2].rstrip("`")
    return f"has {key} = {given.get(key)!r}; valid: {_VALID.get(key, 'a number')}"


def as_tables(axes: Sequence[Axis]) -> list[dict[str, Any]]:
    """Return axes as files have them."""
    return [*msgspec.to_builtins(axes)]


def misfit(axis: Axis, values: Float[np.ndarray, " N"] | None, effects: Float[np.ndarray, " N"]) -> str:
    """Say what is said of an axis that its data cannot be, or nothing; `values` are what a feature shows."""
    known = effects if values is None else values
    if axis.period and values is not None and np.abs(effects).max() > 0.51 * axis.period:
        return (
            f"{axis.name} is an angle, and its effects go beyond half of its period; name the angle in "
            "--columns when the table is read, so that effects are taken the shorter way round"
        )
    if axis.kind == "flag" and not np.isin(known, (0, 1)).all():
        return f"{axis.name} is a flag, and the data have {known.min():g} to {known.max():g}; valid: 0 and 1"
    most = float(np.abs(effects).max())
    if axis.cell and not axis.is_set and axis.cell > 2 * most:
        return f"{axis.name} has a cell of {axis.cell:g}, and no effect on it is greater than {most:g}"
    low = -np.inf if axis.low is None or axis.period else axis.low
    high = np.inf if axis.high is None else axis.high
    if values is not None and np.mean((values >= low) & (values <= high)) < 0.5:
        return (
            f"{axis.name} goes from {low:g} to {high:g}, and most of the data lie outside: they go from "
            f"{values.min():g} to {values.max():g}"
        )
    return ""


def check_flags(
    axes: Sequence[Axis], effects: Float[np.ndarray, "N E"], features: Sequence[str]
) -> list[str]:
    """List effects on flags that cannot be: changes where a feature shows the flag, else 0 and 1."""
    problems = list[str]()
    for number, axis in enumerate(axes):
        valid = (-1, 0, 1) if axis.name in features else (0, 1)
        bad = ~np.isin(effects[:, number], valid) & (axis.kind == "flag")
        if bad.any():
            row = int(bad.argmax())
            said = f"effects[{row}, {number}] is {effects[row, number]:g}, on the flag {axis.name}"
            problems.append(f"{said}; valid: {', '.join(map(str, valid))}")
    return problems


def legal_name(name: str) -> str:
    """Make of the name of a column one that PDDL takes: `Speed (m/s)` becomes `speed-m-s`."""
    plain = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")
    return plain if plain[:1].isalpha() else f"a{plain}"
