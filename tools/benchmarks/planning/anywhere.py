"""Tasks as a user would ask for them: objects and goals anywhere on the table, far from one another."""

from collections.abc import Callable

import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidValue
from neurosym.evaluation.comparison_tasks import Bench
from neurosym.operators import TOLERANCE, vector
from neurosym.pddl.footprints import overlapping
from neurosym.problems import Problem, SceneObject
from neurosym.table import Table
from neurosym.world import Scene
from neurosym.worlds.problem_drawing import item_names

AWAY = 0.15
"""Least distance of a goal from where its object stands [m]."""
Fits = Callable[[Float[np.ndarray, " F"]], bool]
_STREAM = 0x616E7977  # keeps this randomness apart from any other
_DRAWS, _TRIES = 1000, 1000


def draw_anywhere(
    bench: Bench, objects: int, seed: int, tolerance: float = TOLERANCE, *, fits: Fits | None = None
) -> Problem:
    """Draw objects of all shapes, and for each a start and a goal, uniform over the table.

    Footprints lie on the table. Starts lie apart from one another, and so do goals. A goal is also apart from
    where objects stand whose goals are drawn later, so that moving the objects in turn leads to the goals.
    Places do not depend on what was learned.

    Args:
        bench: The world and the learned domain.
        objects: How many objects.
        seed: Same seed, same task.
        tolerance: How near each object must come to its goal [m].
        fits: Says of the features of an object whether it may be drawn; all may, if not given.

    Raises:
        InvalidValue: If so many objects find no places.
    """
    world = bench.setting.world
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, objects, seed, draw])
        scene = world.sample_scene(rng, objects)  # its places are near the middle, and not used
        if fits and not all(map(fits, scene.features)):
            continue
        sizes = scene.features[:, :2]
        starts = draw_places(rng, sizes, world.table)
        goals = None if starts is None else draw_places(rng, sizes, world.table, starts)
        if starts is None or goals is None:
            continue
        name, said = f"anywhere-{objects:02d}-{seed:05d}", f"anywhere on the table, draw {draw + 1}"
        return arranged(bench, name, scene, starts, goals, tolerance, said)
    raise InvalidValue(f"{objects} objects do not find places on the table; ask for fewer.")


def arranged(
    bench: Bench,
    name: str,
    scene: Scene,
    starts: Float[np.ndarray, "M 2"],
    goals: Float[np.ndarray, "M 2"],
    tolerance: float,
    provenance: str,
) -> Problem:
    """Return the task that brings the objects of a scene from where they start to their goals.

    Args:
        bench: The learned domain.
        name: What the task is called.
        scene: The objects, wherever they are drawn.
        starts: Where they stand [m].
        goals: Where they shall stand [m].
        tolerance: How near each must come to its goal [m].
        provenance: How the task came about.
    """
    names, heights = item_names(len(scene)), scene.positions[:, 2]
    symbols = bench.categorise(scene.features)
    items = tuple(
        SceneObject(item, symbol, tuple(features.tolist()), vector(np.array([*start, height])))
        for item, symbol, features, start, height in zip(
            names, symbols, scene.features, starts, heights, strict=True
        )
    )
    ends = {
        item: vector(np.array([*goal, height]))
        for item, goal, height in zip(names, goals, heights, strict=True)
    }
    return Problem(name, items, ends, tolerance, provenance=provenance)


def draw_places(
    rng: np.random.Generator,
    sizes: Float[np.ndarray, "M 2"],
    table: Table,
    starts: Float[np.ndarray, "M 2"] | None = None,
) -> Float[np.ndarray, "M 2"] | None:
    """Draw where objects shall be, on the table and apart; None if one finds no place.

    Args:
        rng: Source of randomness.
        sizes: Widths of the footprints along x and y [m].
        table: Where they shall lie.
        starts: Where the objects stand now [m], if it is goals that are drawn.
    """
    low, high = np.array([table.x, table.y]).T
    apart = (sizes[:, None] + sizes) / 2  # (M, M, 2)
    taken = np.full(sizes.shape, np.inf) if starts is None else starts.copy()
    for row, size in enumerate(sizes):
        others = np.arange(len(sizes)) != row
        for _ in range(_TRIES):
            spot = rng.uniform(low + size / 2, high - size / 2)
            is_far = starts is None or np.linalg.norm(spot - starts[row]) >= AWAY
            if is_far and not overlapping(spot, taken[others], apart[row, others]).any():
                taken[row] = spot
                break
        else:
            return None
    return taken
