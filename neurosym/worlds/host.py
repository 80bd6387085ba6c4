"""What a process does that holds a world of somebody's own: it answers the calls of `worlds/hosted.py`.

The functions here are called in that process, which has one world. It ends when nobody asks any more.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.errors import InvalidWorld, NeurosymError
from neurosym.factories import admit, told
from neurosym.guarded import OPTIONAL, Guarded, is_number
from neurosym.world import Frame, Scene, references_of
from neurosym.worlds.children import parent
from neurosym.worlds.custom import make_own_world

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
