"""Curiosity: networks that learn while the robot explores, and say which action they know least about.

Between two blocks of interactions they learn from all interactions so far, for a few epochs.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from neurosym.checks import Float
from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidValue
from neurosym.learning.losses import reproducible, run_epochs, total_loss
from neurosym.learning.network import DirectModel, EffectModel, reflected
from neurosym.learning.training_config import DirectConfig, ModelConfig, check_numbers
from neurosym.world import Mirror

_STREAM = 0x626C  # keeps these draws apart from those of scenes and candidates


@dataclass(frozen=True, slots=True)
class LearningConfig:
    """How networks learn during exploration.

    Attributes:
        epochs: How often a network sees every interaction after a block.
        batch: Interactions in a mini-batch.
        learning_rate: Step size of Adam.
        loss_coefficient: The coefficient lambda of eq. 9.
        temperature: The temperature tau of eq. 8.
        clip_norm: Greatest norm of a gradient.
        ensemble: How many networks disagree.
        ensemble_hidden: Width of their hidden layers.
    """

    epochs: int = 10
    batch: int = 512
    learning_rate: float = 1e-3
    loss_coefficient: float = 1.0
    temperature: float = 0.1
    clip_norm: float = 1.0
    ensemble: int = 5
    ensemble_hidden: int = 64

    def __post_init__(self) -> None:
        positive = ("learning_rate", "loss_coefficient", "temperature", "clip_norm")
        check_numbers("", self, counts=("epochs", "batch"), positive=positive)
        if self.ensemble < 2:
            raise InvalidValue(f"ensemble = {self.ensemble} must be at least 2.")


class Curiosity(ABC):
    """One network or several, that learn and are asked how little they know.

    Args:
        networks: The networks, as they begin.
        config: How they learn.
        mirrors: Mirrors of the world.
        seed: Of the exploration.
    """

    def __init__(self, networks: Sequence[Any], config: LearningConfig, mirrors: Sequence[Mirror], seed: int):
        self.networks, self.config, self.mirrors, self.seed = networks, config, mirrors, seed
        self.optimisers = [
            torch.optim.Adam(network.parameters(), lr=config.learning_rate, fused=True)
            for network in networks
        ]

    @abstractmethod
    def uncertainties(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Say how little is known of the effect of each candidate.

        Args:
            features: Features of the one object.
            candidates: Actions that could be performed on it.
        """

    def pick(self, uncertainties: Float[np.ndarray, "C"], rng: np.random.Generator) -> int:
        """Pick a candidate: the one of which least is known (Algorithm 1, line 10).

        Args:
            uncertainties: How little is known of each.
            rng: Source of randomness, owned by the caller.
        """
        del rng
        return int(np.argmax(uncertainties))

    @abstractmethod
    def expected_sizes(
        self, features: Float[np.ndarray, "F"], candidates: Float[np.ndarray, "C A"]
    ) -> Float[np.ndarray, "C"]:
        """Predict the sum of absolute displacements that each candidate leads to [m]."""

    @abstractmethod
    def loss(self, network: Any, features: Tensor, actions: Tensor, effects: Tensor) -> Tensor:
        """Compute what a network descends."""

    def learn(self, interactions: Interactions, block: int) -> None:
        """Let every network learn from all interactions so far.

        Args:
            interactions: All interactions so far.
            block: How many blocks they are.
        """
        columns = interactions.features, interactions.actions, interactions.effects
        features, actions, effects = (torch.from_numpy(column) for column in columns)
        mirrored = tuple(axis for mirror in self.mirrors for axis in mirror.effects)
        for number, (network, optimiser) in enumerate(zip(self.networks, self.optimisers, strict=True)):
            network.set_scale(effects, mirrored)
            with reproducible(seed_of(self.seed, block, number)) as generator:
                loss_of = partial(self._loss_of_rows, network, generator, features, actions, effects)
                network.train()
                run_epochs(
                    loss_of,
                    len(effects),
                    optimiser,
                    generator,
                    epochs=self.config.epochs,
                    batch=self.config.batch,
                    clip_norm=self.config.clip_norm,
                )
                network.eval()

    def _loss_of_rows(
        self,
        network: Any,
        generator: torch.Generator,
        features: Tensor,
        actions: Tensor,
        effects: Tensor,
        rows: Tensor,
    ) -> Tensor:
        seen = reflected(actions[rows], effects[rows], self.mirrors, generator)
        return self.loss(network, features[rows], *seen)

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

        Args:
            arrays: As `state` returned them.

        Raises:
            KeyError, RuntimeError, ValueError: If they do not fit these networks.
        """
        for number, (network, optimiser) in enumerate(zip(self.networks, self.optimisers, strict=True)):
            moments: dict[int, dict[str, Tensor]] = {}
            weights: dict[str, Tensor] = {}
            for key, array in arrays.items():
                owner, kind, name = key.split("/", 2)
                if owner == str(number) and kind == "model":
                    weights[name] = torch.from_numpy(array.copy())
                elif owner == str(number):
                    parameter, name = name.split("/")
                    moments.setdefault(int(parameter), {})[name] = torch.from_numpy(array.copy())
            network.load_state_dict(weights)
            for index, values in enumerate(network.parameters()):
                shapes = {moments[index][name].shape for name in ("exp_avg", "exp_avg_sq")}
                if shapes != {values.shape} or moments[index]["step"].numel() != 1:
                    raise ValueError(f"The moments of parameter {index} have the shapes {shapes}.")
            groups = optimiser.state_dict()["param_groups"]
            optimiser.load_state_dict({"state": moments, "param_groups": groups})


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


def make_curiosity(
    about: str,
    dimensions: Dimensions,
    model_config: ModelConfig,
    config: LearningConfig,
    mirrors: Sequence[Mirror],
    seed: int,
) -> Curiosity:
    """Make the networks that a strategy is curious with.

    Args:
        about: "entropy" or "disagreement".
        dimensions: What they read and write.
        model_config: How the paper's network is built.
        config: How they learn.
        mirrors: Mirrors of the world.
        seed: Of the exploration.
    """
    if about == "entropy":
        with reproducible(seed_of(seed, 0, 0)):
            return Entropy([EffectModel(dimensions, model_config).eval()], config, mirrors, seed)
    direct = DirectConfig(config.ensemble_hidden, 0.0, model_config.gripper_sharpness, peaks=False)
    networks = []
    for number in range(config.ensemble):
        with reproducible(seed_of(seed, 0, number)):
            networks.append(DirectModel(dimensions, direct).eval())
    return Disagreement(networks, config, mirrors, seed)


def seed_of(seed: int, block: int, network: int) -> int:
    """Derive where the draws of a network start after a block."""
    return int(np.random.default_rng([seed, _STREAM, block, network]).integers(2**62))
