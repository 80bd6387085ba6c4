"""Worlds of somebody's own that give images of their objects beside what else they tell of them."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidWorld
from neurosym.perception.eye import NUMBERS, as_crops
from neurosym.perception.seen_world import TOLD, SeenWorld
from neurosym.world import Outcome, Scene
from neurosym.worlds.own_world import OwnFactory


class Picture(NamedTuple):
    """What an object looks like."""

    crop: Float[np.ndarray, "cells cells"]  # [m]


class ImageWorld(SeenWorld):
    """A world with a method `images`: an eye tells these in numbers, which are features beside its own.

    Networks are shown these numbers alone.

    Args:
        blind: Makes the world.
        eye: File with the eye.
    """

    def __init__(self, blind: OwnFactory, eye: Path):
        super().__init__(blind(), blind, eye)
        self.unshown = tuple(self.table_world.feature_names)
        if taken := sorted({*self.unshown} & {*TOLD}):
            raise InvalidWorld(
                self.name, f"has a feature {taken[0]}, as what an eye tells is called; rename it"
            )
        self.feature_names = (*self.unshown, *TOLD)

    def look(self, scene: Scene) -> list[Picture]:
        """Return what the objects of a scene look like, which the world gives."""
        world: Any = self.table_world
        return [*map(Picture, as_crops(world.images(scene)))]

    def told(self, scene: Scene, found: Sequence[Picture]) -> Scene:
        """Add what the eye tells of the objects of a scene."""
        told = np.array([self.eye.tell(one.crop) for one in found])
        return replace(scene, features=np.hstack([scene.features, told]))

    def beneath(self, scene: Scene) -> Scene:
        """Leave out what the eye tells of the objects of a scene."""
        return replace(scene, features=scene.features[:, :-NUMBERS])

    def witnessed(self, scene: Scene, done: Outcome, **_: Any) -> Outcome:
        """Say of an outcome what objects looked like when it began."""
        start, lifted, end = (
            replace(one, features=scene.features) for one in (done.start, done.lifted, done.end)
        )
        return replace(done, start=start, lifted=lifted, end=end)
