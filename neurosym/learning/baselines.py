"""What predictors achieve that look at nothing: every table of errors shows them beside the model."""

import numpy as np

from neurosym.arrays import Float

TEST_ROWS = 2400
"""Interactions of a test set that are used: the first ones with a high effect, as many as the paper's."""


def trivial_predictions(
    seen: Float[np.ndarray, "N E"], count: int
) -> dict[str, Float[np.ndarray, "{count} E"]]:
    """Predict effects without looking at objects and actions [m].

    Args:
        seen: The effects that were learned from.
        count: How many predictions.
    """
    shape = (count, seen.shape[1])
    return {
        "always zero": np.zeros(shape),
        "always mean": np.broadcast_to(seen.mean(0), shape),
        "per-axis median": np.broadcast_to(np.median(seen, axis=0), shape),
    }
