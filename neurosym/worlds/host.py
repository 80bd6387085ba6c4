"""What a process does that holds a world of somebody's own: it answers the calls of `worlds/hosted.py`.

The functions here are called in that process, which has one world. It ends when nobody asks any more.
"""

import os
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.contract import is_number
from neurosym.errors import InvalidWorld, NeurosymError
from neurosym.factories import admit, told
from neurosym.guarded import OPTIONAL, Guarded
from neurosym.table import Reference
from neurosym.world import Frame, Outcome, Scene, references_of
from neurosym.worlds.children import GRACE, end_with_parent, leave_signals_to_parent, say_up
from neurosym.worlds.custom import make_own_world

FRAME, ANSWER, REFUSAL = "frame", "answer", "refusal"
PATIENCE = 600.0
"""How long a call may take unless the world has a `patience` of its own [s]."""

_connection: Connection
_world: Guarded


def serve(requests: int, lifeline: int, errors: int) -> None:
    """Answer calls, a function and its arguments each, until the other end is closed; see `Serve`."""
    global _connection
    leave_signals_to_parent()
    end_with_parent(lifeline, _end_slowly)
    _connection = say_up(requests, errors)
    while True:
        try:
            name, function, arguments = _connection.recv()
        except EOFError:
            return
        _connection.send(_answer(name, function, arguments))


def _answer(name: str, function: Callable[..., Any], arguments: tuple[Any, ...]) -> tuple[str, Any]:
    try:
        return ANSWER, function(*arguments)
    except NeurosymError as error:
        return REFUSAL, error
    except BaseException as error:  # nothing that the world does may end the loop
        return REFUSAL, InvalidWorld(name, f"raises an error: {told(error)}")


def _end_slowly() -> None:
    time.sleep(GRACE)
    os._exit(1)


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


def interact(
    scene: Scene,
    action: np.ndarray,
    target: int,
    put_down: bool,
    is_filmed: bool,
    ghosts: np.ndarray | None,
    reference: Reference | None,
) -> Outcome:
    """Perform an interaction, and send its pictures on the way if it is filmed."""
    sink = _send_frame if is_filmed else None
    return _world.interact(
        scene, action, target, put_down=put_down, on_frame=sink, ghosts=ghosts, reference=reference
    )


def _send_frame(frame: Frame, phase: str) -> None:
    _connection.send((FRAME, (np.array(frame), phase)))


def call(method: str, *arguments: Any) -> Any:
    """Call another method of the world."""
    return getattr(_world, method)(*arguments)


def put(name: str, value: Any) -> None:
    """Set an attribute of the world."""
    setattr(_world, name, value)


def get(name: str) -> tuple[bool, Any]:
    """Return whether the world has an attribute, and the attribute."""
    if hasattr(_world, name) and not callable(getattr(_world, name)):
        return True, getattr(_world, name)
    return False, None
