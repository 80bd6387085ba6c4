"""What is said of the symbols of a domain, as values that a page, a terminal or a program can show."""

from dataclasses import dataclass, replace

from neurosym.errors import UnknownChoice
from neurosym.symbols import Symbol

_PARTS = ("actions", "carrying", "relating", "states", "pairs", "objects")


@dataclass(frozen=True, slots=True)
class EffectRow:
    """One way that an action symbol turns out on a category.

    Attributes:
        operator: Name of the operator, as in the PDDL domain.
        trials: How many rehearsals there were, or rows of the data.
        promised: How many of them ended within the tolerance of what the operator promises.
        share: Share of the rehearsals that ended so.
        ends: How the object ended.
        effect: Mean displacement as it ended, in words.
        spread: Its standard deviation on each axis, in words.
        domain: Whether the operator is in the PDDL domain, or why not; empty if nobody knows.
    """

    operator: str
    trials: int
    promised: int
    share: float
    ends: str
    effect: str
    spread: str
    domain: str


@dataclass(frozen=True, slots=True)
class SymbolExplanation:
    """What one symbol means.

    Attributes:
        symbol: Its bits.
        title: What an action symbol does to which share of the objects; the name of a category.
        about: Sentences on what the hand does, or on which objects have the symbol.
        effects: What an action symbol does, by category and mode; empty for object symbols.
    """

    symbol: Symbol
    title: str
    about: str
    effects: tuple[EffectRow, ...] = ()

    @property
    def called(self) -> frozenset[str]:
        """What it may be called by: its bits, its name, and its operators."""
        return frozenset((self.symbol, self.title, *(row.operator for row in self.effects)))


@dataclass(frozen=True, slots=True)
class Explanation:
    """What the symbols of a domain mean.

    Attributes:
        summary: How many symbols there are, and what is said of all.
        actions: The action symbols, in the order of their bits.
        objects: The object symbols, in the order of their bits.
        carrying: The symbols of actions that are aimed at a place, if these were learned.
        relating: The symbols of actions that are aimed at another object, if these were learned.
        states: The states of pairs of objects, if these were learned.
        pairs: The kinds of pairs of objects, if these were learned.
    """

    summary: tuple[str, ...]
    actions: tuple[SymbolExplanation, ...]
    objects: tuple[SymbolExplanation, ...]
    carrying: tuple[SymbolExplanation, ...] = ()
    relating: tuple[SymbolExplanation, ...] = ()
    states: tuple[SymbolExplanation, ...] = ()
    pairs: tuple[SymbolExplanation, ...] = ()

    @property
    def parts(self) -> dict[str, tuple[SymbolExplanation, ...]]:
        """What is said of each kind of symbols, as far as there are any."""
        every = {name: getattr(self, name) for name in _PARTS}
        return {name: part for name, part in every.items() if part}

    def only(self, symbol: str) -> "Explanation":
        """Keep what is said of one symbol, which may be one of actions and of objects alike.

        Args:
            symbol: Its bits, its name, or an operator of it.

        Raises:
            UnknownChoice: If there is none.
        """
        parts = {
            name: tuple(one for one in part if symbol in one.called) for name, part in self.parts.items()
        }
        if not any(parts.values()):
            known = dict.fromkeys(one.symbol for part in self.parts.values() for one in part)
            raise UnknownChoice("symbol", symbol, known, "`neurosym explain DIR`")
        return replace(self, summary=(), **parts)
