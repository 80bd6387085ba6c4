"""Charts as geometry: what a template needs to draw areas and dots as SVG."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.checks import Bool, Float

WIDTH, HEIGHT = 520, 320
LEFT, RIGHT, TOP, BOTTOM = 52.0, 26.0, 12.0, 44.0
"""Room around the plot, for what stands at the axes [pixels]."""
ASPECT = (WIDTH - LEFT - RIGHT) / (HEIGHT - TOP - BOTTOM)
"""How much wider than high the plot is."""
Groups = Mapping[str, Bool[np.ndarray, "P"]]
"""Which points are of each group."""
_STEPS = (1, 2, 2.5, 5, 10)


@dataclass(frozen=True, slots=True)
class Tick:
    """A mark on an axis: where it stands [pixels], and what it says."""

    place: float
    label: str


@dataclass(frozen=True, slots=True)
class Series:
    """What belongs together in a chart: its name, its number among the colours, and its path."""

    name: str
    colour: int
    path: str


@dataclass(frozen=True, slots=True)
class Chart:
    """A chart, ready to be drawn.

    Attributes:
        kind: "area" or "dots".
        title: What it shows.
        alt: The same for who does not see it, with its main figures.
        x_label: What stands along x.
        y_label: What stands along y.
        x_ticks: Marks along x.
        y_ticks: Marks along y.
        series: What is drawn.
    """

    kind: str
    title: str
    alt: str
    x_label: str
    y_label: str
    x_ticks: tuple[Tick, ...]
    y_ticks: tuple[Tick, ...]
    series: tuple[Series, ...]
    width: int = WIDTH
    height: int = HEIGHT
    left: float = LEFT
    right: float = WIDTH - RIGHT
    top: float = TOP
    bottom: float = HEIGHT - BOTTOM


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

    def ticks(self, start: float, end: float) -> tuple[Tick, ...]:
        """Choose some four to six round values, and say where they stand between two places."""
        values = round_values(self.low, self.high)
        places = _placed(np.array(values), self, start, end)
        return tuple(
            Tick(round(float(place), 1), f"{value:.0%}" if self.is_percent else f"{value:,.6g}")
            for place, value in zip(places, values, strict=True)
        )


def round_values(low: float, high: float) -> tuple[float, ...]:
    """List round values between a low one and a high one."""
    rough = (high - low) / 5
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(step * power for step in _STEPS if step * power >= rough * 0.999)
    first, last = int(np.ceil(low / step - 1e-9)), int(np.floor(high / step + 1e-9))
    return tuple(float(f"{number * step:.12g}") + 0.0 for number in range(first, last + 1))


def dots(title: str, alt: str, x: Axis, y: Axis, points: Float[np.ndarray, "P 2"], groups: Groups) -> Chart:
    """Make a chart of points, in a colour for each group; those outside the axes are left out."""
    series, within = [], (points >= (x.low, y.low)).all(1) & (points <= (x.high, y.high)).all(1)
    for number, (name, rows) in enumerate(groups.items()):
        inside = rows & within
        if inside.any():
            places = zip(*_places(points[inside], x, y), strict=True)
            series.append(Series(name, number, "".join(f"M{a:.1f} {b:.1f}h0" for a, b in places)))
    return _chart("dots", title, alt, x, y, series)


def areas(title: str, alt: str, x: Axis, at: Sequence[float], shares: Mapping[str, Sequence[float]]) -> Chart:
    """Make a chart of shares of groups that add up to one, stacked from below, at some values of x."""
    y, series, below = Axis("share", 0.0, 1.0, is_percent=True), [], np.zeros(len(at))
    for number, (name, values) in enumerate(shares.items()):
        above = below + np.asarray(values)
        there = np.column_stack([at, above])
        back = np.column_stack([at, below])[::-1]
        if np.any(above > below):
            outline = _line(*_places(np.vstack([there, back]), x, y))
            series.append(Series(name, number, f"{outline}Z"))
        below = above
    return _chart("area", title, alt, x, y, series)


def _chart(kind: str, title: str, alt: str, x: Axis, y: Axis, series: Sequence[Series]) -> Chart:
    return Chart(
        kind=kind,
        title=title,
        alt=alt,
        x_label=x.label,
        y_label=y.label,
        x_ticks=x.ticks(LEFT, WIDTH - RIGHT),
        y_ticks=y.ticks(HEIGHT - BOTTOM, TOP),
        series=tuple(series),
    )


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
