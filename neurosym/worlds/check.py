"""Whether an object is a world, as exploration, rehearsal and execution need one, in a few interactions."""

from typing import Any

import numpy as np

from neurosym.actions import EFFECT_AXES
from neurosym.errors import InvalidWorld, NeurosymError
from neurosym.guarded import Guarded, attempt, bytes_of
from neurosym.table import Place
from neurosym.world import Outcome, Scene, World, references_of

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
