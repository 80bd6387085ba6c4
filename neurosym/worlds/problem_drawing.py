"""Making problems: tasks drawn from the world as the paper draws them, or goals given by hand."""

from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from neurosym.checks import check_count, check_length, check_seed, check_whole
from neurosym.errors import InvalidValue
from neurosym.guarded import guarded, placed
from neurosym.operators import TOLERANCE, Vector, vector
from neurosym.problems import Problem, SceneObject, check_goals, check_names, goal_heights
from neurosym.relation_goals import RelationGoal
from neurosym.symbols import Categorise, symbols_of
from neurosym.world import Outcome, Scene, World

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
