"""Grounding: what is needed to plan with a learned domain and to turn plans back into motions."""

import math
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated

import msgspec

from neurosym.checks import as_path, check_fields, check_length
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice, quoted
from neurosym.files import MOST_JSON, decode_json, read_bytes, write_json
from neurosym.operators import (
    MIN_CHANCE,
    Category,
    Effect,
    LegalName,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Symbol,
    Vector,
    counted_axes,
    unknown_format,
)
from neurosym.pair_operators import NEVER_CARRIES, PlaceOperators, RelationOperators
from neurosym.regression import remember_fits
from neurosym.world import Table

# Displacements in space, and in whole cells of a grid

Cells = tuple[int, int, int]
"""A displacement along x, y and z in whole cells."""


def in_space(effect: Effect) -> Vector:
    """Return an effect along x, y and z as a vector [m]."""
    x, y, z = effect
    return (x, y, z)


def at_rest(promise: Mode) -> Vector:
    """Return where a promise to end upright brings the object: it keeps its height [m]."""
    x, y, _ = promise.resting_effect
    return (x, y, 0.0)


def in_cells(displacement: Vector, cell: float) -> Cells:
    """Round a displacement to whole cells, halves away from zero.

    Args:
        displacement: The displacement [m].
        cell: Edge of a cell [m].
    """
    x, y, z = (int(math.copysign(math.floor(abs(part) / cell + 0.5), part)) for part in displacement)
    return (x, y, z)


def remainder(displacement: Vector, cells: Cells, cell: float) -> Vector:
    """Return by how much a displacement in whole cells is off, on each axis [m].

    Args:
        displacement: The displacement [m].
        cells: The same in cells.
        cell: Edge of a cell [m].
    """
    x, y, z = (abs(part - cell * whole) for part, whole in zip(displacement, cells, strict=True))
    return (x, y, z)


# Operators that do the same as another: a planner needs one of them, and a reader, too.
#
# Many action symbols share what can be done among them, so some do the same to a category.


def find_duplicates(
    operators: Iterable[Operator], moves: Callable[[Operator], Sequence[Vector]], apart: float
) -> dict[str, str]:
    """Say of each operator that does the same as a more reliable one, which one that is and how they compare.

    The same means: to the same category, with the same kind of promise, and with displacements that differ
    by less than `apart` on every axis. Of equally reliable operators the first by name is kept.

    Args:
        operators: Operators with a promise.
        moves: Returns the displacements that an operator promises [m].
        apart: From which difference on displacements are not the same [m].

    Returns:
        Reasons to leave operators out, by their names.
    """
    kept = defaultdict[tuple[str, str], list[tuple[Operator, Sequence[Vector]]]](list)
    reasons = {}
    for operator in sorted(operators, key=lambda one: (-_reliability(one), one.name)):
        promise, own = operator.promise, moves(operator)
        assert promise is not None, f"{operator.name} promises nothing"
        others = kept[operator.category, promise.kind]
        other = next((other for other, its in others if _alike(own, its, apart)), None)
        if other is None:
            others.append((operator, own))
        else:
            how = "less" if _reliability(operator) < _reliability(other) else "as"
            reasons[operator.name] = f"does the same as {other.name}, {how} reliably"
    return reasons


def _reliability(operator: Operator) -> float:
    return (operator.successes + 1) / (
        operator.trials + 2
    )  # the mean chance of success, after so many trials


def _alike(one: Sequence[Vector], other: Sequence[Vector], apart: float) -> bool:
    return all(
        abs(a - b) < apart
        for mine, its in zip(one, other, strict=True)
        for a, b in zip(mine, its, strict=True)
    )


# Grounding: what is needed to plan with a learned domain and to turn plans back into motions.
#
# It is the table of operators together with the grid that the PDDL text is printed on. No neural network is
# needed beyond this point. It is stored as `grounding.json`, next to the domain.

FORMATS = tuple(f"neurosym-grounding-{number}" for number in range(1, 5))
"""Versions of groundings that can be read; the second knows operators with parameters of their own, the third
what carries objects to places, the fourth what puts them in relations to one another."""
FORMAT, FORMAT_WITH_PLACES, FORMAT_WITH_RELATIONS = FORMATS[1:]
KEEP_DUPLICATES = FORMATS[:1]
"""Formats whose domains have every operator, also where another does the same more reliably."""
MIN_TRIALS = 5
"""An operator with fewer rehearsals, or rows of the data, than this is not believed."""
_Size = Annotated[float, msgspec.Meta(ge=1e-6, le=1e3)]  # [m]
_REMEMBERED = 8  # groundings of which what follows from them is kept: each object of a problem asks for it


