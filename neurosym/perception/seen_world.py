"""Worlds whose objects are known by what an eye tells of their crops, over worlds that are blind."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from neurosym.checks import Float
from neurosym.contract import SETTABLE
from neurosym.errors import InvalidValue, quoted
from neurosym.perception.eye import NUMBERS, Eye
from neurosym.world import Frame, Outcome, Reference, Scene, World, WorldFactory, check_action, references_of

TOLD = tuple(f"v{number}" for number in range(1, NUMBERS + 1))
"""What the numbers are called in which an eye tells an object."""
_DRAWS = 50  # of scenes, until all objects are told apart


class Shown(Protocol):
    """What is seen of an object."""

    @property
    def crop(self) -> Float[np.ndarray, "cells cells"]:
        """Its heights, from straight above [m]."""


class SeenWorld(ABC):
    """A world whose objects are known by what is seen of them.

    Attributes:
        table_world: The world beneath, which does what is done.
        blind: Makes the same in another process.
        unshown: Features that networks are not shown.
    """

    table_world: World
    blind: WorldFactory
    feature_names: tuple[str, ...]
    unshown: tuple[str, ...]

    def __init__(self, table_world: World, blind: WorldFactory, eye: Path | None):
        self.table_world, self.blind, self._eye_file = table_world, blind, eye
        self.name, self.references = table_world.name, references_of(table_world)
        self.action_box, self.table = table_world.action_box, table_world.table
        self.lift_height = table_world.lift_height
        for name in self._settable:
            setattr(self, name, None)
        if hasattr(table_world, "picture"):
            self.picture = self._picture
        if hasattr(table_world, "open_window"):
            self.open_window = table_world.open_window

    @property
    def _settable(self) -> list[str]:
        return [name for name in (*SETTABLE, "on_pose") if hasattr(self.table_world, name)]

    @abstractmethod
    def look(self, scene: Scene) -> Sequence[Any]:
        """Return what is `Shown` of the objects of a scene of the world beneath."""

    @abstractmethod
    def told(self, scene: Scene, found: Sequence[Any]) -> Scene | None:
        """Return a scene of the world beneath as it is seen; None if objects are not told apart."""

    @abstractmethod
    def beneath(self, scene: Scene) -> Scene:
        """Return a scene as the world beneath takes it."""

    @abstractmethod
    def witnessed(self, scene: Scene, done: Outcome, *, is_at_rest: bool = True) -> Outcome:
        """Return an outcome of the world beneath as it is seen, where it began with a scene that was seen."""

    @cached_property
    def eye(self) -> Eye:
        """What tells crops in numbers."""
        if self._eye_file is None or not self._eye_file.is_file():
            folder = quoted(self._eye_file.parent) if self._eye_file else "DIR"
            raise InvalidValue(f"This world has not learned to see yet; `neurosym see {folder}` teaches it.")
        return Eye.load(self._eye_file)

    def seen(self, scene: Scene) -> Scene | None:
        """Return a scene of the world beneath as it is seen; None if objects are not told apart."""
        return self.told(scene, self.look(scene))

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw objects at rest, all of which are told apart (see `World.sample_scene`)."""
        for _ in range(_DRAWS):
            if (seen := self.seen(self.table_world.sample_scene(rng, objects))) is not None:
                return seen
        raise InvalidValue(f"{objects} objects cannot be told apart on the table; ask for fewer.")

    def interact(
        self,
        scene: Scene,
        action: Float[np.ndarray, "A"],
        target: int,
        *,
        put_down: bool = True,
        reference: Reference | None = None,
        **pictures: Any,
    ) -> Outcome:
        """Perform one action, and look again (see `World.interact`)."""
        check_action(self, scene, action, target, reference)
        how = {"put_down": put_down, **({"reference": reference} if self.references else {}), **pictures}
        with self._like_mine(scene) as world:
            done = world.interact(self.beneath(scene), action, target, **how)
        return self.witnessed(scene, done, is_at_rest=put_down or not done.held)

    def _picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        with self._like_mine(scene) as world:
            frame: Frame = world.picture(self.beneath(scene), ghosts)
        return frame

    @contextmanager
    def _like_mine(self, scene: Scene) -> Iterator[Any]:
        """Give the world beneath for a while what was set here; colours are by what is seen."""
        mine = {name: getattr(self, name) for name in self._settable}
        if painter := mine.get("painter"):
            mine["painter"] = lambda _: painter(scene.features)
        for name, value in mine.items():
            setattr(self.table_world, name, value)
        try:
            yield self.table_world
        finally:
            for name in mine:
                setattr(self.table_world, name, None)

    def __getattr__(self, name: str) -> Any:
        """Give what else the world beneath has."""
        if name.startswith("_") or name in ("object_limits", "table_world"):
            raise AttributeError(name)
        return getattr(self.table_world, name)
