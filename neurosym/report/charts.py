"""What was explored, and charts of it as geometry: what a template needs to draw _areas and dots as SVG."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.checks import Bool, Float
from neurosym.data.interactions import Interactions
from neurosym.operators import CARRIED, NO_EFFECT
from neurosym.worlds.aims import PLACE_AXES

WIDTH, HEIGHT = 520, 320
LEFT, RIGHT, TOP, BOTTOM = 52.0, 26.0, 12.0, 44.0
"""Room around the plot, for what stands at the axes [pixels]."""
_ASPECT = (WIDTH - LEFT - RIGHT) / (HEIGHT - TOP - BOTTOM)
"""How much wider than high the plot is."""
_Groups = Mapping[str, Bool[np.ndarray, "P"]]
"""Which points are of each group."""
_STEPS = (1, 2, 2.5, 5, 10)
_MOST_DOTS = 2000
"""Interactions whose effects are drawn: equally spaced ones, if there are more."""
_BLOCK = 256
_MOST_BLOCKS = 24
_INSIDE = 0.99  # share of the points that the axes of a scatter plot must hold
_MILLIMETRES = 1000


Chart = dict[str, Any]
"""A chart as the template draws it: kind ("area" or "dots"), title, the same as alt with its main figures,
labels, ticks (place [pixels] and label), series (name, number of a colour, path), and its edges [pixels]."""


@dataclass(frozen=True, slots=True)
class Axis:
    """What a chart shows along one axis.

    Attributes:
        label: What it is, with its unit.
        low: Least value.
        high: Greatest value.
        is_percent: Whether values are shares, to be written in per cent.
    """

    label: str
    low: float
    high: float
    is_percent: bool = False

    def ticks(self, start: float, end: float) -> list[dict[str, Any]]:
        """Choose some four to six round values, and say where they stand between two places."""
        values = round_values(self.low, self.high)
        places = _placed(np.array(values), self, start, end)
        labels = [f"{value:.0%}" if self.is_percent else f"{value:,.6g}" for value in values]
        return [
            {"place": round(float(at), 1), "label": said} for at, said in zip(places, labels, strict=True)
        ]


def round_values(low: float, high: float) -> tuple[float, ...]:
    """List round values between a low one and a high one."""
    rough = (high - low) / 5
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(step * power for step in _STEPS if step * power >= rough * 0.999)
    first, last = int(np.ceil(low / step - 1e-9)), int(np.floor(high / step + 1e-9))
    return tuple(float(f"{number * step:.12g}") + 0.0 for number in range(first, last + 1))


def dots(title: str, alt: str, x: Axis, y: Axis, points: Float[np.ndarray, "P 2"], groups: _Groups) -> Chart:
    """Make a chart of points, in a colour for each group; those outside the axes are left out."""
    series, within = [], (points >= (x.low, y.low)).all(1) & (points <= (x.high, y.high)).all(1)
    for number, (name, rows) in enumerate(groups.items()):
        inside = rows & within
        if inside.any():
            places = zip(*_places(points[inside], x, y), strict=True)
            series.append(_series(name, number, "".join(f"M{a:.1f} {b:.1f}h0" for a, b in places)))
    return _chart("dots", title, alt, x, y, series)


def _areas(
    title: str, alt: str, x: Axis, at: Sequence[float], shares: Mapping[str, Sequence[float]]
) -> Chart:
    """Make a chart of shares of groups that add up to one, stacked from below, at some values of x."""
    y, series, below = Axis("share", 0.0, 1.0, is_percent=True), [], np.zeros(len(at))
    for number, (name, values) in enumerate(shares.items()):
        above = below + np.asarray(values)
        there = np.column_stack([at, above])
        back = np.column_stack([at, below])[::-1]
        if np.any(above > below):
            outline = _line(*_places(np.vstack([there, back]), x, y))
            series.append(_series(name, number, f"{outline}Z"))
        below = above
    return _chart("area", title, alt, x, y, series)


def _series(name: str, colour: int, path: str) -> dict[str, Any]:
    return {"name": name, "colour": colour, "path": path}


def _chart(kind: str, title: str, alt: str, x: Axis, y: Axis, series: Sequence[dict[str, Any]]) -> Chart:
    left, right, top, bottom = LEFT, WIDTH - RIGHT, TOP, HEIGHT - BOTTOM
    about = {"kind": kind, "title": title, "alt": alt, "x_label": x.label, "y_label": y.label}
    ticks = {"x_ticks": x.ticks(left, right), "y_ticks": y.ticks(bottom, top)}
    plot = {"width": WIDTH, "height": HEIGHT, "left": left, "right": right, "top": top, "bottom": bottom}
    return {**about, **ticks, **plot, "series": series}


def _places(points: Float[np.ndarray, "P 2"], x: Axis, y: Axis) -> tuple[np.ndarray, np.ndarray]:
    return (
        _placed(points[:, 0], x, LEFT, WIDTH - RIGHT),
        _placed(points[:, 1], y, HEIGHT - BOTTOM, TOP),
    )


def _placed(values: np.ndarray, axis: Axis, start: float, end: float) -> np.ndarray:
    return start + (end - start) * (values - axis.low) / (axis.high - axis.low)


def _line(across: np.ndarray, down: np.ndarray) -> str:
    points = [f"{a:.1f} {b:.1f}" for a, b in zip(across, down, strict=True)]
    return f"M{points[0]}" + "".join(f"L{point}" for point in points[1:])


def explored(interactions: Interactions) -> dict[str, Any]:
    """Describe a data set that has one row or more: how often what became of objects, and charts of it."""
    kinds = what_became(interactions)
    return {
        "count": len(interactions),
        "origin": _origin(interactions),
        "shares": [(name, float(rows.mean())) for name, rows in kinds.items() if rows.any()],
        "charts": [_over_time(kinds), *_scatters(interactions, kinds)],
    }


def aimed_in_words(interactions: Interactions) -> str:
    """Tell of a data set of actions that are aimed at places; nothing if it is empty or none."""
    if not len(interactions) or interactions.effects.shape[1] != PLACE_AXES:
        return ""
    carried = float(interactions.effects[:, PLACE_AXES - 1].mean())
    more = f"{len(interactions):,} more interactions were aimed at places"
    return f"{more}; {carried:.0%} of them carried their object there."


def what_became(interactions: Interactions) -> _Groups:
    """Sort interactions by what became of the object; each is of one kind."""
    moved = np.linalg.norm(interactions.effects, axis=1) > NO_EFFECT
    left = np.ones(len(interactions), dtype=bool)
    found = {}
    for name, rows in (
        ("ended in the hand", interactions.held),
        ("left the table", interactions.lost),
        ("toppled", interactions.toppled),
        ("were carried and put down", interactions.peak_heights > CARRIED),
        ("were pushed", moved),
        ("hardly moved", ~moved),
    ):
        found[name] = rows & left
        left = left & ~rows
    return found


def _origin(interactions: Interactions) -> str:
    origin = interactions.origin
    if "strategy" not in origin:
        return "data of one's own"
    return f"explored by {origin['strategy']}, seed {origin.get('seed', 'unknown')}"


def _over_time(kinds: _Groups) -> Chart:
    count = len(next(iter(kinds.values())))
    blocks = np.array_split(np.arange(count), max(2, min(_MOST_BLOCKS, count // _BLOCK)))
    blocks = [block for block in blocks if len(block)]
    at = [float(block.mean()) + 1 for block in blocks]
    at[0], at[-1] = 1.0, float(max(2, count))
    shares = {name: [float(rows[block].mean()) for block in blocks] for name, rows in kinds.items()}
    told = ", ".join(f"{name} {rows.mean():.0%}" for name, rows in kinds.items() if rows.any())
    return _areas(
        "What became of the objects, as exploration went on",
        f"Stacked shares over {count} interactions; over all of them: {told}.",
        Axis("interactions", 1.0, float(max(2, count))),
        at if len(at) > 1 else [1.0, 2.0],
        shares if len(at) > 1 else {name: values * 2 for name, values in shares.items()},
    )


def _scatters(interactions: Interactions, kinds: _Groups) -> list[Chart]:
    rows = np.unique(np.linspace(0, len(interactions) - 1, min(_MOST_DOTS, len(interactions))).astype(int))
    effects = interactions.effects[rows].astype(float)
    groups = {name: found[rows] for name, found in kinds.items()}
    shown = f"{len(rows):,} of {len(interactions):,} interactions"
    if effects.shape[1] != 3:
        return []
    away = _from_above(effects)
    level = np.hypot(away[:, 0], away[:, 1])
    charts = [
        _seen_from_above("Effects, seen from above", f"Where the objects of {shown} went", away, groups),
        dots(
            "Effects, far and high",
            f"How far and how high the objects of {shown} were moved, at the end of the rise.",
            Axis("distance along the table [mm]", 0.0, _reach(level)),
            Axis("height [mm]", *_range(_MILLIMETRES * effects[:, 2])),
            np.column_stack([level, _MILLIMETRES * effects[:, 2]]),
            groups,
        ),
    ]
    actions = interactions.actions[rows].astype(float)
    if actions.shape[1] == 12:
        travel = _from_above(actions[:, 8:11] - actions[:, :3])
        what = f"From the first to the last waypoint of the hand, in {shown}"
        charts.append(_seen_from_above("Actions, seen from above", what, travel, groups))
    return charts


def _from_above(vectors: Float[np.ndarray, "P 3"]) -> Float[np.ndarray, "P 2"]:
    """Turn vectors [m] to how far they go to the right and forward [mm]."""
    return _MILLIMETRES * np.column_stack([-vectors[:, 1], vectors[:, 0]])


def _seen_from_above(title: str, what: str, points: Float[np.ndarray, "P 2"], groups: _Groups) -> Chart:
    reach = _reach(np.maximum(np.abs(points[:, 0]) / _ASPECT, np.abs(points[:, 1])))
    return dots(
        title,
        f"{what}: right is to the right, forward is up.",
        Axis("right [mm]", -_ASPECT * reach, _ASPECT * reach),
        Axis("forward [mm]", -reach, reach),
        points,
        groups,
    )


def _reach(distances: Float[np.ndarray, "P"]) -> float:
    return float(np.quantile(distances, _INSIDE)) * 1.05 or 1.0


def _range(values: Float[np.ndarray, "P"]) -> tuple[float, float]:
    rest = (1 - _INSIDE) / 2
    low, high = (float(value) for value in np.quantile(values, [rest, 1 - rest]))
    room = 0.05 * (high - low) or 1.0
    return low - room, high + room
