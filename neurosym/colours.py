"""Colours, each for one meaning wherever it is seen: categories of objects, in pictures, pages and films."""

from collections.abc import Iterable, Sequence
from itertools import cycle, islice
from typing import Any, Protocol, runtime_checkable

import numpy as np

from neurosym.checks import Float, UInt8

Colour = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""
CATEGORY_COLOURS: tuple[Colour, ...] = (
    (0, 201, 158), (131, 29, 42), (174, 104, 236), (110, 0, 172),
    (66, 122, 115), (213, 231, 52), (255, 197, 253), (223, 84, 20),
)  # fmt: skip
"""Mint, maroon, lilac, purple, slate, lime, pink, orange: told apart under all three colour blindnesses."""
OTHER: Colour = (138, 138, 138)
"""Of rarer categories than there are colours, and of objects whose category nobody knows."""
NEUTRAL: tuple[Colour, ...] = ((112, 104, 94), (236, 233, 228), (78, 76, 74), (168, 158, 144))
"""Greys and beiges of objects, one after another, where a world is asked for no categories."""


class Palette:
    """The colours of the categories of a domain.

    Args:
        symbols: The object symbols, most frequent first; those beyond the eighth are all `OTHER`.
    """

    def __init__(self, symbols: Iterable[str] = ()):
        self._colours = dict(zip(dict.fromkeys(symbols), CATEGORY_COLOURS, strict=False))

    @classmethod
    def of(cls, categories: Iterable[Any]) -> "Palette":
        """Return the palette of categories, which have a `symbol` and a `share` of the objects."""
        ranked = sorted(categories, key=lambda one: (-one.share, one.symbol))
        return cls(one.symbol for one in ranked)

    def __call__(self, symbol: str) -> Colour:
        """Return the colour of an object symbol."""
        return self._colours.get(symbol, OTHER)

    def hex(self, symbol: str) -> str:
        """Return the colour of an object symbol as a page writes it: `#00c99e`."""
        return "#{:02x}{:02x}{:02x}".format(*self(symbol))

    def of_all(self, symbols: Sequence[str]) -> UInt8[np.ndarray, "M 3"]:
        """Return the colours of several object symbols."""
        return np.array([self(one) for one in symbols], dtype=np.uint8).reshape(-1, 3)


@runtime_checkable
class Painted(Protocol):
    """A world whose pictures can show objects in given colours.

    Attributes:
        painter: Gives the colours, 0 to 255, of objects with such features; None for the world's own.
    """

    painter: "Painter | None"


class Painter(Protocol):
    """Gives the colours of objects by their features."""

    def __call__(self, features: Float[np.ndarray, "M F"]) -> UInt8[np.ndarray, "M 3"]:
        """Return the colour of each object."""
        ...


def painted(painter: Painter | None, features: Float[np.ndarray, "M F"]) -> UInt8[np.ndarray, "M 3"]:
    """Return the colours of objects as a painter gives them, or neutral ones by their number."""
    if painter:
        return painter(features)
    return np.array([*islice(cycle(NEUTRAL), len(features))], dtype=np.uint8).reshape(-1, 3)
