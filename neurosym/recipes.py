"""Recipes of the final fit: ways to make the bits of the symbols hold what the effect needs.

* **joint**: the paper's. The whole network descends eq. 9; the embeddings are cut to their signs afterwards.
  They were never near +-1, so the cut costs much of what had been learned.
* **refit**: after that, the codes are frozen and the decoder is fitted to them.
* **taught**: a network without a bottleneck learned the effects first, and says what would happen in
  interactions that were never made. The encoders learn end to end what to tell in their bits: an embedding z
  is read as independent bits that are 1 with probability (1 + z) / 2, and the expected squared error over
  all codes is descended, exactly. Since that has poor local optima, it begins with encoders that were fitted
  to a co-clustering of the teacher's predictions (`meanings.py`). Last, the decoder is fitted to the codes
  (eq. 7).
"""

from collections.abc import Callable
from functools import partial
from itertools import product

import torch
from jaxtyping import Float
from torch import Tensor, nn

from neurosym.direct_model import DirectModel
from neurosym.effect_model import EffectModel, as_signs
from neurosym.fitting import prediction_loss, run_epochs, total_loss
from neurosym.meanings import Meanings, find_meanings
from neurosym.network_inputs import reflected
from neurosym.samples import Samples
from neurosym.training_config import TrainingConfig

Progress = Callable[[str, float], None]
"""Called with what is being done and the share of it that is done."""

_LIKELIHOOD_WEIGHT = 0.05


def fit_direct(
    model: DirectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
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
            model.parameters(), lr=config.direct_rate, weight_decay=config.direct_weight_decay, fused=True
        ),
        generator,
        epochs=config.direct_epochs,
        batch=config.direct_batch,
        clip_norm=config.clip_norm,
        decay=True,
        after_epoch=lambda done: progress("teacher", done / config.direct_epochs),
    )
    model.eval()


