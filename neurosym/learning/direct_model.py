"""A network without a bottleneck: from object and action straight to the effect.

It has no symbols to tell. It serves as the yardstick of what the data can teach, as the teacher of the bits,
and, several at once, as a measure of what is not known yet: where they disagree.
"""

import numpy as np
import torch
from torch import Tensor, nn

from neurosym.arrays import Float
from neurosym.data.dimensions import Dimensions
from neurosym.learning.inputs import InputNorm, with_gripper_states
from neurosym.learning.model_config import DirectConfig
from neurosym.learning.network import EffectNetwork, hidden_layers, inference, tensor


class DirectModel(EffectNetwork):
    """Predicts the effect of an action on an object.

    Args:
        dimensions: What the network reads and writes.
        config: How it is built.
    """

    FORMAT = "neurosym-direct-model-2"
    CONFIG = DirectConfig
    config: DirectConfig

    def __init__(self, dimensions: Dimensions, config: DirectConfig):
        outputs = dimensions.effects + config.peaks
        super().__init__(dimensions, config, outputs)
        inputs = dimensions.features + dimensions.actions
        layers = hidden_layers(inputs, config.hidden, config.dropout)
        columns = dimensions.gripper_columns if config.gripper_sharpness is not None else ()
        norm = InputNorm(inputs, [dimensions.features + column for column in columns])
        self.layers = nn.Sequential(norm, *layers, nn.Linear(config.hidden, outputs))

    def forward(self, features: Float[Tensor, "B F"], actions: Float[Tensor, "B A"]) -> Float[Tensor, "B O"]:
        """Predict the effect, and the peak height behind it if `config.peaks`; all standardised."""
        dimensions = self.dimensions
        actions = with_gripper_states(actions, dimensions.gripper_columns, self.config.gripper_sharpness)
        outputs: Tensor = self.layers(torch.cat([features, actions], dim=1))
        return outputs

    def standard_effects(
        self, features: Float[Tensor, "B F"], actions: Float[Tensor, "B A"]
    ) -> Float[Tensor, "B E"]:
        """Predict the standardised effect."""
        effects: Tensor = self(features, actions)[:, : self.dimensions.effects]
        return effects

    def effects(self, features: Float[Tensor, "B F"], actions: Float[Tensor, "B A"]) -> Float[Tensor, "B E"]:
        """Predict the effect [m]."""
        axes = self.dimensions.effects
        effects: Tensor = (
            self.standard_effects(features, actions) * self.effect_std[:axes] + self.effect_mean[:axes]
        )
        return effects

    def predict(
        self, features: Float[np.ndarray, "N F"], actions: Float[np.ndarray, "N A"]
    ) -> Float[np.ndarray, "N E"]:
        """Predict effects [m]."""
        return self.predict_outcomes(features, actions)[:, : self.dimensions.effects]

    def predict_outcomes(
        self, features: Float[np.ndarray, "N F"], actions: Float[np.ndarray, "N A"]
    ) -> Float[np.ndarray, "N O"]:
        """Predict effects, and peak heights behind them if `config.peaks` [m]."""
        with inference(self):
            mean = self(tensor(features), tensor(actions))
            outcomes: np.ndarray = (mean * self.effect_std + self.effect_mean).numpy()
        return outcomes
