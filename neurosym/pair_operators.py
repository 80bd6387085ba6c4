"""Operators on pairs of objects and on places: states and kinds of pairs, and what was seen of each."""

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from itertools import compress
from typing import Annotated

import msgspec
import numpy as np

from neurosym.checks import Document, Float
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import (
    ANY_KIND,
    MIN_TRIALS,
    Category,
    Company,
    Kept,
    LegalName,
    Length,
    Mode,
    Operator,
    Primitive,
    Share,
    Symbol,
    Vector,
    Versioned,
    vector,
)
from neurosym.world import Scene

NEVER_CARRIES = "never carries"  # why an operator is not in the domain
Case = frozenset[Company]  # the company that there is, if any
OF_PAIRS: tuple[Company, ...] = ("borne", "occupied", "laden")
"""In which company operators on pairs were rehearsed."""


def case_of(borne: bool, occupied: bool, laden: bool) -> Case:
    """Return the case of a pair: a third object bears the target, is on the reference, or on the target."""
    return frozenset(compress(OF_PAIRS, (borne, occupied, laden)))


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

_TOUCHING, _TILTED = DESCRIPTION.index("touching"), DESCRIPTION.index("tilted")
_CERTAIN = 0.9
ALIKE = 4
"""So many operators for the same are in the domain at most: which does it most surely depends on the pair."""
SELDOM = 0.03
"""An operator promises a state if this share of its kind's pairs or more ends so, besides the most frequent
state. With some of them it may be foreseen to do so surely."""
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


def pair_end(state: str, count: int, share: float, offset: Vector, spread: Vector) -> Mode:
    """Return one way in which an operator turns out on pairs of a kind.

    Args:
        state: Code of the state that the pair ends in; empty if the target was not carried there.
        count: How many rehearsals ended so, with nothing else moved.
        share: The same as a share of all rehearsals.
        offset: Mean position of the target relative to the reference, in sums of their half sizes.
        spread: Standard deviation of that, each axis.
    """
    where = (offset, spread, offset, spread)
    return Mode(state or "missed", count, share, *where, peak_height=0.0, near_mean=count)


class RelationOperators(PairStates, frozen=True, cache_hash=True):
    """States and kinds of pairs, and operators on them."""

    # kinds of pairs, in the order of their symbols; features of the target come first
    pairs: tuple[Category, ...]
    primitives: tuple[Primitive, ...]  # in the order of their symbols
    operators: tuple[Operator, ...]  # by primitive, then kind of pair

    @property
    def every_operator(self) -> tuple[Operator, ...]:
        """All operators, those for pairs of any kind last; see `pooled`."""
        return self.operators + pooled(self)

    @property
    def left_out(self) -> Mapping[str, str]:
        """Why operators are not in the domain, by name."""
        return _left_out(self)

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
    found, alike = dict[str, str](), dict[tuple[str, ...], list[Operator]]()
    for one in table.operators:
        if reason := _why_worthless(one, table):
            found[one.name] = reason
        else:
            alike.setdefault((one.subject, *one.case), []).append(one)
    for others in alike.values():
        surest, *rest = sorted(others, key=lambda one: (one.chance, one.name), reverse=True)
        found |= {one.name: f"does less surely what {surest.name} does" for one in rest[ALIKE - 1 :]}
    return found


def _why_worthless(operator: Operator, table: RelationOperators) -> str | None:
    if operator.trials < MIN_TRIALS:
        return f"fewer than {MIN_TRIALS} rehearsals"
    if operator.promise is None:
        return "never carries its target to the reference"
    state = table.state_named(operator.promise.kind)
    if not state.bears:
        return "ends in a state in which the reference bears nothing"
    if state.leans:
        return "makes its target lean"
    if operator.promise.share < SELDOM:
        return f"keeps its promise in {operator.promise.count} of {operator.trials} rehearsals only"
    return None


ODDS = 4.0
"""As how many times as large the odds count that an operator for a kind of pairs puts a target anywhere.

The network learned from all that happened to pairs alone, most of it with motions that carry the target less
well. With the shipped domain, 195 pairs of new scenes were performed. Of what was foreseen in 29, 49 and 70 %
of the cases, 50, 79 and 91 % came true. With the odds so large, a Brier score of .145 comes to .127 on the
half of them that the number was not chosen on.
"""


def shares_foreseen(chances: Float[np.ndarray, "N S"]) -> Float[np.ndarray, "N S"]:
    """Say in which shares of the cases operators for kinds of pairs bring what is foreseen of each state."""
    every = chances.sum(1, keepdims=True)
    some = np.minimum(every, 1.0)
    often = ODDS * some / (1 - some + ODDS * some)
    return np.asarray(chances / np.maximum(every, 1e-9) * often)


# Operators for pairs of any kind: what a primitive does, over all kinds of pairs that it was rehearsed with.
#
# A kind gets no operator for what few of its pairs allow. Yet with some of them a primitive that was chosen
# for another kind is foreseen to do it. So each primitive has an operator for pairs of any kind, for each
# state that it promises some kind. Only pairs of which that is foreseen are offered it, and nothing that
# rests on a target goes along: two things that are unsure at once seldom go well.

LEAST = 0.1
"""What is foreseen of such an operator less surely than this is not said of a pair."""
FAINT, FAINTEST = 0.02, 4
"""Where nothing is foreseen more surely than `LEAST`, a problem keeps so many operators for the state that
are foreseen as surely as the first number or more. They serve goals only: whoever asks for something may know
that it can be done."""


@lru_cache(maxsize=8)
def pooled(table: RelationOperators) -> tuple[Operator, ...]:
    """Make of each primitive's operators for the same state one for pairs of any kind."""
    found = dict[tuple[str, str], list[tuple[Operator, Mode]]]()
    for one in table.operators:
        if one.promise is not None and one.promise.kind in table.straight:
            found.setdefault((one.label, one.promise.kind), []).append((one, one.promise))
    return tuple(
        _pooled(f"{table.state_named(state).name}-by-{label}", rows) for (label, state), rows in found.items()
    )


def _pooled(name: str, rows: list[tuple[Operator, Mode]]) -> Operator:
    first, end = rows[0]
    trials, count = sum(one.trials for one, _ in rows), sum(end.count for _, end in rows)
    weights = np.array([end.count for _, end in rows]) / count
    offsets, spreads = (np.array([getattr(end, what) for _, end in rows]) for what in ("effect", "spread"))
    mean = weights @ offsets
    spread = np.sqrt(weights @ (spreads**2 + (offsets - mean) ** 2))

    def kept(how: Company) -> tuple[Company, Kept]:
        every = [one.among(how) for one, _ in rows]
        return how, Kept(name, sum(one.trials for one in every), sum(one.kept for one in every))

    outcome = pair_end(end.kind, count, count / trials, vector(mean.round(4)), vector(spread.round(4)))
    return Operator(
        name,
        ANY_KIND,
        first.primitive,
        trials,
        (outcome,),
        variant=first.variant,
        frame="pair",
        company=(kept("borne"), kept("occupied")),  # nothing that rests on a target goes along
    )
