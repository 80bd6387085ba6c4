"""Worlds in which every action is aimed at a place: scenes are drawn with one, actions are relative to it.

What explores, auditions and rehearses without knowing of references does so here with one.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from neurosym.checks import Float
from neurosym.contract import made
from neurosym.operators import Categorise, OperatorTable, Symbol, symbols_of
from neurosym.pair_operators import tilt
from neurosym.tasks.promises import LAST_WAYPOINT
from neurosym.world import (
    ActionBox,
    OtherObject,
    Outcome,
    Place,
    Scene,
    Table,
    World,
    WorldFactory,
    relative_to,
)

PLACE_AXES = 4
"""Axes of the effect of an action that is aimed at a place: where the target ends relative to the place, and
1, if it is carried there; else zeros."""


@dataclass(frozen=True, slots=True, eq=False)
class AimedScene(Scene):
    """A scene, and what actions in it are aimed at."""

    reference: Place  # what they are aimed at


class Adapted:
    """A world made of another: what it does not do in its own way, that one does."""

    def __init__(self, world: World):
        self._world = world
        self.name, self.feature_names, self.action_box = world.name, world.feature_names, world.action_box
        self.table, self.lift_height = world.table, world.lift_height

    def __getattr__(self, name: str) -> Any:
        """Give what else the world has, like its limits of objects."""
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._world, name)


class Aimed(Adapted):
    """A world in which every action is aimed at a place, so far inside the edge of the table [m]."""

    effect_axes = PLACE_AXES

    def __init__(self, world: World, margin: float = 0.0):
        super().__init__(world)
        self._margin = margin

    def sample_scene(self, rng: np.random.Generator, objects: int) -> AimedScene:
        """Draw a scene, and then a place anywhere on the table, where an object may stand."""
        scene, table, margin = self._world.sample_scene(rng, objects), self._world.table, self._margin
        x, y = (float(rng.uniform(low + margin, high - margin)) for low, high in (table.x, table.y))
        return AimedScene(reference=Place(x, y), **_columns(scene))

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform an action that is aimed at what the scene says; see `World.interact`."""
        aim = relative_to(self._world, scene.reference) if isinstance(scene, AimedScene) else {}
        return self._world.interact(scene, action, target, **options, **aim)


@dataclass(frozen=True, slots=True)
class AimedFactory:
    """Makes worlds in which every action is aimed at a place."""

    plain: WorldFactory  # makes the world that they are made of
    margin: float = 0.0  # how far inside the edge of the table places lie [m]

    def __call__(self) -> World:
        """Make a world."""
        return Aimed(made(self.plain), self.margin)


# Worlds in which every action is aimed at another object: what is acted upon is a pair of objects.
#
# What explores, auditions and rehearses one object at a time does so here with pairs: a scene shows it one
# thing, which has the features of the target and then those of the reference. Some scenes are fresh, others
# begin as earlier interactions ended, so that towers grow by play.

TARGET, REFERENCE = 0, 1
"""Which objects of a scene the pair is made of; the others are bystanders."""
PAIR_AXES = 6
"""Axes of the effect of an action that is aimed at another object: where the target ends relative to it along
x, y and z [touching units], whether they touch, how far it is tilted, and 1, if it was carried there; else
zeros."""
_COLUMNS = ("features", "positions", "orientations", "unseen")
OBJECTS = (2, 4)
"""How many objects a scene has, at least and at most."""
WIDEST_BELOW = 0.5
"""Share of the fresh scenes in which the smallest object is the target and the largest the reference, seen
from above: by chance few things fit on or into others."""
FROM_ARCHIVE = 1 / 3
"""Share of the scenes that begin as an earlier interaction ended, once there is one."""
ARCHIVED = 500
"""How many of these ends are kept, the last ones."""
STEADY = 0.02
"""An object that is tilted further leans, and may fall when its scene is built anew [rad]."""

Propose = Callable[[np.random.Generator, Float[np.ndarray, "F"], int], Float[np.ndarray, "_ A"]]
"""Draws actions that do something to a target of these features, at most so many."""
Aiming = Callable[[Float[np.ndarray, "A"], Float[np.ndarray, "F"]], Float[np.ndarray, "A"]]
"""Gives an action as it is performed with a target of these features."""


@dataclass(frozen=True, slots=True, eq=False)
class RelatedScene(Scene):
    """A pair of objects, shown as one thing."""

    whole: Scene  # all objects: the target, the reference, and bystanders


