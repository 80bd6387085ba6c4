"""Objects put on and into one another, and taken off and out again, by an action that a person wrote.

What an object is put over is another object of the scene. The action is the one that carries to places; see
`carry_to`. A pair of shapes is tried on objects of random sizes, one of which can be grasped.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import LEARNED_SHAPES as SHAPES
from neurosym.sim.shapes import sample_objects
from neurosym.sim.simulation import sample_scene
from neurosym.world import OtherObject, Outcome, Scene
from neurosym.worlds.workers import Perform, Task, crew, perform_all
from tools.benchmarks.relations.geometry import relation
from tools.benchmarks.world.hand_written import carry_to
from tools.benchmarks.world.measures import MARGIN, NUDGE, Results, factory, random_place, random_tasks

TARGET, UNDER = 0, 1  # which object of a scene is carried, and which one it is put over


def put_over(objects: int, seed: int, workers: int) -> Results:
    """Put objects of each shape over objects of each shape, and take away again what stands on or in them."""
    table: Results = {}
    with crew(factory(), workers) as perform:
        for done, (shape, under) in enumerate(product(SHAPES, SHAPES), 1):
            tasks = [_task(shape, under, [seed, done, number]) for number in range(objects)]
            put = [*perform(tasks)]
            ends = Counter(relation(one, TARGET, UNDER) for one in put if one.kind == "carried")
            table[f"{shape} over {under}"] = {
                "tried": len(put),
                "carried": ends.total(),
                "ends": dict(sorted(ends.items())),
                **_taken(put, perform, [seed, done]),
            }
    return table


def _task(shape: str, under: str, seed: Sequence[int]) -> Task:
    """Draw an object of a shape that can be grasped, and another with room between them for the hand."""
    rng = np.random.default_rng(seed)
    while True:
        scene = sample_scene(TabletopConfig(), rng, 2)
        sizes = {"size": TabletopConfig().size, "height": TabletopConfig().height}
        drawn = [sample_objects(rng, 1, shapes={name: 1.0}, **sizes)[0] for name in (shape, under)]
        features = np.vstack(drawn)
        positions = np.column_stack([scene.positions[:, :2], features[:, 2] / 2])
        gap = np.abs(np.subtract(*positions)) - features[:, :3].sum(0) / 2
        action = carry_to(features[TARGET])
        if action is not None and gap[:2].max() >= MARGIN:
            reference = OtherObject(UNDER)
            return Task(Scene(features, positions, scene.orientations), action, TARGET, reference=reference)


def _taken(put: Sequence[Outcome], perform: Perform, seed: Sequence[int]) -> Results:
    """Take what stands on or in another to a place, and count how often it came there alone."""
    tasks, names = list[Task](), list[str]()
    for number, outcome in enumerate(put):
        name = relation(outcome, TARGET, UNDER)
        action = carry_to(outcome.end.features[TARGET])
        if outcome.kind == "carried" and name in ("on", "in") and action is not None:
            place = random_place(np.random.default_rng([*seed, number, 1]), TabletopConfig().table, MARGIN)
            tasks.append(Task(outcome.end, action, TARGET, reference=place))
            names.append(name)
    ends = zip(names, perform(tasks), strict=True)
    alone = [name for name, end in ends if end.kind == "carried" and not end.disturbed]
    return {f"taken_{name}": [alone.count(name), names.count(name)] for name in ("on", "in")}


def towers(count: int, seed: int, workers: int) -> Results:
    """Build towers of solid objects that can be grasped, the widest below, and count those that stand."""
    table: Results = {}
    with crew(factory(), workers) as perform:
        for height in (3, 4):
            scenes = [_solids(height, [seed, height, number]) for number in range(count)]
            for level in range(1, height):
                outcomes = [*perform([_next_level(scene, level) for scene in scenes])]
                scenes = [outcome.end for outcome in outcomes]
            stand = [all(relation(end, n, n - 1) == "on" for n in range(1, height)) for end in outcomes]
            table[str(height)] = {"tried": count, "stand": sum(stand)}
    return table


def _solids(objects: int, seed: Sequence[int]) -> Scene:
    """Draw solid objects that can be grasped, the widest first."""
    rng, config = np.random.default_rng(seed), TabletopConfig(shapes={"box": 1.0, "plank": 1.0})
    while True:
        scene = sample_scene(config, rng, objects)
        if all(carry_to(features) is not None for features in scene.features):
            order = np.argsort(-scene.features[:, :2].prod(1))
            return Scene(scene.features[order], scene.positions[order], scene.orientations[order])


def _next_level(scene: Scene, level: int) -> Task:
    action = carry_to(scene.features[level])
    assert action is not None, "only what can be grasped is drawn"
    return Task(scene, action, level, reference=OtherObject(level - 1))


def predictability(count: int, seed: int, workers: int) -> Results:
    """Aim random actions at another object, and once more with the action changed by 0.1 mm."""
    runs = [random_tasks(count, seed, nudge=nudge, objects=2) for nudge in (0.0, NUDGE)]
    tasks = [replace(task, reference=OtherObject(UNDER)) for run in runs for task in run]
    outcomes = [*perform_all(factory(), tasks, workers)]
    ends = [relation(outcome, TARGET, UNDER) for outcome in outcomes]
    carried = [end for end, one in zip(ends[:count], outcomes, strict=False) if one.carried]
    return {
        "interactions": count,
        "carried": len(carried) / count,
        "ends_of_carried": dict(sorted(Counter(carried).items())),
        "another_relation": sum(one != other for one, other in zip(ends[:count], ends[count:], strict=True)),
    }
