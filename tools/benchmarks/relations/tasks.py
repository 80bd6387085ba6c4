"""Tasks of relations that a person draws who does not know what was learned, and solves by hand beforehand.

Actions that a person wrote are performed in the world; only tasks that they solve are kept. What is asked for
is told in the words of geometry, like "on", and only then in those of a domain.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from neurosym.operators import TOLERANCE
from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import OPEN_TOP, SOLID
from neurosym.sim.simulation import sample_scene
from neurosym.world import OtherObject, Outcome, Place, Scene, World, relative_to
from tools.benchmarks.relations.geometry import Relation, fits, relation
from tools.benchmarks.world.hand_written import carry_to
from tools.benchmarks.world.measures import MARGIN, random_place

OBJECTS = 6  # how many objects a scene has
FAR = 0.15  # so far away is a place at least [m]
_APART = 0.05  # free room around a place [m]
_DRAWS = 3000
_STREAM = 0x7461

Deed = tuple[int, OtherObject | Place]  # what is carried, and where to


class Unfit(Exception):
    """A scene of which no task can be made."""


@dataclass(frozen=True, slots=True)
class Goal:
    """That a target shall stand so to a reference; both are numbers of objects."""

    target: int
    reference: int
    word: Relation


@dataclass(frozen=True, slots=True, eq=False)
class Asked:
    """A task."""

    start: Scene
    contacts: tuple[tuple[int, int], ...]  # which objects touch at the start
    goals: tuple[Goal, ...]
    places: dict[int, Place]  # where objects shall be on the table, by their numbers
    deeds: tuple[Deed, ...]  # what a person carries where to, one after another, to bring that about

    def is_met(self, end: Outcome) -> bool:
        """Say by geometry whether all that was asked for is so after an interaction."""
        stands = all(relation(end, one.target, one.reference) == one.word for one in self.goals)
        return stands and all(
            math.dist(end.end.positions[target][:2], (place.x, place.y)) <= TOLERANCE
            for target, place in self.places.items()
        )


Draw = Callable[[World, int], Asked]  # draws the task of a seed
Cell = tuple[str, Draw, int]
"""What a cell of the table is called, what draws its tasks, and how many there are for each seed."""


def cells(count: int) -> tuple[Cell, ...]:
    """List what is tried."""
    return (
        ("tower of 3", partial(_tower, height=3), count),
        ("tower of 4", partial(_tower, height=4), count),
        ("three into three", _boxes, count),
        ("unstack and sort", _unstack, count),
        ("swap", _swap, count),
        ("tower of 3 at a place", partial(_tower, height=3, at_place=True), count),
        ("tower of 3 among 8", partial(_tower, height=3, objects=8), count),
    )


def slug(name: str) -> str:
    """Return what files of a cell are called."""
    return name.replace(" ", "-")


def _tower(world: World, seed: int, *, height: int, objects: int = OBJECTS, at_place: bool = False) -> Asked:
    """Draw solid objects that shall stand on one another, the widest below, and perhaps at a place."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked:
        chain = _solids(scene, rng, height, graspable=height if at_place else height - 1)
        goals = tuple(Goal(upper, lower, "on") for lower, upper in pairwise(chain))
        places = {chain[0]: _free_place(scene, chain[0], rng)} if at_place else {}
        return _solved(Asked(scene, (), goals, places, (*places.items(), *_one_by_one(goals))), world)

    return drawn(attempt, objects, [height, int(at_place)], seed)


def _boxes(world: World, seed: int) -> Asked:
    """Draw three objects that shall each come into a box or a ring of its own."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked:
        goals = _matched(scene, rng.permutation(len(scene)).tolist(), "in", 3)
        return _solved(Asked(scene, (), goals, {}, _one_by_one(goals)), world)

    return drawn(attempt, OBJECTS, [9, 3], seed)


def _unstack(world: World, seed: int) -> Asked:
    """Draw a stack of three whose upper objects shall each come on or into another object."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked:
        chain = _solids(scene, rng, 3, graspable=2)
        built = _built(scene, [*pairwise(chain)], world)
        others = [n for n in rng.permutation(len(scene)).tolist() if n not in chain]
        goals = _matched(scene, chain[:0:-1], None, 2, others)
        return _solved(Asked(built.end, built.contacts, goals, {}, _one_by_one(goals)), world)

    return drawn(attempt, OBJECTS, [10, 3], seed)


