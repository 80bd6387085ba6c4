"""Worlds of somebody's own in processes of their own, so that nothing they do ends ours.

A world may raise, call `sys.exit` or `os._exit`, be killed, or never answer: in each case the command says in
one sentence what it did, keeps what was finished, and goes on when it is called again.
"""

import inspect
import json
import math
import threading
from collections.abc import Callable
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np

from neurosym.checks import Float
from neurosym.choices import admit, load_factory, search_here, told
from neurosym.contract import OPTIONAL, Guarded, ObjectLimits, attempt, bytes_of, is_number, limits_of
from neurosym.errors import InvalidWorld, NeurosymError
from neurosym.world import (
    EFFECT_AXES,
    ActionBox,
    FrameSink,
    Outcome,
    Place,
    ReferenceKind,
    Scene,
    Table,
    World,
    references_of,
)
from neurosym.worlds.processes import Child, ChildEnded, parent

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
    if callable(look := getattr(seen, "images", None)) and look(scene).tobytes() != look(scene).tobytes():
        raise InvalidWorld(world.name, "gives other images of the same scene the second time")
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


def make_own_world(name: str, options: dict[str, Any]) -> Guarded:
    """Make a world of one's own from `module:factory` and its options, or raise `InvalidWorld`."""
    factory = _load(name)
    try:
        world = factory(**options)
    except (InvalidWorld, KeyboardInterrupt):
        raise
    except BaseException as error:
        valid = ", ".join(_parameters(factory)) or "none"
        problem = f"cannot be made with its options: {told(error)}; valid: {valid}"
        raise InvalidWorld(name, problem) from error
    return Guarded(world, name)


def _describe(name: str, folder: Path) -> dict[str, Any]:
    """Return the options of a world; it is checked, unless it needs some that must be written down first."""
    admit(name, folder, InvalidWorld)
    defaults = {option: p.default for option, p in _parameters(_load(name)).items()}
    plain = {option: default for option, default in defaults.items() if _is_plain(default)}
    options: dict[str, Any] = json.loads(json.dumps(plain))
    if inspect.Parameter.empty not in defaults.values():
        check_world(make_own_world(name, options))
    return options


def _load(name: str) -> Callable[..., Any]:
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


def _makes_worlds(factory: Any) -> bool:
    """Say whether a factory is a world's class, or is annotated with one, or stands in a module with one."""

    def is_world_class(kind: Any) -> bool:
        return isinstance(kind, type) and hasattr(kind, "sample_scene") and hasattr(kind, "interact")

    while isinstance(factory, partial):
        factory = factory.func
    if isinstance(factory, type):
        return is_world_class(factory)
    try:
        returned = get_type_hints(factory).get("return")
    except Exception:  # annotations can hold anything
        returned = None
    beside = getattr(inspect.unwrap(factory), "__globals__", {}).values()
    return any(is_world_class(kind) for kind in (returned, *(kind for kind in beside if kind is not World)))


def _parameters(factory: Callable[..., Any]) -> dict[str, inspect.Parameter]:
    by_keyword = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    return {name: p for name, p in inspect.signature(factory).parameters.items() if p.kind in by_keyword}