class Grounding(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, cache_hash=True):
    """Everything that planning, replay and execution know of a learned domain.

    Attributes:
        format: Version of this file.
        name: Name of the PDDL domain.
        cell: Edge of a grid cell [m].
        table: Where objects may stand [m].
        lift_height: How far the hand rises after the last waypoint [m].
        operators: The table of operators.
        unit_costs: Whether every step costs the same, instead of the more the rarer it goes well.
        places: What carries objects to places, if that was learned.
        relations: What puts objects in relations to one another, if that was learned.
    """

    format: str
    name: LegalName
    cell: _Size
    table: Table
    lift_height: _Size
    operators: OperatorTable
    unit_costs: bool = False
    places: PlaceOperators | None = None
    relations: RelationOperators | None = None

    def __post_init__(self) -> None:
        check_fields(self)
        for name in ("cell", "lift_height"):
            check_length(name, getattr(self, name))
        if self.operators.axes != 3:
            axes = counted_axes(self.operators.axes)
            raise InvalidValue(f"The effects of a grounding have {axes}; valid: x, y and z.")

    def save(self, path: Path) -> None:
        """Write the grounding to a file, `grounding.json` by custom."""
        write_json(as_path(path), self)

    @classmethod
    def load(cls, path: Path) -> "Grounding":
        """Read a grounding.

        Raises:
            InvalidFile: If the file is none, or of another version.
        """
        path = as_path(path)
        return _decoded(path, read_bytes(path, MOST_JSON))

    @property
    def every_operator(self) -> tuple[Operator, ...]:
        """All operators, those that carry objects to places last."""
        return self.operators.operators + (self.places.operators.operators if self.places else ())

    def carries(self, operator: Operator) -> bool:
        """Say whether an operator is one of those that carry objects to places."""
        return self.places is not None and operator.name in {
            one.name for one in self.places.operators.operators
        }

    def operator_named(self, name: str) -> Operator:
        """Return the operator of that name.

        Raises:
            UnknownChoice: If there is none.
        """
        for operator in self.every_operator:
            if operator.name == name:
                return operator
        known = [operator.name for operator in self.every_operator]
        known += [operator.name for operator in self.relations.operators] if self.relations else []
        raise UnknownChoice("operator", name, known, "`neurosym explain`")

    def operator_for(self, category: Symbol, primitive: Symbol) -> Operator | None:
        """Return what a primitive mostly does to a category, or None if that was never rehearsed.

        If it has several actions for that category, it is done with the surest.
        """
        for operator in self.operators.operators:
            if (operator.category, operator.primitive) == (category, primitive):
                return operator
        return None

    def primitive(self, label: str) -> Primitive:
        """Return the primitive of that label: an action symbol, and a letter if the symbol has several.

        Raises:
            UnknownChoice: If there is none.
        """
        for primitive in self.operators.primitives:
            if primitive.label == label:
                return primitive
        raise UnknownChoice("primitive", label, (p.label for p in self.operators.primitives))

    def primitive_of(self, operator: Operator) -> Primitive:
        """Return the primitive that an operator is performed with."""
        if self.places is None or not self.carries(operator):
            return self.primitive(operator.label)
        return next(one for one in self.places.operators.primitives if one.label == operator.label)

    def category(self, symbol: Symbol) -> Category:
        """Return the category with that object symbol.

        Raises:
            UnknownChoice: If there is none.
        """
        for category in self.operators.categories:
            if category.symbol == symbol:
                return category
        raise UnknownChoice("category", symbol, (c.symbol for c in self.operators.categories))

    def narrowed(self, categories: Collection[Symbol]) -> "Grounding":
        """Keep only what is done to objects of some categories, so that planners have less to read."""
        kept = tuple(op for op in self.operators.operators if op.category in categories)
        return msgspec.structs.replace(
            self, operators=msgspec.structs.replace(self.operators, operators=kept)
        )

    @property
    def live(self) -> tuple[Operator, ...]:
        """The operators that the PDDL domain has actions for, by name."""
        return _live(self)

    @property
    def is_refined(self) -> bool:
        """Whether rehearsals are kept, so that objects of one category are promised different things."""
        return self.places is not None or any(operator.rehearsals for operator in self.live)

    @property
    def left_out(self) -> dict[str, str]:
        """Why each of the other operators has none, by name."""
        reasons = {operator.name: self.why_left_out(operator) for operator in self.operators.operators}
        return {name: reason for name, reason in sorted(reasons.items()) if reason is not None}

    def why_left_out(self, operator: Operator) -> str | None:
        """Say why an operator is not in the PDDL domain, or return None if it is."""
        if self.carries(operator):
            return None if operator.successes else NEVER_CARRIES
        return self._why_worthless(operator) or _duplicates(self).get(operator.name)

    def _why_worthless(self, operator: Operator) -> str | None:
        """Say why an operator is not worth planning with, whatever others there are; None if it is."""
        toppled = sum(mode.count for mode in operator.modes if mode.kind == "toppled")
        if operator.trials < MIN_TRIALS:
            return f"fewer than {MIN_TRIALS} {self.operators.trials}"
        if operator.successes < MIN_CHANCE * operator.trials and 2 * toppled > operator.trials:
            return "topples more often than not"
        if operator.promise is None:
            return "never ends at rest or held"
        if operator.successes < MIN_CHANCE * operator.trials:
            trials = f"{operator.trials} {self.operators.trials}"
            return f"keeps its promise in {operator.successes} of {trials} only"
        if self.cells(operator) == (0, 0, 0):
            return "moves less than half a cell"
        by_object = bool(operator.rehearsals)  # then it is for each object to say, see `promises`
        if not by_object and math.hypot(*self.displacement(operator)) < math.hypot(
            *_promise(operator).scatter
        ):
            return "scatters more than it moves"
        return None

    def displacement(self, operator: Operator) -> Vector:
        """Return what an operator promises [m].

        An object that comes to rest upright keeps its height: the world guarantees that.

        Args:
            operator: An operator with a promise.
        """
        promise = _promise(operator)
        return in_space(promise.effect) if promise.kind == "held" else at_rest(promise)

    def put_down_displacement(self, operator: Operator) -> Vector:
        """Return how putting the object down again moves it [m], back to its height above the table.

        Args:
            operator: An operator that promises to end held.
        """
        promise = _promise(operator)
        x, y, z = promise.effect
        return (promise.resting_effect[0] - x, promise.resting_effect[1] - y, -z)

    def cells(self, operator: Operator) -> Cells:
        """Return what an operator promises, in whole cells."""
        return in_cells(self.displacement(operator), self.cell)

    def put_down_cells(self, operator: Operator) -> Cells:
        """Return how putting down moves the object, in whole cells, such that no rounding adds up."""
        x, y, z = self.cells(operator)
        resting = in_cells(in_space(_promise(operator).resting_effect), self.cell)
        return (resting[0] - x, resting[1] - y, -z)

    def rounding(self, operator: Operator) -> Vector:
        """Return how far a step of a plan can err on each axis because of the grid, put down or not [m].

        Args:
            operator: An operator with a promise.
        """
        step = remainder(self.displacement(operator), self.cells(operator), self.cell)
        resting = at_rest(_promise(operator))
        put_down = remainder(resting, in_cells(resting, self.cell), self.cell)
        x, y, z = map(max, step, put_down)
        return (x, y, z)

    def highest(self, operator: Operator) -> int:
        """Return how far up an operator can lead whichever object of its category, in whole cells.

        Args:
            operator: An operator with a promise.
        """
        highest = self.cells(operator)[2]
        if not is_lift(operator):
            return highest
        seen = [row.effect[2] for row in operator.rehearsals if row.kind == "held"]
        return max(highest, in_cells((0.0, 0.0, max(seen)), self.cell)[2]) if seen else highest


