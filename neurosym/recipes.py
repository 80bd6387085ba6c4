"""Recipes of the final fit: ways to make the bits of the symbols hold what the effect needs.

* **joint**: the paper's. The whole network descends eq. 9; the embeddings are cut to their signs afterwards.
  They were never near +-1, so the cut costs much of what had been learned.
* **refit**: after that, the codes are frozen and the decoder is fitted to them.
* **teacher**: a network without a bottleneck learns the effects first. What it predicts for many actions on
  many objects is co-clustered into as many kinds as there are codes. Then the encoders learn to name the
  kinds: what they minimise is the teacher's own estimate of how much a wrong name would cost. Last, the
  decoder is fitted to the codes.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import product

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from neurosym.coclustering import cocluster, gray_order, profiles
from neurosym.effect_model import EffectModel, as_signs
from neurosym.fitting import prediction_loss, run_epochs, total_loss
from neurosym.model_config import ModelConfig
from neurosym.training_config import TrainingConfig

Progress = Callable[[str, float], None]
"""Called with what is being done and the share of it that is done."""

_TEACHER_BITS = 8
_SHOWN_ACTIONS = 4000
_SHOWN_TO_OBJECTS = 200
_AT_ONCE = 50_000
_LIKELIHOOD_WEIGHT = 0.05


class Samples:
    """The training data as tensors, and the box that further actions may be drawn from.

    Args:
        features: Object features.
        actions: Action parameters.
        effects: Effects [m].
        low: Least value of each action parameter.
        high: Greatest value of each action parameter.
    """

    def __init__(self, features: Tensor, actions: Tensor, effects: Tensor, low: Tensor, high: Tensor):
        self.features, self.actions, self.effects = features, actions, effects
        self.low, self.high = low, high

    def __len__(self) -> int:
        return len(self.features)


def fit_jointly(
    model: EffectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Descend eq. 9 with the whole network."""

    def loss_of(rows: Tensor) -> Tensor:
        batch = samples.features[rows], samples.actions[rows], samples.effects[rows]
        temperature = config.temperature if config.contrastive else None
        return total_loss(model, *batch, coefficient=config.loss_coefficient, temperature=temperature)

    model.train()
    _descend(
        loss_of, len(samples), list(model.parameters()), config.epochs, config, generator, progress, "fitting"
    )
    model.eval()


