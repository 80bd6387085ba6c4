"""Drawings of symbols as SVG: maps of codes, objects of each category, and effects as arrows to scale.

A drawing is a string of HTML. Text is in the colour of the text around it, and what lies beneath in that of
`--card`; a category has its colour, and nothing else has one. Things are drawn as the pictures show them:
seen from the front and the right, so that forward comes nearer and left is to the right.
"""

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from html import escape

import numpy as np

from neurosym.checks import Float
from neurosym.operators import NO_EFFECT, Symbol
from neurosym.report.charts import round_values
from neurosym.report.symbol_map import Feature, SymbolMap
from neurosym.world import OTHER, Colour, Palette

PLOT = (46.0, 10.0, 350.0, 262.0)
"""Edges of a map: left, top, right, bottom [pixels]; below and to the left there is room for the axes."""
SIZE = (360, 306)
_BAND = 60.0  # height of the map of a single feature
_YAW, _PITCH = math.radians(52), math.radians(30)  # of the camera that makes the pictures
_HOLE = 0.15  # thickness of walls, as a share of the lesser side
_ROUND = np.linspace(0, 2 * math.pi, 24, endpoint=False)
_SQUARE = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
_AXES = 3  # along which an effect can be drawn as an arrow
_LEAST_WIDE = 1.2  # width of a drawing by its height, below which the greatest object fits in its width
_FAINT = 0.25  # opacity of an effect that never comes about as promised
_VEIL = 0.5  # how much of what an effect happens to is veiled, so that the arrow is seen
_HEAD, _BELOW = 8.0, 26.0  # length of the head of an arrow, and room below an object's middle [pixels]
Polygon = Float[np.ndarray, "P 2"]


def hexed(colour: Colour, light: float = 1.0) -> str:
    """Write a colour as a page does, darker if the light is below 1."""
    return "#{:02x}{:02x}{:02x}".format(*(round(part * light) for part in colour))


def ink_on(colour: Colour) -> str:
    """Return black or white, whichever is read better on a colour."""
    parts = [(part / 255 / 12.92 if part <= 10 else ((part / 255 + 0.055) / 1.055) ** 2.4) for part in colour]
    luminance = 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]
    return "#000" if luminance > 0.179 else "#fff"


def chip(symbol: Symbol, palette: Palette) -> str:
    """Draw a code on the colour of its category, as a piece of HTML."""
    style = f"background:{palette.hex(symbol)};color:{ink_on(palette(symbol))}"
    return f'<span class="bits" style="{style}">{escape(symbol)}</span>'


def legend(palette: Palette, names: Mapping[Symbol, str], shares: Mapping[Symbol, float]) -> str:
    """List categories with colour, code, name and share, as a piece of HTML."""
    lines = (
        f"<li>{chip(symbol, palette)} {escape(name)}, {shares.get(symbol, 0):.0%}</li>"
        for symbol, name in names.items()
    )
    return f'<ul class="legend">{"".join(lines)}</ul>'


def map_drawing(shown: SymbolMap, palette: Palette, *, title: str = "", name: str = "map") -> str:
    """Draw a map of codes, each area in the colour of its category.

    The attribute `data-map` tells a script how to read a place: for each axis, the number of its feature, its
    ends, and where these lie [pixels of the view box].

    Args:
        shown: The map.
        palette: The colours.
        title: What it is a map of, for those who do not see it.
        name: Its id in the page.
    """
    left, top, right, bottom = PLOT
    is_plane = len(shown.axes) == 2
    bottom = bottom if is_plane else top + _BAND
    width, height = SIZE[0], bottom + SIZE[1] - PLOT[3]
    ends = [(left, right), (bottom, top)][: len(shown.axes)]
    scale = [
        {"feature": number, "name": axis.name, "low": axis.low, "high": axis.high, "from": start, "to": end}
        for number, axis, (start, end) in zip(shown.numbers, shown.axes, ends, strict=True)
    ]

    def placed(points: Polygon) -> Polygon:
        return np.asarray((left, bottom) + np.asarray(points) * (right - left, top - bottom))

    told = title or "Map of symbols: " + " and ".join(axis.word for axis in shown.axes)
    parts = [f'<title id="{escape(name)}-title">{escape(told)}</title>']
    for symbol, loops in shown.areas.items():
        path = "".join(_closed(placed(loop)) for loop in loops)
        parts.append(
            f'<path d="{path}" fill="{palette.hex(symbol)}" fill-rule="evenodd" data-code="{escape(symbol)}" '
            'stroke="var(--card, #fff)" stroke-width="1.5" stroke-linejoin="round"/>'
        )
    for symbol, mark in shown.marks.items():
        x, y = placed(np.array(mark))
        wide = 8 * len(symbol) + 6  # of its own colour beneath, where its area is narrower than the code
        parts.append(
            f'<rect x="{x - wide / 2:.0f}" y="{y - 9:.0f}" width="{wide}" height="17" rx="3" '
            f'fill="{palette.hex(symbol)}"/><text x="{x:.0f}" y="{y + 4:.0f}" text-anchor="middle" '
            'class="code" font-size="13" font-weight="600" font-family="ui-monospace, monospace" '
            f'fill="{ink_on(palette(symbol))}">{escape(symbol)}</text>'
        )
    parts += _axes(shown.axes, left, top, right, bottom)
    return (
        f'<svg class="map" id="{escape(name)}" viewBox="0 0 {width} {height:.0f}" role="img" '
        f'aria-labelledby="{escape(name)}-title" data-map="{escape(json.dumps(scale))}">'
        f"{''.join(parts)}</svg>"
    )


