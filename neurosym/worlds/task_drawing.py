"""Tasks that people bring: put things there, have them change places, set them in a row, clear a crowd."""

from collections.abc import Callable, Mapping, Sequence
from typing import get_args

import msgspec
import numpy as np

from neurosym.checks import Float, check_callable, check_count, check_length, check_seed, check_whole
from neurosym.choices import TaskKind
from neurosym.contract import guarded, placed
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import TOLERANCE, Categorise, Vector, symbols_of, vector
from neurosym.problems import Problem, RelationGoal, SceneObject, check_goals, check_names, goal_heights
from neurosym.world import Outcome, Scene, Table, World

# Making problems: tasks drawn from the world as the paper draws them, or goals given by hand

_MOST_DRAWS = 1000
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
    for kind, count in (("object", objects), ("action", actions)):
        check_whole(f"{kind}s", count)
        if count < 1:
            raise InvalidValue(f"A problem needs at least one {kind}, not {count}.")
    _check(name, seed, tolerance)
    for draw in range(_MOST_DRAWS):
        rng = np.random.default_rng([_TASKS, seed, draw])
        with placed(f"draw {draw + 1}"):
            scene = world.sample_scene(rng, objects)
            outcomes = _act_at_random(world, scene, actions, rng)
        goals = dict(zip(item_names(objects), map(vector, outcomes[-1].lifted.positions), strict=True))
        problem = Problem(
            name=name,
            objects=items_of(outcomes[0].start, categorise),
            goals=goals,
            tolerance=tolerance,
            provenance=f"drawn with seed {seed}: {_told(outcomes)}; draw {draw + 1}, earlier ones met at the "
            "start or off the table",
        )
        stays = all(world.table.contains(spot) for outcome in outcomes for spot in outcome.lifted.positions)
        if stays and not problem.is_met(scene.positions):
            return problem
    raise InvalidValue(f"None of {_MOST_DRAWS} random actions moves an object by more than {tolerance} m.")


def _act_at_random(world: World, scene: Scene, actions: int, rng: np.random.Generator) -> list[Outcome]:
    """Perform random actions on random objects, one after another."""
    outcomes: list[Outcome] = []
    for _ in range(actions):
        target = int(rng.integers(len(scene)))
        outcomes.append(world.interact(scene, world.action_box.sample(rng, 1)[0], target))
        scene = outcomes[-1].end
    return outcomes


def _told(outcomes: Sequence[Outcome]) -> str:
    names = item_names(len(outcomes[0].start))
    count = "one random action" if len(outcomes) == 1 else f"{len(outcomes)} random actions"
    return f"{count} on {', '.join(names[outcome.target] for outcome in outcomes)}"


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

    Raises:
        InvalidValue: If the objects do not fit, or a goal names none of them or lies out of reach.
    """
    world = guarded(world)
    check_count("objects", objects)
    _check(name, seed, tolerance)
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
    )
    check_goals(problem, world.table, goal_heights(problem, world.lift_height))
    return problem


def _check(name: str, seed: int, tolerance: float) -> None:
    """Refuse a name, seed or tolerance before anything is drawn."""
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
    return standing([SceneObject(*row, (0.0, 0.0, 0.0)) for row in rows], scene)


def standing(items: Sequence[SceneObject], scene: Scene) -> tuple[SceneObject, ...]:
    """Return objects as they stand in a scene.

    Args:
        items: The objects.
        scene: The scene, in the same order.
    """
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
