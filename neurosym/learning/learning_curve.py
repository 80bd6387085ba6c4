"""The learning curve of a domain folder: how well its interactions are predicted after so many of them."""

from collections.abc import Callable

import msgspec
import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue

FIRST = 512
"""Interactions of the first fit; each further one has twice as many, and the last has all."""
HELD_OUT = 0.1
"""Share of the interactions, equally spaced, that no fit sees and all are measured on."""


class CurvePoint(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What was learned from the first interactions.

    Attributes:
        interactions: How many were learned from.
        r2_through_codes: R2 of the effect through the bits, mean over the axes.
        r2_direct: The same of a network without a bottleneck.
        mae: Mean absolute error through the bits on each axis [m].
    """

    interactions: int
    r2_through_codes: float
    r2_direct: float
    mae: tuple[float, ...]


class LearningCurve(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How well held-out interactions are predicted after so many others.

    Attributes:
        held_out: How many interactions it was measured on.
        regime: How each fit was made.
        points: A fit for each number of interactions.
    """

    held_out: int
    regime: str
    points: tuple[CurvePoint, ...]


def learning_curve(
    interactions: Interactions,
    *,
    seed: int = 0,
    regime: str = "quick",
    progress: Callable[[int, int], None] | None = None,
) -> LearningCurve:
    """Fit the effect model to the first 512, 1024, ... interactions, and measure each on the same others.

    Args:
        interactions: The data, in the order of exploration.
        seed: Where all draws start.
        regime: Network and training.
        progress: Called with the number of fits that are made and of those wanted.

    Raises:
        InvalidValue: If there are too few interactions for two fits.
    """
    from neurosym.learning.training import assess, train
    from neurosym.learning.training_config import REGIMES

    if len(interactions) < 2 * FIRST:
        raise InvalidValue(
            f"{len(interactions)} interactions are too few for a learning curve; valid: {2 * FIRST} or more."
        )
    is_held_out = np.zeros(len(interactions), dtype=bool)
    is_held_out[:: round(1 / HELD_OUT)] = True
    seen, held_out = interactions[~is_held_out], interactions[is_held_out]
    chosen, points, sizes = REGIMES[regime], [], sizes_up_to(len(seen))
    for number, size in enumerate(sizes, 1):
        first = seen[:size]
        trained = train(first, config=chosen.training, model_config=chosen.model, seed=seed)
        report = assess(trained.model, trained.direct, first, held_out)
        points.append(CurvePoint(size, report.r2_through_codes, report.r2_direct, tuple(report.mae["model"])))
        if progress:
            progress(number, len(sizes))
    return LearningCurve(len(held_out), regime, tuple(points))


def sizes_up_to(count: int) -> tuple[int, ...]:
    """List how many interactions are learned from: 512, 1024, ..., and all."""
    doubled = [FIRST * 2**power for power in range(32) if FIRST * 2**power < 0.75 * count]
    return (*doubled, count)