class Related(Adapted):
    """A world in which every action is aimed at another object.

    What draws actions that do something to the target alone is tried with a reference, too. What is known to
    carry to places may be aimed such that the target ends over the middle of the reference.
    """

    effect_axes = PAIR_AXES
    scenes_to_choose_from = 4

    def __init__(self, world: World, propose: Propose | None = None, aim: Aiming | None = None):
        super().__init__(world)
        self._aim = aim
        self.feature_names = tuple(
            f"{which} {name}" for which in ("target", "reference") for name in world.feature_names
        )
        self._propose = propose
        self.archive: list[Scene] = []

    def sample_scene(self, rng: np.random.Generator, objects: int) -> RelatedScene:
        """Draw a scene with one pair of objects, and none to two bystanders."""
        del objects  # of which it shows one
        if self.archive and rng.random() < FROM_ARCHIVE:
            scene = self.archive[rng.integers(len(self.archive))]
            order = rng.permutation(len(scene))
        else:
            scene = self._world.sample_scene(rng, int(rng.integers(OBJECTS[0], OBJECTS[1] + 1)))
            order = np.arange(len(scene))
            if rng.random() < WIDEST_BELOW:
                smallest, *between, largest = np.argsort(scene.features[:, :2].prod(1))
                order = np.array([smallest, largest, *between])
        return as_pair(taken(scene, order))

    def draw_actions(self, rng: np.random.Generator, scene: Scene, count: int) -> Float[np.ndarray, "_ A"]:
        """Draw so many actions to choose from: half of them are known to do something to the target."""
        drawn = self.action_box.sample(rng, count)
        if self._propose is not None:
            known = self._propose(rng, scene.features[0, : len(self._world.feature_names)], count // 2)
            drawn[: len(known)] = known
        return drawn[rng.permutation(count)]

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform an action that is aimed at the reference of a pair; see `World.interact`."""
        if not isinstance(scene, RelatedScene):
            return self._world.interact(scene, action, target, **options)
        if self._aim is not None:
            action = self._aim(action, scene.whole.features[TARGET])
        aim = relative_to(self._world, OtherObject(REFERENCE))
        return self._world.interact(scene.whole, action, TARGET, **options, **aim)

    def remember(self, outcomes: Sequence[Outcome]) -> None:
        """Archive ends of interactions in which objects touch, in order, to begin others from.

        Scenes in which an object was lost, or leans, are left out.
        """
        table = self._world.table
        for outcome in outcomes:
            end = outcome.end
            steady = all(table.contains(end.positions[n]) and tilt(end, n) <= STEADY for n in range(len(end)))
            if outcome.contacts and steady:
                self.archive.append(end)
        del self.archive[:-ARCHIVED]

    def memory(self) -> dict[str, np.ndarray]:
        """Return the archive as arrays, one scene after the other."""
        if not self.archive:
            return {}
        rows = joined(self.archive)
        objects = np.array([len(scene) for scene in self.archive])
        return {**{name: getattr(rows, name) for name in _COLUMNS}, "objects": objects}

    def recall(self, memory: Mapping[str, np.ndarray]) -> None:
        """Take back an archive that `memory` returned; raise `ValueError` if it is damaged."""
        if not memory:
            return
        ends = np.cumsum(memory["objects"])[:-1]
        columns = {name: np.split(memory[name], ends) for name in _COLUMNS if name in memory}
        rows = zip(*columns.values(), strict=True)
        self.archive = [Scene(**dict(zip(columns, row, strict=True))) for row in rows]


@dataclass(frozen=True, slots=True)
class RelatedFactory:
    """Makes worlds in which every action is aimed at another object; see `Related`."""

    plain: WorldFactory
    propose: Propose | None = None
    aim: Aiming | None = None

    def __call__(self) -> World:
        """Make a world."""
        return Related(made(self.plain), self.propose, self.aim)


def as_pair(whole: Scene) -> RelatedScene:
    """Show the first two objects of a scene as one thing.

    Args:
        whole: The target, the reference, and bystanders.
    """
    features = np.concatenate([whole.features[TARGET], whole.features[REFERENCE]])[None]
    return RelatedScene(features, whole.positions[:1], whole.orientations[:1], whole)


def taken(scene: Scene, order: Sequence[int] | np.ndarray) -> Scene:
    """Return the objects of a scene in another order.

    Args:
        scene: The objects.
        order: Which come first.
    """
    return Scene(**{name: column[np.array(order, dtype=int)] for name, column in _columns(scene).items()})


# Worlds in which other objects stand close around each that an action is tried on.
#
# What drags an object along, or comes down with the hand wide open, does well alone and not among others.

GAPS = (0.015, 0.05)
"""How far from an object its neighbours stand at least and at most [m]."""
ROOM = 0.06
"""How far from an object at the place its neighbours stand at least [m]."""
_APART = 0.01  # how far neighbours stand from each other at least [m]
_SIDES = ((0, -1), (0, 1), (1, -1), (1, 1))


@dataclass(frozen=True, slots=True, eq=False)
class CrowdedScene(AimedScene):
    """A scene of one object, and what stands around it."""

    neighbours: Scene  # they come after the object itself in the scenes of outcomes


class Crowded(Aimed):
    """A world in which every action is aimed at a place, and every target has neighbours."""

    def sample_scene(self, rng: np.random.Generator, objects: int) -> AimedScene:
        """Draw a scene of one object, and then what stands around it; see `Aimed.sample_scene`."""
        scene = super().sample_scene(rng, objects)
        drawn = (super(Crowded, self).sample_scene(rng, 1) for _ in _SIDES)
        around = _around(scene, [*drawn], self._world.table, rng)
        return CrowdedScene(reference=scene.reference, neighbours=around, **_columns(scene))

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform an action among neighbours; see `Aimed.interact`."""
        if isinstance(scene, CrowdedScene):
            around = joined([scene, scene.neighbours])
            scene = AimedScene(reference=scene.reference, **_columns(around))
        return super().interact(scene, action, target, **options)


@dataclass(frozen=True, slots=True)
class CrowdedFactory(AimedFactory):
    """Makes worlds in which every action is aimed at a place, and every target has neighbours."""

    def __call__(self) -> World:
        """Make a world."""
        return Crowded(made(self.plain), self.margin)


def _around(scene: AimedScene, others: list[AimedScene], table: Table, rng: np.random.Generator) -> Scene:
    """Put objects on the sides of another, one on each: those that fit, none where it is to be carried."""
    half, centre = scene.features[0, :2] / 2, scene.positions[0, :2]
    boxes = [(scene.reference.centre[:2], half, ROOM)]
    kept = [taken(scene, [])]
    for (axis, sign), other in zip(_SIDES, others, strict=True):
        size = other.features[0, :2] / 2
        reach = half + size
        away = rng.uniform(-reach / 2, reach / 2)
        away[axis] = sign * (reach[axis] + rng.uniform(*GAPS))
        position = np.array([*(centre + away), other.positions[0, 2]])
        is_free = all(np.any(np.abs(position[:2] - at) > size + wide + gap) for at, wide, gap in boxes)
        if table.contains(position) and is_free:
            boxes.append((position[:2], size, _APART))
            kept.append(replace(taken(other, [0]), positions=position[None]))
    return joined(kept)


def joined(scenes: Sequence[Scene]) -> Scene:
    """Return the objects of several scenes in one.

    Args:
        scenes: The scenes, at least one.
    """
    columns = [*map(_columns, scenes)]
    return Scene(**{name: np.concatenate([one[name] for one in columns]) for name in _COLUMNS})


def _columns(scene: Scene) -> dict[str, np.ndarray]:
    return {name: getattr(scene, name) for name in _COLUMNS}


# Motions that are known to carry an object to a place, to be tried with other objects as references.
#
# They are a start for exploring what can be done with pairs: how to grasp need not be found out once more.
# A place is a reference without size, so that what ends there ends on or in an object instead.

JITTER = 0.003
"""Standard deviation by which their lengths are changed [m]."""
TO_THE_MIDDLE = 0.5
"""Share of the motions that end where the reference is; the others end at random."""


@dataclass(frozen=True)
class KnownMotions:
    """Draws motions that carry objects of a target's category, to the reference or with a random end."""

    places: OperatorTable  # what carries objects to places
    categorise: Categorise  # gives the object symbols of features
    box: ActionBox  # what actions must stay inside

    @cached_property
    def _of_category(self) -> dict[Symbol, Float[np.ndarray, "P A"]]:
        found = dict[Symbol, list[Float[np.ndarray, "A"]]]()
        actions = {one.label: one.action for one in self.places.primitives}
        for one in self.places.operators:
            if one.promise and one.promise.kind == "carried" and 2 * one.successes > one.trials:
                to_the_middle = np.array(actions[one.label])
                to_the_middle[-LAST_WAYPOINT:][:2] -= one.promise.resting_effect[:2]
                found.setdefault(one.subject, []).append(to_the_middle)
        return {category: np.array(rows) for category, rows in found.items()}

    def __call__(
        self, rng: np.random.Generator, features: Float[np.ndarray, "F"], count: int
    ) -> Float[np.ndarray, "_ A"]:
        """Draw motions; none if nothing is known to carry such an object.

        Args:
            rng: Source of randomness, owned by the caller.
            features: Features of the target.
            count: How many.
        """
        (category,) = symbols_of(self.categorise, features[None])
        known = self._of_category.get(category)
        drawn = self.box.sample(rng, count)
        if known is None:
            return drawn[:0]
        motions = known[rng.integers(len(known), size=count)]
        motions += rng.normal(0.0, JITTER, motions.shape) * ~self.box.gripper
        elsewhere = rng.random(count) >= TO_THE_MIDDLE
        motions[elsewhere, -LAST_WAYPOINT:] = drawn[elsewhere, -LAST_WAYPOINT:]
        inside: np.ndarray = np.clip(motions, self.box.low, self.box.high)
        return inside
