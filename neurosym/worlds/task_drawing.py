"""Tasks that people bring: put things there, have them change places, set them in a row, clear a crowd."""

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any, get_args

import msgspec
import numpy as np

from neurosym.checks import Float, check_callable, check_count, check_length, check_seed
from neurosym.choices import TaskKind
from neurosym.contract import guarded, placed
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import TOLERANCE, Categorise, Vector, symbols_of, vector
from neurosym.pair_operators import extent
from neurosym.problems import Problem, RelationGoal, SceneObject, check_goals, check_names, goal_heights
from neurosym.world import Outcome, Scene, Table, World

# Making problems: tasks drawn from the world as the paper draws them, or goals given by hand

_MOST_DRAWS = 1000
_TURNS = 0x7475726E  # keeps the randomness of how objects lie apart from all others
_ROOM = 0.01  # between objects that are turned [m]
_TASKS = 0x7461736B  # keeps the randomness of tasks apart from that of exploration and rehearsal


def draw_problem(
    world: World,
    categorise: Categorise,
    *,
    name: str,
    objects: int,
    seed: int,
    actions: int = 1,
    tolerance: float = TOLERANCE,
) -> Problem:
    """Draw a task as section III-E does: random scene, random action, and what results is the goal.

    Goals may be in mid-air. Draws whose start already meets the goal, or whose result lies off the table, are
    thrown away and drawn again; the problem's provenance counts them. Several actions make harder tasks: each
    begins where everything came to rest after the one before.

    Args:
        world: The world that the random action is performed in.
        categorise: Gives objects their symbols.
        name: Name of the problem.
        objects: How many objects.
        seed: Same seed, same problem.
        actions: How many random actions lead to the goal.
        tolerance: How near each object must come to its goal [m].

    Raises:
        InvalidValue: If the objects do not fit, or no draw moves anything.
    """
    world = guarded(world)
    check_task(name, objects, seed, tolerance)
    check_count("actions", actions)
    count = "one random action" if actions == 1 else f"{actions} random actions"
    for draw in range(_MOST_DRAWS):
        rng = np.random.default_rng([_TASKS, seed, draw])
        outcomes: list[Outcome] = []
        with placed(f"draw {draw + 1}"):
            scene = before = world.sample_scene(rng, objects)
            for _ in range(actions):
                target = int(rng.integers(len(scene)))
                outcomes.append(world.interact(scene, world.action_box.sample(rng, 1)[0], target))
                scene = outcomes[-1].end
        names = item_names(objects)
        acted_on = ", ".join(names[outcome.target] for outcome in outcomes)
        problem = Problem(
            name=name,
            objects=items_of(outcomes[0].start, categorise),
            goals=dict(zip(names, map(vector, outcomes[-1].lifted.positions), strict=True)),
            tolerance=tolerance,
            provenance=f"drawn with seed {seed}: {count} on {acted_on}; draw {draw + 1}, earlier ones met at "
            "the start or off the table",
        )
        stays = all(world.table.contains(spot) for outcome in outcomes for spot in outcome.lifted.positions)
        if stays and not problem.is_met(before.positions):
            return problem
    raise InvalidValue(f"None of {_MOST_DRAWS} random actions moves an object by more than {tolerance} m.")


def set_problem(
    world: World,
    categorise: Categorise,
    goals: Mapping[str, tuple[float, ...]],
    *,
    name: str,
    objects: int,
    seed: int,
    tolerance: float = TOLERANCE,
    relations: tuple[RelationGoal, ...] = (),
    conditions: tuple[str, ...] = (),
) -> Problem:
    """Draw a scene and set goals in it by hand.

    Args:
        world: The world that the scene is drawn from.
        categorise: Gives objects their symbols.
        goals: Where the centre of an object shall come to be [m], by its name (`item-01`, ...): x, y, and z
            unless it is to rest on the table.
        name: Name of the problem.
        objects: How many objects.
        seed: Same seed, same scene.
        tolerance: How near each object must come to its goal [m].
        relations: Which object shall stand to which other one in which state.
        conditions: What shall hold, in words, in place of goals.

    Raises:
        InvalidValue: If the objects do not fit, or a goal names none of them or lies out of reach.
    """
    world = guarded(world)
    check_task(name, objects, seed, tolerance)
    scene = world.sample_scene(np.random.default_rng([_TASKS, seed]), objects)
    items = items_of(scene, categorise)
    resting = {item.name: item.position[2] for item in items}
    problem = Problem(
        name=name,
        objects=items,
        goals={item: _completed(item, goal, resting.get(item, 0.0)) for item, goal in goals.items()},
        tolerance=tolerance,
        provenance=f"scene drawn with seed {seed}, goals by hand",
        relations=relations,
        conditions=conditions,
    )
    check_goals(problem, world.table, goal_heights(problem, world.lift_height))
    return problem


