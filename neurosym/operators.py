"""Operators: what each primitive does to each category of objects, and how all these are named."""

import re
from collections.abc import Callable, Iterable, Sequence
from itertools import product
from pathlib import Path
from typing import Annotated, ClassVar, Literal, Self, get_args

import msgspec
import numpy as np

from neurosym.checks import Document, Float, check_all, check_callable
from neurosym.choices import TOLERANCE as TOLERANCE
from neurosym.errors import InvalidFile, InvalidValue, one_called, shortened
from neurosym.files import MOST_JSON, decode_json, read_bytes
from neurosym.world import OutcomeKind

_BITS = r"\A[01]{1,64}\Z"
Symbol = Annotated[str, msgspec.Meta(pattern=_BITS)]
"""A code of bits, like "101"; what stands in files is checked when it is read."""
Categorise = Callable[[Float[np.ndarray, "N F"]], tuple[Symbol, ...]]  # gives the object symbols of features


def symbols_of(categorise: Categorise, features: Float[np.ndarray, "N F"]) -> tuple[Symbol, ...]:
    """Return the symbols that a function gives to objects; `InvalidValue` if it gives not as many symbols."""
    check_callable("categorise", categorise, "a function from features (N, F) to N symbols")
    symbols = categorise(features)
    check_all("the symbols that categorise gives", symbols, str, "a tuple of symbols, like '10'")
    if len(symbols) != len(features):
        raise InvalidValue(f"categorise gives {len(symbols)} symbols for {len(features)} objects.")
    for symbol in symbols:
        if not re.match(_BITS, symbol):
            raise InvalidValue(f"categorise gives the symbol {shortened(symbol)!r}; valid: bits, like '10'.")
    return tuple(symbols)


def all_symbols(bits: int) -> tuple[Symbol, ...]:
    """List the 2^K symbols of K bits in counting order."""
    return tuple("".join(code) for code in product("01", repeat=bits))


def signs(symbol: Symbol) -> Float[np.ndarray, "K"]:
    """Write a symbol in tanh's range: +1 for each 1, -1 for each 0."""
    return np.array([1.0 if bit == "1" else -1.0 for bit in symbol])


# The table of operators: what each primitive does to each category of objects.
#
# Every PDDL output is printed from operators, plans are replayed with them, and execution compares what it
# observes with what they promise. How they stand in files is told in `neurosym.formats`.

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
TABLE_FORMAT = TABLE_FORMATS[-1]  # the version of tables that are made now
EffectFrame = Literal["object", "place", "pair", "side"]
"""What operators act on: an object, seen from where it was; an object that is carried to a place, seen from
there; a pair, whose target is seen from its reference in sums of their half sizes; or an object that lies on
a side, seen from where it was."""
_ENDING = rf"\A({'|'.join(get_args(OutcomeKind))}|[01]{{1,64}})\Z"
Ending = Annotated[str, msgspec.Meta(pattern=_ENDING)]
"""How an object ends, one of `OutcomeKind`, or the state that a pair ends in."""
Subject = Annotated[str, msgspec.Meta(pattern=r"\A[01]{0,64}\Z")]
Company = Literal["occupied", "beside", "borne", "laden"]
"""What others there are where an operator is performed: one on the place or the reference, some close around
the object, one that bears the object, or one that rests on it."""
LEAST_SHARE = 0.5  # where a third object leaves less than this of what is usual, it is forbidden
ANY_KIND = ""  # what stands for the kind of pairs where an operator is for pairs of any kind
_MOST_BITS = 10  # of symbols whose unused codes are listed


def vector(values: Float[np.ndarray, "3"]) -> Vector:
    """Return three numbers as a tuple of floats."""
    x, y, z = map(float, values)
    return (x, y, z)


PROMISING: tuple[OutcomeKind, ...] = ("resting", "held", "carried")
"""How targets end that operators promise something of."""
MIN_CHANCE = 0.1  # an outcome that is seen more rarely than this is not worth planning with
MIN_TRIALS = 5  # an operator with fewer rehearsals, or rows of the data, than this is not believed


def smoothed(kept: int, trials: int) -> float:
    """Return a chance from what was seen: (k + 1) / (n + 2), the rule of succession."""
    return (kept + 1) / (trials + 2)


