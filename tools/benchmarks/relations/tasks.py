"""Tasks of relations that a person draws who does not know what was learned, and solves by hand beforehand.

Actions that a person wrote are performed in the world; only tasks that they solve are kept. What is asked for
is told in the words of geometry, like "on", and only then in those of a domain.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import TypeVar

import numpy as np

from neurosym.operators import TOLERANCE
from neurosym.sim.config import OPEN_TOP, SOLID, TabletopConfig
from neurosym.sim.simulation import sample_scene
from neurosym.world import OtherObject, Outcome, Place, Scene, World, relative_to
from tools.benchmarks.relations.geometry import Relation, fits, relation
from tools.benchmarks.world.hand_written import carry_to
from tools.benchmarks.world.measures import MARGIN, random_place

OBJECTS = 6
"""How many objects a scene has."""
FAR = 0.15
"""So far away is a place at least [m]."""
_APART = 0.05  # free room around a place [m]
_DRAWS = 3000
_STREAM = 0x7461


Deed = tuple[int, OtherObject | Place]
"""What is carried, and where to."""


@dataclass(frozen=True, slots=True)
class Goal:
    """That a target shall stand so to a reference; both are numbers of objects."""

    target: int
    reference: int
    word: Relation


@dataclass(frozen=True, slots=True, eq=False)
class Asked:
    """A task.

    Attributes:
        start: The objects as they stand.
        contacts: Which of them touch.
        goals: How they shall stand to one another.
        places: Where objects shall be on the table, by their numbers.
        deeds: What a person carries where to, one after another, to bring that about.
    """

    start: Scene
    contacts: tuple[tuple[int, int], ...]
    goals: tuple[Goal, ...]
    places: dict[int, Place]
    deeds: tuple[Deed, ...]

    def is_met(self, end: Outcome) -> bool:
        """Say by geometry whether all that was asked for is so after an interaction."""
        stands = all(relation(end, one.target, one.reference) == one.word for one in self.goals)
        return stands and all(
            math.dist(end.end.positions[target][:2], (place.x, place.y)) <= TOLERANCE
            for target, place in self.places.items()
        )


AnyAsked = TypeVar("AnyAsked", bound=Asked)
Draw = Callable[[World, int], Asked]
"""Draws the task of a seed."""


def tower(world: World, seed: int, *, height: int, objects: int = OBJECTS, at_place: bool = False) -> Asked:
    """Draw solid objects that shall stand on one another, the widest below, and perhaps at a place."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked | None:
        chain = _solids(scene, rng, height, graspable=height if at_place else height - 1)
        if chain is None:
            return None
        goals = tuple(Goal(upper, lower, "on") for lower, upper in pairwise(chain))
        place = _free_place(scene, chain[0], rng) if at_place else None
        if at_place and place is None:
            return None
        places = {chain[0]: place} if place else {}
        return _if_solved(Asked(scene, (), goals, places, (*places.items(), *_one_by_one(goals))), world)

    return drawn(attempt, objects, [height, int(at_place)], seed)


def boxes(world: World, seed: int, *, count: int = 3) -> Asked:
    """Draw objects that shall each come into a box or a ring of its own."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked | None:
        goals = _matched(scene, rng.permutation(len(scene)).tolist(), "in", count)
        if goals is None:
            return None
        return _if_solved(Asked(scene, (), goals, {}, _one_by_one(goals)), world)

    return drawn(attempt, 2 * count, [9, count], seed)


def unstack(world: World, seed: int, *, height: int = 3) -> Asked:
    """Draw a stack whose upper objects shall each come on or into another object."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked | None:
        chain = _solids(scene, rng, height, graspable=height - 1)
        if chain is None:
            return None
        built = _done(scene, [(upper, OtherObject(lower)) for lower, upper in pairwise(chain)], world)
        if built is None or any(relation(built, upper, lower) != "on" for lower, upper in pairwise(chain)):
            return None
        upper, others = chain[:0:-1], [n for n in rng.permutation(len(scene)).tolist() if n not in chain]
        goals = _matched(scene, upper, None, height - 1, others)
        if goals is None:
            return None
        return _if_solved(Asked(built.end, built.contacts, goals, {}, _one_by_one(goals)), world)

    return drawn(attempt, OBJECTS, [10, height], seed)


