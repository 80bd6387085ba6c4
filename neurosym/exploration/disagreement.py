"""Curiosity by disagreement: what several networks predict differently is not known yet."""

from collections.abc import Sequence

import numpy as np
from torch import Tensor, nn

from neurosym.arrays import Float
from neurosym.exploration.curiosity import Curiosity
from neurosym.learning.direct_model import DirectModel


class Disagreement(Curiosity):
    """Networks without a bottleneck, that differ in how they began: what they disagree about is not known."""

    networks: Sequence[DirectModel]

    def uncertainties(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Compute the variance among the standardised predictions, averaged over the axes."""
        scale = self.networks[0].effect_std.numpy()
        return np.asarray((self._predictions(features, candidates) / scale).var(0).mean(1))

    def pick(self, uncertainties: Float[np.ndarray, "C"], rng: np.random.Generator) -> int:
        """Draw a candidate with a probability in proportion to the disagreement about it.

        Until the networks learn again, the greatest disagreement is always about the same sort of action, of
        which a few would do (Kirsch et al., 2023, Stochastic Batch Acquisition).

        Args:
            uncertainties: The variance of the predictions of each.
            rng: Source of randomness, owned by the caller.
        """
        weights = uncertainties.astype(np.float64)
        total = weights.sum()
        return int(rng.choice(len(weights), p=weights / total if total > 0 else None))

    def expected_sizes(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Predict the sum of absolute displacements that each candidate leads to [m]."""
        return np.asarray(np.abs(self._predictions(features, candidates).mean(0)).sum(1))

    def loss(self, network: DirectModel, features: Tensor, actions: Tensor, effects: Tensor) -> Tensor:
        """Compute the squared error of the standardised effect."""
        targets = (effects - network.effect_mean) / network.effect_std
        return nn.functional.mse_loss(network(features, actions), targets)

    def _predictions(self, features: np.ndarray, candidates: np.ndarray) -> Float[np.ndarray, "R C E"]:
        repeated = np.tile(features, (len(candidates), 1))
        return np.stack([network.predict(repeated, candidates) for network in self.networks])
