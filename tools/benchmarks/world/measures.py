"""What `evaluate.py` measures of the tabletop world, each from its own seed."""

import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import LEARNED_SHAPES as SHAPES
from neurosym.sim.shapes import OPEN_THROUGH, OPEN_TOP, SOLID
from neurosym.sim.simulation import sample_scene
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Outcome, Place, Table
from neurosym.worlds.workers import Task, crew, perform_all
from tools.benchmarks.world.hand_written import HAND_WRITTEN, carry_to

NUDGE = 1e-4  # length of the vector by which an action is changed to see whether its effect survives [m]
SPANNABLE = 0.128  # objects are spanned by the hand up to this s_y [m]: its opening of 0.14 m less some room
MARGIN = 0.05
"""How far inside the edge places lie that objects are carried to, lest their centres end beyond it [m]."""

Results = dict[str, Any]


def factory(**options: Any) -> Callable[[], Tabletop]:
    """Return what makes a tabletop world, in this process or another."""
    return partial(Tabletop, TabletopConfig(**options))


def random_tasks(
    count: int, seed: int, *, nudge: float = 0.0, objects: int = 1, world: Tabletop | None = None
) -> list[Task]:
    """Draw random actions on random objects, each nudged by a random vector of that length [m]."""
    world, tasks = world or Tabletop(), list[Task]()
    box = world.action_box
    for number in range(count):
        rng = np.random.default_rng([seed, number])
        scene = world.sample_scene(rng, objects)
        action = box.sample(rng, 1)[0]
        direction = np.where(box.gripper, 0.0, rng.normal(size=len(action)))
        nudged = action + nudge * direction / np.linalg.norm(direction)
        tasks.append(Task(scene, np.clip(nudged, box.low, box.high)))
    return tasks


def kind_of(features: np.ndarray) -> str:
    """Name what kind of object features describe: how it is open, and whether the hand spans it."""
    opened = {SOLID: "solid", OPEN_TOP: "open-topped", OPEN_THROUGH: "ring"}[float(features[3])]
    flat = opened == "solid" and features[2] < 0.04 and max(features[:2]) > 0.1 and min(features[:2]) < 0.07
    return f"{'plank' if flat else opened}, {'spannable' if features[1] <= SPANNABLE else 'too wide'}"


def predictability(count: int, seed: int, workers: int, **options: Any) -> Results:
    """Measure the share of the effects' variance that survives a 0.1 mm change of the action."""
    make = factory(**options)
    tasks = random_tasks(count, seed, world=make())
    nudged = random_tasks(count, seed, nudge=NUDGE, world=make())
    outcomes = [*perform_all(make, [*tasks, *nudged], workers)]
    effects = np.array([outcome.effect for outcome in outcomes]).reshape(2, count, 3)
    held = np.array([outcome.held for outcome in outcomes]).reshape(2, count)
    shapes = np.array([kind_of(task.scene.features[0]).split(",")[0] for task in tasks])
    surviving = partial(_surviving, effects)
    return {
        "share": surviving(np.ones(count, bool)),
        "by_shape": {shape: surviving(shapes == shape) for shape in sorted(set(shapes))},
        "interactions": count,
        "held": float(held.mean()),
        "held_in_one_of_two": int((held[0] != held[1]).sum()),
    }


def _surviving(effects: np.ndarray, rows: np.ndarray) -> float:
    first, second = effects[:, rows]
    lost, whole = ((first - second) ** 2).sum() / 2, ((first - first.mean(0)) ** 2).sum()
    return round(float(1 - lost / whole), 4) if whole > 0 else 1.0