def fit_jointly(
    model: EffectModel,
    teacher: DirectModel,  # noqa: ARG001 (one signature for all)
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Descend eq. 9, as the paper does."""

    def loss_of(rows: Tensor) -> Tensor:
        temperature = config.temperature if config.contrastive else None
        batch = samples.batch(rows, generator)
        return total_loss(model, *batch, coefficient=config.loss_coefficient, temperature=temperature)

    model.train()
    _descend(
        loss_of, len(samples), list(model.parameters()), config.epochs, config, generator, progress, "fitting"
    )
    model.eval()


def fit_and_refit(
    model: EffectModel,
    teacher: DirectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
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
    progress: Progress,
) -> None:
    """Learn what the bits should say from a network without a bottleneck; see the head of this file."""
    progress("meanings", 0.0)
    meanings = find_meanings(teacher, model.config, samples, config, generator)
    fit_names(model, meanings, config, generator, progress)
    fit_encoders(model, teacher, nn.Parameter(meanings.effects), samples, config, generator, progress)
    refit_decoder(model, samples, config, generator, progress)


def fit_names(
    model: EffectModel,
    meanings: Meanings,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Fit each encoder so that the codes it gives are expected to cost little.

    Without the likelihood of the cheapest code, an encoder that gives everything one code could never leave
    it: tanh is flat there.
    """
    parts = (
        ("actions", model.action_encoder, model.embed_actions, meanings.actions, meanings.action_costs),
        ("objects", model.object_encoder, model.embed_objects, meanings.features, meanings.object_costs),
    )
    for stage, encoder, embed, inputs, costs in parts:
        cheapest = costs.argmin(1, keepdim=True)

        def loss() -> Tensor:
            rows = torch.randint(len(inputs), (config.naming_batch,), generator=generator)  # noqa: B023
            likely = code_probabilities(embed(inputs[rows]))  # noqa: B023 (called in this round only)
            right = likely.gather(1, cheapest[rows]).clamp(min=1e-6)  # noqa: B023
            return (likely * costs[rows]).sum(1).mean() - _LIKELIHOOD_WEIGHT * right.log().mean()  # noqa: B023

        encoder.train()
        report = partial(progress, f"naming {stage}")
        _take_steps(loss, list(encoder.parameters()), config.naming_steps, config.code_rate, report)
        encoder.eval()


def fit_encoders(
    model: EffectModel,
    teacher: DirectModel,
    effects: nn.Parameter,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Descend the expected squared error over all codes, of what the teacher says of imagined interactions.

    Each step imagines every one of some actions on every one of some objects.

    Args:
        model: Whose encoders learn.
        teacher: Says what would happen.
        effects: The effect (La, Lo, E) that each pair of codes stands for; learned, too.
        samples: Whose objects and action box are imagined with.
        config: How many steps.
        generator: Source of randomness, owned by the caller.
        progress: Told of the steps.
    """
    rows, columns = config.imagined_actions, config.imagined_objects
    encoders = nn.ModuleList([model.object_encoder, model.action_encoder]).train()

    def loss() -> Tensor:
        _, actions = samples.imagine(rows, generator)
        features, _ = samples.imagine(columns, generator)
        with torch.no_grad():
            pairs = features.repeat(rows, 1), actions.repeat_interleave(columns, 0)
            targets = teacher.standard_effects(*pairs)
        by_action = code_probabilities(model.embed_actions(actions))
        by_object = code_probabilities(model.embed_objects(features))
        return expected_error(by_action, by_object, effects, targets.view(rows, columns, -1))

    report = partial(progress, "codes")
    _take_steps(loss, [*encoders.parameters(), effects], config.code_steps, config.code_rate / 2, report)
    encoders.eval()


def expected_error(
    by_action: Float[Tensor, "R La"],
    by_object: Float[Tensor, "C Lo"],
    effects: Float[Tensor, "La Lo E"],
    targets: Float[Tensor, "R C E"],
) -> Float[Tensor, ""]:
    """Compute the squared error expected if codes are drawn, mean over actions and objects, sum over axes.

    Args:
        by_action: Probability of each code of each action.
        by_object: Probability of each code of each object.
        effects: The effect that each pair of codes stands for.
        targets: What happens.
    """
    means = torch.einsum("ri,ije->rje", by_action, effects)  # (R, Lo, E)
    squares = by_action @ (effects**2).sum(2) @ by_object.T  # (R, C)
    products = torch.einsum("rce,cj,rje->rc", targets, by_object, means)
    return ((targets**2).sum(2) - 2 * products + squares).mean()


def code_probabilities(embeddings: Float[Tensor, "B K"]) -> Float[Tensor, "B L"]:
    """Compute how likely each code is, in counting order, if a bit is 1 with probability (1 + z) / 2."""
    signs = torch.tensor(list(product((-1.0, 1.0), repeat=embeddings.shape[1])))  # (L, K)
    probabilities: Tensor = ((1 + embeddings[:, None, :] * signs) / 2).prod(2)
    return probabilities


def refit_decoder(
    model: EffectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: Progress,
) -> None:
    """Fit the decoder to the codes that the frozen encoders give, without dropout."""
    model.eval()

    def loss_of(rows: Tensor) -> Tensor:
        features, actions, effects = samples.batch(rows, generator)
        with torch.no_grad():
            objects = as_signs(model.embed_objects(features))
            chosen = as_signs(model.embed_actions(actions))
        return prediction_loss(model, objects, chosen, effects)

    decoder = [*model.norm.parameters(), *model.decoder.parameters()]
    _descend(loss_of, len(samples), decoder, config.refit_epochs, config, generator, progress, "decoder")


Recipe = Callable[[EffectModel, DirectModel, Samples, TrainingConfig, torch.Generator, Progress], None]
RECIPES: dict[str, Recipe] = {"joint": fit_jointly, "refit": fit_and_refit, "taught": fit_as_taught}


def _take_steps(
    loss: Callable[[], Tensor],
    parameters: list[torch.nn.Parameter],
    steps: int,
    rate: float,
    report: Callable[[float], None],
) -> None:
    """Descend a loss that draws its own batches, the step size rising to `rate` and falling to 0."""
    optimiser = torch.optim.Adam(parameters, lr=rate, fused=True)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, rate, total_steps=steps)
    for step in range(steps):
        optimiser.zero_grad()
        loss().backward()  # type: ignore[no-untyped-call]
        optimiser.step()
        schedule.step()
        report((step + 1) / steps)


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