def _axes(axes: Sequence[Feature], left: float, top: float, right: float, bottom: float) -> Iterable[str]:
    """Draw values and what they are of, below the plot and on its left."""
    text = '<text {} font-size="{}" fill="currentColor" text-anchor="{}">{}</text>'
    for is_upwards, axis in enumerate(axes):
        low, high = axis.low * axis.factor, axis.high * axis.factor
        for value in axis.choices or round_values(low, high):
            share = (value * (axis.factor if axis.choices else 1) - low) / (high - low)
            if is_upwards:
                at, anchor = f'x="{left - 6}" y="{bottom + share * (top - bottom) + 4:.1f}"', "end"
            else:
                at, anchor = f'x="{left + share * (right - left):.1f}" y="{bottom + 16}"', "middle"
            yield text.format(at, 11.5, anchor, escape(axis.told(value) if axis.choices else f"{value:,.6g}"))
        label = escape(axis.word + (f" [{axis.unit}]" if axis.unit else ""))
        middle = f'x="{(left + right) / 2}" y="{bottom + 36}"'
        turned = f'transform="translate(11 {(top + bottom) / 2}) rotate(-90)"'
        yield text.format(turned if is_upwards else middle, 12.5, "middle", label)


def _closed(points: Polygon) -> str:
    """Write a closed line through points, without those that lie on the way."""
    rounded = np.round(points, 1)
    before, after = np.roll(rounded, 1, axis=0), np.roll(rounded, -1, axis=0)
    to, on = rounded - before, after - rounded
    turns = np.abs(to[:, 0] * on[:, 1] - to[:, 1] * on[:, 0]) > 0.05
    kept = rounded[turns] if turns.sum() > 2 else rounded
    return "M" + "L".join(f"{x:g} {y:g}" for x, y in kept.tolist()) + "Z"


def seen(points: Float[np.ndarray, "P 3"]) -> Polygon:
    """Say where points [m] are seen, rightwards and downwards [m]."""
    x, y, z = np.asarray(points, dtype=float).T
    towards = math.sin(_YAW) * x - math.cos(_YAW) * y
    return np.stack(
        [math.cos(_YAW) * x + math.sin(_YAW) * y, math.sin(_PITCH) * towards - math.cos(_PITCH) * z], 1
    )


