"""Spots: places whose names say where they lie, as `spot-5500-m1200` for x = 0.55 m and y = -0.12 m.

A problem has few places of its own, and plans may need others. Any problem knows a spot by its name.
"""

import re

PER_METRE = 10_000
"""Names count tenths of a millimetre."""
SPOT = re.compile(r"spot-(m?\d{1,6})-(m?\d{1,6})")
"""What spots are called; `m` is for minus, which PDDL does not know."""


def spot_name(x: float, y: float) -> str:
    """Return the name of the spot that is nearest.

    Args:
        x: Where it lies [m].
        y: The same for the other axis [m].
    """
    return "-".join(["spot", *(_word(round(value * PER_METRE)) for value in (x, y))])


def spot_named(name: str) -> tuple[float, float] | None:
    """Return where a spot lies [m], or None if the name is not that of a spot.

    Args:
        name: The name of a place.
    """
    found = SPOT.fullmatch(name)
    if found is None:
        return None
    x, y = (int(word.replace("m", "-")) / PER_METRE for word in found.groups())
    return x, y


def _word(count: int) -> str:
    return f"m{-count}" if count < 0 else str(count)
