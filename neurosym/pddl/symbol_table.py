"""The learned symbols, as a table at the head of the page: what each does to each category."""

from collections.abc import Iterable, Sequence

from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.moves import chance
from neurosym.tasks.puts import Put, puts_of

_NOTHING = "-"


def symbol_table(grounding: Grounding) -> tuple[str, ...]:
    """Print what each action symbol does, a line each.

    A symbol has several motions, with parameters of their own; it is told what the surest of them does.

    Args:
        grounding: The learned domain.
    """
    categories = sorted(grounding.operators.categories, key=lambda one: one.symbol)
    names = {category.symbol: category.name for category in categories}
    rows = [["symbol", *names.values()], *_rows(grounding.live, names)]
    carriers = _rows(carriers_of(grounding), names)
    widths = [max(map(len, column)) for column in zip(*rows, *carriers, strict=True)]
    lines = ["Learned action symbols: what the surest motion of each does, how far in mm, and how often."]
    lines += [_line(row, widths) for row in rows]
    if carriers:
        lines += ["Symbols of carrying: how often the surest motion of each brings an object to its place."]
        lines += [_line(row, widths) for row in carriers]
    if puts := puts_of(grounding):
        lines += ["Symbols of putting on and into others: with how many kinds of pairs, and how surely."]
        lines += _of_pairs(puts)
    return tuple(lines)


def _line(row: Sequence[str], widths: Sequence[int]) -> str:
    return "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()


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
    far = f" {1000 * z:.0f} up" if is_lift(operator) else f" {1000 * (x * x + y * y) ** 0.5:.0f}"
    said = "" if verb.startswith("carry") else f"{verb}{far} "
    return f"{said}{chance(operator):.0%}"


def _of_pairs(puts: Iterable[Put]) -> list[str]:
    """Print a row for each symbol, with the relations that it leads to."""
    rows = dict[str, dict[str, list[float]]]()
    for put in puts:
        if put.kind:
            rows.setdefault(put.operator.primitive, {}).setdefault(put.state.name, []).append(put.chance())
    return [
        f"{symbol}  "
        + ", ".join(
            f"{state} with {len(found)}, {min(found):.0%} to {max(found):.0%}"
            for state, found in sorted(of.items())
        )
        for symbol, of in sorted(rows.items())
    ]