def fit_and_refit(
    model: EffectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Descend eq. 9, then fit the decoder to the frozen codes."""
    fit_jointly(model, samples, config, generator, progress)
    refit_decoder(model, samples, config, generator, progress)


def fit_from_teacher(
    model: EffectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Learn what the bits should say from a network without a bottleneck; see the head of this file."""
    wide = replace(
        model.config,
        object_bits=_TEACHER_BITS,
        action_bits=_TEACHER_BITS,
        layer_norm=False,
        head="gaussian",
    )
    teacher = EffectModel(model.dimensions, wide)
    teacher.set_scale(samples.effects)
    fit_jointly(teacher, samples, replace(config, contrastive=False), generator, progress)
    extra = torch.rand(config.teacher_actions, len(samples.low), generator=generator)
    actions = torch.cat([samples.actions, samples.low + extra * (samples.high - samples.low)])
    rng = np.random.default_rng(int(torch.randint(2**31, (1,), generator=generator)))
    action_costs, object_costs = name_costs(teacher, model.config, samples.features, actions, config, rng)
    for encode, inputs, costs in (
        (model.embed_actions, actions, action_costs),
        (model.embed_objects, samples.features, object_costs),
    ):
        _fit_names(model, encode, inputs, costs, config, generator, progress)
    refit_decoder(model, samples, config, generator, progress)


def name_costs(
    teacher: EffectModel,
    bits: ModelConfig,
    features: Float[Tensor, "N F"],
    actions: Float[Tensor, "R A"],
    config: TrainingConfig,
    rng: np.random.Generator,
) -> tuple[Float[Tensor, "R La"], Float[Tensor, "N Lo"]]:
    """Let the teacher say what each name for each action and each object would cost.

    The cost of a name is the mean squared distance (standardised) between what the teacher predicts and the
    mean of the block that the name stands for. Codes are given so that names one bit apart are alike.

    Args:
        teacher: The network without a bottleneck.
        bits: How many bits symbols have.
        features: The objects.
        actions: The actions.
        config: How many objects the teacher is asked about.
        rng: Source of randomness, owned by the caller.
    """
    action_kinds, object_kinds = 2**bits.action_bits, 2**bits.object_bits
    asked = torch.from_numpy(rng.permutation(len(features))[: config.teacher_objects])
    shown = torch.from_numpy(rng.permutation(len(actions))[:_SHOWN_ACTIONS])
    table = _predictions(teacher, features[asked], actions[shown])  # (S, C, E)
    found = cocluster(table, action_kinds, object_kinds, rng)
    rows = profiles(table, found.columns, object_kinds)
    columns = profiles(table.transpose(1, 0, 2), found.rows, action_kinds)
    row_centres, column_centres = (
        _means(rows, found.rows, action_kinds),
        _means(columns, found.columns, object_kinds),
    )
    everything = profiles(_predictions(teacher, features[asked], actions), found.columns, object_kinds)
    per_object = _predictions(teacher, features, actions[shown[:_SHOWN_TO_OBJECTS]]).transpose(1, 0, 2)
    few = profiles(
        table.transpose(1, 0, 2)[:, :_SHOWN_TO_OBJECTS], found.rows[:_SHOWN_TO_OBJECTS], action_kinds
    )
    few_centres = _means(few, found.columns, object_kinds)
    object_profiles = profiles(per_object, found.rows[:_SHOWN_TO_OBJECTS], action_kinds)
    return (
        _costs(everything, row_centres, gray_order(row_centres, rng)),
        _costs(object_profiles, few_centres, gray_order(column_centres, rng)),
    )


def refit_decoder(
    model: EffectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Fit the decoder to the codes that the frozen encoders give, without dropout."""
    model.eval()
    with torch.no_grad():
        objects = as_signs(model.embed_objects(samples.features))
        chosen = as_signs(model.embed_actions(samples.actions))

    def loss_of(rows: Tensor) -> Tensor:
        return prediction_loss(model, objects[rows], chosen[rows], samples.effects[rows])

    decoder = [*model.norm.parameters(), *model.decoder.parameters()]
    _descend(loss_of, len(samples), decoder, config.refit_epochs, config, generator, progress, "refitting")


Recipe = Callable[[EffectModel, Samples, TrainingConfig, torch.Generator, Progress], None]
RECIPES: dict[str, Recipe] = {"joint": fit_jointly, "refit": fit_and_refit, "teacher": fit_from_teacher}


def _fit_names(
    model: EffectModel,
    encode: Callable[[Tensor], Tensor],
    inputs: Tensor,
    costs: Float[Tensor, "N L"],
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Fit an encoder so that the names it gives are expected to cost little.

    An embedding z is read as independent bits that are 1 with probability (1 + z) / 2. Without the likelihood
    of the cheapest name, an encoder that gives everything one name could never leave it: tanh is flat there.
    """
    names = torch.tensor(list(product((-1.0, 1.0), repeat=int(math.log2(costs.shape[1])))))  # (L, K)

    cheapest = costs.argmin(1)

    def loss_of(rows: Tensor) -> Tensor:
        agreement = (1 + encode(inputs[rows])[:, None, :] * names) / 2  # (B, L, K)
        expected_cost = (agreement.prod(2) * costs[rows]).sum(1).mean()
        right = agreement[torch.arange(len(rows)), cheapest[rows]].clamp(min=1e-6)  # (B, K)
        return expected_cost - _LIKELIHOOD_WEIGHT * right.log().mean()

    encoder = model.object_encoder if encode == model.embed_objects else model.action_encoder
    encoder.train()
    parameters = list(encoder.parameters())
    _descend(loss_of, len(inputs), parameters, config.encoder_epochs, config, generator, progress, "naming")
    encoder.eval()


def _predictions(
    teacher: EffectModel, features: Float[Tensor, "C F"], actions: Float[Tensor, "R A"]
) -> Float[np.ndarray, "R C E"]:
    """Predict standardised effects of every action on every object."""
    with torch.inference_mode():
        objects, chosen = teacher.embed_objects(features), teacher.embed_actions(actions)
        rows = [
            teacher.decode(objects.repeat(len(part), 1), part.repeat_interleave(len(objects), 0))[0]
            for part in torch.split(chosen, max(1, _AT_ONCE // len(objects)))
        ]
    return torch.cat(rows).numpy().reshape(len(actions), len(features), -1)


def _means(points: np.ndarray, labels: np.ndarray, kinds: int) -> np.ndarray:
    members = np.eye(kinds)[labels]
    means: np.ndarray = members.T @ points / np.maximum(members.sum(0), 1)[:, None]
    return means


def _costs(points: np.ndarray, centres: np.ndarray, codes: np.ndarray) -> Float[Tensor, "N L"]:
    squares = ((points[:, None] - centres) ** 2).sum(2)
    squares -= squares.min(1, keepdims=True)
    by_code = np.empty_like(squares)
    by_code[:, codes] = squares
    return torch.from_numpy(by_code / by_code.mean()).float()


def _descend(
    loss_of: Callable[[Tensor], Tensor],
    rows: int,
    parameters: list[torch.nn.Parameter],
    epochs: int,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
    stage: str,
) -> None:
    run_epochs(
        loss_of,
        rows,
        torch.optim.Adam(parameters, lr=config.learning_rate, fused=True),
        generator,
        epochs=epochs,
        batch=config.batch,
        clip_norm=config.clip_norm,
        decay=config.decay,
        after_epoch=lambda done: progress(stage, done / epochs),
    )
