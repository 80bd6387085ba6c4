"""Scenes drawn at random: objects of every shape and size, at rest and apart from one another."""

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import SHAPES
from neurosym.world import Scene

ROOMY = 2
"""So many objects, or fewer, keep `spawn_margin` from the table's edge, so that pushes do not lose them."""
_DRAWS = 50  # of objects, if their places cannot be found
_ATTEMPTS = 400  # to find places for given objects


def sample_scene(config: TabletopConfig, rng: np.random.Generator, objects: int) -> Scene:
    """Draw objects of random shape and size at rest on the table, not overlapping.

    Objects that find no place are drawn again, so that crowded scenes have somewhat smaller ones.

    Args:
        config: The world.
        rng: Source of randomness, owned by the caller.
        objects: How many objects.

    Raises:
        InvalidValue: If there are none, or so many do not fit.
    """
    if objects < 1:
        raise InvalidValue(f"A scene needs at least one object, not {objects}.")
    for _ in range(_DRAWS):
        features = sample_features(config, rng, objects)
        places = _sample_places(config, rng, features[:, :2] / 2)
        if places is not None:
            return Scene(
                features=features,
                positions=np.column_stack([places, features[:, 2] / 2]),
                orientations=np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1)),
            )
    raise InvalidValue(f"{objects} objects do not fit on the table; ask for fewer.")


def sample_features(
    config: TabletopConfig, rng: np.random.Generator, objects: int
) -> Float[np.ndarray, "{objects} 4"]:
    """Draw what the objects are: s_x, s_y, d [m] and t.

    Args:
        config: The world.
        rng: Source of randomness, owned by the caller.
        objects: How many objects.
    """
    names = list(config.shapes)
    shares = np.array([config.shapes[name] for name in names])
    drawn = rng.choice(len(names), size=objects, p=shares / shares.sum())
    return np.array([SHAPES[names[shape]](rng, config.size, config.height) for shape in drawn])


def _sample_places(
    config: TabletopConfig, rng: np.random.Generator, half_sizes: Float[np.ndarray, "M 2"]
) -> Float[np.ndarray, "M 2"] | None:
    """Find a place for each object, largest first; None if one finds none."""
    low = np.array([config.table_x[0], config.table_y[0]])
    high = np.array([config.table_x[1], config.table_y[1]])
    margins = np.maximum(half_sizes, config.spawn_margin if len(half_sizes) <= ROOMY else 0.0)
    order = np.argsort(-half_sizes.prod(axis=1), kind="stable")
    places = np.zeros_like(half_sizes)
    for number, index in enumerate(order):
        placed = order[:number]
        candidates = rng.uniform(low + margins[index], high - margins[index], size=(_ATTEMPTS, 2))
        apart = np.abs(candidates[:, None] - places[placed]) - (half_sizes[placed] + half_sizes[index])
        clear = (apart.max(axis=-1) >= config.spawn_gap).all(axis=-1)  # (_ATTEMPTS,)
        if not clear.any():
            return None
        places[index] = candidates[np.argmax(clear)]
    return places
