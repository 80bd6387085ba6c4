"""Tasks that people bring: put these things there, swap two, set them in a row, clear a crowd."""

from collections.abc import Callable

import numpy as np
from jaxtyping import Float

from neurosym.evaluation.comparison_tasks import Bench
from neurosym.operators import TOLERANCE
from neurosym.pddl.footprints import overlapping
from neurosym.problems import Problem
from neurosym.world import Scene
from tools.benchmarks.planning.anywhere import arranged, draw_anywhere, draw_places
from tools.benchmarks.world.hand_written import carry_to

ROW_GAP = 0.04
"""Room between objects that shall stand in a row [m]."""
CROWDED = 0.05
"""Objects of a crowd stand nearer to the next than this [m]."""
_STREAM = 0x706C61  # keeps this randomness apart from any other
_DRAWS = 1000

Draw = Callable[[Bench, int], Problem]
"""Draws the task of a seed."""


def is_graspable(features: Float[np.ndarray, " F"]) -> bool:
    """Say whether a person who writes actions by hand finds a grasp for an object."""
    return carry_to(features) is not None


def far(bench: Bench, objects: int, seed: int, *, graspable: bool, tolerance: float = TOLERANCE) -> Problem:
    """Draw goals anywhere on the table, at least 15 cm away; see `draw_anywhere`."""
    fits = is_graspable if graspable else None
    return draw_anywhere(bench, objects, seed, tolerance, fits=fits)


def swap(bench: Bench, seed: int) -> Problem:
    """Draw two objects that shall change places."""

    def places(rng: np.random.Generator, scene: Scene) -> tuple[np.ndarray, np.ndarray] | None:
        sizes = np.tile(scene.features[:, :2].max(0), (2, 1))  # so that either fits where the other stands
        starts = draw_places(rng, sizes, bench.setting.world.table)
        return None if starts is None else (starts, starts[::-1].copy())

    return _drawn(bench, "swap", 2, seed, places)


def row(bench: Bench, seed: int) -> Problem:
    """Draw four objects that shall stand in a row across the middle of the table, in their order."""

    def places(rng: np.random.Generator, scene: Scene) -> tuple[np.ndarray, np.ndarray] | None:
        table, widths = bench.setting.world.table, scene.features[:, 1]
        length = widths.sum() + ROW_GAP * (len(widths) - 1)
        if length > table.y[1] - table.y[0]:
            return None
        left = np.cumsum(widths + ROW_GAP) - ROW_GAP - widths / 2 - length / 2 + sum(table.y) / 2
        goals = np.column_stack([np.full(len(widths), sum(table.x) / 2), left])
        starts = draw_places(rng, scene.features[:, :2], table)
        return None if starts is None else (starts, goals)

    return _drawn(bench, "row", 4, seed, places)


def crowded(bench: Bench, seed: int) -> Problem:
    """Draw four objects that stand near one another, and shall go anywhere at least 15 cm away."""

    def places(rng: np.random.Generator, scene: Scene) -> tuple[np.ndarray, np.ndarray] | None:
        starts = _crowd(rng, scene.features[:, :2], bench)
        if starts is None:
            return None
        goals = draw_places(rng, scene.features[:, :2], bench.setting.world.table, starts)
        return None if goals is None else (starts, goals)

    return _drawn(bench, "crowded", 4, seed, places)


def _crowd(
    rng: np.random.Generator, sizes: Float[np.ndarray, "M 2"], bench: Bench
) -> Float[np.ndarray, "M 2"] | None:
    """Place objects on the table, each within `CROWDED` of one that stands already, and apart from all."""
    low, high = np.array([bench.setting.world.table.x, bench.setting.world.table.y]).T
    apart = (sizes[:, None] + sizes) / 2
    places = rng.uniform(low + sizes[:1] / 2, high - sizes[:1] / 2)
    for number in range(1, len(sizes)):
        for _ in range(_DRAWS):
            spot = rng.uniform(low + sizes[number] / 2, high - sizes[number] / 2)
            beside = overlapping(spot, places, apart[number, :number] + CROWDED)
            if beside.any() and not overlapping(spot, places, apart[number, :number]).any():
                places = np.vstack([places, spot])
                break
        else:
            return None
    return places


def _drawn(
    bench: Bench,
    kind: str,
    objects: int,
    seed: int,
    places: Callable[[np.random.Generator, Scene], tuple[np.ndarray, np.ndarray] | None],
) -> Problem:
    """Draw graspable objects until they can be arranged so."""
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, objects, seed, draw])
        scene = bench.setting.world.sample_scene(rng, objects)
        if not all(map(is_graspable, scene.features)) or (found := places(rng, scene)) is None:
            continue
        name, said = f"{kind}-{seed:05d}", f"{kind}, draw {draw + 1}"
        return arranged(bench, name, scene, *found, TOLERANCE, said)
    raise AssertionError(f"no {kind} of {objects} graspable objects in {_DRAWS} draws")
