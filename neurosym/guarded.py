"""Worlds of somebody's own, such that whatever they do wrong is told in one sentence.

Every call into a world that is not ours passes through `Guarded`: an error, `sys.exit`, or something that is
no scene or outcome is an `InvalidWorld`, which names the world and what it did.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from neurosym.actions import ActionBox
from neurosym.arrays import Float
from neurosym.contract import attempt, check_attributes, check_drawn, check_outcome
from neurosym.errors import InvalidValue, InvalidWorld, NeurosymError
from neurosym.table import Reference, Table
from neurosym.world import Frame, FrameSink, Outcome, Scene, World, WorldFactory, is_world, relative_to

OPTIONAL = ("picture", "open_window")
"""Methods that a world may have besides."""


class Guarded:
    """A world whose every answer is checked.

    What it returns are plain values of ours, with the same numbers, that another process can read.

    Args:
        world: A world.
        name: What messages call it, if not by its own name.

    Raises:
        InvalidWorld: If it is no world; from its methods, if a call fails or gives what cannot be.
    """

    def __init__(self, world: Any, name: str | None = None):
        check_attributes(world, name)
        self._world, self._called = world, name or world.name
        self.name, self.lift_height = str(world.name), world.lift_height
        self.feature_names = tuple(map(str, world.feature_names))
        box = world.action_box
        self.action_box = ActionBox(np.array(box.low), np.array(box.high), np.array(box.gripper), box.mirrors)
        self.table = Table(world.table.x, world.table.y)
        if hasattr(world, "picture"):
            self.picture = self._picture
        if hasattr(world, "open_window"):
            self.open_window = lambda: self._attempt("open_window", world.open_window)
        if hasattr(world, "wanted_pictures"):
            self.wanted_pictures = world.wanted_pictures

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene; see `World.sample_scene`."""
        scene = self._attempt("sample_scene", lambda: self._world.sample_scene(rng, objects))
        self._check(lambda: check_drawn(self, scene, objects, self._called))
        return _plain_scene(scene)

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
        before = _plain_scene(scene)

        def interact() -> Any:
            aim = relative_to(self._world, reference)
            return self._world.interact(
                scene, action, target, put_down=put_down, on_frame=sink, ghosts=ghosts, **aim
            )

        def look(frame: Frame, phase: str) -> None:
            self._check_frame(frame, "on_frame")
            assert on_frame is not None, "else it is not called"
            on_frame(frame, str(phase))

        sink = None if on_frame is None else look
        outcome = self._attempt("interact", interact)
        if not _are_equal(scene, before):
            problem = "changes the scene that interact is given; it must return new ones"
            raise InvalidWorld(self._called, problem)
        self._check(lambda: check_outcome(self, scene, target, outcome, self._called, reference))
        return _plain_outcome(outcome)

    def __getattr__(self, name: str) -> Any:
        """Give what else the world has, like its `object_limits`."""
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._world, name)

    def __setattr__(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)
        if name == "wanted_pictures":
            self._attempt(name, lambda: setattr(self._world, name, value))

    def _picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        frame = self._attempt("picture", lambda: self._world.picture(scene, ghosts))
        self._check_frame(frame, "picture")
        return np.array(frame)

    def _check_frame(self, frame: object, where: str) -> None:
        if not (isinstance(frame, np.ndarray) and frame.dtype == np.uint8 and frame.ndim == 3):
            shape = f"{frame.dtype} {frame.shape}" if isinstance(frame, np.ndarray) else type(frame).__name__
            problem = f"gives a picture of {shape} to {where}; valid: uint8 (height, width, 3)"
            raise InvalidWorld(self._called, problem)

    def _attempt(self, what: str, call: Callable[[], Any]) -> Any:
        return attempt(self._called, what, call, NeurosymError)

    def _check(self, check: Callable[[], None]) -> None:
        """Check an answer; whatever looking at it raises is its own doing."""
        attempt(self._called, "what it returns", check)


def guarded(world: object) -> World:
    """Return a world such that it tells what it does wrong; one of ours is returned as it is.

    Args:
        world: The world.

    Raises:
        InvalidWorld: If it is none.
    """
    return world if _is_ours(world) and is_world(world) else Guarded(world)


def made(factory: WorldFactory) -> World:
    """Make a world, such that it tells what it does wrong.

    Args:
        factory: Builds it.

    Raises:
        InvalidValue: If the factory is none.
        InvalidWorld: If it fails, or what it makes is no world.
    """
    if not callable(factory):
        instead = "a world itself" if is_world(factory) else f"a {type(factory).__name__}"
        raise InvalidValue(
            f"The factory of worlds is {instead}; valid: a function that makes one, like its class."
        )
    name = getattr(factory, "__name__", type(factory).__name__)
    return guarded(attempt(name, "the factory", factory, NeurosymError))


@contextmanager
def placed(place: str) -> Iterator[None]:
    """Add to what a world does wrong where that was.

    Args:
        place: Where, like `interaction 18`.
    """
    try:
        yield
    except InvalidWorld as error:
        raise error.at(place) from error


def _is_ours(world: object) -> bool:
    return not isinstance(world, type) and type(world).__module__.split(".")[0] == __name__.split(".")[0]


def _plain_scene(scene: Scene) -> Scene:
    return Scene(np.array(scene.features), np.array(scene.positions), np.array(scene.orientations))


def _plain_outcome(outcome: Outcome) -> Outcome:
    scenes = {id(scene): _plain_scene(scene) for scene in (outcome.start, outcome.lifted, outcome.end)}
    return Outcome(
        start=scenes[id(outcome.start)],
        lifted=scenes[id(outcome.lifted)],
        end=scenes[id(outcome.end)],
        target=int(outcome.target),
        held=bool(outcome.held),
        toppled=bool(outcome.toppled),
        lost=bool(outcome.lost),
        peak_height=outcome.peak_height
        if isinstance(outcome.peak_height, np.number)
        else +outcome.peak_height,
        touched=tuple(int(number) for number in outcome.touched),
        disturbed=tuple((int(number), str(how)) for number, how in outcome.disturbed),  # type: ignore[misc]
        reference=outcome.reference,
        carried=bool(outcome.carried),
        contacts=tuple((int(one), int(other)) for one, other in outcome.contacts),
    )


def _are_equal(one: Scene, other: Scene) -> bool:
    pairs = zip(
        (one.features, one.positions, one.orientations),
        (other.features, other.positions, other.orientations),
        strict=True,
    )
    return all(np.asarray(first).tobytes() == np.asarray(second).tobytes() for first, second in pairs)
