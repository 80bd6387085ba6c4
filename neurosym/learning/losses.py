"""Losses of the effect model, and the loop that descends them."""

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor
from torch.nn import functional

from neurosym.checks import Float, Int
from neurosym.data.interactions import Interactions
from neurosym.data.origin import REQUIRED, Dimensions, mirrors_of, strategy_of
from neurosym.learning.network import DirectModel, EffectModel, one_thread, reflected, tensor
from neurosym.world import Mirror

BatchLoss = Callable[[Tensor], Tensor]
"""Gives the loss of a batch, from the numbers of its rows."""

FitProgress = Callable[[str, float], None]
"""Called with what is being done and the share of it that is done."""


def negative_log_likelihood(
    mean: Float[Tensor, "B E"], log_variance: Float[Tensor, "B E"], effects: Float[Tensor, "B E"]
) -> Float[Tensor, ""]:
    """Compute the NLL of eq. 7, averaged over samples and axes."""
    squares = (effects - mean) ** 2 * torch.exp(-log_variance)
    return 0.5 * (math.log(2 * math.pi) + log_variance + squares).mean()


def nt_xent(embeddings: Float[Tensor, "B K"], temperature: float) -> Float[Tensor, ""]:
    """Compute the contrastive loss of eq. 8 as printed: each sample is its own positive.

    Since s_ii = 1, what is left is a pull towards embeddings that are spread evenly.
    """
    unit = functional.normalize(embeddings, dim=1)
    similarities = unit @ unit.T / temperature  # (B, B)
    return (torch.logsumexp(similarities, dim=1) - similarities.diagonal()).mean()


def total_loss(
    model: EffectModel,
    features: Float[Tensor, "B F"],
    actions: Float[Tensor, "B A"],
    effects: Float[Tensor, "B E"],
    *,
    coefficient: float,
    temperature: float | None,
) -> Float[Tensor, ""]:
    """Compute the loss of eq. 9; a "mean" head takes the squared error in place of the NLL.

    Args:
        model: The model.
        features: Object features.
        actions: Action parameters.
        effects: Observed effects [m].
        coefficient: The loss coefficient lambda.
        temperature: The temperature tau; None leaves the contrastive loss out.
    """
    objects, chosen = model.embed_objects(features), model.embed_actions(actions)
    loss = prediction_loss(model, objects, chosen, effects)
    if temperature is not None:
        loss = loss + nt_xent(torch.cat([objects, chosen], dim=1), temperature)
    return coefficient * loss


def prediction_loss(
    model: EffectModel,
    objects: Float[Tensor, "B Ko"],
    chosen: Float[Tensor, "B Ka"],
    effects: Float[Tensor, "B E"],
) -> Float[Tensor, ""]:
    """Compute how badly the decoder predicts effects [m] from embeddings or +-1 codes, by the head's loss."""
    mean, log_variance = model.decode(objects, chosen)
    targets = (effects - model.effect_mean) / model.effect_std
    if model.config.head == "mean":
        return functional.mse_loss(mean, targets)
    return negative_log_likelihood(mean, log_variance, targets)


def squared_error(
    model: DirectModel,
    features: Float[Tensor, "B F"],
    actions: Float[Tensor, "B A"],
    outcomes: Float[Tensor, "B O"],
) -> Float[Tensor, ""]:
    """Compute the squared error of a network without a bottleneck, where outcomes [m] are standardised."""
    targets = (outcomes - model.effect_mean) / model.effect_std
    return functional.mse_loss(model(features, actions), targets)


def run_epochs(
    loss_of: BatchLoss,
    rows: int,
    optimiser: torch.optim.Optimizer,
    generator: torch.Generator,
    *,
    epochs: int,
    batch: int,
    clip_norm: float,
    decay: bool = False,
    after_epoch: Callable[[int], None] | None = None,
) -> None:
    """Descend a loss in shuffled mini-batches of nearly equal size.

    Args:
        loss_of: Loss of a batch.
        rows: How many samples there are.
        optimiser: Holds the parameters and takes the steps.
        generator: Source of the order of samples, owned by the caller.
        epochs: How often every sample is seen.
        batch: Samples in a mini-batch.
        clip_norm: Greatest norm of a gradient.
        decay: Whether the learning rate falls to zero along a half cosine.
        after_epoch: Called with the number of epochs done.
    """
    parameters = [p for group in optimiser.param_groups for p in group["params"]]
    rates = [group["lr"] for group in optimiser.param_groups]
    parts = max(1, round(rows / batch))
    for epoch in range(epochs):
        batches: tuple[Int[Tensor, " B"], ...] = torch.randperm(rows, generator=generator).tensor_split(parts)
        for number, indices in enumerate(batches):
            done = (epoch * parts + number) / (epochs * parts)
            for group, rate in zip(optimiser.param_groups, rates, strict=True):
                group["lr"] = rate * 0.5 * (1 + math.cos(math.pi * done)) if decay else rate
            optimiser.zero_grad()
            loss_of(indices).backward()  # type: ignore[no-untyped-call]
            torch.nn.utils.clip_grad_norm_(parameters, clip_norm)
            optimiser.step()
        if after_epoch is not None:
            after_epoch(epoch + 1)
    for group, rate in zip(optimiser.param_groups, rates, strict=True):
        group["lr"] = rate


