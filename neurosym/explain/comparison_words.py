"""How symbols compare with one another, in words."""

from collections.abc import Collection, Mapping

from neurosym.explain.action_words import AXES, displacement_in_words, distance_in_words
from neurosym.explain.likeness import Difference, Likeness, Sorting
from neurosym.operators import Mode
from neurosym.symbols import Symbol
from neurosym.world import OutcomeKind

ENDS: dict[OutcomeKind, str] = {
    "resting": "at rest",
    "held": "held",
    "toppled": "on another face",
    "carried": "carried to the place",
    "missed": "not carried to the place",
    "lost": "off the table",
}
_MOST_TOLD = 2  # places where two symbols differ most


def sorting_in_words(sorting: Sorting, count: int, axes: int) -> tuple[str, ...]:
    """Say how many action symbols do something of their own, and by which criterion.

    Args:
        sorting: Which do.
        count: How many action symbols there are.
        axes: How many numbers an effect has.
    """
    within = distance_in_words(sorting.within, axes)
    pairs = ", ".join(f"{symbol} of {original}" for symbol, original in sorting.duplicates.items())
    idle = ", ".join(sorting.idle)
    order = ", forward, left and up" if axes == AXES else ""
    return (
        f"Of {count} action symbols, {len(sorting.own)} {_do(sorting.own)} something of their own, "
        f"{len(sorting.duplicates)} {_are(sorting.duplicates)} duplicates{f' ({pairs})' if pairs else ''}, "
        f"{len(sorting.idle)} {_are(sorting.idle)} idle{f' ({idle})' if idle else ''}.",
        f"Duplicate: on average over the objects, it promises what another does to within {within}, and it "
        f"ends alike (held, at rest) on each category. Idle: it promises less than {within} of motion.",
        f"± is one standard deviation{order}; an operator promises its most frequent end at rest or held.",
    )


def verdict_in_words(symbol: Symbol, sorting: Sorting, axes: int) -> tuple[str, ...]:
    """Say whether an action symbol is a duplicate or idle; nothing if it is neither."""
    if symbol in sorting.duplicates:
        return (f"It is a duplicate of {sorting.duplicates[symbol]}.",)
    if symbol in sorting.idle:
        return (f"It is idle: it promises less than {distance_in_words(sorting.within, axes)} on average.",)
    return ()


def competitor_in_words(
    symbol: Symbol, nearest: Likeness | None, names: Mapping[Symbol, str], axes: int
) -> str:
    """Say which other action symbol does the most similar thing, and in what they differ most.

    Args:
        symbol: The action symbol.
        nearest: The other, if there is one.
        names: Names of the categories.
        axes: How many numbers an effect has.
    """
    if nearest is None:
        return "There is no other action symbol to compare it with."
    far = distance_in_words(nearest.apart, axes)
    about = f"Nearest competitor: {nearest.other}, {far} apart on average over the objects."
    told = [
        _difference(symbol, nearest.other, names[part.where], part, axes)
        for part in nearest.differences[:_MOST_TOLD]
        if part.apart
    ]
    return f"{about} They differ most {'; '.join(told)}." if told else about


def category_in_words(nearest: Likeness, names: Mapping[Symbol, str], axes: int) -> str:
    """Say to which other category the most similar things are done, and what differs most.

    Args:
        nearest: The other category.
        names: Names of the categories.
        axes: How many numbers an effect has.
    """
    far = distance_in_words(nearest.apart, axes)
    most = nearest.differences[0]
    about = (
        f"Most alike in what is done to it: {names[nearest.other]}, {far} apart on average over the actions"
    )
    if not most.apart:
        return f"{about}."
    return f"{about}; most with {most.where}: {_outcome(most.mine)} here, {_outcome(most.other)} there."


def _difference(symbol: Symbol, other: Symbol, name: str, part: Difference, axes: int) -> str:
    where = f"on {name} ({distance_in_words(part.apart, axes)})"
    return f"{where}: {symbol} leaves it {_outcome(part.mine)}, {other} {_outcome(part.other)}"


def _do(symbols: Collection[Symbol]) -> str:
    return "does" if len(symbols) == 1 else "do"


def _are(symbols: Collection[Symbol]) -> str:
    return "is" if len(symbols) == 1 else "are"


def _outcome(mode: Mode) -> str:
    place = displacement_in_words(mode.outcome)
    return f"{ENDS[mode.kind]} {'where it was' if place == 'nowhere' else place}"
