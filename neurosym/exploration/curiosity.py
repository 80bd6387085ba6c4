"""Curiosity: networks that learn while the robot explores, and say which action they know least about.

Between two blocks of interactions they learn from all interactions so far, for a few epochs.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from torch import Tensor

from neurosym.checks import Float
from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidValue
from neurosym.learning.losses import Samples, reproducible, run_epochs, samples_of, squared_error, total_loss
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.learning.training_config import DirectConfig, ModelConfig, check_positive

_STREAM = 0x626C  # keeps these draws apart from those of scenes and candidates


@dataclass(frozen=True, slots=True)
class LearningConfig:
    """How networks learn during exploration."""

    epochs: int = 10  # how often a network sees every interaction after a block
    batch: int = 512  # interactions in a mini-batch
    learning_rate: float = 1e-3  # step size of Adam
    loss_coefficient: float = 1.0  # the coefficient lambda of eq. 9
    temperature: float = 0.1  # the temperature tau of eq. 8
    clip_norm: float = 1.0  # greatest norm of a gradient
    ensemble: int = 5  # how many networks disagree
    ensemble_hidden: int = 64  # width of their hidden layers

    def __post_init__(self) -> None:
        check_positive(self)
        if self.ensemble < 2:
            raise InvalidValue(f"ensemble = {self.ensemble} must be at least 2.")


class Curiosity(ABC):
    """One network or several, that learn and are asked how little they know.

    Args:
        networks: The networks, as they begin.
        config: How they learn.
        seed: Of the exploration.
    """

    def __init__(self, networks: Sequence[Any], config: LearningConfig, seed: int):
        self.networks, self.config, self.seed = networks, config, seed
        self.optimisers = [
            torch.optim.Adam(network.parameters(), lr=config.learning_rate, fused=True)
            for network in networks
        ]

    @abstractmethod
    def uncertainties(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Say how little is known of the effect of each candidate on the one object."""

    def pick(self, uncertainties: Float[np.ndarray, "C"], rng: np.random.Generator) -> int:
        """Pick the candidate of which least is known (Algorithm 1, line 10)."""
        del rng
        return int(np.argmax(uncertainties))

    @abstractmethod
    def loss(self, network: Any, features: Tensor, actions: Tensor, effects: Tensor) -> Tensor:
        """Compute what a network descends."""

    def learn(self, interactions: Interactions, block: int) -> None:
        """Let every network learn from all interactions so far, seen through the mirrors of their world."""
        samples = samples_of(interactions)
        for number, network in enumerate(self.networks):
            network.set_scale(samples.effects, samples.mirrored_axes)
            with reproducible(_seed_of(self.seed, block, number)) as generator:
                self._learn(network.train(), self.optimisers[number], samples, generator)
                network.eval()

    def _learn(
        self, network: Any, optimiser: torch.optim.Adam, samples: Samples, generator: torch.Generator
    ) -> None:
        config = self.config
        run_epochs(
            lambda rows: self.loss(network, *samples.batch(rows, generator)),
            len(samples),
            optimiser,
            generator,
            epochs=config.epochs,
            batch=config.batch,
            clip_norm=config.clip_norm,
        )

    def state(self) -> dict[str, np.ndarray]:
        """Copy weights and moments of Adam into arrays."""
        arrays: dict[str, np.ndarray] = {}
        for number, (network, optimiser) in enumerate(zip(self.networks, self.optimisers, strict=True)):
            for name, weights in network.state_dict().items():
                arrays[f"{number}/model/{name}"] = weights.numpy().copy()
            for parameter, moments in optimiser.state_dict()["state"].items():
                arrays |= {f"{number}/adam/{parameter}/{name}": m.numpy() for name, m in moments.items()}
        return arrays

    def restore(self, arrays: dict[str, np.ndarray]) -> None:
        """Take up weights and moments again.

        Raises KeyError, RuntimeError or ValueError if they do not fit these networks.
        """
        tensors = {tuple(key.split("/", 2)): torch.from_numpy(array.copy()) for key, array in arrays.items()}
        for number, (network, optimiser) in enumerate(zip(self.networks, self.optimisers, strict=True)):
            moments: dict[int, dict[str, Tensor]] = {}
            weights: dict[str, Tensor] = {}
            for (owner, kind, name), found in tensors.items():
                if owner == str(number) and kind == "model":
                    weights[name] = found
                elif owner == str(number):
                    parameter, moment = name.split("/")
                    moments.setdefault(int(parameter), {})[moment] = found
            network.load_state_dict(weights)
            for index, values in enumerate(network.parameters()):
                shapes = {moments[index][name].shape for name in ("exp_avg", "exp_avg_sq")}
                if shapes != {values.shape} or moments[index]["step"].numel() != 1:
                    raise ValueError(f"The moments of parameter {index} have the shapes {shapes}.")
            groups = optimiser.state_dict()["param_groups"]
            optimiser.load_state_dict({"state": moments, "param_groups": groups})


