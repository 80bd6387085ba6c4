"""Whether a mirror is one: whether it names what is there, and whether the world looks the same in it."""

import reprlib

import numpy as np

from neurosym.actions import ActionBox, Mirror, column_problem
from neurosym.world import World

EFFECT_AXES = 3
"""Axes of a displacement in a world."""

INTERACTIONS = 20
"""Interactions that are looked at through each mirror."""

LEAST_MOTION = 1e-3
"""Root mean square of effects along an axis below which nothing can be said of it [m]."""

_OPPOSITE = -0.25


def box_problem(box: ActionBox) -> str | None:
    """Say what is wrong with the mirrors of an action box, or return None.

    Args:
        box: The action box; its columns fit together.
    """
    if not isinstance(box.mirrors, tuple) or not all(isinstance(mirror, Mirror) for mirror in box.mirrors):
        return f"mirrors = {reprlib.repr(box.mirrors)}; valid: a tuple of Mirror"
    grippers = np.flatnonzero(box.gripper).tolist()
    for mirror in box.mirrors:
        if problem := column_problem(mirror, len(box.low), EFFECT_AXES, grippers):
            return f"{mirror}; {problem}"
        for number in mirror.actions:
            low, high = box.low[number], box.high[number]
            if low != -high:
                return (
                    f"{mirror}, but action parameter {number} goes from {low:g} to {high:g}; "
                    "valid: as far below 0 as above"
                )
    return None


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
