"""Tasks as people bring them: things lie turned, goals are conditions in words, and what has toppled."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from itertools import islice
from typing import Any

import msgspec
import numpy as np

from neurosym.evaluation.comparison import Bench
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.supports import with_pairs
from neurosym.world import Scene, World
from neurosym.worlds.task_drawing import lying_turned
from tools.benchmarks.carrying.tasks import far

Draw = Callable[[Bench, DomainFolder, int], Problem]
FORMS: Mapping[str, str] = {
    "rectangle": "{a} x=0.55..0.75 y=-0.2..-0.05",
    "half plane": "{a} y=0.08..",
    "within reach": "all {kind} within-reach and {a} x=0.7..",
    "one coordinate": "{a} x=0.7",
    "heading": "{a} at 0.6,-0.1 and {a} heading=60",
    "one of several": "{a} at 0.7,0.2 or {b} at 0.6,-0.2",
    "next to": "{a} next-to {b}",
    "apart from": "{a} apart-from {b} and {a} y=..0",
    "under": "{c} under {a}",
    "not on": "{a} not-on {c} and {a} x=..0.6",
    "all of a category": "all {kind} x=..0.55",
    "so many of some": "2 of {a},{b},{d} y=..-0.08",
    "a point and a relation": "{a} on {c} and {a} at 0.6,0.1",
}
"""Conditions of every form: `a`, `b` and `d` can be grasped, `c` is the widest, `kind` that of `a`."""
OBJECTS = 4


def turned(objects: int, bench: Bench, _: DomainFolder, seed: int) -> Problem:
    """Draw graspable objects that lie at any angle, with goals anywhere, at least 15 cm away."""
    return lying_turned(far(bench, objects, seed, graspable=True), seed)


def headed(bench: Bench, folder: DomainFolder, seed: int) -> Problem:
    """Draw a graspable object at any angle, that shall come to a point anywhere and be turned there."""
    drawn, rng = turned(1, bench, folder, seed), np.random.default_rng([seed, 15])
    ((name, (x, y, _)),) = drawn.goals.items()
    wanted = f"{name} at {x:.3f},{y:.3f} and {name} heading={rng.integers(-90, 90)}"
    return with_goals(msgspec.structs.replace(drawn, goals={}, conditions=(wanted,)), bench.setting.grounding)


def said(form: str, bench: Bench, folder: DomainFolder, seed: int) -> Problem:
    """Draw a scene, and ask for something of a form.

    Raises:
        InvalidValue: If nothing that was learned can bring it about there.
    """
    grounding = bench.setting.grounding
    drawn = far(bench, OBJECTS, seed, graspable=True)
    names = {item.name: item for item in drawn.objects}
    widest = max(names, key=lambda name: min(names[name].features[:2]))
    others = [name for name in names if name != widest]
    words = dict(zip("abd", others, strict=True)) | {"c": widest, "kind": names[others[0]].category}
    bare = msgspec.structs.replace(drawn, goals={}, conditions=(FORMS[form].format(**words),))
    return with_goals(with_pairs(bare, grounding.relations, sight_of_pairs(folder)), grounding)


def all_shapes(bench: Bench, _: DomainFolder, seed: int) -> Problem:
    """Draw eight objects of all shapes, with goals anywhere."""
    return far(bench, 8, seed, graspable=False)


ALL_SHAPES = "all shapes, 8 objects"
DRAWN: Mapping[str, tuple[Draw, int]] = {
    "turned, 1 object": (partial(turned, 1), 60),
    "turned, 4 objects": (partial(turned, 4), 40),
    "headings": (headed, 60),
    **{f"form: {form}": (partial(said, form), 5) for form in FORMS},
    ALL_SHAPES: (all_shapes, 10),
}
"""What is tried, by name, and how many tasks of each."""


def set_upright(world: World, seed: int, tries: int) -> dict[str, Any]:
    """Perform random actions on objects that have toppled, and list those after which one stands upright."""
    rng, upright, moved, rested = np.random.default_rng([seed, 90]), list[dict[str, Any]](), 0, 0
    for side, toppled in islice(_toppled(world, rng), tries):
        action = world.action_box.sample(rng, 1)[0]
        outcome = world.interact(toppled, action, 0)
        if _stands(outcome.start):  # it does not rest on that side by itself
            continue
        rested += 1
        moved += bool(np.linalg.norm(outcome.resting_effect) > 0.01)
        if _stands(outcome.end):
            upright.append({"side": side, "action": action.tolist()})
    return {"tries": rested, "moved": moved, "upright": upright}


def set_upright_again(world: World, seed: int, found: Mapping[str, Any], times: int) -> float:
    """Say how often an action sets others upright that lie on the same side, as a share."""
    rng, good, rested = np.random.default_rng([seed, 91]), 0, 0
    alike = (toppled for side, toppled in _toppled(world, rng) if side == found["side"])
    for toppled in islice(alike, times):
        outcome = world.interact(toppled, np.array(found["action"]), 0)
        rested += not _stands(outcome.start)
        good += not _stands(outcome.start) and _stands(outcome.end)
    return good / max(1, rested)


def _toppled(world: World, rng: np.random.Generator) -> Iterator[tuple[int, Scene]]:
    """Draw objects that have toppled, each with the axis about which it has: 0 for x, 1 for y."""
    while True:
        scene = world.sample_scene(rng, 1)
        x, y = scene.features[0][:2]
        angle = np.pi / 4  # half of a quarter turn
        axis = int(rng.integers(2))
        orientation = np.zeros((1, 4))
        orientation[0, axis], orientation[0, 3] = np.sin(angle), np.cos(angle)
        position = scene.positions.copy()
        position[0, 2] = (y if axis == 0 else x) / 2
        yield axis, Scene(scene.features, position, orientation)


def _stands(scene: Scene) -> bool:
    """Say whether the side of the only object that was up at first is up."""
    x, y, _, _ = scene.orientations[0]
    return bool(1 - 2 * (x * x + y * y) > 0.9)