def solid(
    features: Sequence[float], colour: Colour, at: tuple[float, float], scale: float, veil: float = 0.0
) -> str:
    """Draw a body of three sizes [m] and a type that stands at a place [pixels], a hole in it by its type.

    A veil makes it paler.
    """
    depth, width, height, kind = features
    is_round = kind >= 1.5
    outline = np.stack([np.cos(_ROUND), np.sin(_ROUND)], 1) if is_round else _SQUARE
    base = outline * (depth / 2, width / 2)
    hole = outline * (np.array([depth, width]) / 2 - _HOLE * min(depth, width))

    def places(flat: Polygon, level: float) -> Polygon:
        return np.asarray(at + scale * seen(np.column_stack([flat, np.full(len(flat), level)])))

    def face(points: Polygon, light: float) -> str:
        return f'<path d="{_closed(points)}" fill="{hexed(colour, light)}"/>'

    low, high = places(base, 0), places(base, height)
    hull = _hull(np.vstack([low, high]))
    if is_round:
        parts = [face(hull, 0.72)]
    else:
        front, side = np.array([1, 2]), np.array([0, 1])  # corners of the faces towards +x and -y
        parts = [
            face(np.vstack([low[edge], high[edge[::-1]]]), light)
            for edge, light in ((front, 0.82), (side, 0.62))
        ]
    parts.append(face(high, 1.0))
    if kind >= 0.5:
        parts.append(face(places(hole, height), 0.38))
    if veil:
        parts.append(f'<path d="{_closed(hull)}" fill="var(--card, #fff)" fill-opacity="{veil}"/>')
    edges = ' stroke="currentColor" stroke-opacity=".55" stroke-width=".7" stroke-linejoin="round"'
    return f"<g{edges}>{''.join(parts)}</g>"


def _hull(points: Polygon) -> Polygon:
    """Return the points of the convex hull, in order around it."""
    ordered = sorted(map(tuple, np.round(points, 3).tolist()))

    def half(row: Iterable[tuple[float, ...]]) -> list[tuple[float, ...]]:
        found: list[tuple[float, ...]] = []
        for x, y in row:
            while len(found) > 1 and (
                (found[-1][0] - found[-2][0]) * (y - found[-2][1])
                <= (found[-1][1] - found[-2][1]) * (x - found[-2][0])
            ):
                found.pop()
            found.append((x, y))
        return found[:-1]

    return np.array(half(ordered) + half(reversed(ordered)))


def object_drawing(
    values: Sequence[float],
    features: Sequence[Feature],
    colour: Colour = OTHER,
    *,
    width: int = 72,
    height: int = 60,
) -> str:
    """Draw an object to scale, or a bar for each of its features if nobody knows what these mean."""
    told = ", ".join(f"{one.word} {one.told(value)}" for one, value in zip(features, values, strict=True))
    if is_body(features):
        longest = max(one.high for one in features[:3])
        scale = min(width, _LEAST_WIDE * height) * 0.62 / longest
        inner = solid(values, colour, (width / 2, height * 0.62), scale)
    else:
        shares = [
            (value - one.low) / (one.high - one.low) for one, value in zip(features, values, strict=True)
        ]
        inner = _bars(shares, hexed(colour), width, height, low=0.0)
    return _small(inner, told, width, height)


