"""Whether an object is a world, as exploration, rehearsal and execution need one."""

import math
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from neurosym.actions import ActionBox
from neurosym.errors import InvalidWorld
from neurosym.factories import told
from neurosym.problems import LEGAL_NAME
from neurosym.world import Outcome, Scene, Table, World
from neurosym.worlds.mirrors import box_problem, broken_mirror

Result = TypeVar("Result")

REQUIRED = tuple(name for name in vars(World) if not name.startswith("_"))
"""What a world must have."""


def check_world(world: World) -> None:
    """Raise unless an object keeps what the protocol `World` promises; for tests of worlds of your own.

    Samples a scene and performs an interaction, another one, and the first again: a world has no memory.
    Then, if the action box has mirrors, performs 20 interactions and their images in each mirror.

    Args:
        world: The world.

    Raises:
        InvalidWorld: If it does not; the message says which requirement is broken.
    """
    check_attributes(world)
    _check_interactions(world, _checked_scene(world))
    if broken := _attempt(world.name, "interact", lambda: broken_mirror(world)):
        raise InvalidWorld(world.name, f"has an action_box with {broken}; leave that mirror out")


def check_attributes(world: object, name: str | None = None) -> None:
    """Raise unless an object has what a world has, without acting in it.

    Args:
        world: The object.
        name: What messages call it, if not by its class.

    Raises:
        InvalidWorld: If something is missing or impossible.
    """
    called = name or type(world).__name__
    _attempt(called, "its attributes", lambda: _check_attributes(world, called))


def _check_attributes(world: object, called: str) -> None:
    missing = [attribute for attribute in REQUIRED if not hasattr(world, attribute)]
    if missing or not isinstance(world, World):
        raise InvalidWorld(called, f"is no World: {type(world).__name__} lacks {', '.join(missing)}")
    if not (isinstance(world.name, str) and LEGAL_NAME.fullmatch(world.name)):
        raise InvalidWorld(
            called, f"has the name {world.name!r}; valid: a lower-case letter, then a-z, 0-9 and hyphens"
        )
    features = world.feature_names
    if not (isinstance(features, tuple) and features and all(isinstance(entry, str) for entry in features)):
        raise InvalidWorld(called, f"has feature_names = {features!r}; valid: a tuple of one name or more")
    _check_box(called, world.action_box)
    if not isinstance(world.table, Table):
        raise InvalidWorld(called, f"has a table of type {type(world.table).__name__}; valid: Table")
    if not (_is_number(world.lift_height) and world.lift_height > 0):
        raise InvalidWorld(called, f"has lift_height = {world.lift_height!r}; valid: a length above 0 m")


def _check_box(called: str, box: object) -> None:
    if not isinstance(box, ActionBox):
        raise InvalidWorld(called, f"has an action_box of type {type(box).__name__}; valid: ActionBox")
    low, high, gripper = np.asarray(box.low), np.asarray(box.high), np.asarray(box.gripper)
    if low.ndim != 1 or not len(low) or not low.shape == high.shape == gripper.shape:
        shapes = f"low {low.shape}, high {high.shape} and gripper {gripper.shape}"
        raise InvalidWorld(called, f"has an action_box with {shapes}; valid: one shape (A,) for all three")
    if gripper.dtype != bool:
        raise InvalidWorld(called, f"has an action_box with gripper of {gripper.dtype}; valid: bool")
    if not (np.all(np.isfinite(low)) and np.all(np.isfinite(high)) and np.all(low <= high)):
        raise InvalidWorld(called, "has an action_box that is empty or not finite; valid: low <= high")
    if problem := box_problem(box):
        raise InvalidWorld(called, f"has an action_box with {problem}")


