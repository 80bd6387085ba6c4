"""Worlds of somebody's own in processes of their own, so that nothing they do ends ours.

A world may raise, call `sys.exit` or `os._exit`, be killed, or never answer: in each case the command says in
one sentence what it did, keeps what was finished, and goes on when it is called again.
"""

import signal
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidWorld
from neurosym.factories import search_here
from neurosym.table import Reference, ReferenceKind
from neurosym.world import Frame, FrameSink, Outcome, Scene, World
from neurosym.worlds import host
from neurosym.worlds.children import Child, ChildEnded, Unreadable
from neurosym.worlds.custom import describe_own_world


class _Process:
    """A process that calls functions for a world that is made there, so that ours can tell what they do."""

    def __init__(self, name: str):
        self._name, self.patience = name, host.PATIENCE
        self.child = Child(host.__name__)
        self._lock = threading.Lock()

    def call(
        self, what: str, function: Callable[..., Any], *arguments: Any, on_frame: FrameSink | None = None
    ) -> Any:
        """Have a function called, of which messages speak as `what`, and return what it returns."""
        hear = (lambda word: on_frame(*word)) if on_frame else None
        try:
            with self._lock:
                self.child.ask(host.told_by, self._name, function, arguments)
                return self.child.answer(self.patience, hear)
        except ChildEnded as error:
            self.child.close(grace=0.0)
            raise InvalidWorld(self._name, f"{_how(error.code)} in {what}") from error
        except TimeoutError as error:
            problem = f"has not come back from {what} for {self.patience:g} s"
            raise InvalidWorld(self._name, problem) from error
        except Unreadable as error:
            raise InvalidWorld(self._name, f"gives what no other process can read from {what}") from error


def _how(code: int) -> str:
    """Say how a process of a world ended."""
    if code >= 0:
        return f"ends its process with exit code {code}"
    because = " (by somebody, or for want of memory)" if -code == signal.SIGKILL else ""
    return f"has its process killed by {signal.Signals(-code).name}{because}"


class Hosted:
    """A world that lives in another process.

    Args:
        process: The process.
        about: What `host.make` says of it.
    """

    def __init__(self, process: _Process, about: dict[str, Any]):
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
            self.open_window = lambda: self._call("open_window")
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
        options = {"put_down": put_down, "ghosts": ghosts, "reference": reference}
        outcome: Outcome = self._call("interact", scene, action, target, on_frame=on_frame, **options)
        return outcome

    def _picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        frame: Frame = self._call("picture", scene, ghosts)
        return frame

    def _call(self, method: str, *arguments: Any, on_frame: FrameSink | None = None, **options: Any) -> Any:
        given = method, arguments, options, on_frame is not None
        return self.process.call(method.strip("_"), host.call, *given, on_frame=on_frame)

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
            self._call("__setattr__", name, value)
        object.__setattr__(self, name, value)


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
        if self._world is None or not self._world.process.child.is_open:
            self._world = self.another()
        return self._world

    def another(self) -> Hosted:
        """Make one in a new process.

        Raises:
            InvalidWorld: If it cannot be made.
        """
        name, options = self.args
        search_here(self._folder)
        process = _Process(name)
        try:
            return Hosted(process, process.call("its making", host.make, name, options, self._folder))
        except BaseException:
            process.child.close(grace=0.0)
            raise

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
    process = _Process(name)
    try:
        options: dict[str, Any] = process.call("a first trial", describe_own_world, name, folder)
    finally:
        process.child.close()
    return options
