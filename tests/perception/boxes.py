"""Depth images of boxes on a table, by where rays enter them: no renderer of ours or of anybody's."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from neurosym.perception.regions import Sight

EYE = np.array([0.65, 0.0, 1.3])


class Box(NamedTuple):
    """A box on the table: its middle [m], sizes [m], and turn about the vertical [rad]."""

    at: tuple[float, float]
    size: tuple[float, float, float]
    turn: float = 0.0
    above: float = 0.0  # how high it stands [m]


def sight_of(boxes: Sequence[Box], pixels: int = 192, half: float = 0.42) -> Sight:
    """Look straight down at boxes."""
    steps = half * ((2 * np.arange(pixels) + 1) / pixels - 1)
    right, down = np.meshgrid(steps, steps)
    rays = np.stack([-down, -right, -np.ones_like(right)], axis=-1)
    depths = np.full((pixels, pixels), EYE[2])
    for box in boxes:
        depths = np.minimum(depths, _entered(rays, box))
    return Sight(depths, rays, EYE)


def _entered(rays: np.ndarray, box: Box) -> np.ndarray:
    """Return how far along each ray a box is entered; infinite where it is missed."""
    cosine, sine = math.cos(box.turn), math.sin(box.turn)
    own = np.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]])
    middle = np.array([*box.at, box.above + box.size[2] / 2])
    start, along = own @ (EYE - middle), rays @ own.T
    with np.errstate(divide="ignore"):
        near, far = ((sign * np.array(box.size) / 2 - start) / along for sign in (-1, 1))
    first, last = np.minimum(near, far).max(-1), np.maximum(near, far).min(-1)
    return np.where(first < last, first, np.inf)
