"""Operators on pairs of objects and on places: states and kinds of pairs, and what was seen of each."""

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from itertools import compress
from typing import Annotated, Literal, get_args

import msgspec
import numpy as np

from neurosym.checks import Document, Float
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import (
    MIN_TRIALS,
    Category,
    Count,
    LegalName,
    Length,
    OperatorTable,
    Primitive,
    Share,
    Symbol,
    Variant,
    Vector,
    Versioned,
    smoothed,
    vector,
)
from neurosym.world import Scene

PLACES_FORMAT = "neurosym-places-1"
NEVER_CARRIES = "never carries"  # why an operator is not in the domain


class Kept(Document, frozen=True):
    """How an operator turned out where there were other objects."""

    name: LegalName  # name of the operator
    trials: Count  # how many rehearsals there were
    kept: Count  # how many ended as promised, on the table, with nothing else moved

    @property
    def share(self) -> float:
        """The share that ended so; 1 if there were no rehearsals."""
        return self.kept / self.trials if self.trials else 1.0


Company = Literal["occupied", "beside", "borne", "laden"]
"""What others there are where an operator is performed: one on the place or the reference, some close around
the object, one that bears the object, or one that rests on it."""
Case = frozenset[Company]  # the company that there is, if any
_OF_PAIRS: tuple[Company, ...] = ("borne", "occupied", "laden")
LEAST_SHARE = 0.5  # where a third object leaves less than this of what is usual, it is forbidden


def case_of(borne: bool, occupied: bool, laden: bool) -> Case:
    """Return the case of a pair: a third object bears the target, is on the reference, or on the target."""
    return frozenset(compress(_OF_PAIRS, (borne, occupied, laden)))


class PlaceOperators(Versioned, frozen=True):
    """Operators that carry objects to places, and promise where these stand relative to the place."""

    operators: OperatorTable  # what each primitive does to each category; effects are relative to the place
    occupied: tuple[Kept, ...] = ()  # how they turned out where another object stood on the place
    beside: tuple[Kept, ...] = ()  # how they turned out where others stood close around the object
    format: str = PLACES_FORMAT  # version of this table
    # how they turned out where the object rested on another one
    borne: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET
    # how they turned out where another one rested on the object; kept if that went along
    laden: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET
    readable = (PLACES_FORMAT,)

    def company(self, name: str) -> dict[Company, Kept]:
        """Return how an operator turned out among others, where that was rehearsed."""
        tables = (self.occupied, self.beside, self.borne, self.laden)
        rows = zip(get_args(Company), tables, strict=True)
        return {how: one for how, table in rows for one in table or () if one.name == name}


# How one object stands to another, in numbers that do not depend on how large the two are.
#
# Distances are measured in touching units: along each axis in sums of the half sizes of both, so that 1
# means that they touch. What a robot sees besides: whether they touch anywhere, and how far the target is
# tilted.

DESCRIPTION = ("away", "above", "touching", "tilted", "reference tilted")
"""What the numbers of a description are. Along x or y, whichever is more, the target is so far away from the
reference; along z it is so far above it [touching units]. They touch or not; and the target and the reference
are tilted by so much, as shares of the greatest tilt that counts."""
FARTHEST = 2.5  # farther apart than this objects have nothing to do with one another [touching units]
STEEPEST = 0.35  # the tilt of an object counts up to this [rad]
LEANING = 0.4  # what is tilted by more than this share of `STEEPEST` leans


def describe_pair(
    scene: Scene, target: int, reference: int, contacts: tuple[tuple[int, int], ...]
) -> Float[np.ndarray, "5"]:
    """Describe how a target stands to a reference, by their indices, in the numbers of `DESCRIPTION`."""
    units = touching_units(scene, target, reference)
    away = min(float(np.abs(units[:2]).max()), FARTHEST)
    up = np.clip(units[2], -FARTHEST, FARTHEST)
    pair = (min(target, reference), max(target, reference))
    tilts = (tilt(scene, index) / STEEPEST for index in (target, reference))
    return np.array([away, up, float(pair in contacts), *tilts])


