"""Tasks that people bring: put things there, have them change places, set them in a row, clear a crowd."""

from collections.abc import Callable
from typing import get_args

import numpy as np

from neurosym.arrays import Float
from neurosym.checks import check_callable, check_count, check_length, check_seed
from neurosym.choices import TaskKind
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.guarded import guarded, placed
from neurosym.operators import TOLERANCE, vector
from neurosym.problems import Problem, check_names
from neurosym.symbols import Categorise
from neurosym.table import Table
from neurosym.world import Scene, World
from neurosym.worlds.problem_drawing import items_of

TASK_KINDS: tuple[TaskKind, ...] = get_args(TaskKind)
AWAY = 0.15
"""Least distance of a goal from where its object stands [m], but for swaps and rows."""
ROW_GAP = 0.04
"""Room between objects that shall stand in a row [m]."""
CROWDED = 0.05
"""Objects of a crowd stand nearer to the next than this [m]."""
Fits = Callable[[Float[np.ndarray, " F"]], bool]
"""Says of the features of an object whether it may be drawn."""
_STREAM = 0x616E7977  # keeps this randomness apart from any other
_DRAWS, _TRIES = 1000, 1000

Spots = Float[np.ndarray, "M 2"]


def draw_task(
    world: World,
    categorise: Categorise,
    kind: TaskKind,
    *,
    name: str,
    objects: int,
    seed: int,
    tolerance: float = TOLERANCE,
    fits: Fits | None = None,
) -> Problem:
    """Draw objects, and for each a start and a goal on the table.

    `anywhere`: starts and goals are uniform over the table, each goal at least 15 cm away. A goal is also
    apart from where objects stand whose goals are drawn later, so that moving the objects in turn leads to
    the goals. `swap`: each object shall stand where the next one stands. `row`: all shall stand in a row
    across the middle of the table, in their order. `crowded`: each stands within 5 cm of another, and shall
    go anywhere. Footprints lie on the table, starts apart from one another, and so do goals. Nothing depends
    on what was learned, but the names of categories.

    Args:
        world: The world that the objects are drawn from.
        categorise: Gives objects their symbols.
        kind: What is asked for.
        name: Name of the problem.
        objects: How many objects.
        seed: Same seed, same task.
        tolerance: How near each object must come to its goal [m].
        fits: Says of the features of an object whether it may be drawn; all may, if not given.

    Raises:
        UnknownChoice: If there is no such kind.
        InvalidValue: If so many objects find no places.
    """
    if kind not in TASK_KINDS:
        raise UnknownChoice("kind of task", str(kind), TASK_KINDS)
    world = guarded(world)
    check_count("objects", objects)
    check_names((name,))
    check_seed(seed)
    check_length("tolerance", tolerance)
    if fits is not None:
        check_callable("fits", fits, "a function from features (F,) to True or False")
    if kind == "swap" and objects < 2:
        raise InvalidValue("One object has no other to change places with; ask for at least 2.")
    if kind == "crowded" and objects < 2:
        raise InvalidValue("One object is no crowd; ask for at least 2.")
    number = TASK_KINDS.index(kind)
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, objects, seed, draw, *([number] if number else [])])
        with placed(f"draw {draw + 1}"):
            scene = world.sample_scene(rng, objects)  # its places are near the middle, and not used
        if fits and not all(map(fits, scene.features)):
            continue
        found = _PLACES[kind](rng, scene.features[:, :2], world.table)
        if found is not None:
            said = f"{kind}, drawn with seed {seed}; draw {draw + 1}"
            return _arranged(scene, categorise, *found, name, tolerance, said)
    raise InvalidValue(f"{objects} objects find no places on the table for the task {kind!r}; ask for fewer.")


def _arranged(
    scene: Scene,
    categorise: Categorise,
    starts: Spots,
    goals: Spots,
    name: str,
    tolerance: float,
    provenance: str,
) -> Problem:
    """Return the task that brings the objects of a scene from where they start to their goals."""
    heights = scene.positions[:, 2:]
    upright = np.tile([0.0, 0.0, 0.0, 1.0], (len(scene), 1))
    items = items_of(Scene(scene.features, np.hstack([starts, heights]), upright), categorise)
    ends = map(vector, np.hstack([goals, heights]))
    goals_of = {item.name: end for item, end in zip(items, ends, strict=True)}
    return Problem(name, items, goals_of, tolerance, provenance=provenance)


def _anywhere(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots] | None:
    starts = draw_places(rng, sizes, table)
    goals = None if starts is None else draw_places(rng, sizes, table, starts)
    return None if starts is None or goals is None else (starts, goals)


def _swap(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots] | None:
    largest = np.tile(sizes.max(0), (len(sizes), 1))  # so that each fits where the next stands
    starts = draw_places(rng, largest, table)
    return None if starts is None else (starts, np.roll(starts, -1, axis=0))


def _row(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots] | None:
    widths = sizes[:, 1]
    length = widths.sum() + ROW_GAP * (len(widths) - 1)
    if length > table.y[1] - table.y[0]:
        return None
    left = np.cumsum(widths + ROW_GAP) - ROW_GAP - widths / 2 - length / 2 + sum(table.y) / 2
    goals = np.column_stack([np.full(len(widths), sum(table.x) / 2), left])
    starts = draw_places(rng, sizes, table)
    return None if starts is None else (starts, goals)


def _crowded(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots] | None:
    low, high = np.array([table.x, table.y]).T
    apart = (sizes[:, None] + sizes) / 2
    starts = rng.uniform(low + sizes[:1] / 2, high - sizes[:1] / 2)
    for number in range(1, len(sizes)):
        for _ in range(_TRIES):
            spot = rng.uniform(low + sizes[number] / 2, high - sizes[number] / 2)
            away = np.abs(starts - spot)
            beside = np.all(away < apart[number, :number] + CROWDED, axis=1)
            if beside.any() and not np.all(away < apart[number, :number], axis=1).any():
                starts = np.vstack([starts, spot])
                break
        else:
            return None
    goals = draw_places(rng, sizes, table, starts)
    return None if goals is None else (starts, goals)


_PLACES: dict[TaskKind, Callable[[np.random.Generator, Spots, Table], tuple[Spots, Spots] | None]] = {
    "anywhere": _anywhere,
    "swap": _swap,
    "row": _row,
    "crowded": _crowded,
}


def draw_places(
    rng: np.random.Generator, sizes: Spots, table: Table, starts: Spots | None = None
) -> Spots | None:
    """Draw where objects shall be, on the table and apart; None if one finds no place.

    Args:
        rng: Source of randomness.
        sizes: Widths of the footprints along x and y [m].
        table: Where they shall lie.
        starts: Where the objects stand now [m], if it is goals that are drawn.
    """
    low, high = np.array([table.x, table.y]).T
    if np.any(low + sizes / 2 > high - sizes / 2):
        return None
    apart = (sizes[:, None] + sizes) / 2  # (M, M, 2)
    taken = np.full(sizes.shape, np.inf) if starts is None else starts.copy()
    for row, size in enumerate(sizes):
        others = np.arange(len(sizes)) != row
        for _ in range(_TRIES):
            spot = rng.uniform(low + size / 2, high - size / 2)
            is_far = starts is None or np.linalg.norm(spot - starts[row]) >= AWAY
            if is_far and not np.all(np.abs(taken[others] - spot) < apart[row, others], axis=1).any():
                taken[row] = spot
                break
        else:
            return None
    return taken