def effect_drawing(
    effect: Sequence[float],
    *,
    told: str,
    chance: float,
    is_held: bool,
    item: Sequence[float] = (),
    colour: Colour = OTHER,
    scale: float = 400.0,
    width: int = 96,
    height: int = 132,
) -> str:
    """Draw an effect as an arrow to scale: filled where the object is held, faint where it is unlikely.

    Where nothing moves there is a dot; a thin line from the tip stands on the table below it. What would not
    fit moves aside, and is cut off above `effect_room`. Effects along other than three axes are bars.

    Args:
        effect: How far the object moves [m].
        told: The effect in words, for those who do not see it.
        chance: How likely it is.
        is_held: Whether the object ends in the hand.
        item: Features of an object that it happens to, drawn palely beneath; none if it is no `is_body`.
        colour: The object's colour.
        scale: How long a metre is [pixels].
        width: Of the drawing [pixels].
        height: Of the drawing [pixels].
    """
    if len(effect) != _AXES:
        inner = _bars([one * scale / width for one in effect], "currentColor", width, height, low=-1.0)
        return _small(f'<g opacity="{_opacity(chance):.2f}">{inner}</g>', told, width, height)
    depth, breadth, tall = (*item, 0.0, 0.0, 0.0)[:3]
    flat = scale * seen(np.array([(depth, breadth, 0), (depth, -breadth, 0), (effect[0], effect[1], 0)]))
    wide = np.abs(flat[:2, 0]).max() / 2
    left, right = min(-wide, flat[2, 0] - _HEAD), max(wide, flat[2, 0] + _HEAD)
    at = np.array([width / 2 - max(0.0, right - width / 2) + max(0.0, -left - width / 2), height - _BELOW])
    body = solid(item, colour, tuple(at), scale, _VEIL) if item else ""
    start, end, foot = at + scale * seen(
        np.array([(0, 0, tall / 2), np.add(effect, (0, 0, tall / 2)), (effect[0], effect[1], 0)])
    )
    if float(np.linalg.norm(effect)) < NO_EFFECT:
        x, y = start.tolist()
        arrow = f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.6" fill="currentColor" stroke="var(--card, #fff)"/>'
    else:
        arrow = _arrow(start, end, is_filled=is_held)
        if effect[2] > 2 * NO_EFFECT:
            arrow = (
                f'<path d="M{end[0]:.1f} {end[1]:.1f}L{foot[0]:.1f} {foot[1]:.1f}" stroke="currentColor" '
                'stroke-opacity=".5" stroke-dasharray="1.5 2.5"/>' + arrow
            )
    return _small(f'{body}<g opacity="{_opacity(chance):.2f}">{arrow}</g>', told, width, height)


def effect_room(effect: Sequence[float], item: Sequence[float], scale: float) -> int:
    """Say how high the drawing of an effect must be, so that nothing is cut off [pixels]."""
    depth, breadth, tall = (*item, 0.0, 0.0, 0.0)[:3]
    tops = np.array([(-depth / 2, breadth / 2, tall), np.add(effect, (0, 0, tall / 2))])
    return math.ceil(_BELOW + _HEAD - scale * float(seen(tops)[:, 1].min()))


def scale_for(pairs: Iterable[tuple[Sequence[float], Sequence[float]]], height: int) -> float:
    """Return the scale at which all effects, each with features of an object, fit in a height [pixels/m]."""
    margin = effect_room((0.0,) * _AXES, (), 0.0)
    rooms = (effect_room(effect, item, 1000.0) for effect, item in pairs if len(effect) == _AXES)
    return 1000.0 * (height - margin) / (max(rooms, default=1000) - margin)


def _opacity(chance: float) -> float:
    return _FAINT + (1 - _FAINT) * math.pow(min(1.0, max(0.0, chance)), 1.5)


def _arrow(start: Polygon, end: Polygon, *, is_filled: bool) -> str:
    """Draw an arrow, its head filled or not, with a rim that sets it off from what lies beneath."""
    way = end - start
    length = float(np.hypot(*way)) or 1.0
    along, aside = way / length, np.array([-way[1], way[0]]) / length
    size = min(_HEAD, max(0.6 * length, 0.6 * _HEAD))
    neck = end - size * along
    head = _closed(np.array([end, neck + 0.5 * size * aside, neck - 0.5 * size * aside]))
    shaft = f"M{start[0]:.1f} {start[1]:.1f}L{neck[0]:.1f} {neck[1]:.1f}"
    fill = "currentColor" if is_filled else "var(--card, #fff)"
    return (
        f'<path d="{shaft}{head}" fill="none" stroke="var(--card, #fff)" stroke-width="5" '
        'stroke-linejoin="round"/>'
        f'<path d="{shaft}" stroke="currentColor" stroke-width="2.2" stroke-linecap="round"/>'
        f'<path d="{head}" fill="{fill}" stroke="currentColor" stroke-width="1.6" stroke-linejoin="round"/>'
    )


def is_body(features: Sequence[Feature]) -> bool:
    """Say whether features are three sizes and a type."""
    return len(features) == 4 and all(one.is_length for one in features[:3]) and bool(features[3].choices)


def _bars(shares: Sequence[float], fill: str, width: int, height: int, low: float) -> str:
    """Draw a bar for each share of the greatest value, from 0 upwards, and downwards if negative."""
    zero = 4 + (height - 8) / (1 - low)
    step = (width - 8) / max(1, len(shares))
    bars = (
        f'<rect x="{4 + (number + 0.15) * step:.1f}" y="{min(zero, zero - size):.1f}" '
        f'width="{0.7 * step:.1f}" height="{abs(size):.1f}" fill="{fill}"/>'
        for number, share in enumerate(shares)
        for size in [float(np.clip(share, low, 1)) * (height - 8) / (1 - low)]
    )
    return f'{"".join(bars)}<path d="M4 {zero:.1f}H{width - 4}" stroke="currentColor"/>'


def _small(inner: str, told: str, width: int, height: int) -> str:
    label = escape(told)
    return (
        f'<svg viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
        f'aria-label="{label}"><title>{label}</title>{inner}</svg>'
    )