def swap(world: World, seed: int) -> Asked:
    """Draw two objects, each on another, that shall change places."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked | None:
        chain = _solids(scene, rng, 4, graspable=2)
        if chain is None:
            return None
        here, there, one, other = chain
        built = _done(scene, [(one, OtherObject(here)), (other, OtherObject(there))], world)
        if built is None or {relation(built, one, here), relation(built, other, there)} != {"on"}:
            return None
        place = _free_place(built.end, one, rng)
        if place is None:
            return None
        goals = Goal(other, here, "on"), Goal(one, there, "on")
        deeds = ((one, place), *_one_by_one(goals))
        return _if_solved(Asked(built.end, built.contacts, goals, {}, deeds), world)

    return drawn(attempt, OBJECTS, [11], seed)


Cell = tuple[str, Draw, int]
"""What a cell of the table is called, what draws its tasks, and how many there are for each seed."""


def cells(count: int) -> tuple[Cell, ...]:
    """List what is tried."""
    return (
        ("tower of 3", partial(tower, height=3), count),
        ("tower of 4", partial(tower, height=4), count),
        ("three into three", boxes, count),
        ("unstack and sort", unstack, count),
        ("swap", swap, count),
        ("tower of 3 at a place", partial(tower, height=3, at_place=True), count),
        ("tower of 3 among 8", partial(tower, height=3, objects=8), count),
    )


def drawn(
    attempt: Callable[[Scene, np.random.Generator], AnyAsked | None], objects: int, kind: list[int], seed: int
) -> AnyAsked:
    """Draw scenes until one makes a task.

    Raises:
        RuntimeError: If none of many scenes makes one.
    """
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, *kind, objects, seed, draw])
        asked = attempt(sample_scene(TabletopConfig(), rng, objects), rng)
        if asked is not None:
            return asked
    raise RuntimeError(f"none of {_DRAWS} draws can be done by hand")


def _solids(scene: Scene, rng: np.random.Generator, count: int, graspable: int) -> list[int] | None:
    """Choose solid objects of a scene, the widest first; so many of the last can be grasped."""
    solid = [n for n in rng.permutation(len(scene)).tolist() if scene.features[n][3] < (SOLID + OPEN_TOP) / 2]
    chosen = sorted(solid[:count], key=lambda n: -float(scene.features[n][:2].prod()))
    held = chosen[count - graspable :]
    is_enough = len(chosen) == count and all(carry_to(scene.features[n]) is not None for n in held)
    return chosen if is_enough else None


def _matched(
    scene: Scene, targets: Sequence[int], word: Relation | None, count: int, others: Sequence[int] = ()
) -> tuple[Goal, ...] | None:
    """Give so many of the targets a reference each, the first that will do; None if there are too few."""
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
    return tuple(goals[:count]) if len(goals) >= count else None


def _word(scene: Scene, target: int, other: int) -> Relation | None:
    """Say how an object ends that a person sets down over another; None if that is hard to tell."""
    if scene.features[other][3] < (SOLID + OPEN_TOP) / 2:
        return "on"
    return "in" if fits(scene.features[target], scene.features[other]) else None


def _one_by_one(goals: Sequence[Goal]) -> tuple[Deed, ...]:
    return tuple((goal.target, OtherObject(goal.reference)) for goal in goals)


def _free_place(scene: Scene, target: int, rng: np.random.Generator) -> Place | None:
    """Draw a place with room for an object, far from where it is; None if none is found."""
    sizes, table = scene.features[:, :2], TabletopConfig().table
    others = np.arange(len(scene)) != target
    room = (sizes + sizes[target])[others] / 2 + _APART
    for _ in range(50):
        place = random_place(rng, table, MARGIN)
        away = np.abs(scene.positions[:, :2] - (place.x, place.y))
        is_free = bool(np.all(np.any(away[others] > room, axis=1)))
        if is_free and float(np.linalg.norm(away[target])) >= FAR:
            return place
    return None


def _if_solved(asked: Asked, world: World) -> Asked | None:
    """Return a task if its deeds, done by hand, bring about what is asked for."""
    end = _done(asked.start, asked.deeds, world)
    return asked if end is not None and asked.is_met(end) else None


def _done(scene: Scene, deeds: Sequence[Deed], world: World) -> Outcome | None:
    """Carry objects by hand, one after another; None if one of them is not carried."""
    outcome = None
    for target, reference in deeds:
        action = carry_to(scene.features[target])
        assert action is not None, "only what can be grasped is to be carried"
        outcome = world.interact(scene, action, target, **relative_to(world, reference))
        if outcome.kind != "carried" or outcome.disturbed:
            return None
        scene = outcome.end
    return outcome


def slug(name: str) -> str:
    """Return what files of a cell are called."""
    return name.replace(" ", "-")