def random_outcomes(outcomes: Sequence[Outcome]) -> Results:
    """Tell how random interactions end: held, put down, toppled, lost, and whether anything is impossible."""
    data = Interactions.from_outcomes(outcomes, np.zeros((len(outcomes), 12)), {})
    away = np.linalg.norm((data.resting_effects - data.effects)[data.held][:, :2], axis=1)
    hollow, wide = data.features[:, 3] >= 0.5, data.features[:, 1] > SPANNABLE
    kinds = {
        "solid, spannable": ~hollow & ~wide,
        "solid, too wide": ~hollow & wide,
        "open, spannable": hollow & ~wide,
        "open, too wide": hollow & wide,
    }
    # how high the lowest possible point of the target lies at the end: at least 0 on a table [m]
    halves = [one.start.features[one.target][:3].min() / 2 for one in outcomes]
    bottoms = np.array([one.end.positions[one.target][2] for one in outcomes]) - halves
    moved = np.linalg.norm(data.resting_effects, axis=1)
    return {
        "interactions": len(data),
        "held": float(data.held.mean()),
        "held_by_kind": {name: float(data.held[rows].mean()) for name, rows in kinds.items()},
        "lifts": int(data.held.sum()),
        "put_down_within_1cm": float(np.mean(away < 0.01)),
        "put_down_median_mm": float(1000 * np.median(away)),
        "toppled": float(data.toppled.mean()),
        "lost": float(data.lost.mean()),
        "moved_less_than_1cm": float(np.mean(np.linalg.norm(data.effects, axis=1) < 0.01)),
        "greatest_displacement_m": float(moved.max()),
        "below_the_table": int(np.sum(bottoms < -0.002)),
    }


def object_matters(actions: int, objects: int, seed: int, workers: int) -> Results:
    """Split the effects' variance: what the action alone decides, and what the object adds.

    The same random actions are performed on the same random objects. The share of the action alone is the
    variance of the means over objects (without bias: less the variance within, divided by their number).
    """
    world = Tabletop()
    scenes = [world.sample_scene(np.random.default_rng([seed, 0, i]), 1) for i in range(objects)]
    drawn = world.action_box.sample(np.random.default_rng([seed, 1]), actions)
    tasks = [Task(scene, action) for action in drawn for scene in scenes]
    outcomes = [*perform_all(factory(), tasks, workers)]
    effects = np.array([outcome.effect for outcome in outcomes]).reshape(actions, objects, 3)
    within = effects.var(axis=1, ddof=1).mean(axis=0)
    alone = effects.mean(axis=1).var(axis=0, ddof=1) - within / objects
    return {
        "actions": actions,
        "objects": objects,
        "share_of_action_alone": float((alone / (alone + within)).mean()),
        "by_axis": (alone / (alone + within)).tolist(),
        "outcomes_by_kind": _outcomes_by_kind([kind_of(one.features[0]) for one in scenes], outcomes),
    }


def _outcomes_by_kind(kinds: Sequence[str], outcomes: Sequence[Outcome]) -> Results:
    actions, found = len(outcomes) // len(kinds), {kind: Counter[str]() for kind in sorted(set(kinds))}
    for number, outcome in enumerate(outcomes):
        is_unmoved = outcome.kind == "resting" and np.linalg.norm(outcome.effect) < 0.01
        found[kinds[number % len(kinds)]]["unmoved" if is_unmoved else outcome.kind] += 1
    return {
        kind: {"objects": kinds.count(kind)}
        | {mode: round(count / (actions * kinds.count(kind)), 3) for mode, count in sorted(modes.items())}
        for kind, modes in found.items()
    }


def hand_written(objects: int, seed: int, workers: int) -> Results:
    """Perform the hand-written primitives on objects of each shape that afford them."""
    table: Results = {name: {} for name in HAND_WRITTEN}
    with crew(factory(), workers) as perform:
        for (name, primitive), shape in product(HAND_WRITTEN.items(), SHAPES):
            tasks, drawn = _afforded(primitive.action, shape, objects, seed)
            failures = Counter(map(primitive.failure, perform(tasks)))
            succeeded = failures.pop("", 0)
            table[name][shape] = {
                "success": succeeded / objects,
                "objects": objects,
                "afforded_by": round(objects / drawn, 3),
                "failures": dict(sorted(failures.items())),
            }
    return table