def _checked_scene(world: World) -> Scene:
    def sample() -> Any:
        return world.sample_scene(np.random.default_rng(0), 1)

    scenes: list[Scene] = _attempt(world.name, "sample_scene", lambda: [sample(), sample()])
    for scene in scenes:
        _check_scene(world, scene, "sample_scene")
    scene, again = scenes
    if _bytes_of(scene) != _bytes_of(again):
        raise InvalidWorld(world.name, "samples another scene from a generator in the same state")
    if not world.table.contains(scene.positions[0]):
        raise InvalidWorld(world.name, f"samples an object off its table, at {scene.positions[0].tolist()}")
    return scene


def _check_interactions(world: World, scene: Scene) -> None:
    """Perform an interaction, then another that ends in mid-air, and then the first again."""
    before = _bytes_of(scene)
    action, other = world.action_box.sample(np.random.default_rng(1), 2)

    def interact() -> Any:
        return world.interact(scene, action, 0)

    def interrupt() -> Any:
        return world.interact(scene, other, 0, put_down=False, on_frame=None, ghosts=None)

    first, between, second = _attempt(world.name, "interact", lambda: (interact(), interrupt(), interact()))
    if _bytes_of(scene) != before:
        raise InvalidWorld(world.name, "changes the scene that interact is given; it must return new ones")
    for outcome in (first, between, second):
        _check_outcome(world, scene, outcome)
    if _outcome_bytes(first) != _outcome_bytes(second):
        raise InvalidWorld(
            world.name, "has a memory: the same interaction came out differently the second time"
        )


def _attempt(name: str, what: str, call: Callable[[], Result]) -> Result:
    try:
        return call()
    except InvalidWorld:
        raise
    except Exception as error:
        raise InvalidWorld(name, f"raises an error in {what}: {told(error)}") from error


def _check_scene(world: World, scene: object, where: str) -> None:
    if not isinstance(scene, Scene):
        raise InvalidWorld(world.name, f"gives a {type(scene).__name__} as {where}; valid: a Scene")
    widths = {"features": len(world.feature_names), "positions": 3, "orientations": 4}
    for column, width in widths.items():
        array = getattr(scene, column)
        if np.shape(array) != (1, width):
            raise InvalidWorld(
                world.name,
                f"gives {column} of shape {np.shape(array)} in {where}; valid for one object: (1, {width})",
            )
        if np.asarray(array).dtype.kind != "f" or not np.all(np.isfinite(array)):
            raise InvalidWorld(world.name, f"gives {column} in {where} that are not finite floats")


def _check_outcome(world: World, scene: Scene, outcome: object) -> None:
    if not isinstance(outcome, Outcome):
        raise InvalidWorld(world.name, f"gives a {type(outcome).__name__} from interact; valid: an Outcome")
    for moment in ("start", "lifted", "end"):
        _check_scene(world, getattr(outcome, moment), f"outcome.{moment}")
        if not np.array_equal(getattr(outcome, moment).features, scene.features):
            raise InvalidWorld(world.name, f"changes the features of an object in outcome.{moment}")
    if outcome.target != 0:
        raise InvalidWorld(world.name, f"gives the target {outcome.target!r} when asked to act on object 0")
    for flag in ("held", "toppled", "lost"):
        if not isinstance(getattr(outcome, flag), bool | np.bool_):
            raise InvalidWorld(
                world.name, f"gives outcome.{flag} = {getattr(outcome, flag)!r}; valid: a bool"
            )
    if not _is_number(outcome.peak_height):
        raise InvalidWorld(world.name, f"gives outcome.peak_height = {outcome.peak_height!r}; valid: metres")


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float | np.number) and math.isfinite(value)


def _bytes_of(scene: Scene) -> bytes:
    return b"".join(np.asarray(a).tobytes() for a in (scene.features, scene.positions, scene.orientations))


def _outcome_bytes(outcome: Outcome) -> tuple[object, ...]:
    scenes = tuple(_bytes_of(scene) for scene in (outcome.start, outcome.lifted, outcome.end))
    numbers = (outcome.held, outcome.toppled, outcome.lost, outcome.peak_height, outcome.touched)
    return (*scenes, *numbers)
