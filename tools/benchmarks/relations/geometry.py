"""Which relation two objects have, by geometry that a person wrote. It judges; the robot is never told it."""

import math
from typing import Literal

import numpy as np
from jaxtyping import Float

from neurosym.sim.camera_world import truth_of
from neurosym.sim.interaction import rotation
from neurosym.sim.shapes import OPEN_TOP, SOLID, UNSEEN
from neurosym.world import Outcome, Scene

Relation = Literal["on", "in", "leaning", "against", "beside", "apart", "around"]
UPRIGHT_COSINE = math.cos(math.radians(10))
"""An object is upright when some face of it points up, but for so much."""
SUNK = 0.005  # what stands in another reaches at least so far below its top [m]
WALL = 0.006  # how thick the walls of hollow objects are [m]
NEAR = 0.05  # what stands beside another is so near at most [m]


def relation(outcome: Outcome, one: int, other: int) -> Relation:
    """Say how one object stands to another in the end, as things are and not as a camera sees them."""
    scene, pair = _as_it_is(outcome.end), (min(one, other), max(one, other))
    low, high = spans(scene, one)
    below, above = spans(scene, other)
    if is_inside(scene, one, other):
        return "in" if is_upright(scene, one) else "leaning"
    if is_inside(scene, other, one):
        return "around"
    if pair in outcome.contacts:
        if not is_upright(scene, one):
            return "leaning"
        return "on" if low[2] >= above[2] - SUNK else "against"
    gap = float(np.max(np.maximum(below - high, low - above)[:2]))
    return "beside" if gap <= NEAR else "apart"


def _as_it_is(scene: Scene) -> Scene:
    return truth_of(scene) if scene.unseen.shape[1] > len(UNSEEN) else scene


def is_inside(scene: Scene, one: int, other: int) -> bool:
    """Say whether an object reaches into another one or stands in it, which is hollow, larger and upright."""
    low, high = spans(scene, one)
    below, above = spans(scene, other)
    centre = scene.positions[one][:2]
    is_over = bool(np.all((below[:2] <= centre) & (centre <= above[:2])))
    is_hollow = scene.features[other][3] > (SOLID + OPEN_TOP) / 2
    is_sunk = bool(below[2] - SUNK < low[2] < above[2] - SUNK)
    is_smaller = bool(np.prod((high - low)[:2]) < np.prod((above - below)[:2]))
    return is_over and is_hollow and is_sunk and is_smaller and is_upright(scene, other)


def fits(target: Float[np.ndarray, " F"], reference: Float[np.ndarray, " F"]) -> bool:
    """Say whether an object fits between the walls of another."""
    is_hollow = reference[3] > (SOLID + OPEN_TOP) / 2
    return bool(is_hollow and np.all(target[:2] < reference[:2] - 2 * WALL))


def is_upright(scene: Scene, index: int) -> bool:
    """Say whether an object lies on a face of it, and not on an edge."""
    return bool(np.abs(rotation(scene.orientations[index])[2]).max() >= UPRIGHT_COSINE)


def spans(scene: Scene, index: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the least and the greatest coordinates of an object, as of a box around it [m]."""
    half = np.abs(rotation(scene.orientations[index])) @ (scene.features[index][:3] / 2)
    return scene.positions[index] - half, scene.positions[index] + half
