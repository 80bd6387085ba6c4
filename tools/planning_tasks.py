"""Symbolic tasks for `evaluate_planning.py`: goals that random operators lead to, so that a plan exists."""

import msgspec
import numpy as np

from neurosym.comparison_tasks import Bench
from neurosym.errors import InvalidValue
from neurosym.operators import TOLERANCE, Vector
from neurosym.pddl.grounding import Grounding, is_lift
from neurosym.pddl.moves import PUT_DOWN
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.replay import replay
from neurosym.problems import Problem, SceneObject
from neurosym.tasks import item_names
from neurosym.world import Scene, World

DIFFICULTIES = {"easy": (1, 3), "hard": (5, 8)}
"""Least and greatest number of steps that lead each object to its goal."""
CROWD, SMALL = 4, 0.075
"""Where more objects than this are to find room, none is wider [m]."""
_STREAM = 0x73796D62  # keeps this randomness apart from any other
_TRIES, _PLACES = 400, 4000


def draw_symbolic(bench: Bench, objects: int, difficulty: str, seed: int) -> Problem:
    """Draw a scene, and goals that random live operators lead to without leaving the table or colliding.

    No object is at its goal at the start, and none but the last may end held.

    Args:
        bench: The world and the learned domain.
        objects: How many objects.
        difficulty: One of `DIFFICULTIES`.
        seed: Same seed, same task.
    """
    low, high = DIFFICULTIES[difficulty]
    for attempt in range(_TRIES):
        rng = np.random.default_rng([_STREAM, objects, low, seed, attempt])
        scene = _scene(bench.setting.world, rng, objects)
        start = _problem(bench, scene, f"{difficulty}-{objects:02d}-{seed:05d}")
        walk = rng.permutation(np.repeat(np.arange(objects), rng.integers(low, high + 1, size=objects)))
        end = _walked(start, bench.setting.grounding, [start.object_names[index] for index in walk], rng)
        if end is not None:
            goals = {item.name: item.position for item in end.objects}
            task = msgspec.structs.replace(start, goals=goals)
            if min(task.distances(scene.positions).values()) > TOLERANCE:
                return task
    raise InvalidValue(f"No task of {objects} objects was found in {_TRIES} draws.")


def _scene(world: World, rng: np.random.Generator, objects: int) -> Scene:
    """Draw a scene; a crowded one object by object, small ones that do not overlap."""
    if objects <= CROWD:
        return world.sample_scene(rng, objects)
    found: list[Scene] = []
    for _ in range(_PLACES):
        one = world.sample_scene(rng, 1)
        if one.features[0, :2].max() <= SMALL and not any(_overlap(one, other) for other in found):
            found.append(one)
        if len(found) == objects:
            parts = ((s.features, s.positions, s.orientations) for s in found)
            return Scene(*(np.concatenate(part) for part in zip(*parts, strict=True)))
    raise InvalidValue(f"{objects} objects find no room.")


def _overlap(one: Scene, other: Scene) -> bool:
    reach = (one.features[0, :2] + other.features[0, :2]) / 2
    return bool(np.all(np.abs(one.positions[0, :2] - other.positions[0, :2]) < reach))


def _problem(bench: Bench, scene: Scene, name: str) -> Problem:
    rows = zip(
        item_names(len(scene)),
        bench.categorise(scene.features),
        scene.features.tolist(),
        scene.positions.tolist(),
        strict=True,
    )
    items = tuple(SceneObject(item, kind, tuple(size), _vector(place)) for item, kind, size, place in rows)
    return Problem(name, items, {item.name: item.position for item in items}, provenance="random operators")


def _walked(
    problem: Problem, grounding: Grounding, walk: list[str], rng: np.random.Generator
) -> Problem | None:
    """Apply a random operator to each object in turn; None if an object can go nowhere."""
    live = sorted(grounding.live, key=lambda operator: operator.name)
    for number, name in enumerate(walk, 1):
        item = problem.object_named(name)
        usable = [operator for operator in live if operator.category == item.category]
        for index in rng.permutation(len(usable)):
            steps = [PlanStep(usable[index].name, name)]
            if is_lift(usable[index]) and number < len(walk):
                steps.append(PlanStep(PUT_DOWN + usable[index].name, name))
            moved = replay(steps, problem, grounding)
            if moved.possible:
                problem = _moved(problem, moved.positions[-1])
                break
        else:
            return None
    return problem


def _moved(problem: Problem, positions: np.ndarray) -> Problem:
    rows = zip(problem.objects, positions.tolist(), strict=True)
    items = tuple(msgspec.structs.replace(item, position=_vector(place)) for item, place in rows)
    return msgspec.structs.replace(problem, objects=items)


def _vector(values: list[float]) -> Vector:
    x, y, z = values
    return (x, y, z)
