"""The table of operators: what each primitive does to each category of objects.

This one table is what every PDDL output is printed from, what plans are replayed with, and what execution
compares observations against. It is stored in `primitives.json`.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Literal

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.checks import check_fields
from neurosym.choices import TOLERANCE as TOLERANCE
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.reading import read_json
from neurosym.symbols import Symbol, all_symbols
from neurosym.world import OutcomeKind

LegalName = Annotated[str, msgspec.Meta(pattern=r"\A[a-z][a-z0-9-]{0,199}\Z")]
"""A name that PDDL takes, and that a terminal and a page show as it is."""
Length = Annotated[float, msgspec.Meta(ge=-1e9, le=1e9)]
Share = Annotated[float, msgspec.Meta(ge=0, le=1)]
Count = Annotated[int, msgspec.Meta(ge=0)]
Vector = tuple[Length, Length, Length]
Effect = tuple[Length, ...]
"""A displacement: x, y and z [m] in every world, any number of axes in data of a user's own."""
Variant = Annotated[str, msgspec.Meta(pattern=r"\A[a-z]{0,2}\Z")]
"""Which of the parameters of an action symbol; empty where there are no others."""
TABLE_FORMATS = ("neurosym-primitives-1", "neurosym-primitives-2")
"""Versions of tables that can be read; since the second there may be several operators for a pair."""
TABLE_FORMAT = TABLE_FORMATS[-1]
"""The version of tables that are made now."""
_MOST_BITS = 10  # of symbols whose unused codes are listed


def vector(values: Float[np.ndarray, "3"]) -> Vector:
    """Return three numbers as a tuple of floats."""
    x, y, z = (float(value) for value in values)
    return (x, y, z)


PROMISING: tuple[OutcomeKind, ...] = ("resting", "held", "carried")
"""How targets end that operators promise something of."""
MIN_CHANCE = 0.1
"""An outcome that is seen more rarely than this is not worth planning with."""


