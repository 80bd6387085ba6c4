"""Worlds in which every action is aimed at a place: scenes are drawn with one, actions are relative to it.

What explores, auditions and rehearses without knowing of references does so here with one.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.actions import ActionBox
from neurosym.arrays import Float
from neurosym.guarded import made
from neurosym.table import Place, Table
from neurosym.world import Outcome, Scene, World, WorldFactory, relative_to

PLACE_AXES = 4
"""Axes of the effect of an action that is aimed at a place: where the target ends relative to the place, and
1, if it is carried there; else zeros."""


@dataclass(frozen=True, slots=True, eq=False)
class AimedScene(Scene):
    """A scene, and what actions in it are aimed at.

    Attributes:
        reference: What they are aimed at.
    """

    reference: Place


class Adapted:
    """A world made of another: what it does not do in its own way, that one does.

    Args:
        world: That world.
    """

    def __init__(self, world: World):
        self._world = world

    def __getattr__(self, name: str) -> Any:
        """Give what else the world has, like its limits of objects."""
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._world, name)

    @property
    def name(self) -> str:
        """Name of the world that it is made of."""
        return self._world.name

    @property
    def feature_names(self) -> tuple[str, ...]:
        """Names of the object features."""
        return self._world.feature_names

    @property
    def action_box(self) -> ActionBox:
        """The box of the action parameters."""
        return self._world.action_box

    @property
    def table(self) -> Table:
        """Where objects may stand."""
        return self._world.table

    @property
    def lift_height(self) -> float:
        """How far the hand rises after the last waypoint [m]."""
        return self._world.lift_height


class Aimed(Adapted):
    """A world in which every action is aimed at a place; else it is the world that it is made of.

    Args:
        world: That world, which takes places.
        margin: How far inside the edge of the table places lie [m].
    """

    effect_axes = PLACE_AXES

    def __init__(self, world: World, margin: float = 0.0):
        super().__init__(world)
        self._margin = margin

    def sample_scene(self, rng: np.random.Generator, objects: int) -> AimedScene:
        """Draw a scene, and then a place anywhere on the table, where an object may stand.

        Args:
            rng: Source of randomness, owned by the caller.
            objects: How many objects.

        Raises:
            InvalidValue: If so many objects do not fit on the table.
        """
        scene, table, margin = self._world.sample_scene(rng, objects), self._world.table, self._margin
        x, y = (float(rng.uniform(low + margin, high - margin)) for low, high in (table.x, table.y))
        return AimedScene(scene.features, scene.positions, scene.orientations, Place(x, y))

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform an action that is aimed at what the scene says; see `World.interact`."""
        aim = relative_to(self._world, scene.reference) if isinstance(scene, AimedScene) else {}
        return self._world.interact(scene, action, target, **options, **aim)


@dataclass(frozen=True, slots=True)
class AdaptedFactory(ABC):
    """Makes worlds that are made of others.

    Attributes:
        plain: Makes the world that they are made of.
    """

    plain: WorldFactory

    def world(self) -> World:
        """Make the world that they are made of."""
        return made(self.plain)

    @abstractmethod
    def __call__(self) -> World:
        """Make a world."""


@dataclass(frozen=True, slots=True)
class AimedFactory(AdaptedFactory):
    """Makes worlds in which every action is aimed at a place, so far inside the edge of the table [m]."""

    margin: float = 0.0

    def __call__(self) -> World:
        """Make a world."""
        return Aimed(made(self.plain), self.margin)