def _swap(world: World, seed: int) -> Asked:
    """Draw two objects, each on another, that shall change places."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked:
        here, there, one, other = _solids(scene, rng, 4, graspable=2)
        built = _built(scene, [(here, one), (there, other)], world)
        place = _free_place(built.end, one, rng)
        goals = Goal(other, here, "on"), Goal(one, there, "on")
        deeds = ((one, place), *_one_by_one(goals))
        return _solved(Asked(built.end, built.contacts, goals, {}, deeds), world)

    return drawn(attempt, OBJECTS, [11], seed)


def drawn(
    attempt: Callable[[Scene, np.random.Generator], Asked], objects: int, kind: list[int], seed: int
) -> Any:
    """Draw scenes until one makes a task, of which `attempt` says `Unfit` otherwise; at most `_DRAWS`."""
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, *kind, objects, seed, draw])
        try:
            return attempt(sample_scene(TabletopConfig(), rng, objects), rng)
        except Unfit:
            continue
    raise RuntimeError(f"none of {_DRAWS} draws can be done by hand")


def _solids(scene: Scene, rng: np.random.Generator, count: int, graspable: int) -> list[int]:
    """Choose solid objects of a scene, the widest first; so many of the last can be grasped."""
    solid = [n for n in rng.permutation(len(scene)).tolist() if _is_solid(scene, n)]
    chosen = sorted(solid[:count], key=lambda n: -float(scene.features[n][:2].prod()))
    held = chosen[count - graspable :]
    if len(chosen) < count or any(carry_to(scene.features[n]) is None for n in held):
        raise Unfit
    return chosen


def _is_solid(scene: Scene, index: int) -> bool:
    return bool(scene.features[index][3] < (SOLID + OPEN_TOP) / 2)


def _matched(
    scene: Scene, targets: Sequence[int], word: Relation | None, count: int, others: Sequence[int] = ()
) -> tuple[Goal, ...]:
    """Give so many of the targets a reference each, the first that will do."""
    goals = list[Goal]()
    for target in targets:
        used = {n for goal in goals for n in (goal.target, goal.reference)}
        if target in used or carry_to(scene.features[target]) is None:
            continue
        for other in others or targets:
            found = _word(scene, target, other)
            if other not in (*used, target) and found and word in (None, found):
                goals.append(Goal(target, other, found))
                break
    if len(goals) < count:
        raise Unfit
    return tuple(goals[:count])


def _word(scene: Scene, target: int, other: int) -> Relation | None:
    """Say how an object ends that a person sets down over another; None if that is hard to tell."""
    if _is_solid(scene, other):
        return "on"
    return "in" if fits(scene.features[target], scene.features[other]) else None


def _one_by_one(goals: Sequence[Goal]) -> tuple[Deed, ...]:
    return tuple((goal.target, OtherObject(goal.reference)) for goal in goals)


def _free_place(scene: Scene, target: int, rng: np.random.Generator) -> Place:
    """Draw a place with room for an object, far from where it is."""
    sizes, table = scene.features[:, :2], TabletopConfig().table
    others = np.arange(len(scene)) != target
    room = (sizes + sizes[target])[others] / 2 + _APART
    for _ in range(50):
        place = random_place(rng, table, MARGIN)
        away = np.abs(scene.positions[:, :2] - (place.x, place.y))
        is_free = bool(np.all(np.any(away[others] > room, axis=1)))
        if is_free and float(np.linalg.norm(away[target])) >= FAR:
            return place
    raise Unfit


def _built(scene: Scene, stacked: Sequence[tuple[int, int]], world: World) -> Outcome:
    """Put objects on others by hand: pairs of a lower and an upper one."""
    built = _done(scene, [(upper, OtherObject(lower)) for lower, upper in stacked], world)
    if any(relation(built, upper, lower) != "on" for lower, upper in stacked):
        raise Unfit
    return built


def _solved(asked: Asked, world: World) -> Asked:
    """Return a task whose deeds, done by hand, bring about what is asked for."""
    if not asked.is_met(_done(asked.start, asked.deeds, world)):
        raise Unfit
    return asked


def _done(scene: Scene, deeds: Sequence[Deed], world: World) -> Outcome:
    """Carry objects by hand, one after another."""
    for target, reference in deeds:
        action = carry_to(scene.features[target])
        assert action is not None, "only what can be grasped is to be carried"
        outcome = world.interact(scene, action, target, **relative_to(world, reference))
        if outcome.kind != "carried" or outcome.disturbed:
            raise Unfit
        scene = outcome.end
    return outcome
