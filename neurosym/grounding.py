"""Grounding: what is needed to plan with a learned domain and to turn plans back into motions."""

import math
from collections import defaultdict
from functools import lru_cache
from itertools import chain
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np

from neurosym.checks import as_path, check_length
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice, one_called, quoted
from neurosym.files import MOST_JSON, read_bytes, write_json
from neurosym.formats import PairFile, PlaceFile
from neurosym.operators import (
    MIN_CHANCE,
    MIN_TRIALS,
    Category,
    Effect,
    EffectFrame,
    LegalName,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Symbol,
    Vector,
    Versioned,
    counted_axes,
    labelled,
    vector,
)
from neurosym.pair_operators import NEVER_CARRIES, PairState, RelationOperators
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


# What is needed to plan with a learned domain is what operators there are, and the grid that the PDDL text is
# printed on; no neural network. It is stored as `grounding.json`, next to the domain.

FORMATS = tuple(f"neurosym-grounding-{number}" for number in range(1, 6))
"""Versions of groundings that can be read; the second knows operators with parameters of their own, the third
what carries objects to places, the fourth what puts them in relations to one another, the fifth what sets
them upright."""
FORMAT, FORMAT_WITH_PLACES, FORMAT_WITH_RELATIONS, FORMAT_WITH_UPRIGHT = FORMATS[1:]
_VALUES = "neurosym-values-"
"""What formats of domains begin with that are none of these; see `neurosym.values`."""
_Size = Annotated[float, msgspec.Meta(ge=1e-6, le=1e3)]  # [m]
_REMEMBERED = 8  # groundings of which what follows from them is kept: each object of a problem asks for it


class Grounding(Versioned, frozen=True, omit_defaults=True, cache_hash=True, rename={"objects": "operators"}):
    """Everything that planning, replay and execution know of a learned domain."""

    format: str  #: Version of its file
    name: LegalName  #: Name of the PDDL domain
    cell: _Size  #: Edge of a grid cell [m]
    table: Table  #: Where objects may stand [m]
    lift_height: _Size  #: How far the hand rises after the last waypoint [m]
    objects: OperatorTable  #: What is done to objects by themselves
    unit_costs: bool = False  #: Whether every step costs the same, instead of the more the rarer it goes well
    places: OperatorTable | None = None  #: What carries objects to places, if that was learned
    #: What puts objects in relations to one another, if that was learned
    relations: RelationOperators | None = None
    upright: OperatorTable | None = None  #: What sets objects upright that lie on a side, if that was learned
    turned: bool = False  #: Whether motions are performed turned as objects lie; see `neurosym.world.heading`
    readable = FORMATS

    def __post_init__(self) -> None:
        super().__post_init__()
        check_length("cell", self.cell)
        check_length("lift_height", self.lift_height)
        if self.objects.axes != 3:
            axes = counted_axes(self.objects.axes)
            raise InvalidValue(f"The effects of a grounding have {axes}; valid: x, y and z.")
        raised = self.upright
        if raised and (raised.axes != 3 or any(one.frame != "side" for one in raised.operators)):
            raise InvalidValue(
                "What sets upright must have effects along x, y and z, and be of the frame side."
            )

    @classmethod
    def _unreadable(cls, found: str | None) -> str:
        if found and found.startswith(_VALUES):
            return "it is of values, and this command needs positions: of objects on a table, in a world"
        return super()._unreadable(found)

    def save(self, path: Path) -> None:
        """Write the grounding to a file, `grounding.json` by custom."""
        places, pairs = self.places, self.relations
        parts = msgspec.structs.asdict(self) | {"places": places and PlaceFile.holding(places)}
        write_json(as_path(path), _File(**parts | {"relations": pairs and PairFile.holding(pairs)}))

    @classmethod
    def load(cls, path: Path) -> "Grounding":
        """Read a grounding; `InvalidFile` if the file is none, or of another version."""
        path = as_path(path)
        return _decoded(path, read_bytes(path, MOST_JSON))

    @property
    def operators(self) -> tuple[Operator, ...]:
        """All operators but those that set upright: on objects, those that carry them to places, on pairs."""
        return tuple(one for one in _by_name(self).values() if one.frame != "side")

    def operator_named(self, name: str) -> Operator:
        """Return the operator of that name; `UnknownChoice` if there is none."""
        found = _by_name(self)
        if one := found.get(name) or found.get(name.removesuffix(FORMER_SUFFIX)):
            return one
        known = (one.name for one in self.operators if one.subject)
        raise UnknownChoice("operator", name, known, "`neurosym explain`")

    def operators_on(self, category: Symbol) -> tuple[Operator, ...]:
        """Return what is done to the objects of a category, by themselves or with places."""
        return tuple(one for one in self.operators if one.frame != "pair" and one.subject == category)

    def operator_for(self, category: Symbol, primitive: Symbol) -> Operator | None:
        """Return what a primitive mostly does to a category, with its surest action; None if never tried."""
        asked = (category, primitive)
        return next((op for op in self.objects.operators if (op.subject, op.primitive) == asked), None)

    def primitive_of(self, operator: Operator) -> Primitive:
        """Return the primitive that an operator is performed with."""
        tables = {"object": self.objects, "place": self.places, "pair": self.relations, "side": self.upright}
        table = tables[operator.frame]
        return labelled(table.primitives if table else (), operator.label)

    @property
    def bearing_states(self) -> tuple[PairState, ...]:
        """The states in which a reference bears its target, in the order of their symbols."""
        return tuple(state for state in self.relations.states if state.bears) if self.relations else ()

    def category(self, symbol: Symbol) -> Category:
        """Return the category with that object symbol; `UnknownChoice` if there is none."""
        return one_called("category", symbol, self.objects.categories, by="symbol")

    @property
    def live(self) -> tuple[Operator, ...]:
        """The operators that the PDDL domain has actions for to displace objects, by name."""
        return self.live_on("object")

    def live_on(self, frame: EffectFrame) -> tuple[Operator, ...]:
        """Return the operators of the PDDL domain that act on objects, with places, or on pairs, by name."""
        return _live(self, frame)

    @property
    def is_refined(self) -> bool:
        """Whether rehearsals are kept, so that objects of one category are promised different things."""
        return self.places is not None or any(operator.rehearsals for operator in self.live)

    @property
    def left_out(self) -> dict[str, str]:
        """Why operators are not in the PDDL domain, by name."""
        reasons = {one.name: reason for one in self.operators if (reason := self.why_left_out(one))}
        return dict(sorted(reasons.items()))

    def why_left_out(self, operator: Operator) -> str | None:
        """Say why an operator is not in the PDDL domain, or return None if it is."""
        if operator.frame == "place":
            return None if operator.successes else NEVER_CARRIES
        if operator.frame == "pair":
            return self.relations.left_out.get(operator.name) if self.relations else None
        return self._why_worthless(operator) or _duplicates(self).get(operator.name)

    def _why_worthless(self, operator: Operator) -> str | None:
        """Say why an operator is not worth planning with, whatever others there are; None if it is."""
        toppled = sum(mode.count for mode in operator.outcomes if mode.kind == "toppled")
        is_rare, promise = operator.successes < MIN_CHANCE * operator.trials, operator.promise
        if operator.trials < MIN_TRIALS:
            return f"fewer than {MIN_TRIALS} {self.objects.trials}"
        if is_rare and 2 * toppled > operator.trials:
            return "topples more often than not"
        if promise is None:
            return "never ends at rest or held"
        if is_rare:
            trials = f"{operator.trials} {self.objects.trials}"
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


