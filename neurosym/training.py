"""The final fit: from a data set of interactions to an effect model whose bits can be relied on.

Each restart starts from other weights; the one that predicts held-out effects best *through its binary codes*
is kept. The report sets the model's error beside what predictors that look at nothing achieve.
"""

from dataclasses import asdict
from typing import Any

import numpy as np
import torch
from jaxtyping import Float

from neurosym.data_check import too_few
from neurosym.effect_model import EffectModel
from neurosym.errors import InvalidValue
from neurosym.fitting import reproducible
from neurosym.interactions import Interactions
from neurosym.model_config import Dimensions, ModelConfig
from neurosym.recipes import RECIPES, Progress, Samples
from neurosym.training_config import TrainingConfig

TrainingReport = dict[str, Any]
"""Plain JSON values: see `assess` for the keys; besides, `restarts` and the figures of each."""


def train(
    interactions: Interactions,
    *,
    config: TrainingConfig | None = None,
    model_config: ModelConfig | None = None,
    seed: int,
    progress: Progress | None = None,
) -> tuple[EffectModel, TrainingReport]:
    """Fit an effect model to a data set; the same seed gives the same bytes.

    Which action parameters are gripper values, and the box of the actions, are read from the data's origin
    (`gripper_columns`, `action_low`, `action_high`) where they stand there.

    Args:
        interactions: The data.
        config: How the fit is made.
        model_config: How the network is built.
        seed: Where all draws start.
        progress: Called with the stage and the share of it that is done.

    Raises:
        InvalidValue: If there are too few interactions to hold some out.
    """
    config, model_config = config or TrainingConfig(), model_config or ModelConfig()
    kept, held_out = split(interactions, config.validation_share, seed)
    samples, dimensions = samples_of(kept), dimensions_of(interactions)
    fits = []
    for restart in range(config.restarts):
        with reproducible(_restart_seed(seed, restart)) as generator:
            model = EffectModel(dimensions, model_config)
            model.set_scale(samples.effects)
            RECIPES[config.recipe](model, samples, config, generator, progress or _silent)
            fits.append((model, assess(model, kept, held_out)))
    best = int(np.argmax([report["r2_through_codes"] for _, report in fits]))
    model, report = fits[best]
    report["restarts"] = [figures["r2_through_codes"] for _, figures in fits]
    model.trained_by = {
        "training": asdict(config),
        "seed": seed,
        "interactions": len(interactions),
        "origin": interactions.origin,
    }
    return model, report


def split(interactions: Interactions, share: float, seed: int) -> tuple[Interactions, Interactions]:
    """Split a data set into the part to train on and the part held out.

    Args:
        interactions: The data.
        share: Share that is held out.
        seed: Decides which.

    Raises:
        InvalidValue: If there are too few.
    """
    if problem := too_few(len(interactions)):
        raise InvalidValue(f"{problem}.")
    order = np.random.default_rng([seed, len(interactions)]).permutation(len(interactions))
    held_out = max(2, round(share * len(interactions)))
    return interactions[order[held_out:]], interactions[order[:held_out]]


def assess(model: EffectModel, kept: Interactions, held_out: Interactions) -> TrainingReport:
    """Measure a model on interactions that it was not trained on.

    Returns:
        `r2_through_codes` and `r2` (without cutting the embeddings to bits), mean over the axes and per axis;
        `mae` [m] per axis of the model (through codes) and of the trivial predictors always-zero, always-mean
        and per-axis median; `object_symbols` and `action_symbols`, the share of each.

    Args:
        model: The model.
        kept: What it was trained on, from which the trivial predictors come.
        held_out: What it is measured on.
    """
    effects = np.asarray(held_out.effects, dtype=np.float64)
    coded, _ = model.predict_from_codes(held_out.features, held_out.actions)
    direct, _ = model.predict(held_out.features, held_out.actions)
    predictors = {
        "model": coded,
        "always zero": np.zeros_like(effects),
        "always mean": np.broadcast_to(kept.effects.mean(0), effects.shape),
        "per-axis median": np.broadcast_to(np.median(kept.effects, axis=0), effects.shape),
    }
    r2_coded, r2_direct = r_squared(coded, effects), r_squared(direct, effects)
    return {
        "held_out": len(held_out),
        "r2_through_codes": float(r2_coded.mean()),
        "r2_through_codes_by_axis": r2_coded.tolist(),
        "r2": float(r2_direct.mean()),
        "r2_by_axis": r2_direct.tolist(),
        "mae": {name: np.abs(guess - effects).mean(0).tolist() for name, guess in predictors.items()},
        "object_symbols": _shares(model.object_symbols(held_out.features)),
        "action_symbols": _shares(model.action_symbols(held_out.actions)),
    }


def r_squared(
    predicted: Float[np.ndarray, "N E"], observed: Float[np.ndarray, "N E"]
) -> Float[np.ndarray, "E"]:
    """Compute the share of the variance that is explained, per axis; 0 where there is no variance."""
    residual = ((predicted - observed) ** 2).sum(0)
    total = ((observed - observed.mean(0)) ** 2).sum(0)
    return np.where(total > 1e-12, 1 - residual / np.maximum(total, 1e-12), 0.0)


def samples_of(interactions: Interactions) -> Samples:
    """Turn a data set into tensors, with the box of its actions."""
    actions, origin = interactions.actions, interactions.origin
    return Samples(
        features=_tensor(interactions.features),
        actions=_tensor(actions),
        effects=_tensor(interactions.effects),
        low=_tensor(np.asarray(origin.get("action_low", actions.min(0)))),
        high=_tensor(np.asarray(origin.get("action_high", actions.max(0)))),
    )


def dimensions_of(interactions: Interactions) -> Dimensions:
    """Read from a data set what a network for it must read and write."""
    return Dimensions(
        features=interactions.features.shape[1],
        actions=interactions.actions.shape[1],
        effects=interactions.effects.shape[1],
        gripper_columns=tuple(interactions.origin.get("gripper_columns", ())),
    )


def _restart_seed(seed: int, restart: int) -> int:
    return int(np.random.default_rng([seed, restart]).integers(2**62))


def _shares(symbols: tuple[str, ...]) -> dict[str, float]:
    names, counts = np.unique(symbols, return_counts=True)
    return {str(name): float(count) / len(symbols) for name, count in zip(names, counts, strict=True)}


def _tensor(values: np.ndarray) -> torch.Tensor:
    return torch.from_numpy(np.array(values, dtype=np.float32))


def _silent(stage: str, share: float) -> None:
    """Report nothing."""
