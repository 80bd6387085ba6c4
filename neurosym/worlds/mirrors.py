"""Whether a mirror is one: whether the world looks the same in it."""

import numpy as np

from neurosym.actions import EFFECT_AXES
from neurosym.world import World

INTERACTIONS = 20
"""Interactions that are looked at through each mirror."""

LEAST_MOTION = 1e-3
"""Root mean square of effects along an axis below which nothing can be said of it [m]."""

_OPPOSITE = -0.25


def broken_mirror(world: World) -> str | None:
    """Say in which mirror of a world objects go the opposite way to what it says, or return None.

    A few interactions cannot tell more: after contact, effects depend on differences far too small to see.

    Args:
        world: The world; its mirrors name what is there.
    """
    rng = np.random.default_rng(2)
    box = world.action_box
    scenes = [world.sample_scene(rng, 1) for _ in range(INTERACTIONS if box.mirrors else 0)]
    actions = box.sample(rng, len(scenes))
    effects = [world.interact(scene, action, 0).effect for scene, action in zip(scenes, actions, strict=True)]
    for mirror in box.mirrors:
        action_signs, effect_signs = np.ones(len(box.low)), np.ones(EFFECT_AXES)
        action_signs[list(mirror.actions)] = effect_signs[list(mirror.effects)] = -1
        reflections = [
            world.interact(scene, action_signs * action, 0).effect * effect_signs
            for scene, action in zip(scenes, actions, strict=True)
        ]
        for axis, likeness in enumerate(_likeness(np.array(effects), np.array(reflections))):
            if likeness < _OPPOSITE:
                return f"{mirror}, in which objects go the opposite way along effect axis {axis}"
    return None


def _likeness(effects: np.ndarray, reflections: np.ndarray) -> np.ndarray:
    """Compute on each axis the cosine between two lists of effects; 0 where hardly anything moves."""
    norms = np.linalg.norm(effects, axis=0), np.linalg.norm(reflections, axis=0)
    moves = np.minimum(*norms) >= LEAST_MOTION * np.sqrt(len(effects))
    return np.where(moves, (effects * reflections).sum(0) / np.maximum(norms[0] * norms[1], 1e-30), 0.0)
