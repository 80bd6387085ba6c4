"""What all networks that predict effects share: layers, standardised effects, and their file."""

import itertools
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any, ClassVar, TypeVar

import msgspec
import numpy as np
import torch
from torch import Tensor, nn

from neurosym import choices
from neurosym.checks import Float, check_array
from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.learning.training_config import DirectConfig, ModelConfig
from neurosym.operators import Symbol, signs
from neurosym.world import Mirror

Network = TypeVar("Network", bound="EffectNetwork")

_MISFITS = KeyError, TypeError, ValueError, ArithmeticError, RuntimeError, InvalidValue
"""What is raised where a description is foreign, or weights do not fit it."""


class EffectNetwork(nn.Module):
    """A network that predicts effects; lengths go in and come out in metres.

    Args:
        dimensions: What the network reads and writes.
        config: How it is built.
        outputs: How many numbers it predicts, the effect axes first; just these if not given.
    """

    FORMAT: ClassVar[str]
    CONFIG: ClassVar[type[ModelConfig] | type[DirectConfig]]
    effect_mean: Tensor
    effect_std: Tensor
    trained_by: dict[str, Any]  # what made the weights, as plain JSON values; stored in the file

    def __init__(
        self, dimensions: Dimensions, config: ModelConfig | DirectConfig, outputs: int | None = None
    ):
        super().__init__()
        outputs = outputs or dimensions.effects
        self.dimensions = dimensions
        self.config = config
        self.trained_by = {}
        self.register_buffer("effect_mean", torch.zeros(outputs))
        self.register_buffer("effect_std", torch.ones(outputs))

    def set_scale(self, effects: Float[Tensor, "N E"], mirrored: tuple[int, ...] = ()) -> None:
        """Standardise effects by mean and standard deviation of these, together with their mirror images."""
        mean = effects.mean(0)
        mean[list(mirrored)] = 0.0
        self.effect_mean.copy_(mean)
        self.effect_std.copy_(((effects - mean) ** 2).mean(0).sqrt().clamp(min=1e-4))

    def unscaled(self, outcomes: Float[Tensor, "B O"]) -> Float[Tensor, "B O"]:
        """Return standardised effects, or all that is predicted, in metres."""
        return outcomes * self.effect_std + self.effect_mean

    def save(self, path: Path) -> None:
        """Write weights, configuration and `trained_by` as a safetensors file."""
        weights = {name: tensor.numpy().copy() for name, tensor in self.state_dict().items()}
        dimensions = asdict(self.dimensions)
        if not self.dimensions.unshown:
            del dimensions["unshown"]  # which earlier versions did not know
        parts = {"dimensions": dimensions, "config": asdict(self.config)}
        write_tensors(path, self.FORMAT, weights, {**parts, "trained_by": self.trained_by})

    @classmethod
    def load(cls: type[Network], path: Path) -> Network:
        """Read a network.

        Raises:
            InvalidFile: If the file is corrupt or foreign, or its weights do not fit its configuration.
        """
        weights, description = read_tensors(path, cls.FORMAT)
        try:
            dimensions = msgspec.convert(description["dimensions"], Dimensions)
            config = msgspec.convert(description["config"], cls.CONFIG)
            if msgspec.to_builtins(config) != description["config"]:
                raise ValueError("it has other options")
            with torch.device("meta"):  # takes no memory, whatever sizes the file claims
                sizes = {name: value.numel() for name, value in cls(dimensions, config).state_dict().items()}
            if sizes != {name: array.size for name, array in weights.items()}:
                raise ValueError("its weights are of other sizes")
            network = cls(dimensions, config)
            network.load_state_dict({name: torch.from_numpy(array) for name, array in weights.items()})
            network.trained_by = dict(description["trained_by"])
        except _MISFITS as error:
            raise InvalidFile(path, "its weights do not fit the configuration stored beside them") from error
        if any((weights[name] < 0).any() for name in weights if name.endswith("running_var")):
            raise InvalidFile(path, "it holds a variance below zero")
        return network.eval()


def _layers(inputs: int, width: int, dropout: float, outputs: int) -> list[nn.Module]:
    """Make three hidden layers with ReLU and dropout, and one behind them."""
    layers: list[nn.Module] = []
    for before, after in itertools.pairwise([inputs, width, width, width]):
        layers += [nn.Linear(before, after), nn.ReLU(inplace=True), nn.Dropout(dropout)]
    return [*layers, nn.Linear(width, outputs)]


def tensor(values: np.ndarray) -> Tensor:
    """Copy an array into a tensor of 32-bit numbers."""
    return torch.from_numpy(np.array(values, dtype=np.float32))


@contextmanager
def one_thread() -> Iterator[None]:
    """Compute on one thread, so that sums are taken in the same order on every machine."""
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        with choices.one_thread():  # of numpy
            yield
    finally:
        torch.set_num_threads(threads)