def _is_plain(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return all(map(_is_plain, value))
    if isinstance(value, dict):
        return all(isinstance(key, str) and _is_plain(entry) for key, entry in value.items())
    return isinstance(value, bool | int | str) or (isinstance(value, float) and math.isfinite(value))


# The process that a world of somebody's own lives in, as we see it


class Apart(Child):
    """A process that calls functions for a world, so that ours can tell what they do."""

    def __init__(self, called: str):
        super().__init__(__name__)
        self._called, self._patience = called, PATIENCE
        self._lock = threading.Lock()

    def call(
        self, what: str, function: Callable[..., Any], *arguments: Any, on_frame: FrameSink | None = None
    ) -> Any:
        """Have a function called, of which messages speak as `what`, and return what it returns."""
        hear = (lambda word: on_frame(*word)) if on_frame else None
        try:
            with self._lock:
                self.ask(_told_by, self._called, function, arguments)
                return self.answer(self._patience, hear)
        except ChildEnded as error:
            self.close(grace=0.0)
            raise InvalidWorld(self._called, f"{error} {what}") from error

    def have_made(self, make: Callable[..., Any], *arguments: Any) -> Any:
        """Have the world made, and return what that returns; the process ends if it cannot be made."""
        try:
            return self.call("its making", make, self._called, *arguments)
        except BaseException:
            self.close(grace=0.0)
            raise


class Hosted(Apart):
    """A world that lives in another process; see `World`. `InvalidWorld` is raised if it cannot be made."""

    name: str
    feature_names: tuple[str, ...]
    action_box: ActionBox
    table: Table
    lift_height: float
    references: tuple[ReferenceKind, ...]
    object_limits: ObjectLimits | None

    def __init__(self, called: str, options: dict[str, Any], folder: Path):
        super().__init__(called)
        about, self._patience, methods = self.have_made(_make, options, folder)
        vars(self).update(about)
        for method in methods:
            vars(self)[method] = partial(self._do, method)

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene; see `World.sample_scene`."""
        scene, rng.bit_generator.state = self.call("sample_scene", _sample_scene, rng, objects)
        return scene  # type: ignore[no-any-return]

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform an interaction; see `World.interact`."""
        return self._do("interact", scene, action, target, **options)  # type: ignore[no-any-return]

    def _do(self, method: str, *arguments: Any, on_frame: FrameSink | None = None, **options: Any) -> Any:
        painter = vars(self).get("painter") if on_frame or method == "picture" else None
        colours = painter(arguments[0].features) if painter else None
        given = method, arguments, options, on_frame is not None, colours
        return self.call(method.strip("_"), _do, *given, on_frame=on_frame)

    def __setattr__(self, name: str, value: Any) -> None:
        if name == "wanted_pictures" and value is not self.__dict__.get(name):
            self._do("__setattr__", name, value)
        object.__setattr__(self, name, value)


class OwnFactory:
    """Makes a world of one's own, each in a process of its own; can be pickled.

    Within a process, those that are called for one after another are the same one: worlds have no memory.
    The domain folder must not bring code of its own.
    """

    def __init__(self, name: str, options: dict[str, Any], folder: Path):
        self.args, self._folder = (name, options), folder.resolve()
        self._world: Hosted | None = None

    def __call__(self) -> World:
        """Return the world, made if there is none yet, or its process has ended."""
        if self._world is None or not self._world.is_open:
            self._world = self.another()
        return self._world

    def another(self) -> Hosted:
        """Make one in a new process; raise `InvalidWorld` if it cannot be made."""
        search_here(self._folder)
        return Hosted(*self.args, self._folder)

    def __reduce__(self) -> tuple[Any, ...]:
        return OwnFactory, (*self.args, self._folder)


def describe_apart(name: str, folder: Path) -> dict[str, Any]:
    """Say which options a world of one's own has, as they stand in a TOML file, and check that it is a world.

    Both happen in a process of its own. Raises `InvalidWorld` if it is none, as far as a few interactions
    tell; what needs an option is not made.
    """
    search_here(folder)
    with closing(Apart(name)) as process:
        options: dict[str, Any] = process.call("a first trial", _describe, name, folder)
    return options


# What that process does, which has one world: it answers the calls of `Hosted`

PATIENCE = 600.0
"""How long a call may take unless the world has a `patience` of its own [s]."""
_ATTRIBUTES = ("name", "feature_names", "action_box", "table", "lift_height")

_world: Guarded


def _told_by(name: str, function: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
    """Call a function; whatever the world `name` raises in it is told as an `InvalidWorld`."""
    try:
        return function(*arguments)
    except (NeurosymError, KeyboardInterrupt):
        raise
    except BaseException as error:  # nothing that the world does may end the process
        raise InvalidWorld(name, f"raises an error: {told(error)}") from error


def _make(name: str, options: dict[str, Any], folder: Path) -> tuple[dict[str, Any], float, tuple[str, ...]]:
    """Make the world, and return what it has, its patience [s], and which optional methods there are."""
    global _world
    admit(name, folder, InvalidWorld)
    _world = make_own_world(name, options)
    patience = getattr(_world, "patience", PATIENCE)
    if not (is_number(patience) and patience > 0):
        raise InvalidWorld(name, f"has patience = {patience!r}; valid: a time above 0 s")
    about = {attribute: getattr(_world, attribute) for attribute in _ATTRIBUTES}
    about |= {"references": references_of(_world), "object_limits": limits_of(_world)}
    about |= {name: None for name in ("wanted_pictures", "painter") if hasattr(_world, name)}
    return (
        about,
        float(patience),
        tuple(method for method in OPTIONAL if callable(getattr(_world, method, None))),
    )


def _sample_scene(rng: np.random.Generator, objects: int) -> tuple[Scene, Any]:
    """Draw a scene, and return it with the state that the generator is left in."""
    return _world.sample_scene(rng, objects), rng.bit_generator.state


def _do(method: str, given: tuple[Any, ...], options: dict[str, Any], is_filmed: bool, colours: Any) -> Any:
    """Call another method of the world, with its objects painted, and send its pictures if it is filmed."""
    if colours is not None:
        _world.painter = lambda _: colours
    if is_filmed:
        options["on_frame"] = lambda frame, phase: parent().send((np.array(frame), phase))
    return getattr(_world, method)(*given, **options)
