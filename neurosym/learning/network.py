"""What all networks that predict effects share: layers, standardised effects, and their file."""

import itertools
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any, ClassVar, TypeVar

import msgspec
import numpy as np
import torch
from torch import Tensor, nn

from neurosym.arrays import Float
from neurosym.data.dimensions import Dimensions
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.learning.model_config import DirectConfig, ModelConfig
from neurosym.tensor_files import read_tensors, write_tensors

Network = TypeVar("Network", bound="EffectNetwork")

_MISFITS = (
    KeyError,
    TypeError,
    ValueError,
    ArithmeticError,
    RuntimeError,
    InvalidValue,
    msgspec.ValidationError,
)
"""What is raised where a description is foreign, or weights do not fit it."""


class EffectNetwork(nn.Module):
    """A network that predicts effects; lengths go in and come out in metres.

    Args:
        dimensions: What the network reads and writes.
        config: How it is built.
        outputs: How many numbers it predicts, the effect axes first; just these if not given.

    Attributes:
        trained_by: What made the weights, as plain JSON values; stored in the file.
    """

    FORMAT: ClassVar[str]
    CONFIG: ClassVar[type[ModelConfig] | type[DirectConfig]]
    effect_mean: Tensor
    effect_std: Tensor
    trained_by: dict[str, Any]

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
        """Standardise effects by mean and standard deviation of these, together with their mirror images.

        Args:
            effects: Effects, or all that is predicted [m].
            mirrored: Axes whose sign some mirror of the world changes; their mean is 0.
        """
        mean = effects.mean(0)
        mean[list(mirrored)] = 0.0
        self.effect_mean.copy_(mean)
        self.effect_std.copy_(((effects - mean) ** 2).mean(0).sqrt().clamp(min=1e-4))

    def save(self, path: Path) -> None:
        """Write weights, configuration and `trained_by` as a safetensors file."""
        weights = {name: tensor.numpy().copy() for name, tensor in self.state_dict().items()}
        parts = {"dimensions": asdict(self.dimensions), "config": asdict(self.config)}
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


def hidden_layers(inputs: int, width: int, dropout: float) -> list[nn.Module]:
    """Make three hidden layers with ReLU and dropout."""
    layers: list[nn.Module] = []
    for before, after in itertools.pairwise([inputs, width, width, width]):
        layers += [nn.Linear(before, after), nn.ReLU(inplace=True), nn.Dropout(dropout)]
    return layers


def tensor(values: np.ndarray) -> Tensor:
    """Copy an array into a tensor of 32-bit numbers."""
    return torch.from_numpy(np.array(values, dtype=np.float32))


@contextmanager
def one_thread() -> Iterator[None]:
    """Compute on one thread, so that sums are taken in the same order on every machine."""
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
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