@contextmanager
def inference(model: nn.Module) -> Iterator[None]:
    """Let a model answer and not learn, on one thread."""
    was_training = model.training
    if was_training:  # switching visits every layer, which an explorer that asks often would feel
        model.eval()
    try:
        with one_thread(), torch.inference_mode():
            yield
    finally:
        if was_training:
            model.train()


# What networks are shown: inputs normalised, grippers open or closed, and mirror images


def with_gripper_states(
    actions: Float[Tensor, "B A"], columns: Sequence[int], sharpness: float | None
) -> Float[Tensor, "B A"]:
    """Put 1 for an open gripper (g >= 0.5) and 0 for a closed one; downhill is where sigmoid says it is.

    A gripper value acts only through the threshold. Backwards the step counts as
    sigmoid(sharpness (g - 0.5)), so that distillation can still move it.

    Without sharpness, of the sigmoid, the values stay as they are (the paper).
    """
    if sharpness is None or not columns:
        return actions
    chosen = list(columns)
    state = (actions[:, chosen] >= 0.5).to(actions.dtype)
    if actions.requires_grad:
        smooth = torch.sigmoid(sharpness * (actions[:, chosen] - 0.5))
        state = state + smooth - smooth.detach()
    return actions.index_copy(1, torch.tensor(chosen), state)


class InputNorm(nn.BatchNorm1d):
    """Batch normalisation of what a network is shown, except for states of 0 and 1, which become -1 and 1.

    A state that hardly ever changes in the data would be divided by next to nothing, and the other state be
    something that the network has never seen the like of. What it is not shown is 0, whatever it is.
    """

    is_state: Tensor
    is_shown: Tensor

    def __init__(self, inputs: int, states: Sequence[int], unshown: Sequence[int] = ()):
        super().__init__(inputs)
        is_state, is_shown = torch.zeros(inputs, dtype=torch.bool), torch.ones(inputs, dtype=torch.bool)
        is_state[list(states)], is_shown[list(unshown)] = True, False
        self.register_buffer("is_state", is_state, persistent=False)
        self.register_buffer("is_shown", is_shown, persistent=False)
        self._shows_all = not len(unshown)

    def forward(self, shown: Float[Tensor, "B I"]) -> Float[Tensor, "B I"]:
        """Normalise the inputs."""
        normed = torch.where(self.is_state, 2 * shown - 1, super().forward(shown))
        return normed if self._shows_all else torch.where(self.is_shown, normed, 0.0)


def reflected(
    actions: Float[Tensor, "B A"],
    effects: Float[Tensor, "B E"],
    mirrors: Sequence[Mirror],
    generator: torch.Generator,
) -> tuple[Float[Tensor, "B A"], Float[Tensor, "B E"]]:
    """Look at each sample through each mirror or not, by the toss of a coin."""
    if not mirrors:
        return actions, effects
    action_signs, effect_signs = torch.ones_like(actions), torch.ones_like(effects)
    for mirror in mirrors:
        coin = torch.randint(2, (len(actions), 1), generator=generator) * 2.0 - 1
        action_signs[:, list(mirror.actions)] *= coin
        effect_signs[:, list(mirror.effects)] *= coin
    return actions * action_signs, effects * effect_signs


# The paper's effect model: two encoders, a bottleneck that becomes symbols, and a decoder.
#
# Object features and action parameters are encoded separately into embeddings in [-1, 1]; the signs of the
# embeddings are the symbols (eq. 2). A decoder turns the concatenated embeddings into a Gaussian over the
# effect (eq. 3). Lengths go in and come out in metres; inside, effects are standardised, since with effects
# in metres the printed training regime moves nothing.

LOG_VARIANCE_FLOOR = -5.0
"""Least log variance, of standardised effects; without it the NLL diverges."""