def lying_turned(problem: Problem, seed: int) -> Problem:
    """Return a problem whose objects lie turned by any angle, where they have room for that.

    Quarter turns change nothing but which of two sizes is along x, and these are drawn alike. So angles go
    from -45 to 45 degrees. An object that would come too near to another one stays as it is.
    """
    rng, objects = np.random.default_rng([_TURNS, seed]), [*problem.objects]
    for number, item in enumerate(problem.objects):
        angle = float(rng.uniform(-np.pi / 4, np.pi / 4))
        turned = msgspec.structs.replace(
            item, orientation=(0.0, 0.0, round(math.sin(angle / 2), 6), round(math.cos(angle / 2), 6))
        )
        scene = msgspec.structs.replace(
            problem, objects=(*objects[:number], turned, *objects[number + 1 :])
        ).scene()
        size = np.array([extent(scene, row)[:2] for row in range(len(scene))])
        gaps = np.abs(scene.positions[:, :2] - scene.positions[number, :2]) - (size + size[number]) / 2
        gaps[number] = np.inf
        if np.all(gaps.max(1) >= _ROOM):
            objects[number] = turned
    return msgspec.structs.replace(
        problem, objects=tuple(objects), provenance=f"{problem.provenance}; objects lie turned"
    )


def check_task(name: str, objects: int, seed: int, tolerance: float) -> None:
    """Raise `InvalidValue` unless a task can be called so and have so much, before anything is drawn."""
    check_count("objects", objects)
    check_names((name,))
    check_seed(seed)
    check_length("tolerance", tolerance)


def item_names(objects: int) -> tuple[str, ...]:
    """Return what the objects of a made scene are called: `item-01`, `item-02`, ..."""
    return tuple(f"item-{number:02d}" for number in range(1, objects + 1))


def items_of(scene: Scene, categorise: Categorise) -> tuple[SceneObject, ...]:
    """Return the objects of a scene, called `item-01` and so on.

    Args:
        scene: The scene.
        categorise: Gives objects their symbols.
    """
    symbols, features = symbols_of(categorise, scene.features), scene.features.tolist()
    rows = zip(item_names(len(scene)), symbols, map(tuple, features), strict=True)
    items = [SceneObject(*row, (0.0, 0.0, 0.0)) for row in rows]
    if scene.unseen.size:
        known = zip(items, scene.unseen.tolist(), strict=True)
        items = [msgspec.structs.replace(item, unseen=tuple(unseen)) for item, unseen in known]
    return standing(items, scene)


def standing(items: Sequence[SceneObject], scene: Scene) -> tuple[SceneObject, ...]:
    """Return objects as they stand in a scene, in the same order."""
    rows = zip(items, scene.positions, scene.orientations, strict=True)
    return tuple(
        msgspec.structs.replace(item, position=vector(position), orientation=tuple(orientation.tolist()))
        for item, position, orientation in rows
    )


def _completed(item: str, goal: tuple[float, ...], resting_height: float) -> Vector:
    is_place = isinstance(goal, tuple | list) and all(isinstance(part, int | float) for part in goal)
    if not is_place or len(goal) not in (2, 3) or not np.all(np.isfinite(goal)):
        raise InvalidValue(f"The goal of {item} is {goal}; give x,y or x,y,z in metres.")
    x, y, z = (*goal, resting_height)[:3]
    return (x, y, z)


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
    check_task(name, objects, seed, tolerance)
    if fits is not None:
        check_callable("fits", fits, "a function from features (F,) to True or False")
    if kind in _ALONE and objects < 2:
        raise InvalidValue(f"One object {_ALONE[kind]}; ask for at least 2.")
    number = TASK_KINDS.index(kind)
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, objects, seed, draw, *([number] if number else [])])
        with placed(f"draw {draw + 1}"):
            scene = world.sample_scene(rng, objects)  # its places are near the middle, and not used
        if fits and not all(map(fits, scene.features)):
            continue
        with suppress(NoRoom):
            starts, goals = _PLACES[kind](rng, scene.features[:, :2], world.table)
            heights = scene.positions[:, 2:]
            turns = np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1))
            items = items_of(
                replace(scene, positions=np.hstack([starts, heights]), orientations=turns), categorise
            )
            ends = map(vector, np.hstack([goals, heights]))
            goals_of = dict(zip(item_names(objects), ends, strict=True))
            told = f"{kind}, drawn with seed {seed}; draw {draw + 1}"
            return Problem(name, items, goals_of, tolerance, provenance=told)
    raise InvalidValue(f"{objects} objects find no places on the table for the task {kind!r}; ask for fewer.")


