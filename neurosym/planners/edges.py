"""The edges of the table, which careful plans keep clear of."""

import msgspec

from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.table import Table

STRIP = 0.04
"""Width of the strip at the edges of the table that is left free if it can be [m]."""


def away_from_edges(grounding: Grounding, problem: Problem) -> Grounding:
    """Leave a strip at the edges of the table free, but for goals there: what goes too far is lost.

    Args:
        grounding: The learned domain.
        problem: The problem.
    """
    spots = [goal[:2] for goal in problem.goals.values()]

    def kept(axis: int, bounds: tuple[float, float]) -> tuple[float, float]:
        low, high = bounds
        strip = min(STRIP, (high - low) / 4)
        wanted = [spot[axis] for spot in spots]
        return max(low, min(low + strip, *wanted)), min(high, max(high - strip, *wanted))

    table = Table(x=kept(0, grounding.table.x), y=kept(1, grounding.table.y))
    return msgspec.structs.replace(grounding, table=table)
