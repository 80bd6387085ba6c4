"""Strategies of exploration: which candidate action to try next, and what the model learns from.

`entropy`, also called `curiosity`, is the paper's (Algorithm 1): try what a Gaussian is least certain of. It
is caught by what cannot be learned, such as whether a grasp will hold by a hair. `disagreement` asks several
networks, and the more they disagree about an action, the likelier it is tried (Pathak, Gandhi and Gupta,
2019): they come to agree about noise. `random` and `active` are the paper's baselines, which predict the
effect itself and not a distribution over it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.choices import DEFAULT_STRATEGY as DEFAULT_STRATEGY
from neurosym.choices import StrategyName as StrategyName
from neurosym.errors import InvalidValue, UnknownChoice

MIN_EFFECT = 0.08
"""Least sum of absolute displacements of a high effect [m]."""


@dataclass(frozen=True, slots=True)
class Strategy:
    """A way to explore, and to learn from it.

    Attributes:
        curious_about: What it looks for in the candidate actions; None takes a random one.
        head: What the final model predicts.
        learns_from: Says which interactions a model is trained on, from their effects (N, E) [m].
    """

    curious_about: Literal["entropy", "disagreement"] | None
    head: Literal["gaussian", "mean"]
    learns_from: Callable[[np.ndarray], np.ndarray]


def has_high_effect(effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
    """Say which effects have a sum of absolute displacements of at least `MIN_EFFECT`."""
    return np.asarray(np.abs(effects).sum(1) >= MIN_EFFECT)


def is_any(effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
    """Say yes to every effect."""
    return np.ones(len(effects), dtype=bool)


_ALIASES = {"curiosity": "entropy"}
STRATEGIES = {
    "disagreement": Strategy("disagreement", "gaussian", is_any),
    "entropy": Strategy("entropy", "gaussian", is_any),
    "random": Strategy(None, "mean", is_any),
    "active": Strategy(None, "mean", has_high_effect),
}


def own_name(name: str) -> str:
    """Return what a strategy is called, if it was called by another name.

    Args:
        name: One of `STRATEGIES`, or another name of one; any other is returned as it is.
    """
    return _ALIASES.get(name, name)


def strategy_named(name: str, min_predicted_effect: float = 0.0) -> Strategy:
    """Return a strategy.

    Args:
        name: One of `STRATEGIES`.
        min_predicted_effect: What it shall filter its candidates by [m]; 0 for no filter.

    Raises:
        UnknownChoice: If there is no such strategy.
        InvalidValue: If candidates cannot be filtered so.
    """
    name = own_name(name)
    if name not in STRATEGIES:
        raise UnknownChoice("strategy", name, STRATEGIES)
    if not 0 <= min_predicted_effect < np.inf:
        raise InvalidValue(f"min-predicted-effect = {min_predicted_effect} m must be at least 0.")
    if min_predicted_effect > 0 and not STRATEGIES[name].curious_about:
        curious = ", ".join(sorted(known for known in STRATEGIES if STRATEGIES[known].curious_about))
        raise InvalidValue(
            f"The strategy {name} predicts no effect that min-predicted-effect could compare; "
            f"valid with it: {curious}."
        )
    return STRATEGIES[name]