class Mode(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One way that a primitive turns out on a category.

    Attributes:
        kind: How the target ended: at rest upright, held in the air, on another face, or off the table.
        count: How many rehearsals ended so, or rows of the data.
        share: The same as a share of all trials of this primitive on this category.
        effect: Mean displacement at the end of the rise [m].
        spread: Standard deviation of that displacement, each axis [m].
        resting_effect: Mean displacement once everything is put down [m].
        resting_spread: Standard deviation of that, each axis [m].
        peak_height: Mean of the greatest height on the way [m].
        near_mean: How many of the `count` lie within the planning tolerance of the mean effect.
    """

    kind: OutcomeKind
    count: Count
    share: Share
    effect: Effect
    spread: Effect
    resting_effect: Effect
    resting_spread: Effect
    peak_height: Length
    near_mean: Count

    def __post_init__(self) -> None:
        check_fields(self)
        if len({len(self.effect), len(self.spread), len(self.resting_effect), len(self.resting_spread)}) > 1:
            raise InvalidValue("The effects and spreads of a mode must have the same number of axes.")

    @property
    def outcome(self) -> Effect:
        """Mean displacement of the object as it ended: held in the air, or else at rest [m]."""
        return self.effect if self.kind == "held" else self.resting_effect

    @property
    def scatter(self) -> Effect:
        """Standard deviation of `outcome`, each axis [m]."""
        return self.spread if self.kind == "held" else self.resting_spread


CONVERGED = 0.05
"""Greatest mean squared error to the code of an action that counts as found."""


class Primitive(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """An action symbol with distilled parameters; a symbol may have several, each with a letter of its own.

    Attributes:
        symbol: The action symbol, like "101".
        action: The distilled action parameters.
        code_error: Mean squared error of the action's embedding to the symbol's +-1 code.
        variant: Which of the symbol's parameters these are: empty, or one of "a", "b" and so on.
    """

    symbol: Symbol
    action: tuple[Length, ...]
    code_error: float
    variant: Variant = ""

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def label(self) -> str:
        """The symbol and the variant, like "101" or "101b"."""
        return self.symbol + self.variant

    @property
    def has_converged(self) -> bool:
        """Whether the action really encodes to the symbol."""
        return self.code_error < CONVERGED


class Rehearsal(msgspec.Struct, frozen=True, array_like=True):
    """How a primitive turned out on one object.

    Attributes:
        kind: How the object ended.
        effect: Its displacement at the end of the rise [m].
        resting_effect: Its displacement once everything is put down [m].
        peak_height: Its greatest height on the way [m].
        turn: By what angle it was turned in the end [rad].
    """

    kind: OutcomeKind
    effect: Effect
    resting_effect: Effect
    peak_height: Length
    turn: Length

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def outcome(self) -> Effect:
        """Displacement of the object as it ended: held in the air, or else at rest [m]."""
        return self.effect if self.kind == "held" else self.resting_effect


class Category(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, cache_hash=True):
    """The objects that share one object symbol.

    Attributes:
        symbol: The object symbol, like "10".
        name: Readable name, a legal PDDL type.
        share: Share of the sampled objects, or of the rows of the data, that fall into this category.
        feature_means: Mean of each feature over those objects; empty if there were none.
        feature_spreads: Standard deviation of each feature over those objects.
        objects: Features of the objects that all its operators were rehearsed on, if that is kept.
    """

    symbol: Symbol
    name: LegalName
    share: Share
    feature_means: tuple[Length, ...]
    feature_spreads: tuple[Length, ...]
    objects: tuple[tuple[Length, ...], ...] = ()

    def __post_init__(self) -> None:
        check_fields(self)


class Operator(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, cache_hash=True):
    """What one primitive does to one category.

    Attributes:
        name: Readable name, a legal PDDL action name, unique in the table.
        category: Symbol of the category.
        primitive: Symbol of the primitive.
        trials: How many rehearsals there were on objects as the world draws them, or rows of the data.
        modes: The outcomes seen in these, most frequent first.
        promised: How it promises to end; None for the most frequent of `PROMISING`.
        variant: Which of the parameters of its primitive it is performed with.
        rehearsals: How it turned out on each of the `objects` of its category, if that is kept: first in
            its trials, then on objects that were chosen since it was unsure what happens to them.
        objects: Features of the objects that it was rehearsed on, if they are others than those.
    """

    name: LegalName
    category: Symbol
    primitive: Symbol
    trials: Count
    modes: tuple[Mode, ...]
    promised: OutcomeKind | None = None
    variant: Variant = ""
    rehearsals: tuple[Rehearsal, ...] = ()
    objects: tuple[tuple[Length, ...], ...] = ()

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def label(self) -> str:
        """The action symbol and the variant, like "101" or "101b"."""
        return self.primitive + self.variant

    @property
    def promise(self) -> Mode | None:
        """The mode the operator promises; None if it never ends so."""
        kinds = (self.promised,) if self.promised else PROMISING
        return next((mode for mode in self.modes if mode.kind in kinds), None)

    @property
    def successes(self) -> int:
        """Trials that ended in the promised mode, within the planning tolerance of its mean."""
        return self.promise.near_mean if self.promise else 0


def unknown_format(found: str, known: Sequence[str]) -> str:
    """Say that a file is of a version that cannot be read."""
    return f"it is of the format {found!r}, and this version reads {' and '.join(map(repr, known))}"


class _Versioned(msgspec.Struct, frozen=True):
    format: str = TABLE_FORMATS[0]


class OperatorTable(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """Categories, primitives, and one operator or two for each pair of them.

    Attributes:
        categories: In the order of their symbols.
        primitives: In the order of their symbols; of each symbol first the action that it shares among
            categories, then those that are for single ones.
        operators: By primitive, then category, the surest first; pairs that were never tried are missing. In
            a grounding, those that promise other outcomes than the likeliest come last.
        measured: What the modes were measured by: rehearsals of the distilled actions, or averages over the
            rows of the data whose action has the primitive's symbol, where there is no world to rehearse in.
        format: Version of this table.
    """

    categories: tuple[Category, ...]
    primitives: tuple[Primitive, ...]
    operators: tuple[Operator, ...]
    measured: Literal["rehearsal", "data"] = "rehearsal"
    format: str = TABLE_FORMATS[0]

    def __post_init__(self) -> None:
        check_fields(self)
        if self.format not in TABLE_FORMATS:
            raise InvalidValue(unknown_format(self.format, TABLE_FORMATS))
        if len(self._widths) > 1:
            raise InvalidValue("All effects must have the same number of axes.")

    @classmethod
    def load(cls, path: Path) -> "OperatorTable":
        """Read a table.

        Raises:
            InvalidFile: If the file is none, or of another version.
        """
        found = read_json(path, _Versioned).format
        if found not in TABLE_FORMATS:
            raise InvalidFile(path, unknown_format(found, TABLE_FORMATS))
        return read_json(path, cls)

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """The action symbols, each once."""
        return tuple(dict.fromkeys(primitive.symbol for primitive in self.primitives))

    @property
    def axes(self) -> int:
        """How many axes the effects have; 3 if there are none."""
        return next(iter(self._widths), 3)

    @property
    def trials(self) -> str:
        """What the trials of operators are called: rehearsals, or rows of the data."""
        return "rehearsals" if self.measured == "rehearsal" else "rows of the data"

    @property
    def effects(self) -> str:
        """What the effects of operators are called, by how they came about."""
        return "rehearsed effects" if self.measured == "rehearsal" else "effects averaged over the data"

    @property
    def unreached(self) -> tuple[Symbol, ...]:
        """Action symbols without a primitive, where there are few enough to list: none encodes to them."""
        found = {primitive.symbol for primitive in self.primitives}
        bits = len(next(iter(found), ""))
        codes = all_symbols(bits) if bits <= _MOST_BITS else ()
        return tuple(code for code in codes if code not in found)

    @property
    def _widths(self) -> set[int]:
        return {len(mode.effect) for operator in self.operators for mode in operator.modes}