class Mode(Document, frozen=True):
    """One way that a primitive turns out on a category, or on a kind of pairs."""

    # how the target ended: at rest upright, held in the air, on another face, or off the table; of a pair the
    # code of the state that it ended in, or else "missed"
    kind: Ending
    count: Count  # how many rehearsals ended so, or rows of the data
    share: Share  # the same as a share of all trials of this primitive on this category
    effect: Effect  # mean displacement at the end of the rise [m]
    spread: Effect  # standard deviation of that displacement, each axis [m]
    resting_effect: Effect  # mean displacement once everything is put down [m]
    resting_spread: Effect  # standard deviation of that, each axis [m]
    peak_height: Length  # mean of the greatest height on the way [m]
    near_mean: Count  # how many of the `count` lie within the planning tolerance of the mean effect

    def __post_init__(self) -> None:
        super().__post_init__()
        if len({len(self.effect), len(self.spread), len(self.resting_effect), len(self.resting_spread)}) > 1:
            raise InvalidValue("The effects and spreads of a mode must have the same number of axes.")
        if not re.match(_ENDING, self.kind):
            raise InvalidValue(f"Mode.kind = {shortened(self.kind)!r}; valid: as 'held', or bits of a state.")

    @property
    def is_promising(self) -> bool:
        """Whether operators promise to end so."""
        return self.kind in PROMISING or self.kind[0] in "01"

    @property
    def outcome(self) -> Effect:
        """Mean displacement of the object as it ended: held in the air, or else at rest [m]."""
        return self.effect if self.kind == "held" else self.resting_effect

    @property
    def scatter(self) -> Effect:
        """Standard deviation of `outcome`, each axis [m]."""
        return self.spread if self.kind == "held" else self.resting_spread


CONVERGED = 0.05  # greatest mean squared error to the code of an action that counts as found


class Primitive(Document, frozen=True, omit_defaults=True):
    """An action symbol with distilled parameters; one may have several, each with a letter of its own."""

    symbol: Symbol  #: The action symbol, like "101"
    action: tuple[Length, ...]  #: The distilled action parameters
    code_error: float  #: Mean squared error of the action's embedding to the symbol's +-1 code
    variant: Variant = ""  #: Which of the symbol's parameters these are, empty, or "a", "b" and so on

    @property
    def label(self) -> str:
        """The symbol and the variant, like "101" or "101b"."""
        return self.symbol + self.variant

    @property
    def has_converged(self) -> bool:
        """Whether the action really encodes to the symbol."""
        return self.code_error < CONVERGED


def labelled(primitives: Sequence[Primitive], label: str) -> Primitive:
    """Return the primitive of that label, like "101b" or "101"; `UnknownChoice` if there is none."""
    return one_called("primitive", label, primitives, by="label")


class Rehearsal(Document, frozen=True, array_like=True):
    """How a primitive turned out on one object."""

    kind: OutcomeKind  # how the object ended
    effect: Effect  # its displacement at the end of the rise [m]
    resting_effect: Effect  # its displacement once everything is put down [m]
    peak_height: Length  # its greatest height on the way [m]
    turn: Length  # by what angle it was turned in the end [rad]

    @property
    def outcome(self) -> Effect:
        """Displacement of the object as it ended: held in the air, or else at rest [m]."""
        return self.effect if self.kind == "held" else self.resting_effect


class Category(Document, frozen=True, omit_defaults=True, cache_hash=True):
    """The objects that share one object symbol."""

    symbol: Symbol  #: The object symbol, like "10"
    name: LegalName  #: Readable name, a legal PDDL type
    share: Share  #: Share of the sampled objects, or of the rows of the data, that fall into this category
    feature_means: tuple[Length, ...]  #: Mean of each feature over those objects; empty if there were none
    feature_spreads: tuple[Length, ...]  #: Standard deviation of each feature over those objects
    #: Features of the objects that all its operators were rehearsed on, if that is kept
    objects: tuple[tuple[Length, ...], ...] = ()


def by_share(categories: Iterable[Category]) -> list[Category]:
    """Return categories in an order, the most frequent first."""
    return sorted(categories, key=lambda one: (-one.share, one.symbol))


