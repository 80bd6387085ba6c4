"""Which symbols do similar things: how far apart the effects are that operators promise.

Two action symbols are compared on every category that both were rehearsed on, weighted by the categories'
shares; two categories by every action symbol that both were rehearsed with, each weighing the same.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from neurosym.naming import NO_EFFECT
from neurosym.operators import Mode, Operator, OperatorTable
from neurosym.symbols import Symbol

_IN_METRES = 3  # axes of effects that are x, y, z [m]
_SMALL = 0.1  # share of the mean effect that counts as none, where effects are not in metres


@dataclass(frozen=True, slots=True)
class Difference:
    """How two symbols differ in one place: two action symbols on a category, or the other way round.

    Attributes:
        where: Symbol of that category or primitive.
        weight: How much of the whole comparison it is.
        apart: Distance between the two outcomes [m].
        mine: What the first symbol brings about.
        other: What the second symbol brings about.
    """

    where: Symbol
    weight: float
    apart: float
    mine: Mode
    other: Mode


@dataclass(frozen=True, slots=True)
class Likeness:
    """How much alike two symbols are.

    Attributes:
        other: The symbol that one is compared with.
        apart: Weighted mean of the distances between outcomes [m].
        differences: Where they differ, what contributes most first.
    """

    other: Symbol
    apart: float
    differences: tuple[Difference, ...]

    @property
    def ends_alike(self) -> bool:
        """Whether objects end in the same way (held, at rest, ...) everywhere."""
        return all(part.mine.kind == part.other.kind for part in self.differences)


@dataclass(frozen=True, slots=True)
class Sorting:
    """Which action symbols are worth having.

    Attributes:
        within: Effects that differ by less count as the same, smaller ones as none [m].
        own: Those that do something of their own.
        duplicates: Those that do what one of `own` does, each with that one.
        idle: Those that promise to move nothing, on average over the objects.
    """

    within: float
    own: tuple[Symbol, ...]
    duplicates: dict[Symbol, Symbol]
    idle: tuple[Symbol, ...]


class Likenesses:
    """Compares the symbols of a table, by the surest operator of each pair.

    Args:
        table: What each primitive does to each category.
    """

    def __init__(self, table: OperatorTable):
        self._primitives = table.symbols
        self._shares = {category.symbol: category.share for category in table.categories}
        self._by_primitive: dict[Symbol, dict[Symbol, Mode]] = {}
        self._by_category: dict[Symbol, dict[Symbol, Mode]] = {}
        for operator in table.operators:
            if (mode := typical(operator)) is not None:
                self._by_primitive.setdefault(operator.primitive, {}).setdefault(operator.category, mode)
                self._by_category.setdefault(operator.category, {}).setdefault(operator.primitive, mode)

    def nearest_action(self, symbol: Symbol) -> Likeness | None:
        """Return the action symbol that does the most similar thing, or None if there is none to compare."""
        return _nearest(self._by_primitive, symbol, self._shares)

    def nearest_category(self, symbol: Symbol) -> Likeness | None:
        """Return the category to which the most similar things are done, or None."""
        return _nearest(self._by_category, symbol, dict.fromkeys(self._primitives, 1.0))

    def sort_out(self) -> Sorting:
        """Tell action symbols that do something of their own from duplicates and idle ones.

        A symbol is a duplicate if, averaged over the categories, its outcomes lie within 10 mm of those of a
        symbol before it, and objects end in the same way everywhere. It is idle if its outcomes lie within
        10 mm of the start. Where effects are not x, y, z, it is a tenth of the mean effect instead of 10 mm.
        """
        sizes = {symbol: self._mean_size(symbol) for symbol in self._primitives}
        measured = [size for size in sizes.values() if size is not None]
        within = NO_EFFECT if self._axes() == _IN_METRES else _SMALL * float(np.mean(measured or [0.0]))
        idle = tuple(symbol for symbol, size in sizes.items() if size is not None and size < within)
        own: list[Symbol] = []
        duplicates: dict[Symbol, Symbol] = {}
        for symbol in self._primitives:
            if symbol in idle or sizes[symbol] is None:
                continue
            same = self._same(symbol, own, within)
            if same is None:
                own.append(symbol)
            else:
                duplicates[symbol] = same
        return Sorting(within=within, own=tuple(own), duplicates=duplicates, idle=idle)

    def _same(self, symbol: Symbol, others: list[Symbol], within: float) -> Symbol | None:
        rows = {other: self._by_primitive[other] for other in [*others, symbol]}
        nearest = _nearest(rows, symbol, self._shares, ends_alike=True)
        return nearest.other if nearest and nearest.apart < within else None

    def _mean_size(self, symbol: Symbol) -> float | None:
        """Return how far a primitive moves objects, on average over the categories [m]."""
        row = self._by_primitive.get(symbol, {})
        weights = [self._shares[where] for where in row]
        if not sum(weights):
            return None
        return float(np.average([np.linalg.norm(mode.outcome) for mode in row.values()], weights=weights))

    def _axes(self) -> int:
        return next((len(mode.outcome) for row in self._by_primitive.values() for mode in row.values()), 0)


def typical(operator: Operator) -> Mode | None:
    """Return the mode that an operator promises; its most frequent one if it promises none."""
    return operator.promise or next(iter(operator.modes), None)


def _nearest(
    rows: Mapping[Symbol, Mapping[Symbol, Mode]],
    symbol: Symbol,
    weights: Mapping[Symbol, float],
    *,
    ends_alike: bool = False,
) -> Likeness | None:
    others = [other for other in rows if other != symbol and symbol in rows]
    found = [compare(rows[symbol], rows[other], weights, other) for other in others]
    known = [likeness for likeness in found if likeness and (likeness.ends_alike or not ends_alike)]
    return min(known, key=lambda likeness: (likeness.apart, likeness.other), default=None)


def compare(
    mine: Mapping[Symbol, Mode], others: Mapping[Symbol, Mode], weights: Mapping[Symbol, float], other: Symbol
) -> Likeness | None:
    """Compare what two symbols do wherever both were rehearsed, or return None if that is nowhere.

    Args:
        mine: What the first does, by category or primitive.
        others: What the second does.
        weights: How much each category or primitive weighs.
        other: The second symbol.
    """
    shared = [where for where in mine if where in others and weights[where]]
    if not shared:
        return None
    total = sum(weights[where] for where in shared)
    parts = [
        Difference(
            where, weights[where] / total, _distance(mine[where], others[where]), mine[where], others[where]
        )
        for where in shared
    ]
    parts.sort(key=lambda part: (-part.weight * part.apart, part.where))
    return Likeness(other, sum(part.weight * part.apart for part in parts), tuple(parts))


def _distance(one: Mode, other: Mode) -> float:
    return float(np.linalg.norm(np.subtract(one.outcome, other.outcome)))
