"""The sheet of symbols, one SVG file: which objects have which code, and what each action does to them."""

from collections.abc import Iterable, Sequence
from html import escape
from itertools import product
from typing import Any

from neurosym.grounding import Grounding
from neurosym.operators import Category, Symbol, by_share
from neurosym.report.drawings import (
    SIZE,
    effect_drawing,
    ink_on,
    is_body,
    map_drawing,
    object_drawing,
    scale_for,
)
from neurosym.report.symbol_map import Atlas
from neurosym.report.symbols import displacement_in_words
from neurosym.world import CATEGORY_COLOURS, Palette

_COLUMN, _ROW = SIZE[0] + 16, SIZE[1] + 34  # of maps and the legend [pixels]
_ACROSS, _CELL = 8, (84, 92)  # actions beside one another, and the size of an arrow's cell [pixels]
_WIDTH, _SIDE, _LEGEND = 2 * _COLUMN, 2 * _COLUMN - _ACROSS * _CELL[0], 76  # height of a category there
_MATTERS = 0.02  # share of codes that a feature must change for there to be a map of each of its values
_MIDDLE = 'text-anchor="middle" font-family="monospace"'
_NOTE = "What each action does, from where the object stands: filled where it is held, faint where unlikely"


def symbol_sheet(atlas: Atlas, grounding: Grounding) -> str:
    """Draw maps of codes with a legend, and below them each action symbol's effect on each category.

    Args:
        atlas: Which objects have which code.
        grounding: The categories, of which those that have colours are shown, and the operators.
    """
    symbols, palette = grounding.objects.symbols, Palette.of(grounding.objects.categories)
    shown = by_share(grounding.objects.categories)[: len(CATEGORY_COLOURS)]
    cells = [*_maps(atlas, palette), "".join(_legend(atlas, palette, shown))]
    places = [(8 + number % 2 * _COLUMN, 44 + number // 2 * _ROW) for number in range(len(cells))]
    parts = [_text(12, 28, f"Symbols of {grounding.name}", 'font-weight="bold"', 17)]
    parts += [_moved(*place, cell) for place, cell in zip(places, cells, strict=True)]
    top = max(places[-1][1] + _LEGEND * len(shown), 44 + len(cells) // 2 * _ROW) + 16
    parts.append(_text(12, top, _NOTE))
    for start in range(0, len(symbols), _ACROSS):
        parts += _band(atlas, grounding, shown, symbols[start : start + _ACROSS], top + 26)
        top += len(shown) * _CELL[1] + 34
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {top + 20}" width="{_WIDTH}" '
        f'height="{top + 20}" font-family="sans-serif" color="#1d1d1d" fill="#1d1d1d" role="img">'
        f'<title>Symbols of {escape(grounding.name)}</title><rect width="100%" height="100%" fill="#fff"/>'
    )
    return "\n".join((head, *parts, "</svg>\n")).replace("var(--card, #fff)", "#fff")


def _text(x: float, y: float, said: str, more: str = "", size: int = 13) -> str:
    return f'<text x="{x:g}" y="{y:g}" font-size="{size}" {more}>{escape(said)}</text>'


def _moved(x: float, y: float, drawing: str) -> str:
    return f'<g transform="translate({x:g} {y:g})">{drawing}</g>'


def _code(x: float, y: float, symbol: Symbol, palette: Palette) -> str:
    """Draw a code on the colour of its category."""
    box = f'x="{x}" y="{y - 15:g}" width="{9 * len(symbol) + 12}" height="20" rx="3"'
    style = f'font-family="monospace" font-weight="bold" style="fill:{ink_on(palette(symbol))}"'
    return f'<rect {box} fill="{palette.hex(symbol)}"/>' + _text(x + 6, y, symbol, style, 14)


def _maps(atlas: Atlas, palette: Palette) -> Iterable[str]:
    """Draw a map for each value of the third feature, if it matters, or else one of objects like most."""
    at = list(atlas.typical)
    third = next((one for one in atlas.others if atlas.matter[one] >= _MATTERS), atlas.axes[0])
    for number, value in enumerate(atlas.settings(third) if third in atlas.others else at[:1]):
        at[third] = value
        told = ", ".join(f"{(f := atlas.features[one]).word} {f.told(at[one])}" for one in atlas.others)
        drawing = map_drawing(atlas.map(at), palette, title=told, name=f"map-{number}")
        yield _text(46, 6, told) + f'<svg y="10" width="{SIZE[0]}" height="{SIZE[1]}">{drawing}</svg>'


def _legend(atlas: Atlas, palette: Palette, shown: Sequence[Category]) -> Iterable[str]:
    """Draw for each category its colour, code, name and share, and objects of it."""
    for row, one in enumerate(shown):
        top = 6 + row * _LEGEND
        yield _code(8, top, one.symbol, palette)
        yield _text(28 + 9 * len(one.symbol), top, f"{one.name}, {one.share:.0%}")
        for number, values in enumerate(atlas.examples(one.symbol)):
            item = object_drawing(values, atlas.features, palette(one.symbol), width=78, height=48)
            yield _moved(8 + 84 * number, top + 6, item)


def _band(
    atlas: Atlas, grounding: Grounding, shown: Sequence[Category], symbols: Sequence[Symbol], top: float
) -> Iterable[str]:
    """Draw the effects of some actions, a column each, on all categories, a row each."""
    table, palette = grounding.objects, Palette.of(grounding.objects.categories)
    found = [(one.promise or mode).outcome for one in table.operators for mode in one.outcomes[:1]]
    items = {
        one.symbol: tuple(next(iter(atlas.examples(one.symbol, 1)), ())) if is_body(atlas.features) else ()
        for one in shown
    }
    scale = scale_for(product(found, items.values()), _CELL[1])
    for column, symbol in enumerate(symbols):
        yield _text(_SIDE + (column + 0.5) * _CELL[0], top + 8, symbol, _MIDDLE)
    for row, category in enumerate(shown):
        y = top + 14 + row * _CELL[1]
        yield _code(12, y + _CELL[1] / 2, category.symbol, palette)
        look: dict[str, Any] = {
            "item": items[category.symbol],
            "colour": palette(category.symbol),
            "scale": scale,
        }
        look |= {"width": _CELL[0], "height": _CELL[1]}
        for column, symbol in enumerate(symbols):
            operator = grounding.operator_for(category.symbol, symbol)
            if operator is None or not operator.outcomes:
                continue
            end, kept = operator.promise or operator.outcomes[0], f"{operator.successes} of {operator.trials}"
            look["told"] = f"{operator.name}: {end.kind}, {displacement_in_words(end.outcome)}; {kept}"
            arrow = effect_drawing(end.outcome, chance=operator.chance, is_held=end.kind == "held", **look)
            yield _moved(_SIDE + column * _CELL[0], y, arrow)
