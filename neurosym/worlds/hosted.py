"""Worlds of somebody's own in processes of their own, so that nothing they do ends ours.

A world may raise, call `sys.exit` or `os._exit`, be killed, or never answer: in each case the command says in
one sentence what it did, keeps what was finished, and goes on when it is called again.
"""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.arrays import Float
from neurosym.factories import search_here
from neurosym.table import Reference, ReferenceKind
from neurosym.world import Frame, FrameSink, Outcome, Scene, World
from neurosym.worlds import host
from neurosym.worlds.apart import Process
from neurosym.worlds.children import at_hand
from neurosym.worlds.custom import describe_own_world, make_own_world


class Hosted:
    """A world that lives in another process.

    Args:
        process: The process.
        about: What `host.make` says of it.
    """

    def __init__(self, process: Process, about: dict[str, Any]):
        self.process = process
        self.name: str = about["name"]
        self.feature_names: tuple[str, ...] = about["feature_names"]
        self.action_box, self.table = about["action_box"], about["table"]
        self.lift_height: float = about["lift_height"]
        self.references: tuple[ReferenceKind, ...] = about["references"]
        process.patience = about["patience"]
        if "picture" in about["optional"]:
            self.picture = self._picture
        if "open_window" in about["optional"]:
            self.open_window = lambda: process.call("open_window", host.call, "open_window")
        if about["is_sparing"]:
            self.wanted_pictures = None

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene; see `World.sample_scene`."""
        scene, rng.bit_generator.state = self.process.call("sample_scene", host.sample_scene, rng, objects)
        return scene  # type: ignore[no-any-return]

    def interact(
        self,
        scene: Scene,
        action: Float[np.ndarray, "A"],
        target: int,
        *,
        put_down: bool = True,
        on_frame: FrameSink | None = None,
        ghosts: Float[np.ndarray, "M 3"] | None = None,
        reference: Reference | None = None,
    ) -> Outcome:
        """Perform an interaction; see `World.interact`."""
        arguments = scene, action, target, put_down, on_frame is not None, ghosts, reference
        outcome: Outcome = self.process.call("interact", host.interact, *arguments, on_frame=on_frame)
        return outcome

    def __getattr__(self, name: str) -> Any:
        """Give what else the world has, like its `object_limits`."""
        if name.startswith("_") or name == "process":
            raise AttributeError(name)
        is_there, value = self.process.call(name, host.get, name)
        if not is_there:
            raise AttributeError(f"The world {self.name} has no attribute {name!r}.")
        return value

    def __setattr__(self, name: str, value: Any) -> None:
        if name == "wanted_pictures" and value is not self.__dict__.get(name):
            self.process.call(name, host.put, name, value)
        object.__setattr__(self, name, value)

    def _picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        frame: Frame = self.process.call("picture", host.call, "picture", scene, ghosts)
        return frame


class OwnFactory:
    """Makes a world of one's own, each in a process of its own; can be pickled.

    Within a process, those that are called for one after another are the same one: worlds have no memory.

    Args:
        name: `module:factory`.
        options: What to call it with.
        folder: The domain folder, which must not bring code of its own.
    """

    def __init__(self, name: str, options: dict[str, Any], folder: Path):
        self.args, self._folder = (name, options), folder.resolve()
        self._world: Hosted | None = None

    def __call__(self) -> World:
        """Return the world, made if there is none yet, or its process has ended."""
        if self._world is None or not self._world.process.is_open:
            self._world = self.another()
        return self._world

    def another(self) -> Hosted:
        """Make one in a new process.

        Raises:
            InvalidWorld: If it cannot be made.
        """
        name, options = self.args
        search_here(self._folder)
        process = Process(name)
        try:
            return Hosted(process, process.call("its making", host.make, name, options, self._folder))
        except BaseException:
            process.close(grace=0.0)
            raise

    def here(self) -> World:
        """Make one in this process, which nothing but the world needs."""
        return make_own_world(*self.args)

    def __getstate__(self) -> tuple[tuple[str, dict[str, Any]], Path]:
        return self.args, self._folder

    def __setstate__(self, state: tuple[tuple[str, dict[str, Any]], Path]) -> None:
        (self.args, self._folder), self._world = state, None


def describe_apart(name: str, folder: Path) -> dict[str, Any]:
    """Do in a process of its own what `describe_own_world` does.

    Args:
        name: `module:factory`.
        folder: The domain folder that it is for.

    Raises:
        InvalidWorld: If it is no world.
    """
    search_here(folder)
    process = Process(name)
    try:
        options: dict[str, Any] = process.call("a first trial", describe_own_world, name, folder)
    finally:
        process.close()
    return options


@contextmanager
def hosts(factory: OwnFactory, count: int) -> Iterator[Callable[[Callable[[World], Any]], "Future[Any]"]]:
    """Keep worlds at hand, each in a process of its own; yields what hands work out to whichever is free.

    Args:
        factory: Makes them.
        count: How many.
    """
    made: list[Hosted] = []
    try:
        for _ in range(count):
            made.append(factory.another())
        with at_hand(made) as submit:
            try:
                yield submit
            finally:
                _kill(made)  # before the threads are waited for that wait for them
    finally:
        _kill(made)


def _kill(worlds: Sequence[Hosted]) -> None:
    for world in worlds:
        world.process.close(grace=0.0)
