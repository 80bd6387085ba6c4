"""Worlds in which every action is aimed at another object: what is acted upon is a pair of objects.

What explores, auditions and rehearses one object at a time does so here with pairs: a scene shows it one
thing, which has the features of the target and then those of the reference. Some scenes are fresh, others
begin as earlier interactions ended, so that towers grow by play.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.arrays import Float
from neurosym.guarded import made
from neurosym.pair_states import tilt
from neurosym.table import OtherObject
from neurosym.world import Outcome, Scene, World, relative_to
from neurosym.worlds.aimed import Adapted, AdaptedFactory

TARGET, REFERENCE = 0, 1
"""Which objects of a scene the pair is made of; the others are bystanders."""
PAIR_AXES = 6
"""Axes of the effect of an action that is aimed at another object: where the target ends relative to it along
x, y and z [touching units], whether they touch, how far it is tilted, and 1, if it was carried there; else
zeros."""
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


@dataclass(frozen=True, slots=True, eq=False)
class RelatedScene(Scene):
    """A pair of objects, shown as one thing.

    Attributes:
        whole: All objects: the target, the reference, and bystanders.
    """

    whole: Scene


class Related(Adapted):
    """A world in which every action is aimed at another object.

    Args:
        world: The world that it is made of, which takes objects as references.
        propose: Draws actions that do something to the target alone, to try them with a reference.
    """

    effect_axes = PAIR_AXES
    scenes_to_choose_from = 4

    def __init__(self, world: World, propose: Propose | None = None):
        super().__init__(world)
        self._propose = propose
        self.archive: list[Scene] = []

    @property
    def feature_names(self) -> tuple[str, ...]:
        """Names of the features of the target, and then of the reference."""
        names = self._world.feature_names
        return (*(f"target {name}" for name in names), *(f"reference {name}" for name in names))

    def sample_scene(self, rng: np.random.Generator, objects: int) -> RelatedScene:
        """Draw a scene with a pair of objects, and none to two bystanders.

        Args:
            rng: Source of randomness, owned by the caller.
            objects: How many pairs: one.
        """
        del objects
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
        """Draw actions to choose from: half of them from what is known to do something to the target.

        Args:
            rng: Source of randomness, owned by the caller.
            scene: The pair.
            count: How many.
        """
        drawn = self.action_box.sample(rng, count)
        if self._propose is not None:
            features = scene.features[0, : len(self._world.feature_names)]
            known = self._propose(rng, features, count // 2)
            drawn[: len(known)] = known
        return drawn[rng.permutation(count)]

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform an action that is aimed at the reference of a pair; see `World.interact`."""
        if not isinstance(scene, RelatedScene):
            return self._world.interact(scene, action, target, **options)
        aim = relative_to(self._world, OtherObject(REFERENCE))
        return self._world.interact(scene.whole, action, TARGET, **options, **aim)

    def remember(self, outcomes: Sequence[Outcome]) -> None:
        """Archive ends of interactions in which objects touch, to begin others from.

        Scenes in which an object was lost, or leans, are left out.

        Args:
            outcomes: What happened, in order.
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
        parts = ("features", "positions", "orientations")
        rows = {name: np.concatenate([getattr(scene, name) for scene in self.archive]) for name in parts}
        return {**rows, "objects": np.array([len(scene) for scene in self.archive])}

    def recall(self, memory: Mapping[str, np.ndarray]) -> None:
        """Take back an archive.

        Args:
            memory: What `memory` returned.

        Raises:
            ValueError: If it is damaged.
        """
        if not memory:
            return
        ends = np.cumsum(memory["objects"])[:-1]
        columns = [np.split(memory[name], ends) for name in ("features", "positions", "orientations")]
        self.archive = [Scene(*rows) for rows in zip(*columns, strict=True)]


@dataclass(frozen=True, slots=True)
class RelatedFactory(AdaptedFactory):
    """Makes worlds in which every action is aimed at another object.

    Attributes:
        propose: Draws actions that do something to the target alone.
    """

    propose: Propose | None = None

    def __call__(self) -> World:
        """Make a world."""
        return Related(made(self.plain), self.propose)


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
    rows = np.asarray(order)
    return Scene(scene.features[rows], scene.positions[rows], scene.orientations[rows])
