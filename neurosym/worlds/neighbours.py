"""Worlds in which other objects stand close around each that an action is tried on.

What drags an object along, or comes down with the hand wide open, does well alone and not among others.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.arrays import Float
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
            scene = AimedScene(*_joined(scene, scene.neighbours), scene.reference)
        return super().interact(scene, action, target, **options)


@dataclass(frozen=True, slots=True)
class CrowdedFactory(AimedFactory):
    """Makes worlds in which every action is aimed at a place, and every target has neighbours."""

    @property
    def here(self) -> "CrowdedFactory":
        """What makes the same worlds in the process that calls it, if they are a user's own."""
        return CrowdedFactory(super(CrowdedFactory, self).here.plain, self.margin)

    def __call__(self) -> World:
        """Make a world."""
        return Crowded(self.world(), self.margin)


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
    kept, positions = list[Scene](), list[Float[np.ndarray, "1 3"]]()
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
            kept.append(other)
            positions.append(position)
    if not kept:
        return Scene(scene.features[:0], scene.positions[:0], scene.orientations[:0])
    features, orientations = ([getattr(one, of) for one in kept] for of in ("features", "orientations"))
    return Scene(np.concatenate(features), np.concatenate(positions), np.concatenate(orientations))


def _joined(one: Scene, other: Scene) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return features, positions and orientations of the objects of two scenes."""
    return (
        np.concatenate([one.features, other.features]),
        np.concatenate([one.positions, other.positions]),
        np.concatenate([one.orientations, other.orientations]),
    )
