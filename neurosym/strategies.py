"""Strategies of exploration: which candidate action to try next, and what the model learns from.

`curiosity` is the paper's (Algorithm 1). The other two are its baselines, which predict the effect itself and
not a distribution over it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, Protocol, runtime_checkable

import numpy as np
from jaxtyping import Bool, Float

MIN_EFFECT = 0.08
"""Least sum of absolute displacements of a high effect [m]."""


@runtime_checkable
class Uncertain(Protocol):
    """A model that knows how uncertain it is."""

    def mean_entropies(
        self, features: Float[np.ndarray, "F"], actions: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Compute the entropy of the predicted effect of each action, mean over the axes."""
        ...


Choose = Callable[[Uncertain, np.ndarray, np.ndarray], int]
"""Chooses among candidates: (model, features (F,), candidates (C, A)) -> index."""


@dataclass(frozen=True, slots=True)
class Strategy:
    """A way to explore.

    Attributes:
        choose: Chooses one of the candidate actions.
        head: What the model predicts.
        learns_from: Says which interactions the model is trained on, from their effects (N, E) [m].
    """

    choose: Choose
    head: Literal["gaussian", "mean"]
    learns_from: Callable[[np.ndarray], np.ndarray]


def most_uncertain(
    model: Uncertain, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
) -> int:
    """Choose the candidate of the highest mean entropy (Algorithm 1, line 11)."""
    return int(np.argmax(model.mean_entropies(features, candidates)))


def first(
    model: Uncertain,  # noqa: ARG001 (one signature for all)
    features: Float[np.ndarray, "F"],  # noqa: ARG001
    candidates: Float[np.ndarray, "C A"],  # noqa: ARG001
) -> int:
    """Choose the first candidate: a random action."""
    return 0


def has_high_effect(effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
    """Say which effects have a sum of absolute displacements of at least `MIN_EFFECT`."""
    return np.asarray(np.abs(effects).sum(1) >= MIN_EFFECT)


def is_any(effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
    """Say yes to every effect."""
    return np.ones(len(effects), dtype=bool)


STRATEGIES = {
    "curiosity": Strategy(most_uncertain, "gaussian", is_any),
    "random": Strategy(first, "mean", is_any),
    "active": Strategy(first, "mean", has_high_effect),
}
