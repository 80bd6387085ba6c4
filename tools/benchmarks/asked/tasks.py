"""Tasks as people bring them: things lie turned or on a side, and goals are conditions in words."""

import math
from collections.abc import Callable, Mapping
from functools import partial
from itertools import count

import msgspec
import numpy as np

from neurosym.evaluation.comparison import Bench
from neurosym.operators import vector
from neurosym.primitives.uprighting import laid
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.lying import SIDES, side_of
from neurosym.tasks.supports import with_pairs
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
ROOM = 0.2
"""How far apart two objects are at least of which one is laid on a side [m]."""
SEEDS_APART = 100_000
"""How far apart the seeds are of scenes that are drawn anew, since what is laid on a side rolls off it."""


def turned(objects: int, bench: Bench, _: DomainFolder, seed: int) -> Problem:
    """Draw graspable objects that lie at any angle, with goals anywhere, at least 15 cm away."""
    return lying_turned(far(bench, objects, seed, graspable=True), seed)


def headed(bench: Bench, folder: DomainFolder, seed: int) -> Problem:
    """Draw a graspable object at any angle, that shall come to a point anywhere and be turned there."""
    drawn, rng = turned(1, bench, folder, seed), np.random.default_rng([seed, 15])
    ((name, (x, y, _)),) = drawn.goals.items()
    wanted = f"{name} at {x:.3f},{y:.3f} and {name} heading={rng.integers(-90, 90)}"
    return with_goals(msgspec.structs.replace(drawn, goals={}, conditions=(wanted,)), bench.setting.grounding)


def fallen(is_brought: bool, bench: Bench, _: DomainFolder, seed: int) -> Problem:
    """Draw two graspable objects; the first lies on a side and shall stand, brought to its goal or not."""
    grounding, world = bench.setting.grounding, bench.setting.world
    for number in count(seed, SEEDS_APART):
        drawn, side = far(bench, 2, number, graspable=True), [*SIDES][seed % len(SIDES)]
        first, *others = drawn.objects
        lies = laid(drawn.only(first.name).scene(), side)
        at_rest = world.interact(lies, world.action_box.high, 0).start
        has_room = math.dist(first.position, others[0].position) > ROOM
        if has_room and side_of(at_rest.orientations[0], turned=False) == side:
            break
    pose = {"position": vector(lies.positions[0]), "orientation": tuple(lies.orientations[0].tolist())}
    objects = (msgspec.structs.replace(first, **pose), *others)
    x, y, _ = drawn.goals[first.name]
    wanted = f"{first.name} upright" + f" and {first.name} at {x:.3f},{y:.3f}" * is_brought
    asked = msgspec.structs.replace(drawn, objects=objects, goals={}, conditions=(wanted,))
    return with_goals(asked, grounding)


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
    "set upright": (partial(fallen, False), 60),
    "set upright, and brought": (partial(fallen, True), 40),
    **{f"form: {form}": (partial(said, form), 5) for form in FORMS},
    ALL_SHAPES: (all_shapes, 10),
}
"""What is tried, by name, and how many tasks of each."""
