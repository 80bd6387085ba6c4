"""What was explored, and charts of it as geometry: what a template needs to draw areas and dots as SVG."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from neurosym.checks import Bool, Float
from neurosym.data.interactions import Interactions
from neurosym.operators import CARRIED, NO_EFFECT, Symbol
from neurosym.world import Palette
from neurosym.worlds.aims import PLACE_AXES

_WIDTH, _HEIGHT = 520, 320
_LEFT, _RIGHT, _TOP, _BOTTOM = 52.0, _WIDTH - 26.0, 12.0, _HEIGHT - 44.0
"""Edges of the plot; outside them is room for what stands at the axes [pixels]."""
_ASPECT = (_RIGHT - _LEFT) / (_BOTTOM - _TOP)
_STEPS = (1, 2, 2.5, 5, 10)
_MOST_DOTS = 2000  # interactions whose effects are drawn: equally spaced ones, if there are more
_BLOCK = 256
_MOST_BLOCKS = 24
_PANEL, _MOST_PANELS = 60, 16  # half a side of the plot of an action [pixels], and how many there are
_INSIDE = 0.99  # share of the points that the axes of a scatter plot must hold
_MILLIMETRES = 1000
_SIGNS = ("h0", "m-3-3l6 6m0-6l-6 6", "m-3 0h6m-3-3v6", "m-2-2h4v4h-4z", "m-2 0h4", "h0")
"""How dots show what became of objects, as paths from their places, in the order of `what_became`."""

Chart = dict[str, Any]
"""A chart as the template draws it: kind, title, the same as alt with its main figures, labels, ticks (place
[pixels] and label), series (name, number, path, colour or sign), and its edges [pixels]."""


@dataclass(frozen=True, slots=True)
class Axis:
    """What a chart shows along one axis, with its unit; its ends; whether values are written in per cent."""

    label: str
    low: float
    high: float
    is_percent: bool = False

    def places(self, values: Float[np.ndarray, "P"], start: float, end: float) -> Float[np.ndarray, "P"]:
        """Say where values stand between two places [pixels]."""
        return np.asarray(start + (end - start) * (values - self.low) / (self.high - self.low))

    def ticks(self, start: float, end: float) -> list[dict[str, Any]]:
        """Choose some four to six round values, and say where they stand between two places."""
        values = round_values(self.low, self.high)
        return [
            {"place": round(at, 1), "label": f"{value:.0%}" if self.is_percent else f"{value:,.6g}"}
            for at, value in zip(self.places(np.array(values), start, end).tolist(), values, strict=True)
        ]


def round_values(low: float, high: float) -> tuple[float, ...]:
    """List round values between a low one and a high one."""
    rough = (high - low) / 5
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(step * power for step in _STEPS if step * power >= rough * 0.999)
    first, last = int(np.ceil(low / step - 1e-9)), int(np.floor(high / step + 1e-9))
    return tuple(float(f"{number * step:.12g}") + 0.0 for number in range(first, last + 1))


def chart(
    kind: Literal["dots", "area"],
    title: str,
    alt: str,
    axes: tuple[Axis, Axis],
    groups: Mapping[str, Float[np.ndarray, "P 2"]],
    looks: Sequence[str] = (),
) -> Chart:
    """Make a chart of the points in the axes, or of areas within outlines.

    Groups look differently: by a sign of `looks`, the rest of a path from its place, by a colour there, or by
    their shades of grey.
    """
    x, y = axes
    series = []
    for number, (name, points) in enumerate(groups.items()):
        shown = points[((points >= (x.low, y.low)) & (points <= (x.high, y.high))).all(1) | (kind == "area")]
        across, down = x.places(shown[:, 0], _LEFT, _RIGHT), y.places(shown[:, 1], _BOTTOM, _TOP)
        places = [f"{a:.1f} {b:.1f}" for a, b in zip(across, down, strict=True)]
        look = looks[number] if looks else "h0"
        paint, sign = (look, "h0") if look.startswith("#") else ("", look)
        path = "".join(f"M{at}{sign}" for at in places) if kind == "dots" else f"M{'L'.join(places)}Z"
        if places:
            series.append({"name": name, "colour": number, "path": path, "paint": paint, "sign": sign})
    about = {"kind": kind, "title": title, "alt": alt, "x_label": x.label, "y_label": y.label}
    ticks = {"x_ticks": x.ticks(_LEFT, _RIGHT), "y_ticks": y.ticks(_BOTTOM, _TOP)}
    edges = {"left": _LEFT, "right": _RIGHT, "top": _TOP, "bottom": _BOTTOM}
    return {**about, **ticks, **edges, "width": _WIDTH, "height": _HEIGHT, "series": series}


def explored(
    interactions: Interactions,
    codes: Sequence[Symbol] = (),
    palette: Palette | None = None,
    acts: Sequence[Symbol] = (),
) -> dict[str, Any]:
    """Describe a data set that has one row or more: how often what became of objects, and charts of it.

    Args:
        interactions: The data.
        codes: The object symbol of each row, if there are any.
        palette: Their colours.
        acts: The action symbol of each row, if there are any.
    """
    kinds, origin = what_became(interactions), interactions.origin
    rows = {code: np.array(codes) == code for code in sorted(set(codes))}
    paints = [palette.hex(code) for code in rows] if palette else []
    by_code = list(_scatters(interactions, rows, paints))[:2] if palette and rows else []
    by = f"explored by {origin.get('strategy')}, seed {origin.get('seed', 'unknown')}"
    return {
        "count": len(interactions),
        "origin": by if "strategy" in origin else "data of one's own",
        "shares": [(name, float(rows.mean())) for name, rows in kinds.items() if rows.any()],
        "charts": [_over_time(kinds), *_scatters(interactions, kinds, _SIGNS), *by_code],
        "by_action": _by_action(interactions, acts, rows, paints) if paints and acts else None,
    }


def aimed_in_words(interactions: Interactions) -> str:
    """Tell of a data set of actions that are aimed at places; nothing if it is empty or none."""
    if not len(interactions) or interactions.effects.shape[1] != PLACE_AXES:
        return ""
    carried = float(interactions.effects[:, PLACE_AXES - 1].mean())
    more = f"{len(interactions):,} more interactions were aimed at places"
    return f"{more}; {carried:.0%} of them carried their object there."


def what_became(interactions: Interactions) -> dict[str, Bool[np.ndarray, "P"]]:
    """Sort interactions by what became of the object; each is of the first kind that it is like."""
    moved = np.linalg.norm(interactions.effects, axis=1) > NO_EFFECT
    kinds = {
        "ended in the hand": interactions.held,
        "left the table": interactions.lost,
        "toppled": interactions.toppled,
        "were carried and put down": interactions.peak_heights > CARRIED,
        "were pushed": moved,
        "hardly moved": ~moved,
    }
    first = np.array([*kinds.values()]).argmax(0)
    return {name: first == number for number, name in enumerate(kinds)}


def _over_time(kinds: Mapping[str, Bool[np.ndarray, "P"]]) -> Chart:
    """Make a chart of the shares of all kinds, stacked, block by block of the interactions."""
    rows = np.array([*kinds.values()], dtype=float)  # (kinds, P)
    count = rows.shape[1]
    blocks = np.array_split(np.arange(count), np.clip(count // _BLOCK, 1, _MOST_BLOCKS))
    at = np.array([1.0, *(block.mean() + 1 for block in blocks), max(2.0, count)])
    shares = np.stack([rows[:, block].mean(1) for block in blocks], axis=1)
    shares = np.pad(shares, ((0, 0), (1, 1)), mode="edge")  # the first and last block reach to the ends
    edges = np.cumsum(np.vstack([np.zeros(len(at)), shares]), axis=0)
    outlines = {
        name: np.vstack([np.column_stack([at, above]), np.column_stack([at, below])[::-1]])
        for name, below, above in zip(kinds, edges, edges[1:], strict=False)
        if kinds[name].any()
    }
    told = ", ".join(f"{name} {rows.mean():.0%}" for name, rows in kinds.items() if rows.any())
    return chart(
        "area",
        "What became of the objects, as exploration went on",
        f"Stacked shares over {count} interactions; over all of them: {told}.",
        (Axis("interactions", 1.0, at[-1]), Axis("share", 0.0, 1.0, is_percent=True)),
        {name: outlines.get(name, np.zeros((0, 2))) for name in kinds},
    )


def _scatters(
    interactions: Interactions, kinds: Mapping[str, Bool[np.ndarray, "P"]], looks: Sequence[str]
) -> Iterator[Chart]:
    """Make charts of effects, and of where the hand went; none where vectors are not x, y and z."""
    by = " by outcome" if looks is _SIGNS else " by symbol of the object"
    rows = np.unique(np.linspace(0, len(interactions) - 1, min(_MOST_DOTS, len(interactions))).astype(int))
    effects = _MILLIMETRES * interactions.effects[rows].astype(float)
    actions = _MILLIMETRES * interactions.actions[rows].astype(float)
    shown = f"{len(rows):,} of {len(interactions):,} interactions"
    if effects.shape[1] != 3:
        return

    def dots(title: str, alt: str, axes: tuple[Axis, Axis], points: Float[np.ndarray, "P 2"]) -> Chart:
        groups = {name: points[of[rows]] for name, of in kinds.items()}
        return chart("dots", title, alt, axes, groups, looks)

    def from_above(title: str, what: str, vectors: Float[np.ndarray, "P 3"]) -> Chart:
        points = np.column_stack([-vectors[:, 1], vectors[:, 0]])
        far = _reach(np.maximum(np.abs(points[:, 0]) / _ASPECT, np.abs(points[:, 1])))
        axes = Axis("right [mm]", -_ASPECT * far, _ASPECT * far), Axis("forward [mm]", -far, far)
        return dots(title, f"{what}: right is to the right, forward is up.", axes, points)

    yield from_above(f"Effects{by}, seen from above", f"Where the objects of {shown} went", effects)
    level = np.hypot(effects[:, 0], effects[:, 1])
    low, high = np.quantile(effects[:, 2], [(1 - _INSIDE) / 2, (1 + _INSIDE) / 2]).tolist()
    room = 0.05 * (high - low) or 1.0
    yield dots(
        f"Effects{by}, far and high",
        f"How far and how high the objects of {shown} were moved, at the end of the rise.",
        (
            Axis("distance along the table [mm]", 0.0, _reach(level)),
            Axis("height [mm]", low - room, high + room),
        ),
        np.column_stack([level, effects[:, 2]]),
    )
    if actions.shape[1] == 12:
        what = f"From the first to the last waypoint of the hand, in {shown}"
        yield from_above(f"Actions{by}, seen from above", what, actions[:, 8:11] - actions[:, :3])


def _by_action(
    interactions: Interactions,
    acts: Sequence[Symbol],
    kinds: Mapping[Symbol, Bool[np.ndarray, "P"]],
    paints: Sequence[str],
) -> dict[str, Any] | None:
    """Draw for each action symbol where the objects went, seen from above; None where that is not x, y, z."""
    if interactions.effects.shape[1] != 3:
        return None
    rows = np.unique(np.linspace(0, len(acts) - 1, min(_MOST_DOTS, len(acts))).astype(int))
    across = _MILLIMETRES * interactions.effects[rows, :2].astype(float) * (1, -1)
    reach = _reach(np.abs(across).max(1))
    places, shown = _PANEL / reach * across[:, ::-1] * (1, -1), np.abs(across).max(1) <= reach
    codes, panels = np.array(acts)[rows], []
    for code in np.unique(codes).tolist():
        dots = []
        for (name, of), paint in zip(kinds.items(), paints, strict=True):
            these = places[of[rows] & shown & (codes == code)].tolist()
            if these:
                path = "".join(f"M{x:.1f} {y:.1f}h0" for x, y in these)
                dots.append({"name": name, "paint": paint, "path": path})
        panels.append({"code": code, "count": int((codes == code).sum()), "dots": dots})
    panels = sorted(panels, key=lambda one: -one["count"])[:_MOST_PANELS]
    ordered = sorted(panels, key=lambda one: one["code"])
    return {"panels": ordered, "edge": _PANEL, "reach": round(reach), "count": len(rows)}


def _reach(distances: Float[np.ndarray, "P"]) -> float:
    return float(np.quantile(distances, _INSIDE)) * 1.05 or 1.0
