"""What can be done with one object relative to another: states of pairs, kinds of pairs, and operators.

A pair is a target and a reference, in this order. Its kind says what it is (what carries, what fits), its
state how the two stand. Both are codes of learned bits; their names are made from what was measured.
"""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import msgspec

from neurosym.checks import check_fields
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.operators import Category, Count, LegalName, Length, Primitive, Share, Variant, unknown_format
from neurosym.pair_states import DESCRIPTION, LEANING
from neurosym.place_operators import Kept
from neurosym.reading import read_json
from neurosym.symbols import Symbol

FORMAT = "neurosym-relations-2"
_TOUCHING, _TILTED = DESCRIPTION.index("touching"), DESCRIPTION.index("tilted")
_CERTAIN = 0.9
SELDOM = 0.03
"""An operator promises a state if this share of its kind's pairs or more ends so, besides the most frequent
state. With some of them it may be foreseen to do so surely."""
ANY_KIND = ""
"""What stands for the kind of pairs where an operator is for pairs of any kind."""
Description = tuple[Length, ...]
"""How a target stands to a reference, as numbers; see `neurosym.pair_states.describe_pair`."""


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
    format: str = FORMAT

    def __post_init__(self) -> None:
        check_fields(self)
        if self.format != FORMAT:
            raise InvalidValue(unknown_format(self.format, (FORMAT,)))
        PairStates(self.states, self.scales)  # checks them

    @classmethod
    def load(cls, path: Path) -> "RelationOperators":
        """Read a table.

        Raises:
            InvalidFile: If the file is none, or of another version.
        """
        found = read_json(path, _Versioned).format
        if found != FORMAT:
            raise InvalidFile(path, unknown_format(found, (FORMAT,)))
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


class _Versioned(msgspec.Struct, frozen=True):
    format: str
