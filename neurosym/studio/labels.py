"""Where labels stand such that they do not cover each other."""

from collections.abc import Mapping

ABOVE = 0.03
"""How far above its object a label stands at least [m]."""
WIDTH, HEIGHT = 0.16, 0.035
"""About how much room a label takes, as seen from the front of the table [m]."""


def label_heights(spots: Mapping[str, tuple[tuple[float, float, float], float]]) -> dict[str, float]:
    """Return how high the labels of objects stand [m]: the farther ones give way upwards.

    Args:
        spots: Centre and height of each object [m], by name.
    """
    placed: list[tuple[float, float]] = []
    heights = {}
    for name, ((x, y, z), size) in sorted(spots.items(), key=lambda item: (item[1][0][0], item[0])):
        height = z + size / 2 + ABOVE
        seen = _seen(x, height)
        while clash := [
            other for side, other in placed if abs(side - y) < WIDTH and abs(other - seen) < HEIGHT
        ]:
            height += max(clash) + HEIGHT - seen + 1e-6
            seen = _seen(x, height)
        placed.append((y, seen))
        heights[name] = height
    return heights


def _seen(x: float, height: float) -> float:
    """Return how high something stands in the picture: what is farther away stands higher, too."""
    return height + 0.7 * x
