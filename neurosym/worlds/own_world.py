"""Worlds of somebody's own in processes of their own, so that nothing they do ends ours.

A world may raise, call `sys.exit` or `os._exit`, be killed, or never answer: in each case the command says in
one sentence what it did, keeps what was finished, and goes on when it is called again.
"""

import inspect
import json
import math
import signal
import threading
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np

from neurosym.checks import Float
from neurosym.choices import admit, load_factory, search_here, told
from neurosym.contract import OPTIONAL, Guarded, attempt, bytes_of, is_number
from neurosym.errors import InvalidWorld, NeurosymError
from neurosym.world import (
    EFFECT_AXES,
    Frame,
    FrameSink,
    Outcome,
    Place,
    Reference,
    ReferenceKind,
    Scene,
    World,
    references_of,
)
from neurosym.worlds.processes import Child, ChildEnded, Unreadable, parent

# Whether an object is a world, as exploration, rehearsal and execution need one, in a few interactions

_INTERACTIONS = 20  # that are looked at through each mirror
_LEAST_MOTION = 1e-3  # root mean square of effects along an axis below which nothing can be said of it [m]
_OPPOSITE = -0.25


def check_world(world: World) -> None:
    """Raise unless an object keeps what the protocol `World` promises; for tests of worlds of your own.

    First a world that has a method `try_out` tries itself: the hand of a `Tabletop` lifts a plain box.
    Then samples a scene and performs an interaction, another one, and the first again: a world has no memory.
    If the world takes places as references, the other one has the middle of the table as its reference.
    Then, if the action box has mirrors, performs 20 interactions and their images in each mirror.

    Args:
        world: The world.

    Raises:
        InvalidWorld: If it does not; the message says which requirement is broken.
    """
    seen = world if isinstance(world, Guarded) else Guarded(world)
    if try_out := getattr(world, "try_out", None):
        attempt(world.name, "try_out", try_out, NeurosymError)
    scene, again = (seen.sample_scene(np.random.default_rng(0), 1) for _ in range(2))
    if bytes_of(scene) != bytes_of(again):
        raise InvalidWorld(world.name, "samples another scene from a generator in the same state")
    _check_memory(seen, scene)
    if broken := broken_mirror(seen):
        raise InvalidWorld(world.name, f"has an action_box with {broken}; leave that mirror out")


def _check_memory(world: Guarded, scene: Scene) -> None:
    """Perform an interaction, then another that ends in mid-air, and then the first again."""
    action, other = world.action_box.sample(np.random.default_rng(1), 2)
    place = Place(*(sum(side) / 2 for side in (world.table.x, world.table.y)))
    first = world.interact(scene, action, 0)
    world.interact(
        scene, other, 0, put_down=False, reference=place if "place" in references_of(world) else None
    )
    if _outcome_bytes(first) != _outcome_bytes(world.interact(scene, action, 0)):
        problem = "has a memory: the same interaction came out differently the second time"
        raise InvalidWorld(world.name, problem)


def _outcome_bytes(outcome: Outcome) -> tuple[object, ...]:
    scenes = tuple(map(bytes_of, (outcome.start, outcome.lifted, outcome.end)))
    return (*scenes, outcome.held, outcome.toppled, outcome.lost, outcome.peak_height, outcome.touched)


def broken_mirror(world: World) -> str | None:
    """Say in which mirror of a world objects go the opposite way to what it says, or return None.

    A few interactions cannot tell more: after contact, effects depend on differences far too small to see.

    Args:
        world: The world; its mirrors name what is there.
    """
    rng = np.random.default_rng(2)
    box = world.action_box
    scenes = [world.sample_scene(rng, 1) for _ in range(_INTERACTIONS if box.mirrors else 0)]
    actions = box.sample(rng, len(scenes))

    def effects(action_signs: Any, effect_signs: Any) -> np.ndarray:
        pairs = zip(scenes, actions, strict=True)
        return np.array([world.interact(s, action_signs * a, 0).effect * effect_signs for s, a in pairs])

    for mirror in box.mirrors:
        action_signs, effect_signs = np.ones(len(box.low)), np.ones(EFFECT_AXES)
        action_signs[list(mirror.actions)] = effect_signs[list(mirror.effects)] = -1
        likeness = _likeness(effects(1, 1), effects(action_signs, effect_signs))
        if opposite := np.flatnonzero(likeness < _OPPOSITE).tolist():
            return f"{mirror}, in which objects go the opposite way along effect axis {opposite[0]}"
    return None


