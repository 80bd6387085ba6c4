"""Curiosity by entropy, as the paper has it (Algorithm 1)."""

from collections.abc import Sequence

import numpy as np
from torch import Tensor

from neurosym.arrays import Float
from neurosym.exploration.curiosity import Curiosity
from neurosym.learning.effect_model import EffectModel
from neurosym.learning.losses import total_loss


class Entropy(Curiosity):
    """The paper's network: the more entropy in the predicted effect, the less is known (Algorithm 1)."""

    networks: Sequence[EffectModel]

    def uncertainties(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Compute the entropy of the predicted effect, averaged over the axes (lines 5-9)."""
        return self.networks[0].mean_entropies(features, candidates)

    def expected_sizes(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Predict the sum of absolute displacements that each candidate leads to [m]."""
        means, _ = self.networks[0].predict(np.tile(features, (len(candidates), 1)), candidates)
        return np.asarray(np.abs(means).sum(1))

    def loss(self, network: EffectModel, features: Tensor, actions: Tensor, effects: Tensor) -> Tensor:
        """Compute eq. 9."""
        config = self.config
        coefficient, temperature = config.loss_coefficient, config.temperature
        return total_loss(
            network, features, actions, effects, coefficient=coefficient, temperature=temperature
        )
