"""Formats: how operators that carry to places, or act on pairs, stand in files, and both ways between."""

from typing import Any, Self, get_args

import msgspec

from neurosym.checks import Document, decoding
from neurosym.operators import (
    Category,
    Company,
    Count,
    Effect,
    Kept,
    LegalName,
    Operator,
    OperatorTable,
    Primitive,
    Share,
    Subject,
    Symbol,
    Variant,
    Versioned,
)
from neurosym.pair_operators import OF_PAIRS, PairStates, RelationOperators, pair_end


class PlaceFile(Versioned, frozen=True):
    """What carries objects to places, and beside the table how that turned out among others."""

    operators: OperatorTable
    occupied: tuple[Kept, ...] = ()
    beside: tuple[Kept, ...] = ()
    format: str = "neurosym-places-1"
    borne: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET
    laden: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET
    readable = ("neurosym-places-1",)

    @classmethod
    def holding(cls, table: OperatorTable) -> Self:
        """Return what a file holds of a table; of company that was never tried it may say nothing."""
        found: dict[str, Any] = {}
        for how, kept in (row for one in table.operators for row in one.company):
            found[how] = (*found.get(how, ()), kept)
        plain = (msgspec.structs.replace(one, frame="object", company=()) for one in table.operators)
        return cls(msgspec.structs.replace(table, operators=tuple(plain)), **found)

    @decoding()
    def table(self) -> OperatorTable:
        """Return the table."""
        found = dict[str, Any]()
        for how in get_args(Company):
            for kept in getattr(self, how) or ():
                found[kept.name] = (*found.get(kept.name, ()), (how, kept))
        operators = (
            msgspec.structs.replace(one, frame="place", company=found.get(one.name, ()))
            for one in self.operators.operators
        )
        return msgspec.structs.replace(self.operators, operators=tuple(operators))


class _PairEnd(Document, frozen=True):
    state: str  # empty if the target was not carried to the reference
    count: Count
    share: Share
    offset: Effect
    spread: Effect


class _PairOperator(Document, frozen=True):
    name: LegalName
    pair: Subject
    primitive: Symbol
    trials: Count
    ends: tuple[_PairEnd, ...]
    borne: Kept
    occupied: Kept
    laden: Kept
    variant: Variant = ""
    promised: str = ""  # empty for the most frequent state


class PairFile(PairStates, frozen=True):
    """States and kinds of pairs, and what brings pairs into these states."""

    pairs: tuple[Category, ...]
    primitives: tuple[Primitive, ...]
    operators: tuple[_PairOperator, ...]
    format: str = "neurosym-relations-2"
    readable = ("neurosym-relations-2",)

    @classmethod
    def holding(cls, table: RelationOperators) -> Self:
        """Return what a file holds of a table."""
        found = []
        for one in table.operators:
            ends = (
                _PairEnd(end.kind.replace("missed", ""), end.count, end.share, end.effect, end.spread)
                for end in one.outcomes
            )
            told = one.name, one.subject, one.primitive, one.trials, tuple(ends)
            kept: dict[Any, Any] = {how: Kept(one.name, 0, 0) for how in OF_PAIRS} | dict(one.company)
            found.append(_PairOperator(*told, **kept, variant=one.variant, promised=one.promised or ""))
        return cls(table.states, table.scales, table.pairs, table.primitives, tuple(found))

    @decoding()
    def table(self) -> RelationOperators:
        """Return the table."""
        found = []
        for one in self.operators:
            ends = (pair_end(*msgspec.structs.astuple(end)) for end in one.ends)
            told = one.name, one.pair, one.primitive, one.trials, tuple(ends), one.promised or None
            company = tuple((how, getattr(one, how)) for how in OF_PAIRS)
            found.append(Operator(*told, one.variant, frame="pair", company=company))
        return RelationOperators(self.states, self.scales, self.pairs, self.primitives, tuple(found))