def _likeness(effects: np.ndarray, reflections: np.ndarray) -> np.ndarray:
    """Compute on each axis the cosine between two lists of effects; 0 where hardly anything moves."""
    norms = np.linalg.norm(effects, axis=0), np.linalg.norm(reflections, axis=0)
    moves = np.minimum(*norms) >= _LEAST_MOTION * np.sqrt(len(effects))
    return np.where(moves, (effects * reflections).sum(0) / np.maximum(norms[0] * norms[1], 1e-30), 0.0)


# Worlds of your own: `module:factory` names the function or class that makes one.
#
# A domain folder may come from a stranger, and its `world.toml` says what is called, and with which
# options. So nothing is called that does not make worlds (`os:system`).

Factory = Callable[..., Any]


def make_own_world(name: str, options: dict[str, Any]) -> World:
    """Make a world of one's own.

    Args:
        name: `module:factory`; the module can be imported.
        options: What to call the factory with, by keyword.

    Raises:
        InvalidWorld: If there is no such factory, it rejects the options, or does not return a world.
    """
    factory = _load(name)
    _check_options(name, factory, options)
    try:
        world = factory(**options)
    except (InvalidWorld, KeyboardInterrupt):
        raise
    except BaseException as error:
        raise InvalidWorld(name, f"cannot be made with its options: {told(error)}") from error
    return Guarded(world, name)


def describe_own_world(name: str, folder: Path) -> dict[str, Any]:
    """Say which options a world of one's own has, as they stand in a TOML file, and check that it is a world.

    Args:
        name: `module:factory`.
        folder: The domain folder that it is for.

    Raises:
        InvalidWorld: If it is no world, as far as a few interactions tell. What needs an option is not made.
    """
    admit(name, folder, InvalidWorld)
    factory = _load(name)
    defaults = {name: p.default for name, p in _parameters(factory).items() if _is_plain(p.default)}
    options: dict[str, Any] = json.loads(json.dumps(defaults))
    if not _missing_options(factory, options):  # else they must be written into the file first
        check_world(make_own_world(name, options))
    return options


def _load(name: str) -> Factory:
    """Import the factory of a world."""
    factory = load_factory(name, InvalidWorld)
    if not callable(factory):
        kind = type(factory).__name__
        raise InvalidWorld(name, f"is not callable but of type {kind}; name a class or a function")
    if not _makes_worlds(factory):
        raise InvalidWorld(
            name,
            "is not known to make worlds; name a class that has the methods of World, or annotate -> World",
        )
    return factory  # type: ignore[no-any-return]


def _missing_options(factory: Factory, options: dict[str, Any]) -> list[str]:
    needed = [name for name, p in _parameters(factory).items() if p.default is inspect.Parameter.empty]
    return [name for name in needed if name not in options]


def _makes_worlds(factory: Any) -> bool:
    """Say whether a factory is a world's class, or is annotated with one, or stands in a module with one."""
    while isinstance(factory, partial):
        factory = factory.func
    if isinstance(factory, type):
        return _is_world_class(factory)
    try:
        returned = get_type_hints(factory).get("return")
    except Exception:  # annotations can hold anything
        returned = None
    beside = getattr(inspect.unwrap(factory), "__globals__", {}).values()
    return _is_world_class(returned) or any(_is_world_class(kind) for kind in beside if kind is not World)


def _is_world_class(kind: Any) -> bool:
    return isinstance(kind, type) and hasattr(kind, "sample_scene") and hasattr(kind, "interact")


def _check_options(name: str, factory: Factory, options: dict[str, Any]) -> None:
    known = _parameters(factory)
    takes_any = any(p.kind is p.VAR_KEYWORD for p in _signature(factory))
    for option in options:
        if option not in known and not takes_any:
            raise InvalidWorld(name, f"has no option {option!r}; valid: {', '.join(known) or 'none'}")
    if missing := _missing_options(factory, options):
        raise InvalidWorld(name, f"needs the option {missing[0]!r}, which has no default")