class _Entropy(Curiosity):
    """The paper's network: the more entropy in the predicted effect, the less is known (Algorithm 1)."""

    def uncertainties(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Compute the entropy of the predicted effect, averaged over the axes (lines 5-9)."""
        (model,) = self.networks
        entropies: np.ndarray = model.mean_entropies(features, candidates)
        return entropies

    def loss(self, network: EffectModel, features: Tensor, actions: Tensor, effects: Tensor) -> Tensor:
        """Compute eq. 9."""
        coefficient, temperature = self.config.loss_coefficient, self.config.temperature
        return total_loss(
            network, features, actions, effects, coefficient=coefficient, temperature=temperature
        )


class _Disagreement(Curiosity):
    """Networks without a bottleneck, that differ in how they began: what they disagree about is not known."""

    def uncertainties(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Compute the variance among the standardised predictions, averaged over the axes."""
        repeated, scale = np.tile(features, (len(candidates), 1)), self.networks[0].effect_std.numpy()
        predicted = np.stack([network.predict(repeated, candidates) for network in self.networks])
        return np.asarray((predicted / scale).var(0).mean(1))

    def pick(self, uncertainties: Float[np.ndarray, "C"], rng: np.random.Generator) -> int:
        """Draw a candidate with a probability in proportion to the disagreement about it.

        Until the networks learn again, the greatest disagreement is always about the same sort of action, of
        which a few would do (Kirsch et al., 2023, Stochastic Batch Acquisition).
        """
        weights = uncertainties.astype(np.float64)
        total = weights.sum()
        return int(rng.choice(len(weights), p=weights / total if total > 0 else None))

    def loss(self, network: DirectModel, features: Tensor, actions: Tensor, effects: Tensor) -> Tensor:
        """Compute the squared error of the standardised effect."""
        return squared_error(network, features, actions, effects)


def make_curiosity(
    about: str, dimensions: Dimensions, model_config: ModelConfig, config: LearningConfig, seed: int
) -> Curiosity:
    """Make the networks that a strategy is curious with."""
    direct = DirectConfig(config.ensemble_hidden, 0.0, model_config.gripper_sharpness, peaks=False)
    networks: list[EffectModel | DirectModel] = []
    for number in range(1 if about == "entropy" else config.ensemble):
        with reproducible(_seed_of(seed, 0, number)):
            is_papers = about == "entropy"
            network = EffectModel(dimensions, model_config) if is_papers else DirectModel(dimensions, direct)
            networks.append(network.eval())
    return (_Entropy if about == "entropy" else _Disagreement)(networks, config, seed)


def _seed_of(seed: int, block: int, network: int) -> int:
    """Derive where the draws of a network start after a block."""
    return int(np.random.default_rng([seed, _STREAM, block, network]).integers(2**62))
