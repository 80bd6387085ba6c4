"""An explanation of symbols, as Markdown or for a terminal."""

import textwrap
from collections.abc import Iterator, Sequence

from neurosym.console import say, width
from neurosym.explain.explained import EffectRow, Explanation, SymbolExplanation
from neurosym.wording import harmless

_WIDEST = 110  # columns of running text
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
    for name, symbols in explanation.parts.items():
        for symbol in symbols:
            if is_long(explanation):
                _say_wrapped(f"  {symbol.symbol}: {symbol.title}")
                continue
            say("")
            _say_wrapped(f"{_KINDS[name]} symbol {symbol.symbol}: {symbol.title}")
            for line in _told(symbol):
                _say_wrapped(f"  {line}")
    if is_long(explanation):
        _say_wrapped("With --symbol all that is known of one is said, and --output FILE.md writes all of it.")


def explanation_page(explanation: Explanation, title: str) -> str:
    """Return an explanation as a page of Markdown.

    Args:
        explanation: The explanation.
        title: Name of the domain.
    """
    blocks = [f"# What the symbols of {title} mean", *explanation.summary]
    for name, symbols in explanation.parts.items():
        blocks.append(f"## {_KINDS[name]} symbols")
        for symbol in symbols:
            effects = "\n".join(_effects(symbol.effects))
            blocks += [f"### {symbol.symbol}: {symbol.title}", symbol.about, effects]
    text = "\n\n".join(filter(None, blocks)) + "\n"
    return harmless(text).replace("<", "&lt;")  # names in data of a user's own may hold anything


def _told(symbol: SymbolExplanation) -> list[str]:
    return [line for line in (symbol.about, *_effects(symbol.effects)) if line]


def _effects(effects: Sequence[EffectRow]) -> Iterator[str]:
    """Yield a line for each operator, whole so that its name can be copied, and one for each of its modes."""
    before = ""
    for row in effects:
        if row.operator != before:
            yield f"- {row.operator} ({row.trials} trials, {row.promised} as promised{_domain(row)})"
        before = row.operator
        effect = f": {row.effect} ({row.spread})" if row.effect else ""
        yield f"    - {row.share:.0%} {row.ends}{effect}"


def _domain(row: EffectRow) -> str:
    if not row.domain:
        return ""
    return ", in the domain" if row.domain == "yes" else f", not in the domain{row.domain.removeprefix('no')}"


def _say_wrapped(text: str) -> None:
    """Print text between words, and never broken within a name."""
    indent = " " * (len(text) - len(text.lstrip()))
    for line in textwrap.wrap(
        text, min(width(), _WIDEST), subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    ):
        say(line)
