"""Appearance: what an object shows to the robot once it was turned, and which category that is.

What was learned holds for objects that stand straight. One that was turned by a quarter has its sizes along
other axes; one that stands askew is as wide as the box around it.
"""

import math

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.pair_states import rotation
from neurosym.problems import SceneObject

STRAIGHT = math.radians(15)
"""An object that is turned by less than this beyond a quarter counts as straight [rad]."""


def as_it_shows(item: SceneObject, grounding: Grounding) -> SceneObject:
    """Return an object with the sizes that it has along the axes, and the category of objects like that.

    Args:
        item: The object as it lies; its first three features are its sizes along x, y and z [m].
        grounding: The learned domain; where it keeps no rehearsals, the category stays.
    """
    turned = _turned(item.orientation)
    if np.array_equal(turned, np.eye(3)):
        return item
    sizes = np.array(item.features[:3])
    shown = tuple(round(size, 6) for size in (turned @ sizes).tolist())
    features = (*shown, *item.features[3:])
    category = _category_like(features, grounding) or item.category
    return msgspec.structs.replace(item, features=features, category=category)


def _turned(orientation: tuple[float, float, float, float]) -> Float[np.ndarray, "3 3"]:
    """Return what each size adds to what shows along x, y and z; one to each if the object is straight."""
    along = np.abs(rotation(np.array(orientation)))
    straight = along > math.cos(STRAIGHT)
    return np.asarray(straight.astype(float) if straight.sum() == 3 else along)


def _category_like(features: tuple[float, ...], grounding: Grounding) -> str | None:
    """Name the category of the rehearsed object that is most like one of these features."""
    rehearsed = [(objects, one.symbol) for one in grounding.operators.categories for objects in one.objects]
    if not rehearsed:
        return None
    objects = np.array([row for row, _ in rehearsed])
    apart = (objects - features) / np.maximum(objects.std(0), 1e-9)
    return rehearsed[int(np.argmin((apart**2).sum(1)))][1]