class Kept(Document, frozen=True):
    """How an operator turned out where there were other objects."""

    name: LegalName  # name of the operator
    trials: Count  # how many rehearsals there were
    kept: Count  # how many ended as promised, on the table, with nothing else moved

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.kept > self.trials:
            raise InvalidValue(f"Of {self.trials} rehearsals, {self.kept} are said to have been kept.")

    @property
    def share(self) -> float:
        """The share that ended so; 1 if there were no rehearsals."""
        return self.kept / self.trials if self.trials else 1.0

    @property
    def chance(self) -> float:
        """The chance that it ends so; 1 if there were no rehearsals."""
        return smoothed(self.kept, self.trials) if self.trials else 1.0


_UNTRIED = Kept("untried", 0, 0)
_KEYS = {"subject": "category", "outcomes": "modes"}


class Operator(Document, frozen=True, omit_defaults=True, cache_hash=True, rename=_KEYS):
    """What one primitive does to one category of objects, or to pairs of one kind."""

    name: LegalName  #: Readable name, a legal PDDL action name, unique in the domain
    subject: Subject  #: Symbol of the category, or of the kind of pairs; `ANY_KIND` for pairs of any kind
    primitive: Symbol  #: Symbol of the primitive
    trials: Count  #: How many rehearsals there were on objects as the world draws them, or rows of the data
    outcomes: tuple[Mode, ...]  #: The outcomes seen in these, most frequent first
    promised: Ending | None = None  #: How it promises to end; None for the most frequent promising end
    variant: Variant = ""  #: Which of the parameters of its primitive it is performed with
    #: How it turned out on each of the `objects` of its category, if that is kept, first in its trials, then
    #: on objects that were chosen since it was unsure what happens to them
    rehearsals: tuple[Rehearsal, ...] = ()
    #: Features of the objects that it was rehearsed on, if they are others than those
    objects: tuple[tuple[Length, ...], ...] = ()
    frame: EffectFrame = "object"  #: What it acts on, and effects are relative to
    company: tuple[tuple[Company, Kept], ...] = ()  #: How it turned out among others, as far as rehearsed

    @property
    def label(self) -> str:
        """The action symbol and the variant, like "101" or "101b"."""
        return self.primitive + self.variant

    @property
    def promise(self) -> Mode | None:
        """The outcome the operator promises; None if it never ends so."""
        asked = self.promised
        found = (one for one in self.outcomes if (one.kind == asked if asked else one.is_promising))
        return next(found, None)

    @property
    def successes(self) -> int:
        """Trials that ended as promised, for an object within the planning tolerance of the mean."""
        return self.promise.near_mean if self.promise else 0

    @property
    def chance(self) -> float:
        """The chance that a step goes as promised, from its rehearsals."""
        return smoothed(self.successes, self.trials)

    @property
    def case(self) -> tuple[str, ...]:
        """How it promises to end, and what company it takes."""
        return (self.promise.kind if self.promise else "", *filter(self.takes, get_args(Company)))

    def is_for(self, kind: Symbol | None) -> bool:
        """Say whether it is for objects of a category, or for pairs of a kind."""
        return self.subject in (ANY_KIND, kind)

    def among(self, how: Company) -> Kept:
        """Return how it turned out in company; there may have been no rehearsals."""
        return dict(self.company).get(how, _UNTRIED)

    def takes(self, how: Company) -> bool:
        """Say whether it is planned with in company; untried, what another one bears is carried to places."""
        usual, kept = (self.promise.share if self.frame == "pair" and self.promise else 1.0), self.among(how)
        if not kept.trials:
            return (self.frame, how) == ("place", "borne")
        return kept.share >= LEAST_SHARE * usual


class Versioned(Document, frozen=True):
    """A document whose field `format` says of which version it is, if it has one."""

    readable: ClassVar[tuple[str, ...]] = ()  # the versions that can be read

    def __post_init__(self) -> None:
        super().__post_init__()
        if said := self._unreadable(getattr(self, "format", None)):
            raise InvalidValue(said)

    @classmethod
    def load(cls, path: Path) -> Self:
        """Read a document; `InvalidFile` if the file is none, or of another version."""
        return cls.decoded(path, read_bytes(path, MOST_JSON))

    @classmethod
    def decoded(cls, path: Path, content: bytes, remedy: str = "") -> Self:
        """Read the document that a file holds; what `InvalidFile` says ends with the remedy."""
        try:
            return decode_json(path, content, cls, remedy)
        except InvalidFile:
            if said := cls._unreadable(decode_json(path, content, _Format, remedy).format):
                raise InvalidFile(path, said + remedy) from None
            raise

    @classmethod
    def _unreadable(cls, found: str | None) -> str:
        known = " and ".join(map(repr, cls.readable))
        is_known = found is None or not cls.readable or found in cls.readable
        return "" if is_known else f"it is of the format {found!r}, and this version reads {known}"


