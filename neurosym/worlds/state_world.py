"""Worlds of values: a function from the state of a thing and an action to its state afterwards.

A state is the features of the thing, and then the axes that no feature shows, in their order. Such a world is
somebody's own, and lives in a process of its own.
"""

from pathlib import Path
from typing import Any, Protocol

import numpy as np

from neurosym.checks import Float
from neurosym.choices import admit, load_factory, search_here, told
from neurosym.errors import InvalidWorld, shortened
from neurosym.worlds.own_world import Apart


class StateWorld(Protocol):
    """What `module:factory` makes, if `world.toml` names axes beside it."""

    def step(self, state: Float[np.ndarray, "S"], action: Float[np.ndarray, "A"]) -> Float[np.ndarray, "S"]:
        """Return what becomes of a thing; a world has no memory besides.

        Args:
            state: The features of the thing, and then the axes that no feature shows.
            action: The parameters of an action, as the columns of the data have them.
        """
        ...


class HostedStates(Apart):
    """A world of values in a process of its own.

    Args:
        called: `module:factory`.
        options: What the factory is called with.
        folder: The domain folder, which must not bring code of its own.

    Raises:
        InvalidWorld: If it cannot be made, has no `step`, or fails later.
    """

    def __init__(self, called: str, options: dict[str, Any], folder: Path):
        search_here(folder)
        super().__init__(called)
        self.have_made(_make, options, folder)

    def step(self, state: Float[np.ndarray, "S"], action: Float[np.ndarray, "A"]) -> Float[np.ndarray, "S"]:
        """Perform an action; see `StateWorld.step`."""
        given = self.call("step", _step, state, action)
        try:
            found = np.asarray(given, dtype=float)
        except (TypeError, ValueError):
            found = np.array(np.nan)
        if found.shape != state.shape or not np.all(np.isfinite(found)):
            raise InvalidWorld(
                self._called, f"gives {shortened(repr(given))} from step; valid: {len(state)} finite numbers"
            )
        return found


_world: StateWorld


def _make(called: str, options: dict[str, Any], folder: Path) -> None:
    """Make the world, in its process."""
    global _world
    admit(called, folder, InvalidWorld)
    factory = load_factory(called, InvalidWorld)
    if not callable(factory):
        raise InvalidWorld(called, "is not callable; name a class or a function")
    try:
        _world = factory(**options)
    except Exception as error:
        raise InvalidWorld(called, f"cannot be made with its options: {told(error)}") from error
    if not callable(getattr(_world, "step", None)):
        raise InvalidWorld(called, "has no method step(state, action), and world.toml names axes")


def _step(state: np.ndarray, action: np.ndarray) -> Any:
    return _world.step(state.copy(), action.copy())