class _File(Grounding, frozen=True, rename={"objects": "operators"}):
    places: PlaceFile | None = None  # type: ignore[assignment]  # as they stand in the file
    relations: PairFile | None = None  # type: ignore[assignment]


@lru_cache(maxsize=2)
def _decoded(path: Path, content: bytes) -> Grounding:
    """Return the grounding that a file holds; the same one while it holds the same."""
    remedy = f"; `neurosym compile-domain {quoted(path.parent)}` writes it anew"
    parts = msgspec.structs.asdict(_File.decoded(path, content, remedy))
    tables = {name: parts[name] and parts[name].table() for name in ("places", "relations")}
    grounding = Grounding(**parts | tables)
    learned = (grounding.objects, grounding.places, grounding.relations, grounding.upright)
    lengths = {len(one.action) for table in learned if table for one in table.primitives}
    if len(lengths) > 1:
        found = " and ".join(map(str, sorted(lengths)))
        raise InvalidFile(path, f"its actions have {found} numbers; valid: all as many{remedy}")
    remember_fits(path, content, grounding.operators, grounding.objects.categories)
    return grounding


@lru_cache(maxsize=_REMEMBERED)
def _by_name(grounding: Grounding) -> dict[str, Operator]:
    others = (table.operators for table in (grounding.places, grounding.upright) if table)
    pairs = grounding.relations.every_operator if grounding.relations else ()
    return {one.name: one for one in chain(grounding.objects.operators, *others, pairs)}


@lru_cache(maxsize=_REMEMBERED)
def _live(grounding: Grounding, frame: EffectFrame) -> tuple[Operator, ...]:
    found = (one for one in grounding.operators if one.frame == frame and not grounding.why_left_out(one))
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
    operators = () if grounding.format == FORMATS[0] else grounding.objects.operators
    worthy = (one for one in operators if grounding._why_worthless(one) is None)
    for operator in sorted(worthy, key=lambda one: (-one.chance, one.name)):
        promise = _promise(operator)
        own = (*grounding.displacement(operator), *(at_rest(promise) if is_lift(operator) else ()))
        others = kept[operator.subject, promise.kind]
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
