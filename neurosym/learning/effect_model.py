"""The paper's effect model: two encoders, a bottleneck that becomes symbols, and a decoder.

Object features and action parameters are encoded separately into embeddings in [-1, 1]; the signs of the
embeddings are the symbols (eq. 2). A decoder turns the concatenated embeddings into a Gaussian over the
effect (eq. 3). Lengths go in and come out in metres; inside, effects are standardised, since with effects in
metres the printed training regime moves nothing.
"""

from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor, nn

from neurosym.arrays import Float
from neurosym.checks import check_array
from neurosym.data.dimensions import Dimensions
from neurosym.learning.inputs import InputNorm, with_gripper_states
from neurosym.learning.model_config import ModelConfig
from neurosym.learning.network import EffectNetwork, hidden_layers, inference, tensor
from neurosym.symbols import Symbol, binarize, signs

LOG_VARIANCE_FLOOR = -5.0
"""Least log variance, of standardised effects; without it the NLL diverges."""


class EffectModel(EffectNetwork):
    """Predicts the effect of an action on an object, through symbols.

    Args:
        dimensions: What the network reads and writes.
        config: How it is built.
    """

    FORMAT = "neurosym-effect-model-3"
    CONFIG = ModelConfig
    config: ModelConfig

    def __init__(self, dimensions: Dimensions, config: ModelConfig):
        super().__init__(dimensions, config)
        bits = config.object_bits + config.action_bits
        outputs = dimensions.effects * (2 if config.head == "gaussian" else 1)
        states = dimensions.gripper_columns if config.gripper_sharpness is not None else ()
        self.object_encoder = _encoder(InputNorm(dimensions.features, ()), config.object_bits, config)
        self.action_encoder = _encoder(InputNorm(dimensions.actions, states), config.action_bits, config)
        self.norm = nn.LayerNorm(bits) if config.layer_norm else nn.Identity()
        layers = hidden_layers(bits, config.hidden, config.dropout)
        self.decoder = nn.Sequential(*layers, nn.Linear(config.hidden, outputs))

    def embed_objects(self, features: Float[Tensor, "B F"]) -> Float[Tensor, "B Ko"]:
        """Encode objects into embeddings in [-1, 1]."""
        embeddings: Tensor = self.object_encoder(features)
        return embeddings

    def embed_actions(self, actions: Float[Tensor, "B A"]) -> Float[Tensor, "B Ka"]:
        """Encode actions into embeddings in [-1, 1]; differentiable in the actions."""
        columns = self.dimensions.gripper_columns
        actions = with_gripper_states(actions, columns, self.config.gripper_sharpness)
        embeddings: Tensor = self.action_encoder(actions)
        return embeddings

    def decode(
        self, object_embeddings: Float[Tensor, "B Ko"], action_embeddings: Float[Tensor, "B Ka"]
    ) -> tuple[Float[Tensor, "B E"], Float[Tensor, "B E"]]:
        """Predict mean and log variance of the standardised effect (eq. 3).

        With the "mean" head the log variance is minus infinity.
        """
        output = self.decoder(self.norm(torch.cat([object_embeddings, action_embeddings], dim=1)))
        if self.config.head == "mean":
            return output, torch.full_like(output, -torch.inf)
        mean, raw = output.chunk(2, dim=1)
        return mean, LOG_VARIANCE_FLOOR + nn.functional.softplus(raw - LOG_VARIANCE_FLOOR)

    def forward(
        self, features: Float[Tensor, "B F"], actions: Float[Tensor, "B A"]
    ) -> tuple[Float[Tensor, "B E"], Float[Tensor, "B E"]]:
        """Predict mean and log variance of the standardised effect from what is observed."""
        return self.decode(self.embed_objects(features), self.embed_actions(actions))

    def object_codes(self, features: Float[np.ndarray, "N F"]) -> Float[np.ndarray, "N Ko"]:
        """Encode objects into embeddings, whose signs are the bits of their symbols.

        Raises:
            InvalidValue: If they have not as many features as the network reads.
        """
        check_array("features", features, (None, self.dimensions.features))
        with inference(self):
            return self.embed_objects(tensor(features)).numpy()

    def object_margins(self, features: Float[np.ndarray, "N F"]) -> Float[np.ndarray, "N Ko"]:
        """Return what the embeddings of objects are before they are squashed into [-1, 1].

        The signs are the bits. How far a value is from 0 says how far a bit is from its flip, even where the
        embedding itself is 1 or -1 already.

        Raises:
            InvalidValue: If they have not as many features as the network reads.
        """
        check_array("features", features, (None, self.dimensions.features))
        with inference(self):
            margins: np.ndarray = self.object_encoder[:-1](tensor(features)).numpy()
        return margins

    def action_codes(self, actions: Float[np.ndarray, "N A"]) -> Float[np.ndarray, "N Ka"]:
        """Encode actions into embeddings, whose signs are the bits of their symbols.

        Raises:
            InvalidValue: If they have not as many parameters as the network reads.
        """
        check_array("actions", actions, (None, self.dimensions.actions))
        with inference(self):
            return self.embed_actions(tensor(actions)).numpy()

    def object_symbols(self, features: Float[np.ndarray, "N F"]) -> tuple[Symbol, ...]:
        """Name the category of each object."""
        return binarize(self.object_codes(features))

    def action_symbols(self, actions: Float[np.ndarray, "N A"]) -> tuple[Symbol, ...]:
        """Name the symbol of each action."""
        return binarize(self.action_codes(actions))

    def predict(
        self, features: Float[np.ndarray, "N F"], actions: Float[np.ndarray, "N A"]
    ) -> tuple[Float[np.ndarray, "N E"], Float[np.ndarray, "N E"]]:
        """Predict mean [m] and variance [m^2] of the effect; the "mean" head has no variance (zero)."""
        with inference(self):
            return self._in_metres(*self(tensor(features), tensor(actions)))

    def predict_from_codes(
        self, features: Float[np.ndarray, "N F"], actions: Float[np.ndarray, "N A"]
    ) -> tuple[Float[np.ndarray, "N E"], Float[np.ndarray, "N E"]]:
        """Predict like `predict`, but let only the bits of the symbols through (+-1)."""
        with inference(self):
            objects = as_signs(self.embed_objects(tensor(features)))
            chosen = as_signs(self.embed_actions(tensor(actions)))
            return self._in_metres(*self.decode(objects, chosen))

    def branching_table(
        self, features: Float[np.ndarray, "M F"], primitives: Sequence[Symbol]
    ) -> Float[np.ndarray, "M P E"]:
        """Predict what each primitive does to each object, through the symbols alone [m].

        Args:
            features: Features of the objects in a scene.
            primitives: Symbols of the primitives.
        """
        chosen = tensor(np.array([signs(symbol) for symbol in primitives]))  # (P, Ka)
        with inference(self):
            objects = as_signs(self.embed_objects(tensor(features)))  # (M, Ko)
            mean, _ = self.decode(
                objects.repeat_interleave(len(chosen), 0), chosen.repeat(len(objects), 1)
            )  # (M * P, E)
            table: np.ndarray = (mean * self.effect_std + self.effect_mean).numpy()
        return table.reshape(len(features), len(primitives), -1)

    def mean_entropies(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Compute the entropy of the predicted effect, averaged over the axes (Algorithm 1, lines 5-9).

        Args:
            features: Features of the one object.
            candidates: Actions that could be performed on it.
        """
        with inference(self):
            chosen = self.embed_actions(tensor(candidates))
            objects = self.embed_objects(tensor(features[None])).expand(len(chosen), -1)
            _, log_variance = self.decode(objects, chosen)
            entropies = 0.5 * (np.log(2 * np.pi * np.e) + log_variance) + self.effect_std.log()
            mean: np.ndarray = entropies.mean(1).numpy()
        return mean

    def _in_metres(self, mean: Tensor, log_variance: Tensor) -> tuple[np.ndarray, np.ndarray]:
        variance = log_variance.exp() * self.effect_std**2
        return (mean * self.effect_std + self.effect_mean).numpy(), variance.numpy()


def as_signs(embeddings: Float[Tensor, "B K"]) -> Float[Tensor, "B K"]:
    """Write the bits of embeddings in tanh's range: +1 where the value is > 0, else -1 (eq. 2)."""
    return torch.where(embeddings > 0, 1.0, -1.0)


def _encoder(norm: InputNorm, bits: int, config: ModelConfig) -> nn.Sequential:
    layers = hidden_layers(norm.num_features, config.hidden, config.dropout)
    return nn.Sequential(norm, *layers, nn.Linear(config.hidden, bits), nn.Tanh())