def touching_units(scene: Scene, target: int, reference: int) -> Float[np.ndarray, "3"]:
    """Return where a target is relative to a reference, in sums of their half sizes along each axis."""
    reach = (extent(scene, target) + extent(scene, reference)) / 2
    away: np.ndarray = (scene.positions[target] - scene.positions[reference]) / reach
    return away


def extent(scene: Scene, index: int) -> Float[np.ndarray, "3"]:
    """Return the sizes of an object along the axes of the world as it lies [m]."""
    sizes: np.ndarray = np.abs(rotation(scene.orientations[index])) @ scene.features[index][:3]
    return sizes


def tilt(scene: Scene, index: int) -> float:
    """Return how far an object is tilted from lying on a face, at most `STEEPEST` [rad]."""
    steepest = float(np.abs(rotation(scene.orientations[index])[2]).max())
    return min(float(np.arccos(min(1.0, steepest))), STEEPEST)


def rotation(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3 3"]:
    """Return the matrix of a quaternion (x, y, z, w), of any length but 0: its columns are the axes."""
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


# What can be done with one object relative to another: states of pairs, kinds of pairs, and operators.
#
# A pair is a target and a reference, in this order. Its kind says what it is (what carries, what fits), its
# state how the two stand. Both are codes of learned bits; their names are made from what was measured.

RELATIONS_FORMAT = "neurosym-relations-2"
_TOUCHING, _TILTED = DESCRIPTION.index("touching"), DESCRIPTION.index("tilted")
_CERTAIN = 0.9
ALIKE = 4
"""So many operators for the same are in the domain at most: which does it most surely depends on the pair."""
SELDOM = 0.03
"""An operator promises a state if this share of its kind's pairs or more ends so, besides the most frequent
state. With some of them it may be foreseen to do so surely."""
ANY_KIND = ""  # what stands for the kind of pairs where an operator is for pairs of any kind
Description = Annotated[tuple[Length, ...], msgspec.Meta(min_length=5, max_length=5)]
"""How a target stands to a reference, as numbers; see `neurosym.pair_operators.describe_pair`."""


class PairState(Document, frozen=True):
    """One way in which a target stands to a reference."""

    symbol: Symbol  # the code, like "010"
    name: LegalName  # readable name, a legal PDDL predicate
    centre: Description  # the description that is typical of it: a pair has the state whose centre is nearest
    share: Share  # share of the pairs in fresh scenes, whose objects nobody has touched, that are in it
    bears: bool  # whether the reference bears the target: fresh pairs are never so, and actions make them so

    @property
    def leans(self) -> bool:
        """Whether the target leans in this state."""
        return self.centre[_TILTED] > LEANING


class PairStates(Versioned, frozen=True):
    """The states that pairs of objects can be in."""

    # in the order of their symbols; those that were seen
    states: Annotated[tuple[PairState, ...], msgspec.Meta(min_length=1)]
    # what each number of a description is divided by before distances to centres are taken
    scales: Description

    @property
    def bearing(self) -> tuple[Symbol, ...]:
        """Codes of the states in which the reference bears its target, in order, as networks foresee them."""
        return tuple(sorted(state.symbol for state in self.states if state.bears))

    @property
    def straight(self) -> tuple[Symbol, ...]:
        """Those of these codes in which the target does not lean."""
        return tuple(sorted(state.symbol for state in self.states if state.bears and not state.leans))

    def of(self, description: Sequence[float]) -> PairState:
        """Return the state of a pair that stands so: the one whose centre is nearest.

        A pair that touches is in no state in which pairs never do, and the other way round: what stands on a
        third object may be just above the reference.
        """

        def away(state: PairState) -> tuple[bool, float]:
            differs = abs(description[_TOUCHING] - state.centre[_TOUCHING]) > _CERTAIN
            return differs, self.misfit(description, state)

        return min(self.states, key=away)

    def misfit(self, description: Sequence[float], state: PairState) -> float:
        """Return how far a description is from what is typical of a state, in the scales."""
        rows = zip(description, state.centre, self.scales, strict=True)
        return math.hypot(*((one - centre) / scale for one, centre, scale in rows))


class PairEnd(Document, frozen=True):
    """One way in which an operator turns out on pairs of a kind."""

    state: str  # code of the state that the pair ends in; empty if the target was not carried there
    count: Count  # how many rehearsals ended so, with nothing else moved
    share: Share  # the same as a share of all rehearsals
    offset: Vector  # mean position of the target relative to the reference, in sums of their half sizes
    spread: Vector  # standard deviation of that, each axis


class RelationOperator(Document, frozen=True):
    """What one primitive does to pairs of one kind."""

    name: LegalName  # readable name, a legal PDDL action name, unique in the table
    pair: Annotated[str, msgspec.Meta(pattern=r"\A[01]{0,64}\Z")]  # code of the kind of pair, or `ANY_KIND`
    primitive: Symbol  # symbol of the primitive
    trials: Count  # how many rehearsals there were
    ends: tuple[PairEnd, ...]  # what was seen in these, most frequent first
    borne: Kept  # how it turned out where the target rested on a third object at first
    occupied: Kept  # how it turned out where a third object rested on the reference
    laden: Kept  # how it turned out where a third object rested on the target; kept if that went along
    variant: Variant = ""  # which of the parameters of its primitive it is performed with
    promised: str = ""  # code of the state that it promises, where that is not the most frequent one

    @property
    def label(self) -> str:
        """The action symbol and the variant, like "101" or "101b"."""
        return self.primitive + self.variant

    @property
    def company(self) -> dict[Company, Kept]:
        """How it turned out among others."""
        return {how: getattr(self, how) for how in _OF_PAIRS}

    @property
    def case(self) -> tuple[str, ...]:
        """What it does to its kind of pairs, and what company it takes."""
        return (self.promise.state if self.promise else "", *filter(self.takes, self.company))

    @property
    def chance(self) -> float:
        """The chance that it keeps its promise, by what was seen with its kind of pairs."""
        return smoothed(self.promise.count if self.promise else 0, self.trials)

    def is_for(self, kind: Symbol | None) -> bool:
        """Say whether it is for pairs of a kind."""
        return self.pair in (ANY_KIND, kind)

    def takes(self, how: Company) -> bool:
        """Say whether it is planned with in company: not where that was never tried."""
        kept, promise = self.company[how], self.promise
        return bool(promise and kept.trials and kept.share >= LEAST_SHARE * promise.share)

    @property
    def promise(self) -> PairEnd | None:
        """The end in the state that it promises, or else the most frequent; None if it never gets there."""
        return next((end for end in self.ends if end.state and self.promised in ("", end.state)), None)


class RelationOperators(PairStates, frozen=True, cache_hash=True):
    """States and kinds of pairs, and operators on them."""

    # kinds of pairs, in the order of their symbols; features of the target come first
    pairs: tuple[Category, ...]
    primitives: tuple[Primitive, ...]  # in the order of their symbols
    operators: tuple[RelationOperator, ...]  # by primitive, then kind of pair
    format: str = RELATIONS_FORMAT  # version of this table
    readable = (RELATIONS_FORMAT,)

    @property
    def every_operator(self) -> tuple[RelationOperator, ...]:
        """All operators, those for pairs of any kind last; see `pooled`."""
        return self.operators + pooled(self)

    @property
    def left_out(self) -> Mapping[str, str]:
        """Why operators are not in the domain, by name."""
        return _left_out(self)

    def primitive_of(self, operator: RelationOperator) -> Primitive:
        """Return the primitive that an operator is performed with."""
        return next(one for one in self.primitives if one.label == operator.label)

    def state_named(self, name: str) -> PairState:
        """Return the state of that name or symbol; `UnknownChoice` if there is none."""
        if found := next((state for state in self.states if name in (state.name, state.symbol)), None):
            return found
        raise UnknownChoice("state of a pair", name, (state.name for state in self.states))

    def state_meant(self, word: str) -> PairState:
        """Return the state of that name or symbol, or the only one whose name begins so."""
        names = [state.name for state in self.states if word and state.name.startswith(word)]
        if len(names) > 1 and word not in names:
            raise InvalidValue(f"{word!r} may be any of several states; valid: {', '.join(names)}.")
        return self.state_named(names[0] if len(names) == 1 else word)


@lru_cache(maxsize=8)
def _left_out(table: RelationOperators) -> Mapping[str, str]:
    found, alike = dict[str, str](), dict[tuple[str, ...], list[RelationOperator]]()
    for one in table.operators:
        if reason := _why_worthless(one, table):
            found[one.name] = reason
        else:
            alike.setdefault((one.pair, *one.case), []).append(one)
    for others in alike.values():
        surest, *rest = sorted(others, key=lambda one: (one.chance, one.name), reverse=True)
        found |= {one.name: f"does less surely what {surest.name} does" for one in rest[ALIKE - 1 :]}
    return found


def _why_worthless(operator: RelationOperator, table: RelationOperators) -> str | None:
    if operator.trials < MIN_TRIALS:
        return f"fewer than {MIN_TRIALS} rehearsals"
    if operator.promise is None:
        return "never carries its target to the reference"
    state = table.state_named(operator.promise.state)
    if not state.bears:
        return "ends in a state in which the reference bears nothing"
    if state.leans:
        return "makes its target lean"
    if operator.promise.share < SELDOM:
        return f"keeps its promise in {operator.promise.count} of {operator.trials} rehearsals only"
    return None


# Operators for pairs of any kind: what a primitive does, over all kinds of pairs that it was rehearsed with.
#
# A kind gets no operator for what few of its pairs allow. Yet with some of them a primitive that was chosen
# for another kind is foreseen to do it. So each primitive has an operator for pairs of any kind, for each
# state that it promises some kind. Only pairs of which that is foreseen are offered it, and nothing that
# rests on a target goes along: two things that are unsure at once seldom go well.

COMES_TRUE = 0.6
"""What is foreseen of such an operator comes true in this share of the cases: it is the best of many, with
pairs unlike those that its primitive was auditioned with.

Measured with the shipped domain, on pairs that fit (`tools/benchmarks/relations/pooled.py` of
commit 0c6c1345): 25 of 40 were put in where 94 % was foreseen, 23 where it was 81 %, 18 where it was 58 %,
17 where it was 43 %.
"""
LEAST, HOPED = 0.1, 0.2
"""What is foreseen less surely than the first is not said of a pair; the rest is hoped to come true as often
as the second says, or more.

Measured by the same command: of 40 pairs with which 10 to 20 % was foreseen, an action written by hand put 12
in, and what was foreseen 4. With less, the action by hand put in 2 of 40.
"""
FAINT, FAINTEST = 0.02, 4
"""Where nothing is foreseen more surely than `LEAST`, a problem keeps so many operators for the state that
are foreseen as surely as the first number or more. They serve goals only: whoever asks for something may know
that it can be done."""


@lru_cache(maxsize=8)
def pooled(table: RelationOperators) -> tuple[RelationOperator, ...]:
    """Make of each primitive's operators for the same state one for pairs of any kind."""
    found = dict[tuple[str, str], list[tuple[RelationOperator, PairEnd]]]()
    for one in table.operators:
        if one.promise is not None and one.promise.state in table.straight:
            found.setdefault((one.label, one.promise.state), []).append((one, one.promise))
    return tuple(
        _pooled(f"{table.state_named(state).name}-by-{label}", rows) for (label, state), rows in found.items()
    )


def _pooled(name: str, rows: list[tuple[RelationOperator, PairEnd]]) -> RelationOperator:
    first, end = rows[0]
    trials, count = sum(one.trials for one, _ in rows), sum(end.count for _, end in rows)
    weights = np.array([end.count for _, end in rows]) / count
    offsets, spreads = (np.array([getattr(end, what) for _, end in rows]) for what in ("offset", "spread"))
    mean = weights @ offsets
    spread = np.sqrt(weights @ (spreads**2 + (offsets - mean) ** 2))

    def kept(how: Company) -> Kept:
        every = [one.company[how] for one, _ in rows]
        return Kept(name, sum(one.trials for one in every), sum(one.kept for one in every))

    where = vector(mean.round(4)), vector(spread.round(4))
    return RelationOperator(
        name,
        ANY_KIND,
        first.primitive,
        trials,
        (PairEnd(end.state, count, count / trials, *where),),
        borne=kept("borne"),
        occupied=kept("occupied"),
        laden=Kept(name, 0, 0),
        variant=first.variant,
    )


def share_with_any(foreseen: float) -> float | None:
    """Say how surely an operator for any pair does what is foreseen with a chance; None if hardly."""
    return max(HOPED, COMES_TRUE * foreseen) if foreseen >= LEAST else None
