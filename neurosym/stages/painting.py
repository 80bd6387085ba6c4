"""The world of a domain folder as pictures show it: each object in the colour of its category."""

from functools import partial
from pathlib import Path

import numpy as np

from neurosym.checks import Float, UInt8
from neurosym.errors import NeurosymError
from neurosym.grounding import Grounding
from neurosym.stages.layout import GROUNDING, MODEL
from neurosym.world import OTHER, Painted, Palette, World
from neurosym.worlds.world_file import read_world


def painted_world(path: Path) -> World:
    """Make a world whose pictures show objects in the colours of their categories, once these are learned.

    Args:
        path: A `world.toml`, beside the network and the grounding; these are read with each picture.
    """
    world, learned = read_world(path)(), (path.parent / MODEL, path.parent / GROUNDING)
    if isinstance(world, Painted) and all(file.is_file() for file in learned):
        world.painter = partial(_paint, *learned)
    return world


def _paint(model: Path, grounding: Path, features: Float[np.ndarray, "M F"]) -> UInt8[np.ndarray, "M 3"]:
    """Give objects the colours of their categories in a domain folder; grey if these cannot be known."""
    from neurosym.learning.network import EffectModel

    try:
        palette = Palette.of(Grounding.load(grounding).objects.categories)
        return palette.of_all(EffectModel.load(model).object_symbols(features))
    except NeurosymError:
        return np.tile(np.array(OTHER, dtype=np.uint8), (len(features), 1))