def _anywhere(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots]:
    starts = draw_places(rng, sizes, table)
    return starts, draw_places(rng, sizes, table, starts)


def _swap(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots]:
    largest = np.tile(sizes.max(0), (len(sizes), 1))  # so that each fits where the next stands
    starts = draw_places(rng, largest, table)
    return starts, np.roll(starts, -1, axis=0)


def _row(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots]:
    widths = sizes[:, 1]
    length = widths.sum() + ROW_GAP * (len(widths) - 1)
    if length > table.y[1] - table.y[0]:
        raise NoRoom
    left = np.cumsum(widths + ROW_GAP) - ROW_GAP - widths / 2 - length / 2 + sum(table.y) / 2
    goals = np.column_stack([np.full(len(widths), sum(table.x) / 2), left])
    return draw_places(rng, sizes, table), goals


def _crowded(rng: np.random.Generator, sizes: Spots, table: Table) -> tuple[Spots, Spots]:
    apart, starts = (sizes[:, None] + sizes) / 2, np.full(sizes.shape, np.inf)

    def suits(row: int, spot: Float[np.ndarray, "2"]) -> bool:
        away = np.abs(starts[:row] - spot)
        beside = np.all(away < apart[row, :row] + CROWDED, axis=1)
        return row == 0 or bool(beside.any() and not np.all(away < apart[row, :row], axis=1).any())

    _draw_spots(rng, sizes, table, starts, suits)
    return starts, draw_places(rng, sizes, table, starts)


_PLACES: dict[TaskKind, Callable[[np.random.Generator, Spots, Table], tuple[Spots, Spots]]] = {
    "anywhere": _anywhere,
    "swap": _swap,
    "row": _row,
    "crowded": _crowded,
}
"""Draws starts and goals of each kind of task."""
_ALONE = {"swap": "has no other to change places with", "crowded": "is no crowd"}
"""Why tasks of a kind need two objects."""


class NoRoom(Exception):
    """An object finds no place."""


def draw_places(rng: np.random.Generator, sizes: Spots, table: Table, starts: Spots | None = None) -> Spots:
    """Draw where objects of these footprints [m] shall be, on the table and apart.

    If they stand somewhere now, each is `AWAY` from there. `NoRoom` is raised if one finds no place.
    """
    apart = (sizes[:, None] + sizes) / 2  # (M, M, 2)
    taken = np.full(sizes.shape, np.inf) if starts is None else starts.copy()

    def suits(row: int, spot: Float[np.ndarray, "2"]) -> bool:
        others = np.arange(len(sizes)) != row
        is_far = starts is None or np.linalg.norm(spot - starts[row]) >= AWAY
        return bool(is_far) and not np.all(np.abs(taken[others] - spot) < apart[row, others], axis=1).any()

    _draw_spots(rng, sizes, table, taken, suits)
    return taken


def _draw_spots(
    rng: np.random.Generator, sizes: Spots, table: Table, spots: Spots, suits: Callable[[int, Any], bool]
) -> None:
    """Draw one spot after another, until it suits, and put it into its row."""
    low, high = np.array([table.x, table.y]).T
    if np.any(sizes > high - low):
        raise NoRoom
    for row, size in enumerate(sizes):
        drawn = (rng.uniform(low + size / 2, high - size / 2) for _ in range(_TRIES))
        spot = next((spot for spot in drawn if suits(row, spot)), None)
        if spot is None:
            raise NoRoom
        spots[row] = spot
