"""Grounding: what is needed to plan with a learned domain and to turn plans back into motions."""

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np

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
    vector,
)
from neurosym.pair_operators import (
    LEAST_SHARE,
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

Cells = tuple[int, int, int]  # a displacement along x, y and z in whole cells of a grid


def at_rest(promise: Mode) -> Vector:
    """Return where a promise to end upright brings the object: it keeps its height [m]."""
    x, y, _ = promise.resting_effect
    return (x, y, 0.0)


def in_cells(displacement: Effect, cell: float) -> Cells:
    """Round a displacement to whole cells of some edge [both m], halves away from zero."""
    x, y, z = (int(math.copysign(math.floor(abs(part) / cell + 0.5), part)) for part in displacement)
    return (x, y, z)


# What is needed to plan with a learned domain is the table of operators, and the grid that the PDDL text is
# printed on; no neural network. It is stored as `grounding.json`, next to the domain.

FORMATS = tuple(f"neurosym-grounding-{number}" for number in range(1, 5))
"""Versions of groundings that can be read; the second knows operators with parameters of their own, the third
what carries objects to places, the fourth what puts them in relations to one another."""
FORMAT, FORMAT_WITH_PLACES, FORMAT_WITH_RELATIONS = FORMATS[1:]
_Size = Annotated[float, msgspec.Meta(ge=1e-6, le=1e3)]  # [m]
_REMEMBERED = 8  # groundings of which what follows from them is kept: each object of a problem asks for it


class Grounding(Versioned, frozen=True, omit_defaults=True, cache_hash=True):
    """Everything that planning, replay and execution know of a learned domain."""

    format: str  #: Version of this file
    name: LegalName  #: Name of the PDDL domain
    cell: _Size  #: Edge of a grid cell [m]
    table: Table  #: Where objects may stand [m]
    lift_height: _Size  #: How far the hand rises after the last waypoint [m]
    operators: OperatorTable  #: The table of operators
    unit_costs: bool = False  #: Whether every step costs the same, instead of the more the rarer it goes well
    places: PlaceOperators | None = None  #: What carries objects to places, if that was learned
    #: What puts objects in relations to one another, if that was learned
    relations: RelationOperators | None = None
    readable = FORMATS

    def __post_init__(self) -> None:
        super().__post_init__()
        check_length("cell", self.cell)
        check_length("lift_height", self.lift_height)
        if self.operators.axes != 3:
            axes = counted_axes(self.operators.axes)
            raise InvalidValue(f"The effects of a grounding have {axes}; valid: x, y and z.")

    def save(self, path: Path) -> None:
        """Write the grounding to a file, `grounding.json` by custom."""
        write_json(as_path(path), self)

    @classmethod
    def load(cls, path: Path) -> "Grounding":
        """Read a grounding; `InvalidFile` if the file is none, or of another version."""
        path = as_path(path)
        return _decoded(path, read_bytes(path, MOST_JSON))

    @property
    def _on_places(self) -> tuple[Operator, ...]:
        return self.places.operators.operators if self.places else ()

    @property
    def every_operator(self) -> tuple[Operator, ...]:
        """All operators on single objects, those that carry them to places last."""
        return self.operators.operators + self._on_places

    @property
    def carriers(self) -> tuple[Operator, ...]:
        """The operators of the domain that carry objects to places, by name."""
        return tuple(sorted((one for one in self._on_places if one.successes), key=lambda one: one.name))

    def carries(self, operator: Operator) -> bool:
        """Say whether an operator is one of those that carry objects to places."""
        return any(one.name == operator.name for one in self._on_places)

    def operator_named(self, name: str) -> Operator:
        """Return the operator on single objects of that name; `UnknownChoice` if there is none."""
        if found := next((one for one in self.every_operator if one.name == name), None):
            return found
        names = [one.name for one in self.every_operator]
        names += [one.name for one in self.relations.operators] if self.relations else []
        raise UnknownChoice("operator", name, names, "`neurosym explain`")

    def operator_for(self, category: Symbol, primitive: Symbol) -> Operator | None:
        """Return what a primitive mostly does to a category, with its surest action; None if never tried."""
        asked = (category, primitive)
        return next((op for op in self.operators.operators if (op.category, op.primitive) == asked), None)

    def relation_named(self, name: str) -> RelationOperator | None:
        """Return what puts objects in relations to one another by that name, or None if there is none."""
        found = self.relations.every_operator if self.relations else ()
        return next((one for one in found if one.name == name.removesuffix(FORMER_SUFFIX)), None)

    def primitive(self, label: str) -> Primitive:
        """Return the primitive of that label, like "101b" or "101"; `UnknownChoice` if there is none."""
        return _labelled(self.operators.primitives, label)

    def primitive_of(self, operator: Operator | RelationOperator) -> Primitive:
        """Return the primitive that an operator is performed with."""
        table: OperatorTable | RelationOperators | None = self.operators
        if isinstance(operator, RelationOperator):
            table = self.relations
        elif self.places and self.carries(operator):
            table = self.places.operators
        return _labelled(table.primitives if table else (), operator.label)

    @property
    def bearing_states(self) -> tuple[PairState, ...]:
        """The states in which a reference bears its target, in the order of their symbols."""
        return tuple(state for state in self.relations.states if state.bears) if self.relations else ()

    def company(self, operator: Operator) -> Mapping[Company, Kept]:
        """Return how an operator turned out among others, as far as that was rehearsed."""
        return self.places.company(operator.name) if self.places else {}

    def takes(self, operator: Operator, how: Company) -> bool:
        """Say whether an operator carries an object in company; untried, it takes what another one bears."""
        kept = self.company(operator).get(how)
        untried = how == "borne" and self.places is not None
        return kept.share >= LEAST_SHARE if kept and kept.trials else untried

    def category(self, symbol: Symbol) -> Category:
        """Return the category with that object symbol; `UnknownChoice` if there is none."""
        if found := next((one for one in self.operators.categories if one.symbol == symbol), None):
            return found
        raise UnknownChoice("category", symbol, (one.symbol for one in self.operators.categories))

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
        is_rare, promise = operator.successes < MIN_CHANCE * operator.trials, operator.promise
        if operator.trials < MIN_TRIALS:
            return f"fewer than {MIN_TRIALS} {self.operators.trials}"
        if is_rare and 2 * toppled > operator.trials:
            return "topples more often than not"
        if promise is None:
            return "never ends at rest or held"
        if is_rare:
            trials = f"{operator.trials} {self.operators.trials}"
            return f"keeps its promise in {operator.successes} of {trials} only"
        if self.cells(operator) == (0, 0, 0):
            return "moves less than half a cell"
        scatters = math.hypot(*self.displacement(operator)) < math.hypot(*promise.scatter)
        if scatters and not operator.rehearsals:  # else it is for each object to say, see `promises`
            return "scatters more than it moves"
        return None

    def displacement(self, operator: Operator) -> Vector:
        """Return what an operator with a promise does [m]; what comes to rest upright keeps its height."""
        promise = _promise(operator)
        x, y, z = promise.effect
        return (x, y, z) if promise.kind == "held" else at_rest(promise)

    def put_down_displacement(self, operator: Operator) -> Vector:
        """Return how putting down what it lifted moves that [m], back to its height above the table."""
        promise = _promise(operator)
        x, y, z = promise.effect
        return (promise.resting_effect[0] - x, promise.resting_effect[1] - y, -z)

    def cells(self, operator: Operator) -> Cells:
        """Return what an operator promises, in whole cells."""
        return in_cells(self.displacement(operator), self.cell)

    def put_down_cells(self, operator: Operator) -> Cells:
        """Return how putting down moves the object, in whole cells, such that no rounding adds up."""
        x, y, z = self.cells(operator)
        resting = in_cells(_promise(operator).resting_effect, self.cell)
        return (resting[0] - x, resting[1] - y, -z)

    def rounding(self, operator: Operator) -> Vector:
        """Return how far a step of a plan can err on each axis because of the grid, put down or not [m]."""
        led = np.array([self.displacement(operator), at_rest(_promise(operator))])
        return vector(np.abs(led - self.cell * np.array([in_cells(row, self.cell) for row in led])).max(0))

    def highest(self, operator: Operator) -> int:
        """Return how far up an operator can lead whichever object of its category, in whole cells."""
        held = [row.effect for row in operator.rehearsals if row.kind == "held"] if is_lift(operator) else []
        return max(in_cells(effect, self.cell)[2] for effect in (self.displacement(operator), *held))


@lru_cache(maxsize=2)
def _decoded(path: Path, content: bytes) -> Grounding:
    """Return the grounding that a file holds; the same one while it holds the same."""
    remedy = f"; `neurosym compile-domain {quoted(path.parent)}` writes it anew"
    grounding = Grounding.decoded(path, content, remedy)
    remember_fits(path, content, grounding.every_operator, grounding.operators.categories)
    return grounding


def _labelled(primitives: Sequence[Primitive], label: str) -> Primitive:
    if found := next((one for one in primitives if one.label == label), None):
        return found
    raise UnknownChoice("primitive", label, (one.label for one in primitives))


@lru_cache(maxsize=_REMEMBERED)
def _live(grounding: Grounding) -> tuple[Operator, ...]:
    found = (op for op in grounding.operators.operators if grounding.why_left_out(op) is None)
    return tuple(sorted(found, key=lambda operator: operator.name))


@lru_cache(maxsize=_REMEMBERED)
def _duplicates(grounding: Grounding) -> dict[str, str]:
    """Say of each operator that does the same as a more reliable one, which one that is and how they compare.

    The same means: to the same category, with the same kind of promise, and with displacements that differ by
    less than half a cell on every axis. Of equally reliable operators the first by name is kept. Domains of
    the first format keep all.
    """
    kept = defaultdict[tuple[str, str], list[tuple[Operator, tuple[float, ...]]]](list)
    reasons = {}
    operators = () if grounding.format == FORMATS[0] else grounding.operators.operators
    worthy = (one for one in operators if grounding._why_worthless(one) is None)
    for operator in sorted(worthy, key=lambda one: (-one.chance, one.name)):
        promise = _promise(operator)
        own = (*grounding.displacement(operator), *(at_rest(promise) if is_lift(operator) else ()))
        others = kept[operator.category, promise.kind]
        alike = (
            other
            for other, its in others
            if all(abs(a - b) < grounding.cell / 2 for a, b in zip(own, its, strict=True))
        )
        if (other := next(alike, None)) is None:
            others.append((operator, own))
        else:
            how = "less" if operator.chance < other.chance else "as"
            reasons[operator.name] = f"does the same as {other.name}, {how} reliably"
    return reasons


def is_lift(operator: Operator) -> bool:
    """Say whether an operator promises to end with the object held."""
    return operator.promise is not None and operator.promise.kind == "held"


def _promise(operator: Operator) -> Mode:
    assert operator.promise is not None, f"{operator.name} promises nothing"
    return operator.promise
