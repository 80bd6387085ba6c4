"""The learned symbols, as a table at the head of the page: what each does to each category."""

from collections.abc import Iterable, Sequence

from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.moves import chance
from neurosym.tasks.puts import Put, puts_of

_NOTHING = "-"
_ROW = "  "
"""What rows of a table begin with."""


def symbol_table(grounding: Grounding, *, with_others: bool = True) -> tuple[str, ...]:
    """Print what each action symbol does, a line each.

    A symbol has several motions, with parameters of their own; it is told what the surest of them does.

    Args:
        grounding: The learned domain.
        with_others: Whether carrying to places, and putting on and into others, is told, too.
    """
    categories = sorted(grounding.operators.categories, key=lambda one: one.symbol)
    names = {category.symbol: category.name for category in categories}
    rows = [["symbol", *names.values()], *_rows(grounding.live, names)]
    carriers = _rows(carriers_of(grounding), names) if with_others else []
    lines = [
        "Learned action symbols: what the surest motion of each does to a category, how far in mm, how often."
    ]
    lines += _lines(rows)
    if carriers:
        lines += ["Symbols of carrying: how often each brings these categories, column by column, to places."]
        lines += _lines(carriers)
    if with_others and (puts := puts_of(grounding)):
        lines += ["Symbols of putting on or in others: for how many learned kinds of pairs, and how often."]
        lines += _of_pairs(puts)
    return tuple(lines)


def _lines(rows: Sequence[Sequence[str]]) -> list[str]:
    """Print rows with columns as wide as they need."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    padded = (zip(row, widths, strict=True) for row in rows)
    return [_ROW + "  ".join(cell.ljust(width) for cell, width in row).rstrip() for row in padded]


def _rows(operators: Sequence[Operator], names: dict[str, str]) -> list[list[str]]:
    """Return a row for each symbol, with what its surest motion does to each category."""
    rows = []
    for symbol in sorted({one.primitive for one in operators}):
        surest = {
            category: max(
                (one for one in operators if (one.primitive, one.category) == (symbol, category)),
                key=lambda one: (chance(one), one.name),
                default=None,
            )
            for category in names
        }
        rows.append([symbol, *(_told(one) if one else _NOTHING for one in surest.values())])
    return rows


def _told(operator: Operator) -> str:
    """Say what an operator does to its category, how far in mm, and how surely."""
    verb = operator.name.split(f"-{operator.label}-")[0]
    promise = operator.promise
    if promise is None:
        return _NOTHING
    x, y, z = promise.outcome
    far = f" {1000 * z:.0f}" if is_lift(operator) else f" {1000 * (x * x + y * y) ** 0.5:.0f}"
    said = "" if verb.startswith("carry") else f"{verb}{far} "
    return f"{said}{chance(operator):.0%}"


def _of_pairs(puts: Iterable[Put]) -> list[str]:
    """Print a row for each symbol, with the relations that it leads to."""
    rows = dict[str, dict[str, list[float]]]()
    for put in puts:
        if put.kind:
            rows.setdefault(put.operator.primitive, {}).setdefault(put.state.name, []).append(put.chance())
    return [
        f"{_ROW}{symbol}  "
        + ", ".join(f"{state} {len(found)}, {_span(found)}" for state, found in sorted(of.items()))
        for symbol, of in sorted(rows.items())
    ]


def _span(shares: Sequence[float]) -> str:
    return " to ".join(dict.fromkeys(f"{share:.0%}" for share in (min(shares), max(shares))))