def carrying(objects: int, seed: int, workers: int) -> Results:
    """Carry objects of each shape to places all over the table, by hand-written actions."""
    table: Results = {}
    with crew(factory(), workers) as perform:
        for shape in SHAPES:
            tasks, drawn = _afforded(carry_to, shape, objects, seed, to_places=True)
            outcomes = [*perform(tasks)]
            carried = [outcome for outcome in outcomes if outcome.kind == "carried"]
            offsets = [1000 * float(np.linalg.norm(outcome.resting_effect[:2])) for outcome in carried]
            table[shape] = {
                "afforded_by": round(objects / drawn, 3),
                "objects": len(outcomes),
                "success": len(carried) / len(outcomes),
                "offset_mm": np.quantile(offsets, (0.5, 0.9)).round(1).tolist(),
                "turn_degrees": round(math.degrees(np.quantile([one.turn for one in carried], 0.9)), 1),
            }
    return table


def _afforded(
    act: Callable[[np.ndarray], np.ndarray | None],
    shape: str,
    objects: int,
    seed: int,
    to_places: bool = False,
) -> tuple[list[Task], int]:
    """Draw objects until so many afford an action; return these, and how many were drawn."""
    config, tasks, drawn = TabletopConfig(shapes={shape: 1.0}), list[Task](), 0
    while len(tasks) < objects:
        rng = np.random.default_rng([seed, drawn])
        scene = sample_scene(config, rng, 1)
        place = random_place(rng, config.table, MARGIN) if to_places else None
        drawn += 1
        if (action := act(scene.features[0])) is not None:
            tasks.append(Task(scene, action, reference=place))
    return tasks, drawn


def predictability_of_carrying(count: int, seed: int, workers: int) -> Results:
    """Perform random actions with a place as reference, and once more with the action changed by 0.1 mm."""
    world = Tabletop()
    runs = [random_tasks(count, seed, nudge=nudge, world=world) for nudge in (0.0, NUDGE)]
    places = [random_place(np.random.default_rng([seed, n, 1]), world.table) for n in range(count)]
    tasks = [replace(task, reference=place) for run in runs for task, place in zip(run, places, strict=True)]
    outcomes = [*perform_all(factory(), tasks, workers)]
    carried = np.array([outcome.carried for outcome in outcomes]).reshape(2, count)
    ends = np.array([outcome.end.positions[0] for outcome in outcomes]).reshape(2, count, 3)
    apart = np.linalg.norm(ends[0] - ends[1], axis=1)
    both = carried.all(0)
    return {
        "interactions": count,
        "carried": float(carried.mean()),
        "carried_in_one_of_two": int((carried[0] != carried[1]).sum()),
        "ends_apart_by_over_10_mm": float(np.mean(apart > 0.01)),
        "carried_ends_apart_mm": (1000 * np.quantile(apart[both], (0.5, 0.9))).round(2).tolist(),
    }


def random_place(rng: np.random.Generator, table: Table, margin: float = 0.0) -> Place:
    """Draw a place on a table, at least so far inside its edge [m]."""
    x, y = (float(rng.uniform(low + margin, high - margin)) for low, high in (table.x, table.y))
    return Place(x, y)


def several_objects(scenes: int, objects: int, seed: int, workers: int) -> Results:
    """Act on one of several objects, and count what that does to the others."""
    outcomes = [*perform_all(factory(), random_tasks(scenes, seed, objects=objects), workers)]
    touched, moved = (
        np.array([bool(getattr(one, what)) for one in outcomes]) for what in ("touched", "disturbed")
    )
    return {
        "scenes": scenes,
        "objects": objects,
        "robot_touched_a_bystander": float(touched.mean()),
        "a_bystander_moved": float(moved.mean()),
        "moved_untouched": float((moved & ~touched).mean()),
    }