@lru_cache(maxsize=2)
def _decoded(path: Path, content: bytes) -> Grounding:
    """Return the grounding that a file holds; the same one while it holds the same."""
    remedy = f"; `neurosym compile-domain {quoted(path.parent)}` writes it anew"
    try:
        grounding = decode_json(path, content, Grounding, remedy)
    except InvalidFile:
        _check_format(path, decode_json(path, content, _Versioned, remedy).format, remedy)
        raise
    _check_format(path, grounding.format, remedy)
    remember_fits(path, content, grounding.every_operator, grounding.operators.categories)
    return grounding


def _check_format(path: Path, found: str, remedy: str) -> None:
    if found not in FORMATS:
        raise InvalidFile(path, unknown_format(found, FORMATS) + remedy)


@lru_cache(maxsize=_REMEMBERED)
def _live(grounding: Grounding) -> tuple[Operator, ...]:
    found = (op for op in grounding.operators.operators if grounding.why_left_out(op) is None)
    return tuple(sorted(found, key=lambda operator: operator.name))


@lru_cache(maxsize=_REMEMBERED)
def _duplicates(grounding: Grounding) -> dict[str, str]:
    """Say why operators are left out that do the same as another, by name."""
    if grounding.format in KEEP_DUPLICATES:
        return {}

    def moves(operator: Operator) -> tuple[Vector, ...]:
        down = (at_rest(_promise(operator)),) if is_lift(operator) else ()
        return (grounding.displacement(operator), *down)

    worthy = (op for op in grounding.operators.operators if grounding._why_worthless(op) is None)
    return find_duplicates(worthy, moves, grounding.cell / 2)


class _Versioned(msgspec.Struct, frozen=True):
    format: str


def is_lift(operator: Operator) -> bool:
    """Say whether an operator promises to end with the object held."""
    return operator.promise is not None and operator.promise.kind == "held"


def _promise(operator: Operator) -> Mode:
    assert operator.promise is not None, f"{operator.name} promises nothing"
    return operator.promise
