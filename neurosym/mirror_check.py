"""Whether a mirror is one: whether it names what is there, and whether the world looks the same in it."""

import reprlib
from collections.abc import Collection
from typing import Any

import numpy as np

from neurosym.world import ActionBox, Mirror, World

EFFECT_AXES = 3
"""Axes of a displacement in a world."""

INTERACTIONS = 20
"""Interactions that are looked at through each mirror."""

LEAST_MOTION = 1e-3
"""Root mean square of effects along an axis below which nothing can be said of it [m]."""

_OPPOSITE = -0.25


def column_problem(mirror: Mirror, actions: int, effects: int, grippers: Collection[int]) -> str | None:
    """Say what a mirror must name, if it does not, or return None.

    Args:
        mirror: The mirror.
        actions: How many action parameters there are.
        effects: How many effect axes there are.
        grippers: Which action parameters are gripper values, whose sign cannot change.
    """
    valid = set(range(actions)) - set(grippers)
    if mirror.actions and _are_from(mirror.actions, valid) and _are_from(mirror.effects, set(range(effects))):
        return None
    return (
        f"valid: different action parameters from 0 to {actions - 1}, at least one and no gripper value, "
        f"and different effect axes from 0 to {effects - 1}"
    )


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


def _are_from(numbers: Any, valid: Collection[int]) -> bool:
    """Say whether something is a tuple of different numbers out of these."""
    return (
        isinstance(numbers, tuple)
        and all(isinstance(number, int) and not isinstance(number, bool) for number in numbers)
        and len(set(numbers) & set(valid)) == len(numbers)
    )
