"""An explanation of symbols, as Markdown or for a terminal."""

import textwrap
from collections.abc import Sequence

from neurosym.console import say, width
from neurosym.explain.explained import EffectRow, Explanation, SymbolExplanation
from neurosym.markdown import markdown_table
from neurosym.wording import harmless

_COLUMNS = ("operator", "trials", "as promised", "share", "ends", "effect", "spread")
_WIDEST = 110  # columns of running text
_INDENT = "  "
_MANY = 60
_KINDS = {
    "actions": "Action",
    "carrying": "Carrying",
    "relating": "Relating",
    "states": "Pair state",
    "pairs": "Pair",
    "objects": "Object",
}


def is_long(explanation: Explanation) -> bool:
    """Say whether there are so many symbols that a terminal shows only what each is called."""
    return sum(map(len, explanation.parts.values())) > _MANY


def show_explanation(explanation: Explanation) -> None:
    """Print an explanation for a terminal; of many symbols only what each is called."""
    for line in explanation.summary:
        _say_wrapped(line)
    if is_long(explanation):
        _say_titles(explanation)
        return
    for kind, symbols in _parts(explanation):
        for symbol in symbols:
            say("")
            _say_wrapped(f"{kind} symbol {symbol.symbol}: {symbol.title}")
            _say_wrapped(symbol.about, _INDENT)
            _say_effects(symbol.effects)
            _say_wrapped(symbol.compared, _INDENT)


def explanation_page(explanation: Explanation, title: str) -> str:
    """Return an explanation as a page of Markdown.

    Args:
        explanation: The explanation.
        title: Name of the domain.
    """
    blocks = [f"# What the symbols of {title} mean", *explanation.summary]
    for kind, symbols in _parts(explanation):
        blocks.append(f"## {kind} symbols")
        for symbol in symbols:
            table = markdown_table(*_effects(symbol.effects)) if symbol.effects else ""
            blocks += [f"### {symbol.symbol}: {symbol.title}", symbol.about, table, symbol.compared]
    text = "\n\n".join(filter(None, blocks)) + "\n"
    return harmless(text).replace("<", "&lt;")  # names in data of a user's own may hold anything


def _parts(explanation: Explanation) -> tuple[tuple[str, tuple[SymbolExplanation, ...]], ...]:
    return tuple((_KINDS[name], symbols) for name, symbols in explanation.parts.items())


def _say_titles(explanation: Explanation) -> None:
    for kind, symbols in _parts(explanation):
        say("")
        _say_wrapped(f"{kind} symbols:")
        for symbol in symbols:
            _say_wrapped(f"{symbol.symbol}: {symbol.title}", _INDENT)
    say("")
    _say_wrapped("With --symbol all that is known of one is said, and --output FILE.md writes all of it.")


def _effects(effects: Sequence[EffectRow]) -> tuple[list[str], list[list[str]]]:
    """Return headings and cells; what is said of an operator stands beside its first mode only."""
    with_domain = any(row.domain for row in effects)
    rows, before = [], ""
    for row in effects:
        is_first, before = row.operator != before, row.operator
        cells = [row.operator, str(row.trials), str(row.promised)] if is_first else [""] * 3
        cells += [f"{row.share:.0%}", row.ends, row.effect, row.spread]
        rows.append([*cells, row.domain if is_first else ""] if with_domain else cells)
    return [*_COLUMNS, "in the domain"] if with_domain else [*_COLUMNS], rows


def _say_effects(effects: Sequence[EffectRow]) -> None:
    """Print a line for each operator, whole so that its name can be copied, and one for each of its modes."""
    before = ""
    for row in effects:
        if row.operator != before:
            _say_wrapped(
                f"- {row.operator} ({row.trials} trials, {row.promised} as promised{_domain(row)})", _INDENT
            )
        before = row.operator
        effect = f": {row.effect} ({row.spread})" if row.effect else ""
        _say_wrapped(f"{row.share:.0%} {row.ends}{effect}", 3 * _INDENT)


def _domain(row: EffectRow) -> str:
    if not row.domain:
        return ""
    return ", in the domain" if row.domain == "yes" else f", not in the domain{row.domain.removeprefix('no')}"


def _say_wrapped(text: str, indent: str = "") -> None:
    """Print text between words, and never broken within a name."""
    for line in textwrap.wrap(
        text,
        min(width(), _WIDEST),
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    ):
        say(line)
