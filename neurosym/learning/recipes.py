"""Recipes of the final fit: ways to make the bits of the symbols hold what the effect needs.

* **joint**: the paper's. The whole network descends eq. 9; the embeddings are cut to their signs afterwards.
  They were never near +-1, so the cut costs much of what had been learned.
* **refit**: after that, the codes are frozen and the decoder is fitted to them.
* **taught**: a network without a bottleneck learned the effects first, and says what would happen in
  interactions that were never made. The encoders learn end to end what to tell in their bits: an embedding z
  is read as independent bits that are 1 with probability (1 + z) / 2, and the expected squared error over
  all codes is descended, exactly. Since that has poor local optima, it begins with encoders that were fitted
  to a co-clustering of the teacher's predictions (`code_targets.py`). Last, the decoder is fitted to codes
  (eq. 7) of imagined interactions (`teaching.py`).
"""

from collections.abc import Callable
from functools import partial

import torch
from torch import Tensor, nn

from neurosym.learning.code_targets import find_code_targets
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.effect_model import EffectModel
from neurosym.learning.inputs import reflected
from neurosym.learning.losses import FitProgress, descend, prediction_loss, run_epochs, total_loss
from neurosym.learning.samples import Samples
from neurosym.learning.teaching import descend_decoder, fit_decoder, fit_encoders, fit_names, signs_of
from neurosym.learning.training_config import TrainingConfig


def fit_direct(
    model: DirectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
) -> None:
    """Fit a network without a bottleneck to what happened, by squared error."""
    outcomes = samples.outcomes(peaks=model.config.peaks)

    def loss_of(rows: Tensor) -> Tensor:
        actions, targets = reflected(samples.actions[rows], outcomes[rows], samples.mirrors, generator)
        targets = (targets - model.effect_mean) / model.effect_std
        return nn.functional.mse_loss(model(samples.features[rows], actions), targets)

    model.train()
    run_epochs(
        loss_of,
        len(samples),
        torch.optim.AdamW(
            model.parameters(), lr=config.teacher.rate, weight_decay=config.teacher.weight_decay, fused=True
        ),
        generator,
        epochs=config.teacher.epochs,
        batch=config.teacher.batch,
        clip_norm=config.clip_norm,
        decay=True,
        after_epoch=lambda done: progress("teacher", done / config.teacher.epochs),
    )
    model.eval()


def fit_jointly(
    model: EffectModel,
    teacher: DirectModel,  # noqa: ARG001 (one signature for all)
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
) -> None:
    """Descend eq. 9, as the paper does."""

    def loss_of(rows: Tensor) -> Tensor:
        temperature = config.temperature if config.contrastive else None
        batch = samples.batch(rows, generator)
        return total_loss(model, *batch, coefficient=config.loss_coefficient, temperature=temperature)

    model.train()
    report = partial(progress, "fitting")
    whole = list(model.parameters())
    descend(loss_of, len(samples), whole, config, generator, epochs=config.epochs, report=report)
    model.eval()


def fit_and_refit(
    model: EffectModel,
    teacher: DirectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
) -> None:
    """Descend eq. 9, then fit the decoder to the frozen codes."""
    fit_jointly(model, teacher, samples, config, generator, progress)
    refit_decoder(model, samples, config, generator, progress)


def fit_as_taught(
    model: EffectModel,
    teacher: DirectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
) -> None:
    """Learn what the bits should say from a network without a bottleneck; see the head of this file."""
    progress("meanings", 0.0)
    config = config.for_bits(model.config.action_bits, model.config.object_bits)
    targets = find_code_targets(teacher, model.config, samples, config, generator)
    fit_names(model, targets, config, generator, progress)
    fit_encoders(model, teacher, nn.Parameter(targets.effects), samples, config, generator, progress)
    if config.decoder.learns_from == "imagined":
        fit_decoder(model, teacher, samples, config, generator, progress)
    else:
        refit_decoder(model, samples, config, generator, progress)


def refit_decoder(
    model: EffectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
) -> None:
    """Fit the decoder to the codes that the frozen encoders give, without dropout."""
    model.eval()

    def loss_of(rows: Tensor) -> Tensor:
        features, actions, effects = samples.batch(rows, generator)
        with torch.no_grad():
            objects, chosen = signs_of(model, features, actions)
        return prediction_loss(model, objects, chosen, effects)

    descend_decoder(model, loss_of, len(samples), config, generator, config.decoder.epochs, progress)


Recipe = Callable[[EffectModel, DirectModel, Samples, TrainingConfig, torch.Generator, FitProgress], None]
RECIPES: dict[str, Recipe] = {"joint": fit_jointly, "refit": fit_and_refit, "taught": fit_as_taught}
