"""Grounding: what is needed to plan with a learned domain and to turn plans back into motions."""

import math
from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated, TypeVar

import msgspec

from neurosym.checks import as_path, check_length
from neurosym.errors import InvalidValue, UnknownChoice, quoted
from neurosym.files import MOST_JSON, read_bytes, write_json
from neurosym.operators import (
    MIN_CHANCE,
    MIN_TRIALS,
    Category,
    Effect,
    LegalName,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Symbol,
    Vector,
    Versioned,
    counted_axes,
)
from neurosym.pair_operators import (
    NEVER_CARRIES,
    Company,
    Kept,
    PairState,
    PlaceOperators,
    RelationOperator,
    RelationOperators,
)
from neurosym.problems import FORMER_SUFFIX
from neurosym.regression import remember_fits
from neurosym.world import Table

# Displacements in space, and in whole cells of a grid

Cells = tuple[int, int, int]
"""A displacement along x, y and z in whole cells."""


def _in_space(effect: Effect) -> Vector:
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


def _remainder(displacement: Vector, cell: float) -> Vector:
    """Return by how much a displacement is off in whole cells, on each axis [m]."""
    rows = zip(displacement, in_cells(displacement, cell), strict=True)
    x, y, z = (abs(part - cell * whole) for part, whole in rows)
    return (x, y, z)


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
_Size = Annotated[float, msgspec.Meta(ge=1e-6, le=1e3)]  # [m]
_REMEMBERED = 8  # groundings of which what follows from them is kept: each object of a problem asks for it


class Grounding(Versioned, frozen=True, omit_defaults=True, cache_hash=True):
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
    readable = FORMATS

    def __post_init__(self) -> None:
        super().__post_init__()
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
        """All operators on single objects, those that carry them to places last."""
        return self.operators.operators + (self.places.operators.operators if self.places else ())

    @property
    def carriers(self) -> tuple[Operator, ...]:
        """The operators of the domain that carry objects to places, by name."""
        found = self.places.operators.operators if self.places else ()
        return tuple(sorted((one for one in found if one.successes), key=lambda one: one.name))

    def carries(self, operator: Operator) -> bool:
        """Say whether an operator is one of those that carry objects to places."""
        found = self.places.operators.operators if self.places else ()
        return any(one.name == operator.name for one in found)

    def operator_named(self, name: str) -> Operator:
        """Return the operator on single objects of that name.

        Raises:
            UnknownChoice: If there is none.
        """
        known = [one.name for one in self.relations.operators] if self.relations else []
        return _chosen("operator", name, "name", self.every_operator, known)

    def operator_for(self, category: Symbol, primitive: Symbol) -> Operator | None:
        """Return what a primitive mostly does to a category, with its surest action; None if never tried."""
        asked = (category, primitive)
        return next((op for op in self.operators.operators if (op.category, op.primitive) == asked), None)

    def relation_named(self, name: str) -> RelationOperator | None:
        """Return what puts objects in relations to one another by that name, or None if there is none."""
        found = self.relations.every_operator if self.relations else ()
        return next((one for one in found if one.name == name.removesuffix(FORMER_SUFFIX)), None)

    def primitive(self, label: str) -> Primitive:
        """Return the primitive of that label: an action symbol, and a letter if the symbol has several.

        Raises:
            UnknownChoice: If there is none.
        """
        return _chosen("primitive", label, "label", self.operators.primitives)

    def primitive_of(self, operator: Operator | RelationOperator) -> Primitive:
        """Return the primitive that an operator is performed with."""
        if isinstance(operator, RelationOperator):
            assert self.relations is not None, "the operator is one of its own"
            return self.relations.primitive_of(operator)
        if self.places is None or not self.carries(operator):
            return self.primitive(operator.label)
        return next(one for one in self.places.operators.primitives if one.label == operator.label)

    @property
    def bearing_states(self) -> tuple[PairState, ...]:
        """The states in which a reference bears its target, in the order of their symbols."""
        return tuple(state for state in self.relations.states if state.bears) if self.relations else ()

    def company(self, operator: Operator | RelationOperator) -> Mapping[Company, Kept]:
        """Return how an operator turned out among others, as far as that was rehearsed."""
        if isinstance(operator, RelationOperator):
            return operator.company
        return self.places.company(operator.name) if self.places else {}

    def takes(self, operator: Operator | RelationOperator, how: Company) -> bool:
        """Say whether an operator is planned with in company, by what rehearsals showed."""
        if isinstance(operator, RelationOperator):
            return operator.takes(how)
        return self.places is not None and self.places.takes(operator.name, how)

    def category(self, symbol: Symbol) -> Category:
        """Return the category with that object symbol.

        Raises:
            UnknownChoice: If there is none.
        """
        return _chosen("category", symbol, "symbol", self.operators.categories)

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
        return _in_space(promise.effect) if promise.kind == "held" else at_rest(promise)

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
        resting = in_cells(_in_space(_promise(operator).resting_effect), self.cell)
        return (resting[0] - x, resting[1] - y, -z)

    def rounding(self, operator: Operator) -> Vector:
        """Return how far a step of a plan can err on each axis because of the grid, put down or not [m].

        Args:
            operator: An operator with a promise.
        """
        led = (self.displacement(operator), at_rest(_promise(operator)))
        x, y, z = map(max, *(_remainder(by, self.cell) for by in led))
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
    grounding = Grounding.decoded(path, content, remedy)
    remember_fits(path, content, grounding.every_operator, grounding.operators.categories)
    return grounding