def _parameters(factory: Factory) -> dict[str, inspect.Parameter]:
    by_keyword = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    return {p.name: p for p in _signature(factory) if p.kind in by_keyword}


def _signature(factory: Factory) -> list[inspect.Parameter]:
    return list(inspect.signature(factory).parameters.values())


def _is_plain(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return all(map(_is_plain, value))
    if isinstance(value, dict):
        return all(isinstance(key, str) and _is_plain(entry) for key, entry in value.items())
    return isinstance(value, bool | int | str) or (isinstance(value, float) and math.isfinite(value))


class _Process:
    """A process that calls functions for a world that is made there, so that ours can tell what they do."""

    def __init__(self, name: str):
        self._name, self.patience = name, PATIENCE
        self.child = Child(__name__)
        self._lock = threading.Lock()

    def call(
        self, what: str, function: Callable[..., Any], *arguments: Any, on_frame: FrameSink | None = None
    ) -> Any:
        """Have a function called, of which messages speak as `what`, and return what it returns."""
        hear = (lambda word: on_frame(*word)) if on_frame else None
        try:
            with self._lock:
                self.child.ask(told_by, self._name, function, arguments)
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
        scene, rng.bit_generator.state = self.process.call("sample_scene", sample_scene, rng, objects)
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
        return self.process.call(method.strip("_"), call, *given, on_frame=on_frame)

    def __getattr__(self, name: str) -> Any:
        """Give what else the world has, like its `object_limits`."""
        if name.startswith("_") or name == "process":
            raise AttributeError(name)
        is_there, value = self.process.call(name, get, name)
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
            return Hosted(process, process.call("its making", make, name, options, self._folder))
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


# What a process does that holds a world of somebody's own: it answers the calls of `worlds/hosted.py`.
#
# The functions here are called in that process, which has one world. It ends when nobody asks any more.

PATIENCE = 600.0
"""How long a call may take unless the world has a `patience` of its own [s]."""

_world: Guarded


def told_by(name: str, function: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
    """Call a function; whatever the world `name` raises in it is told as an `InvalidWorld`."""
    try:
        return function(*arguments)
    except (NeurosymError, KeyboardInterrupt):
        raise
    except BaseException as error:  # nothing that the world does may end the process
        raise InvalidWorld(name, f"raises an error: {told(error)}") from error


def make(name: str, options: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Make the world, and say what it has.

    Args:
        name: `module:factory`.
        options: What to call the factory with.
        folder: The domain folder, which must not bring code of its own.
    """
    global _world
    admit(name, folder, InvalidWorld)
    world = make_own_world(name, options)
    assert isinstance(world, Guarded), "every world of somebody's own is"
    _world = world
    patience = getattr(world, "patience", PATIENCE)
    if not (is_number(patience) and patience > 0):
        raise InvalidWorld(name, f"has patience = {patience!r}; valid: a time above 0 s")
    return {
        "name": world.name,
        "feature_names": world.feature_names,
        "action_box": world.action_box,
        "table": world.table,
        "lift_height": world.lift_height,
        "references": references_of(world),
        "patience": float(patience),
        "optional": tuple(method for method in OPTIONAL if hasattr(world, method)),
        "is_sparing": hasattr(world, "wanted_pictures"),
    }


def sample_scene(rng: np.random.Generator, objects: int) -> tuple[Scene, Any]:
    """Draw a scene, and return it with the state that the generator is left in."""
    return _world.sample_scene(rng, objects), rng.bit_generator.state


def call(method: str, arguments: tuple[Any, ...], options: dict[str, Any], is_filmed: bool) -> Any:
    """Call another method of the world, and send its pictures on the way if it is filmed."""
    if is_filmed:
        options["on_frame"] = _send_frame
    return getattr(_world, method)(*arguments, **options)


def _send_frame(frame: Frame, phase: str) -> None:
    parent().send((np.array(frame), phase))


def get(name: str) -> tuple[bool, Any]:
    """Return whether the world has an attribute, and the attribute."""
    if hasattr(_world, name) and not callable(getattr(_world, name)):
        return True, getattr(_world, name)
    return False, None
