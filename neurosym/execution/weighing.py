"""Weighing what was promised against what was seen, each by how sure it is."""

import math

import msgspec
import numpy as np

from neurosym.operators import Mode, Vector, vector
from neurosym.world import Outcome

REPEATS = 0.014
"""By how much the same primitive on the same object differs from time to time, RMS of an axis [m]."""
_SUREST = 0.005  # no promise is surer than this [m]


def mean_of(rows: list[np.ndarray]) -> Vector:
    """Return the mean of some vectors.

    Args:
        rows: The vectors.
    """
    return vector(np.mean(rows, axis=0))


def miss_of(mode: Mode, outcome: Outcome) -> float:
    """Return how far an outcome was from what a mode promises [m].

    Args:
        mode: What was promised.
        outcome: What came.
    """
    seen = outcome.effect if mode.kind == "held" else outcome.resting_effect
    return math.dist(mode.outcome, seen)


def combined(mode: Mode, outcomes: list[Outcome]) -> Mode:
    """Weigh what a mode promised against what was seen, each by how sure it is.

    Args:
        mode: What was promised.
        outcomes: What came.
    """
    effect, spread = _weighed(mode.effect, mode.spread, np.array([one.effect for one in outcomes]))
    seen = np.array([one.resting_effect for one in outcomes])
    resting, resting_spread = _weighed(mode.resting_effect, mode.resting_spread, seen)
    return msgspec.structs.replace(
        mode, effect=effect, spread=spread, resting_effect=resting, resting_spread=resting_spread
    )


def _weighed(mean: tuple[float, ...], spread: tuple[float, ...], seen: np.ndarray) -> tuple[Vector, Vector]:
    """Weigh a mean against what was seen; it was less sure than it said if what was seen is far from it."""
    away = np.abs(seen.mean(0) - mean)
    before = 1 / np.maximum(np.maximum(np.array(spread), away), _SUREST) ** 2
    now = len(seen) / REPEATS**2
    value = (before * np.array(mean) + now * seen.mean(0)) / (before + now)
    return vector(value), vector(np.sqrt(1 / (before + now)))