_Named = TypeVar("_Named")


def _chosen(
    kind: str, name: str, called: str, known: Sequence[_Named], others: Collection[str] = ()
) -> _Named:
    """Return the first whose attribute says that name; an error names the others, too."""
    for one in known:
        if getattr(one, called) == name:
            return one
    choices = (*(getattr(one, called) for one in known), *others)
    raise UnknownChoice(kind, name, choices, "`neurosym explain`" if kind == "operator" else "")


@lru_cache(maxsize=_REMEMBERED)
def _live(grounding: Grounding) -> tuple[Operator, ...]:
    found = (op for op in grounding.operators.operators if grounding.why_left_out(op) is None)
    return tuple(sorted(found, key=lambda operator: operator.name))


@lru_cache(maxsize=_REMEMBERED)
def _duplicates(grounding: Grounding) -> dict[str, str]:
    """Say of each operator that does the same as a more reliable one, which one that is and how they compare.

    A planner needs one of them, and a reader, too. The same means: to the same category, with the same kind
    of promise, and with displacements that differ by less than half a cell on every axis. Of equally reliable
    operators the first by name is kept.
    """
    if grounding.format in KEEP_DUPLICATES:
        return {}
    kept = defaultdict[tuple[str, str], list[tuple[Operator, tuple[float, ...]]]](list)
    reasons = {}
    worthy = (op for op in grounding.operators.operators if grounding._why_worthless(op) is None)
    for operator in sorted(worthy, key=lambda one: (-one.chance, one.name)):
        promise = _promise(operator)
        own = (*grounding.displacement(operator), *(at_rest(promise) if is_lift(operator) else ()))
        others = kept[operator.category, promise.kind]
        other = next((other for other, its in others if _alike(own, its, grounding.cell / 2)), None)
        if other is None:
            others.append((operator, own))
        else:
            how = "less" if operator.chance < other.chance else "as"
            reasons[operator.name] = f"does the same as {other.name}, {how} reliably"
    return reasons


def _alike(one: Sequence[float], other: Sequence[float], apart: float) -> bool:
    return all(abs(a - b) < apart for a, b in zip(one, other, strict=True))


def is_lift(operator: Operator) -> bool:
    """Say whether an operator promises to end with the object held."""
    return operator.promise is not None and operator.promise.kind == "held"


def _promise(operator: Operator) -> Mode:
    assert operator.promise is not None, f"{operator.name} promises nothing"
    return operator.promise
