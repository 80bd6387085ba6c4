"""What was explored, for the page: what became of the objects, when, and by which actions."""

from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Float
from neurosym.data.interactions import Interactions
from neurosym.naming import CARRIED, NO_EFFECT
from neurosym.report.charts import ASPECT, Axis, Chart, Groups, areas, dots
from neurosym.worlds.aimed import PLACE_AXES

MOST_DOTS = 2000
"""Interactions whose effects are drawn: equally spaced ones, if there are more."""
BLOCK = 256
MOST_BLOCKS = 24
_INSIDE = 0.99  # share of the points that the axes of a scatter plot must hold
_MILLIMETRES = 1000


@dataclass(frozen=True, slots=True)
class Explored:
    """What was explored.

    Attributes:
        count: How many interactions there are.
        origin: How they came about, in words.
        shares: How often each thing became of the object, by its name.
        charts: What is to be drawn of them.
    """

    count: int
    origin: str
    shares: tuple[tuple[str, float], ...]
    charts: tuple[Chart, ...]


def explored(interactions: Interactions) -> Explored:
    """Describe a data set that has one row or more."""
    kinds = what_became(interactions)
    shares = tuple((name, float(rows.mean())) for name, rows in kinds.items() if rows.any())
    return Explored(
        count=len(interactions),
        origin=_origin(interactions),
        shares=shares,
        charts=(_over_time(kinds), *_scatters(interactions, kinds)),
    )


def aimed_in_words(interactions: Interactions) -> str:
    """Tell of a data set of actions that are aimed at places; nothing if it is empty or none."""
    if not len(interactions) or interactions.effects.shape[1] != PLACE_AXES:
        return ""
    carried = float(interactions.effects[:, PLACE_AXES - 1].mean())
    more = f"{len(interactions):,} more interactions were aimed at places"
    return f"{more}; {carried:.0%} of them carried their object there."


def what_became(interactions: Interactions) -> Groups:
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


def _over_time(kinds: Groups) -> Chart:
    count = len(next(iter(kinds.values())))
    blocks = np.array_split(np.arange(count), max(2, min(MOST_BLOCKS, count // BLOCK)))
    blocks = [block for block in blocks if len(block)]
    at = [float(block.mean()) + 1 for block in blocks]
    at[0], at[-1] = 1.0, float(max(2, count))
    shares = {name: [float(rows[block].mean()) for block in blocks] for name, rows in kinds.items()}
    told = ", ".join(f"{name} {rows.mean():.0%}" for name, rows in kinds.items() if rows.any())
    return areas(
        "What became of the objects, as exploration went on",
        f"Stacked shares over {count} interactions; over all of them: {told}.",
        Axis("interactions", 1.0, float(max(2, count))),
        at if len(at) > 1 else [1.0, 2.0],
        shares if len(at) > 1 else {name: values * 2 for name, values in shares.items()},
    )


def _scatters(interactions: Interactions, kinds: Groups) -> list[Chart]:
    rows = np.unique(np.linspace(0, len(interactions) - 1, min(MOST_DOTS, len(interactions))).astype(int))
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


def _seen_from_above(title: str, what: str, points: Float[np.ndarray, "P 2"], groups: Groups) -> Chart:
    reach = _reach(np.maximum(np.abs(points[:, 0]) / ASPECT, np.abs(points[:, 1])))
    return dots(
        title,
        f"{what}: right is to the right, forward is up.",
        Axis("right [mm]", -ASPECT * reach, ASPECT * reach),
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