class _Format(msgspec.Struct, frozen=True):
    format: str | None = None


class OperatorTable(Versioned, frozen=True, omit_defaults=True):
    """Categories, primitives, and one operator or two for each pair of them."""

    categories: tuple[Category, ...]  #: In the order of their symbols
    #: In the order of their symbols; of each symbol first the action that it shares among categories, then
    #: those that are for single ones
    primitives: tuple[Primitive, ...]
    #: By primitive, then category, the surest first; pairs that were never tried are missing. In a grounding,
    #: those that promise other outcomes than the likeliest come last
    operators: tuple[Operator, ...]
    #: What the outcomes were measured by, rehearsals of the distilled actions, or averages over the rows of
    #: the data whose action has the primitive's symbol, where there is no world to rehearse in
    measured: Literal["rehearsal", "data"] = "rehearsal"
    format: str = TABLE_FORMATS[0]  #: Version of this table
    readable = TABLE_FORMATS

    def __post_init__(self) -> None:
        super().__post_init__()
        if len(self._widths) > 1:
            raise InvalidValue("All effects must have the same number of axes.")

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
        bits = len(next(iter(self.symbols), ""))
        codes = all_symbols(bits) if bits <= _MOST_BITS else ()
        return tuple(code for code in codes if code not in self.symbols)

    @property
    def _widths(self) -> set[int]:
        return {len(mode.effect) for operator in self.operators for mode in operator.outcomes}


# Names that a person can read, for operators, from what was measured.
#
# Forward is +x (away from the robot), back is -x, left is +y. A name ends with the bits it stands for, so
# that it is unique, and matches `[a-z][a-z0-9-]*`, so that it is legal in PDDL.

CARRIED = 0.02  # least height on the way of an object that was carried and not pushed [m]
NO_EFFECT = 0.01  # displacements below this are none [m]
_DIAGONAL = 0.5  # least share of the lesser axis in the greater that is worth a word


def names_of_features(count: int, given: Sequence[str] = ()) -> tuple[str, ...]:
    """Return the names of so many object features: those given, or `f1`, `f2`, ..."""
    return tuple(given) or tuple(f"f{number}" for number in range(1, count + 1))


def name_axes(count: int) -> tuple[str, ...]:
    """Name so many axes of an effect: x, y and z if there are three, else `e1`, `e2`, ..."""
    return ("x", "y", "z") if count == 3 else tuple(f"e{number}" for number in range(1, count + 1))


def counted_axes(count: int) -> str:
    """Say how many axes there are: `1 axis`, `2 axes`."""
    return f"{count} {'axis' if count == 1 else 'axes'}"


def name_operator(primitive: str, category_name: str, modes: Sequence[Mode]) -> str:
    """Name an operator by what it does: `push-left-101b-hollow-low-10`."""
    promised = next((mode for mode in modes if mode.is_promising), modes[0])
    return f"{verb(promised)}-{primitive}-{category_name}"


_VERBS = {"held": "lift", "carried": "carry-to", "missed": "miss", "lost": "throw-off", "toppled": "topple"}


def verb(mode: Mode) -> str:
    """Say in a word or three what happened to the object: `act`, where effects are not along x, y and z."""
    if mode.kind != "resting" or len(mode.resting_effect) != 3:
        return _VERBS.get(mode.kind, "act")
    x, y, z = mode.resting_effect
    if np.hypot(x, y) < NO_EFFECT:
        return "stay" if abs(z) < NO_EFFECT else "raise" if z > 0 else "lower"
    along_x, along_y = ("forward" if x > 0 else "back"), ("left" if y > 0 else "right")
    way = along_x if abs(x) >= abs(y) else along_y
    if min(abs(x), abs(y)) >= _DIAGONAL * max(abs(x), abs(y)):
        way = f"{along_x}-{along_y}"
    if mode.peak_height > CARRIED:
        return f"place-{way}"
    return f"push-{way}".replace("push-back", "pull")
