"""Worlds in which other objects stand close around each that an action is tried on.

What drags an object along, or comes down with the hand wide open, does well alone and not among others.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.arrays import Float
from neurosym.guarded import made
from neurosym.table import Table
from neurosym.world import Outcome, Scene, World
from neurosym.worlds.aimed import Aimed, AimedFactory, AimedScene

GAPS = (0.015, 0.05)
"""How far from an object its neighbours stand at least and at most [m]."""
ROOM = 0.06
"""How far from an object at the place its neighbours stand at least [m]."""
_APART = 0.01  # how far neighbours stand from each other at least [m]
_SIDES = ((0, -1), (0, 1), (1, -1), (1, 1))


@dataclass(frozen=True, slots=True, eq=False)
class CrowdedScene(AimedScene):
    """A scene of one object, and what stands around it.

    Attributes:
        neighbours: They come after the object itself in the scenes of outcomes.
    """

    neighbours: Scene


class Crowded(Aimed):
    """A world in which every action is aimed at a place, and every target has neighbours."""

    def sample_scene(self, rng: np.random.Generator, objects: int) -> AimedScene:
        """Draw a scene of one object, and then what stands around it; see `Aimed.sample_scene`."""
        scene = super().sample_scene(rng, objects)
        drawn = (super(Crowded, self).sample_scene(rng, 1) for _ in _SIDES)
        around = _around(scene, [*drawn], self._world.table, rng)
        return CrowdedScene(scene.features, scene.positions, scene.orientations, scene.reference, around)

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform an action among neighbours; see `Aimed.interact`."""
        if isinstance(scene, CrowdedScene):
            every = joined([scene, scene.neighbours])
            scene = AimedScene(every.features, every.positions, every.orientations, scene.reference)
        return super().interact(scene, action, target, **options)


@dataclass(frozen=True, slots=True)
class CrowdedFactory(AimedFactory):
    """Makes worlds in which every action is aimed at a place, and every target has neighbours."""

    def __call__(self) -> World:
        """Make a world."""
        return Crowded(made(self.plain), self.margin)


def _around(scene: AimedScene, others: list[AimedScene], table: Table, rng: np.random.Generator) -> Scene:
    """Put objects on the sides of another: those that fit, none where it is to be carried.

    Args:
        scene: The object, and where it is to be carried.
        others: One object each, one for each side.
        table: Where they may stand.
        rng: Source of randomness.
    """
    half, centre = scene.features[0, :2] / 2, scene.positions[0, :2]
    boxes = [(scene.reference.centre[:2], half, ROOM)]
    kept = list[Scene]()
    for (axis, sign), other in zip(_SIDES, others, strict=True):
        reach = half + other.features[0, :2] / 2
        away = rng.uniform(-reach / 2, reach / 2)
        away[axis] = sign * (reach[axis] + rng.uniform(*GAPS))
        position = np.array([[*(centre + away), other.positions[0, 2]]])
        is_free = all(
            np.any(np.abs(position[0, :2] - at) > other.features[0, :2] / 2 + size + gap)
            for at, size, gap in boxes
        )
        if table.contains(position[0]) and is_free:
            boxes.append((position[0, :2], other.features[0, :2] / 2, _APART))
            kept.append(Scene(other.features, position, other.orientations))
    return joined([Scene(scene.features[:0], scene.positions[:0], scene.orientations[:0]), *kept])


def joined(scenes: Sequence[Scene]) -> Scene:
    """Return the objects of several scenes in one.

    Args:
        scenes: The scenes, at least one.
    """
    parts = ("features", "positions", "orientations")
    return Scene(*(np.concatenate([getattr(scene, part) for scene in scenes]) for part in parts))