class EffectModel(EffectNetwork):
    """Predicts the effect of an action on an object, through symbols."""

    FORMAT = "neurosym-effect-model-3"
    CONFIG = ModelConfig
    config: ModelConfig

    def __init__(self, dimensions: Dimensions, config: ModelConfig):
        super().__init__(dimensions, config)
        bits, outputs = config.object_bits + config.action_bits, dimensions.effects
        states = dimensions.gripper_columns if config.gripper_sharpness is not None else ()
        norm = InputNorm(dimensions.features, (), dimensions.unshown)
        self.object_encoder = _encoder(norm, config.object_bits, config)
        self.action_encoder = _encoder(InputNorm(dimensions.actions, states), config.action_bits, config)
        self.norm = nn.LayerNorm(bits) if config.layer_norm else nn.Identity()
        outputs *= 2 if config.head == "gaussian" else 1
        self.decoder = nn.Sequential(*_layers(bits, config.hidden, config.dropout, outputs))

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
        """Encode objects into embeddings, whose signs are the bits; other widths raise `InvalidValue`."""
        check_array("features", features, (None, self.dimensions.features))
        with inference(self):
            return self.embed_objects(tensor(features)).numpy()

    def object_margins(self, features: Float[np.ndarray, "N F"]) -> Float[np.ndarray, "N Ko"]:
        """Return what the embeddings of objects are before they are squashed into [-1, 1].

        How far a value is from 0 says how far a bit is from its flip, even where the embedding itself is 1 or
        -1 already.
        """
        with inference(self):
            margins: np.ndarray = self.object_encoder[:-1](tensor(features)).numpy()
        return margins

    def action_codes(self, actions: Float[np.ndarray, "N A"]) -> Float[np.ndarray, "N Ka"]:
        """Encode actions into embeddings, whose signs are the bits; other widths raise `InvalidValue`."""
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
            pairs = objects.repeat_interleave(len(chosen), 0), chosen.repeat(len(objects), 1)
            mean, _ = self.decode(*pairs)  # (M * P, E)
            table: np.ndarray = self.unscaled(mean).numpy()
        return table.reshape(len(features), len(primitives), -1)

    def predict_symbols(
        self, objects: Sequence[Symbol], actions: Sequence[Symbol]
    ) -> Float[np.ndarray, "N E"]:
        """Predict the effects of action symbols on object symbols, pair by pair."""
        pairs = (tensor(np.array([signs(one) for one in symbols])) for symbols in (objects, actions))
        with inference(self):
            mean, _ = self.decode(*pairs)
            found: np.ndarray = self.unscaled(mean).numpy()
        return found

    def mean_entropies(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Compute the entropy of the predicted effect, averaged over the axes (Algorithm 1, lines 5-9)."""
        with inference(self):
            chosen = self.embed_actions(tensor(candidates))
            objects = self.embed_objects(tensor(features[None])).expand(len(chosen), -1)
            _, log_variance = self.decode(objects, chosen)
            entropies = 0.5 * (np.log(2 * np.pi * np.e) + log_variance) + self.effect_std.log()
            mean: np.ndarray = entropies.mean(1).numpy()
        return mean

    def _in_metres(self, mean: Tensor, log_variance: Tensor) -> tuple[np.ndarray, np.ndarray]:
        return self.unscaled(mean).numpy(), (log_variance.exp() * self.effect_std**2).numpy()


def as_signs(embeddings: Float[Tensor, "B K"]) -> Float[Tensor, "B K"]:
    """Write the bits of embeddings in tanh's range: +1 where the value is > 0, else -1 (eq. 2)."""
    return torch.where(embeddings > 0, 1.0, -1.0)


def _encoder(norm: InputNorm, bits: int, config: ModelConfig) -> nn.Sequential:
    return nn.Sequential(norm, *_layers(norm.num_features, config.hidden, config.dropout, bits), nn.Tanh())


# A network without a bottleneck: from object and action straight to the effect.
#
# It has no symbols to tell. It serves as the yardstick of what the data can teach, as the teacher of the
# bits, and, several at once, as a measure of what is not known yet: where they disagree.


class DirectModel(EffectNetwork):
    """Predicts the effect of an action on an object."""

    FORMAT = "neurosym-direct-model-2"
    CONFIG = DirectConfig
    config: DirectConfig

    def __init__(self, dimensions: Dimensions, config: DirectConfig):
        outputs = dimensions.effects + config.peaks
        super().__init__(dimensions, config, outputs)
        columns = dimensions.gripper_columns if config.gripper_sharpness is not None else ()
        inputs = dimensions.features + dimensions.actions
        states = [dimensions.features + column for column in columns]
        norm = InputNorm(inputs, states, dimensions.unshown)
        self.layers = nn.Sequential(norm, *_layers(inputs, config.hidden, config.dropout, outputs))

    def forward(self, features: Float[Tensor, "B F"], actions: Float[Tensor, "B A"]) -> Float[Tensor, "B O"]:
        """Predict the effect, and the peak height behind it if `config.peaks`; all standardised."""
        columns = self.dimensions.gripper_columns
        actions = with_gripper_states(actions, columns, self.config.gripper_sharpness)
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
        return self.unscaled(self(features, actions))[:, : self.dimensions.effects]

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
            outcomes: np.ndarray = self.unscaled(self(tensor(features), tensor(actions))).numpy()
        return outcomes


def binarize(embeddings: Float[np.ndarray, "N K"]) -> tuple[Symbol, ...]:
    """Turn embeddings into symbols by the binary step function (eq. 2): a bit is 1 where the value is > 0."""
    return tuple("".join("1" if value > 0 else "0" for value in row) for row in embeddings)
