"""Operators on pairs of objects and on places: states and kinds of pairs, and what was seen of each."""

import math
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np

from neurosym.checks import Float, check_fields
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import read_json
from neurosym.operators import (
    Category,
    Count,
    LegalName,
    Length,
    OperatorTable,
    Primitive,
    Share,
    Symbol,
    Variant,
    unknown_format,
)
from neurosym.world import Scene

# The table of operators that carry objects to places, beside that of displacements.
#
# What such an operator promises is where its object stands relative to the place.

PLACES_FORMAT = "neurosym-places-1"
NEVER_CARRIES = "never carries"
"""Why an operator is not in the domain."""


class Kept(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How an operator turned out where there were other objects.

    Attributes:
        name: Name of the operator.
        trials: How many rehearsals there were.
        kept: How many ended as promised, on the table, with nothing else moved.
    """

    name: LegalName
    trials: Count
    kept: Count

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def share(self) -> float:
        """The share that ended so; 1 if there were no rehearsals."""
        return self.kept / self.trials if self.trials else 1.0


class PlaceOperators(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Operators that carry objects to places.

    The last two tables are there where objects bear one another.

    Attributes:
        operators: What each primitive does to each category; effects are relative to the place.
        occupied: How they turned out where another object stood on the place.
        beside: How they turned out where others stood close around the object.
        format: Version of this table.
        borne: How they turned out where the object rested on another one.
        laden: How they turned out where another one rested on the object; kept if that went along.
    """

    operators: OperatorTable
    occupied: tuple[Kept, ...] = ()
    beside: tuple[Kept, ...] = ()
    format: str = PLACES_FORMAT
    borne: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET
    laden: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET

    def __post_init__(self) -> None:
        check_fields(self)
        if self.format != PLACES_FORMAT:
            raise InvalidValue(unknown_format(self.format, (PLACES_FORMAT,)))

    @classmethod
    def load(cls, path: Path) -> "PlaceOperators":
        """Read a table.

        Raises:
            InvalidFile: If the file is none, or of another version.
        """
        found = read_json(path, _Versioned).format
        if found != PLACES_FORMAT:
            raise InvalidFile(path, unknown_format(found, (PLACES_FORMAT,)))
        return read_json(path, cls)


class _Versioned(msgspec.Struct, frozen=True):
    format: str


# How one object stands to another, in numbers that do not depend on how large the two are.
#
# Distances are measured in touching units: along each axis in sums of the half sizes of both, so that 1
# means that they touch. What a robot sees besides: whether they touch anywhere, and how far the target is
# tilted.

DESCRIPTION = ("away", "above", "touching", "tilted", "reference tilted")
"""What the numbers of a description are. Along x or y, whichever is more, the target is so far away from the
reference; along z it is so far above it [touching units]. They touch or not; and the target and the reference
are tilted by so much, as shares of the greatest tilt that counts."""
FARTHEST = 2.5
"""Farther apart than this objects have nothing to do with one another [touching units]."""
STEEPEST = 0.35
"""The tilt of an object counts up to this [rad]."""
LEANING = 0.4
"""What is tilted by more than this share of `STEEPEST` leans."""


def describe_pair(
    scene: Scene, target: int, reference: int, contacts: tuple[tuple[int, int], ...]
) -> Float[np.ndarray, "5"]:
    """Describe how a target stands to a reference, in the numbers of `DESCRIPTION`.

    Args:
        scene: The objects, at rest.
        target: Index of the one.
        reference: Index of the other.
        contacts: Pairs of objects that touch, each with the smaller index first.
    """
    units = touching_units(scene, target, reference)
    away = min(float(np.abs(units[:2]).max()), FARTHEST)
    up = np.clip(units[2], -FARTHEST, FARTHEST)
    pair = (min(target, reference), max(target, reference))
    tilts = (tilt(scene, index) / STEEPEST for index in (target, reference))
    return np.array([away, up, float(pair in contacts), *tilts])


def touching_units(scene: Scene, target: int, reference: int) -> Float[np.ndarray, "3"]:
    """Return where a target is relative to a reference, in sums of their half sizes along each axis.

    Args:
        scene: The objects.
        target: Index of the one.
        reference: Index of the other.
    """
    reach = (extent(scene, target) + extent(scene, reference)) / 2
    away: np.ndarray = (scene.positions[target] - scene.positions[reference]) / reach
    return away


def extent(scene: Scene, index: int) -> Float[np.ndarray, "3"]:
    """Return the sizes of an object along the axes of the world as it lies [m].

    Args:
        scene: The objects.
        index: Which one.
    """
    sizes: np.ndarray = np.abs(rotation(scene.orientations[index])) @ scene.features[index][:3]
    return sizes


def tilt(scene: Scene, index: int) -> float:
    """Return how far an object is tilted from lying on a face, at most `STEEPEST` [rad].

    Args:
        scene: The objects.
        index: Which one.
    """
    steepest = float(np.abs(rotation(scene.orientations[index])[2]).max())
    return min(float(np.arccos(min(1.0, steepest))), STEEPEST)


def rotation(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3 3"]:
    """Return the matrix of a rotation, whose columns are the axes of the object.

    Args:
        quaternion: The rotation, as (x, y, z, w), of any length but 0.
    """
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
SELDOM = 0.03
"""An operator promises a state if this share of its kind's pairs or more ends so, besides the most frequent
state. With some of them it may be foreseen to do so surely."""
ANY_KIND = ""
"""What stands for the kind of pairs where an operator is for pairs of any kind."""
Description = tuple[Length, ...]
"""How a target stands to a reference, as numbers; see `neurosym.pair_operators.describe_pair`."""


class PairState(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One way in which a target stands to a reference.

    Attributes:
        symbol: The code, like "010".
        name: Readable name, a legal PDDL predicate.
        centre: The description that is typical of it: a pair has the state whose centre is nearest.
        share: Share of the pairs in fresh scenes, whose objects nobody has touched, that are in it.
        bears: Whether the reference bears the target: fresh pairs are never so, and actions make them so.
    """

    symbol: Symbol
    name: LegalName
    centre: Description
    share: Share
    bears: bool

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def leans(self) -> bool:
        """Whether the target leans in this state."""
        return self.centre[_TILTED] > LEANING


class PairStates(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The states that pairs of objects can be in.

    Attributes:
        states: In the order of their symbols; those that were seen.
        scales: What each number of a description is divided by before distances to centres are taken.
    """

    states: tuple[PairState, ...]
    scales: Description

    def __post_init__(self) -> None:
        check_fields(self)
        if not self.states:
            raise InvalidValue("Pairs need one state or more.")
        if len(self.scales) != len(DESCRIPTION):
            raise InvalidValue(
                f"States have {len(self.scales)} scales; valid: {len(DESCRIPTION)}: {', '.join(DESCRIPTION)}."
            )
        for state in self.states:
            if len(state.centre) != len(self.scales):
                raise InvalidValue(
                    f"The state {state.symbol} has {len(state.centre)} numbers; valid: "
                    f"{len(self.scales)}, one for each scale."
                )

    @classmethod
    def load(cls, path: Path) -> "PairStates":
        """Read the states.

        Raises:
            InvalidFile: If the file is none.
        """
        return read_json(path, cls)

    @property
    def bearing(self) -> frozenset[Symbol]:
        """Codes of the states in which the reference bears its target."""
        return frozenset(state.symbol for state in self.states if state.bears)

    @property
    def straight(self) -> frozenset[Symbol]:
        """Those of these codes in which the target does not lean."""
        return frozenset(state.symbol for state in self.states if state.bears and not state.leans)

    @property
    def bearing_order(self) -> tuple[Symbol, ...]:
        """The same codes in order, as networks foresee these states."""
        return tuple(sorted(self.bearing))

    def of(self, description: Sequence[float]) -> PairState:
        """Return the state of a pair: the one whose centre is nearest.

        A pair that touches is in no state in which pairs never do, and the other way round: what stands on a
        third object may be just above the reference.

        Args:
            description: How the target stands to the reference.
        """

        def away(state: PairState) -> tuple[bool, float]:
            differs = abs(description[_TOUCHING] - state.centre[_TOUCHING]) > _CERTAIN
            rows = zip(description, state.centre, self.scales, strict=True)
            return differs, math.hypot(*((one - centre) / scale for one, centre, scale in rows))

        return min(self.states, key=away)


class PairEnd(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One way in which an operator turns out on pairs of a kind.

    Attributes:
        state: Code of the state that the pair ends in; empty if the target was not carried there.
        count: How many rehearsals ended so, with nothing else moved.
        share: The same as a share of all rehearsals.
        offset: Mean position of the target relative to the reference, in sums of their half sizes.
        spread: Standard deviation of that, each axis.
    """

    state: str
    count: Count
    share: Share
    offset: tuple[Length, Length, Length]
    spread: tuple[Length, Length, Length]

    def __post_init__(self) -> None:
        check_fields(self)


class RelationOperator(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What one primitive does to pairs of one kind.

    Attributes:
        name: Readable name, a legal PDDL action name, unique in the table.
        pair: Code of the kind of pair, or `ANY_KIND`.
        primitive: Symbol of the primitive.
        trials: How many rehearsals there were.
        ends: What was seen in these, most frequent first.
        borne: How it turned out where the target rested on a third object at first.
        occupied: How it turned out where a third object rested on the reference.
        laden: How it turned out where a third object rested on the target; kept if that went along.
        variant: Which of the parameters of its primitive it is performed with.
        promised: Code of the state that it promises, where that is not the most frequent one.
    """

    name: LegalName
    pair: Annotated[str, msgspec.Meta(pattern=r"\A[01]{0,64}\Z")]
    primitive: Symbol
    trials: Count
    ends: tuple[PairEnd, ...]
    borne: Kept
    occupied: Kept
    laden: Kept
    variant: Variant = ""
    promised: str = ""

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def label(self) -> str:
        """The action symbol and the variant, like "101" or "101b"."""
        return self.primitive + self.variant

    def is_for(self, kind: Symbol | None) -> bool:
        """Say whether it is for pairs of a kind."""
        return self.pair in (ANY_KIND, kind)

    @property
    def promise(self) -> PairEnd | None:
        """The end in the state that it promises, or else the most frequent one of those it was carried to.

        None if it was never carried to the reference.
        """
        carried = (end for end in self.ends if end.state)
        return next((end for end in carried if self.promised in ("", end.state)), None)


class RelationOperators(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """States and kinds of pairs, and operators on them.

    Attributes:
        states: In the order of their symbols; those that were seen.
        scales: What each number of a description is divided by before distances to centres are taken.
        pairs: Kinds of pairs, in the order of their symbols; features of the target come first.
        primitives: In the order of their symbols.
        operators: By primitive, then kind of pair.
        format: Version of this table.
    """

    states: tuple[PairState, ...]
    scales: Description
    pairs: tuple[Category, ...]
    primitives: tuple[Primitive, ...]
    operators: tuple[RelationOperator, ...]
    format: str = RELATIONS_FORMAT

    def __post_init__(self) -> None:
        check_fields(self)
        if self.format != RELATIONS_FORMAT:
            raise InvalidValue(unknown_format(self.format, (RELATIONS_FORMAT,)))
        PairStates(self.states, self.scales)  # checks them

    @classmethod
    def load(cls, path: Path) -> "RelationOperators":
        """Read a table.

        Raises:
            InvalidFile: If the file is none, or of another version.
        """
        found = read_json(path, _Versioned).format
        if found != RELATIONS_FORMAT:
            raise InvalidFile(path, unknown_format(found, (RELATIONS_FORMAT,)))
        return read_json(path, cls)

    def state_of(self, description: Sequence[float]) -> PairState:
        """Return the state of a pair: the one whose centre is nearest.

        Args:
            description: How the target stands to the reference.
        """
        return PairStates(self.states, self.scales).of(description)

    def state_named(self, name: str) -> PairState:
        """Return the state of that name or symbol.

        Raises:
            UnknownChoice: If there is none.
        """
        for state in self.states:
            if name in (state.name, state.symbol):
                return state
        raise UnknownChoice("state of a pair", name, (state.name for state in self.states))

    def state_meant(self, word: str) -> PairState:
        """Return the state of that name or symbol, or the only one whose name begins so.

        Raises:
            InvalidValue: If several names begin so.
            UnknownChoice: If none does.
        """
        meant = [state for state in self.states if word and state.name.startswith(word)]
        if len(meant) > 1 and word not in (state.name for state in meant):
            names = ", ".join(state.name for state in meant)
            raise InvalidValue(f"{word!r} may be any of several states; valid: {names}.")
        return meant[0] if len(meant) == 1 else self.state_named(word)

    def primitive_of(self, operator: RelationOperator) -> Primitive:
        """Return the primitive that an operator is performed with."""
        return next(one for one in self.primitives if one.label == operator.label)


# Operators for pairs of any kind: what a primitive does, over all kinds of pairs that it was rehearsed
# with.
#
# A kind gets no operator for what few of its pairs allow. Yet with some of them a primitive that was chosen
# for another kind is foreseen to do it. So each primitive has an operator for pairs of any kind, for each
# state that it promises some kind. Only pairs of which that is foreseen are offered it, and nothing that
# rests on a target goes along: two things that are unsure at once seldom go well.

COMES_TRUE = 0.6
"""What is foreseen of such an operator comes true in this share of the cases: it is the best of many, with
pairs unlike those that its primitive was auditioned with.

Measured with the shipped domain, on pairs that fit (`python -m tools.benchmarks.relations.pooled`): 25 of
40 were put in where 94 % was foreseen, 23 where it was 81 %, 18 where it was 58 %, 17 where it was 43 %.
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
    """Make of each primitive's operators for the same state one for pairs of any kind.

    Args:
        table: What was learned of pairs.
    """
    straight = {state.symbol: state.name for state in table.states if state.bears and not state.leans}
    found = dict[tuple[str, str], list[tuple[RelationOperator, PairEnd]]]()
    for one in table.operators:
        if one.promise is not None and one.promise.state in straight:
            found.setdefault((one.label, one.promise.state), []).append((one, one.promise))
    return tuple(_pooled(f"{straight[state]}-by-{label}", rows) for (label, state), rows in found.items())


def _pooled(name: str, rows: list[tuple[RelationOperator, PairEnd]]) -> RelationOperator:
    first, end = rows[0]
    trials, count = sum(one.trials for one, _ in rows), sum(end.count for _, end in rows)
    weights = np.array([end.count for _, end in rows]) / count
    offsets, spreads = (np.array([getattr(end, what) for _, end in rows]) for what in ("offset", "spread"))
    mean = weights @ offsets
    spread = np.sqrt(weights @ (spreads**2 + (offsets - mean) ** 2))
    return RelationOperator(
        name,
        ANY_KIND,
        first.primitive,
        trials,
        (PairEnd(end.state, count, count / trials, _three(mean), _three(spread)),),
        borne=_sum(name, [one.borne for one, _ in rows]),
        occupied=_sum(name, [one.occupied for one, _ in rows]),
        laden=Kept(name, 0, 0),
        variant=first.variant,
    )


def _sum(name: str, rows: list[Kept]) -> Kept:
    return Kept(name, sum(one.trials for one in rows), sum(one.kept for one in rows))


def _three(values: np.ndarray) -> tuple[float, float, float]:
    x, y, z = (round(float(value), 4) for value in values)
    return x, y, z


def share_with_any(foreseen: float) -> float | None:
    """Say how surely an operator for any pair does what is foreseen; None if that is not worth a try.

    Args:
        foreseen: The chance that a network foresees.
    """
    return max(HOPED, COMES_TRUE * foreseen) if foreseen >= LEAST else None