@contextmanager
def reproducible(seed: int) -> Iterator[torch.Generator]:
    """Compute the same bits each time: one thread, and seeded draws (initial weights, dropout) in this block.

    Args:
        seed: Where the draws start. The caller's random state is left as it was.
    """
    with one_thread(), torch.random.fork_rng(devices=[]):
        yield torch.manual_seed(seed)


# Training data as tensors, with what is known of the actions they were drawn from


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """The training data, and where further actions may be drawn from."""

    features: Float[Tensor, "N F"]  # object features
    actions: Float[Tensor, "N A"]  # action parameters
    effects: Float[Tensor, "N E"]  # effects [m]
    peaks: Float[Tensor, "N"]  # greatest heights on the way [m]
    # least value of each action parameter, if the actions were drawn from a box; else None
    low: Float[Tensor, "A"] | None
    high: Float[Tensor, "A"] | None  # greatest value of each action parameter, likewise
    mirrors: tuple[Mirror, ...] = ()  # mirrors of the world that are made use of

    def __len__(self) -> int:
        return len(self.features)

    @property
    def mirrored_axes(self) -> tuple[int, ...]:
        """Effect axes whose sign some mirror changes."""
        return tuple(axis for mirror in self.mirrors for axis in mirror.effects)

    def batch(
        self, rows: Int[Tensor, "B"], generator: torch.Generator
    ) -> tuple[Float[Tensor, "B F"], Float[Tensor, "B A"], Float[Tensor, "B E"]]:
        """Take rows, each seen through the mirrors at random."""
        actions, effects = reflected(self.actions[rows], self.effects[rows], self.mirrors, generator)
        return self.features[rows], actions, effects

    def imagine(
        self, count: int, generator: torch.Generator
    ) -> tuple[Float[Tensor, "B F"], Float[Tensor, "B A"]]:
        """Draw objects and actions, for a teacher to say what would happen.

        Objects are those of the data. Actions come from the box if those of the data did, else from the data.
        """
        features = self.features[torch.randint(len(self), (count,), generator=generator)]
        if self.low is None or self.high is None:
            return features, self.actions[torch.randint(len(self), (count,), generator=generator)]
        drawn = torch.rand(count, len(self.low), generator=generator)
        return features, self.low + drawn * (self.high - self.low)


def samples_of(interactions: Interactions, *, mirrors: bool = True) -> Samples:
    """Turn a data set into tensors, with the box of its actions if they were drawn from it.

    So they were if a strategy explored. Actions of other origin may lie in few places of their box, and so
    do those that were proposed because they do something.

    Args:
        interactions: The data.
        mirrors: Whether to make use of the mirrors that its origin names.
    """
    origin = interactions.origin
    is_drawn = strategy_of(origin) is not None and not origin.get("proposed")
    has_box = is_drawn and "action_low" in origin and "action_high" in origin
    return Samples(
        features=tensor(interactions.features),
        actions=tensor(interactions.actions),
        effects=tensor(interactions.effects),
        peaks=tensor(interactions.peak_heights),
        low=tensor(np.asarray(origin["action_low"])) if has_box else None,
        high=tensor(np.asarray(origin["action_high"])) if has_box else None,
        mirrors=mirrors_of(origin) if mirrors else (),
    )


def dimensions_of(interactions: Interactions) -> Dimensions:
    """Read from a data set what a network for it must read and write."""
    features, actions, effects = (interactions.columns[name].shape[1] for name in REQUIRED)
    known = (tuple(interactions.origin.get(name, ())) for name in ("gripper_columns", "unshown"))
    return Dimensions(features, actions, effects, *known)
