"""Sampling by category: objects as the world draws them, and enough of each category, rare ones included."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from neurosym.symbols import Categorise, Symbol, all_symbols, symbols_of
from neurosym.world import Scene, World

MOST_DRAWS = 60
"""How many objects are drawn at most for each one that a category shall have."""


@dataclass(frozen=True, slots=True, eq=False)
class Sample:
    """Objects of each category.

    Attributes:
        scenes: For each category that was met, scenes of one object each, in the order of symbols.
        shares: Share of each of these categories among all objects that were drawn.
    """

    scenes: Mapping[Symbol, tuple[Scene, ...]]
    shares: Mapping[Symbol, float]


def draw_scene(world: World, seed: int, stream: int, number: int) -> Scene:
    """Draw one of the objects of a stream.

    Args:
        world: Where it comes from.
        seed: Where all draws start.
        stream: Keeps the draws of one purpose apart from those of another.
        number: Of the object, counted from 0.
    """
    return world.sample_scene(np.random.default_rng([seed, stream, number]), 1)


def sample_by_category(
    world: World, categorise: Categorise, *, least: int, typical: int = 0, seed: int, stream: int
) -> Sample:
    """Draw objects one after the other, and keep of each category the first that fall into it.

    A category so rare that `MOST_DRAWS` times as many draws hold fewer of it has those that were found.

    Args:
        world: Where they come from.
        categorise: Gives the object symbols of features.
        least: How many objects a category shall have.
        typical: A category has as many as there are of it among the first so many draws, if that is more.
        seed: Where all draws start.
        stream: Keeps the draws of one purpose apart from those of another.
    """
    drawn: list[Scene] = []
    symbols: list[Symbol] = []
    first = max(least, typical)
    while not drawn or (len(drawn) < MOST_DRAWS * least and _lacks(symbols, least)):
        numbers = range(len(drawn), len(drawn) + (least if drawn else first))
        scenes = [draw_scene(world, seed, stream, number) for number in numbers]
        symbols += symbols_of(categorise, np.concatenate([scene.features for scene in scenes]))
        drawn += scenes
    kept = {}
    for symbol in sorted(set(symbols)):
        members = [scene for scene, found in zip(drawn, symbols, strict=True) if found == symbol]
        kept[symbol] = tuple(members[: max(least, symbols[:typical].count(symbol))])
    return Sample(kept, {symbol: symbols.count(symbol) / len(symbols) for symbol in kept})


def _lacks(symbols: list[Symbol], least: int) -> bool:
    """Say whether there is a code that too few of the objects have."""
    return any(symbols.count(code) < least for code in all_symbols(len(symbols[0])))
