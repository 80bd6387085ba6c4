"""Recipes of the final fit: ways to make the bits of the symbols hold what the effect needs.

* **joint**: the paper's. The whole network descends eq. 9; the embeddings are cut to their signs afterwards.
  They were never near +-1, so the cut costs much of what had been learned.
* **refit**: after that, the codes are frozen and the decoder is fitted to them.
* **taught**: a network without a bottleneck learned the effects first, and says what would happen in
  interactions that were never made. The encoders learn end to end what to tell in their bits: an embedding z
  is read as independent bits that are 1 with probability (1 + z) / 2, and the expected squared error over
  all codes is descended, exactly. Since that has poor local optima, it begins with encoders that were fitted
  to name what a co-clustering of the teacher's predictions says that codes stand for (`code_targets.py`).
  Last, the decoder is fitted to codes (eq. 7) of imagined interactions: of actions and objects as they come,
  and not as somebody curious chose them.
"""

from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass, replace
from functools import partial
from itertools import product

import torch
from torch import Tensor, nn

from neurosym.arrays import Float, Int
from neurosym.learning.code_targets import CodeTargets, find_code_targets
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.effect_model import EffectModel, as_signs
from neurosym.learning.inputs import reflected
from neurosym.learning.losses import (
    BatchLoss,
    FitProgress,
    prediction_loss,
    run_epochs,
    total_loss,
)
from neurosym.learning.samples import Samples
from neurosym.learning.training_config import TrainingConfig

_LIKELIHOOD_WEIGHT = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """One fit of an effect model.

    Attributes:
        model: The model.
        teacher: A network without a bottleneck on the same data.
        samples: The training data.
        config: How it is fitted.
        generator: Source of randomness.
        progress: Told how far it has come.
    """

    model: EffectModel
    teacher: DirectModel
    samples: Samples
    config: TrainingConfig
    generator: torch.Generator
    progress: FitProgress

    def imagine(self, count: int) -> tuple[Float[Tensor, "B F"], Float[Tensor, "B A"]]:
        """Draw objects and actions, for the teacher to say what would happen."""
        return self.samples.imagine(count, self.generator)

    def codes_of(self, features: Tensor, actions: Tensor) -> tuple[Tensor, Tensor]:
        """Encode objects and actions into codes of +-1."""
        return as_signs(self.model.embed_objects(features)), as_signs(self.model.embed_actions(actions))

    def descend(
        self, stage: str, loss_of: BatchLoss, rows: int, parameters: list[nn.Parameter], epochs: int
    ) -> None:
        """Descend a loss of batches of so many rows by Adam, as the configuration says."""
        run_epochs(
            loss_of,
            rows,
            torch.optim.Adam(parameters, lr=self.config.learning_rate, fused=True),
            self.generator,
            epochs=epochs,
            batch=self.config.batch,
            clip_norm=self.config.clip_norm,
            decay=self.config.decay,
            after_epoch=lambda done: self.progress(stage, done / epochs),
        )

    def descend_decoder(self, loss_of: BatchLoss, rows: int, epochs: int) -> None:
        """Descend a loss with the decoder alone; the encoders stay as they are."""
        decoder = [*self.model.norm.parameters(), *self.model.decoder.parameters()]
        self.descend("decoder", loss_of, rows, decoder, epochs)


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


def _fit_jointly(fit: Fit) -> None:
    """Descend eq. 9, as the paper does."""
    config, model = fit.config, fit.model

    def loss_of(rows: Tensor) -> Tensor:
        temperature = config.temperature if config.contrastive else None
        batch = fit.samples.batch(rows, fit.generator)
        return total_loss(model, *batch, coefficient=config.loss_coefficient, temperature=temperature)

    model.train()
    fit.descend("fitting", loss_of, len(fit.samples), list(model.parameters()), config.epochs)
    model.eval()


def _fit_and_refit(fit: Fit) -> None:
    _fit_jointly(fit)
    _refit_decoder(fit)


def _fit_as_taught(fit: Fit) -> None:
    """Learn what the bits should say from a network without a bottleneck; see the head of this file."""
    fit.progress("meanings", 0.0)
    bits = fit.model.config
    fit = replace(fit, config=fit.config.for_bits(bits.action_bits, bits.object_bits))
    targets = find_code_targets(fit.teacher, bits, fit.samples, fit.config, fit.generator)
    _fit_names(fit, targets)
    _fit_encoders(fit, nn.Parameter(targets.effects))
    if fit.config.decoder.learns_from == "imagined":
        _fit_decoder(fit)
    else:
        _refit_decoder(fit)


def _refit_decoder(fit: Fit) -> None:
    """Fit the decoder to the codes that the frozen encoders give, without dropout."""
    fit.model.eval()

    def loss_of(rows: Tensor) -> Tensor:
        features, actions, effects = fit.samples.batch(rows, fit.generator)
        with torch.no_grad():
            codes = fit.codes_of(features, actions)
        return prediction_loss(fit.model, *codes, effects)

    fit.descend_decoder(loss_of, len(fit.samples), fit.config.decoder.epochs)


def _fit_names(fit: Fit, targets: CodeTargets) -> None:
    """Fit each encoder so that the codes it gives are expected to cost little; the best of several starts.

    From some starts an encoder never comes to use one of the codes.
    """
    model = fit.model
    parts = (
        ("actions", model.action_encoder, model.embed_actions, targets.actions, targets.action_costs),
        ("objects", model.object_encoder, model.embed_objects, targets.features, targets.object_costs),
    )
    for stage, encoder, embed, inputs, costs in parts:
        found: list[tuple[float, dict[str, Tensor]]] = []
        for start in range(fit.config.naming.starts):
            if start:
                encoder.apply(_begin_anew)
            _fit_naming(fit, stage, encoder, embed, inputs, costs)
            with torch.inference_mode():
                named = code_probabilities(embed(inputs)).argmax(1, keepdim=True)
                cost = float(costs.gather(1, named).mean())
            found.append((cost, deepcopy(encoder.state_dict())))
        encoder.load_state_dict(min(found, key=lambda fit: fit[0])[1])


def _fit_naming(
    fit: Fit,
    stage: str,
    encoder: nn.Module,
    embed: Callable[[Tensor], Tensor],
    inputs: Tensor,
    costs: Float[Tensor, "N L"],
) -> None:
    """Descend the expected cost, and a little of the surprise at the cheapest code.

    Without the latter, an encoder that gives everything one code could never leave it: tanh is flat there.
    """
    cheapest, config = costs.argmin(1, keepdim=True), fit.config

    def loss() -> Tensor:
        rows = torch.randint(len(inputs), (config.naming.batch,), generator=fit.generator)
        likely = code_probabilities(embed(inputs[rows]))
        right = likely.gather(1, cheapest[rows]).clamp(min=1e-6)
        return (likely * costs[rows]).sum(1).mean() - _LIKELIHOOD_WEIGHT * right.log().mean()

    encoder.train()
    report = partial(fit.progress, f"naming {stage}")
    _take_steps(loss, list(encoder.parameters()), config.naming.steps, config.coding.rate, report)
    encoder.eval()


def _begin_anew(layer: nn.Module) -> None:
    if isinstance(layer, nn.Linear | nn.BatchNorm1d):
        layer.reset_parameters()


def _fit_encoders(fit: Fit, effects: nn.Parameter) -> None:
    """Descend the expected squared error over all codes, of what the teacher says of imagined interactions.

    Each step imagines every one of some actions on every one of some objects. The effect (La, Lo, E) that
    each pair of codes stands for is learned, too.
    """
    model, coding = fit.model, fit.config.coding
    rows, columns = coding.actions, coding.objects
    encoders = nn.ModuleList([model.object_encoder, model.action_encoder]).train()

    def loss() -> Tensor:
        _, actions = fit.imagine(rows)
        features, _ = fit.imagine(columns)
        with torch.no_grad():
            pairs = features.repeat(rows, 1), actions.repeat_interleave(columns, 0)
            targets = fit.teacher.standard_effects(*pairs)
        by_action = code_probabilities(model.embed_actions(actions))
        by_object = code_probabilities(model.embed_objects(features))
        return expected_error(by_action, by_object, effects, targets.view(rows, columns, -1))

    report = partial(fit.progress, "codes")
    _take_steps(loss, [*encoders.parameters(), effects], coding.steps, coding.rate / 2, report)
    encoders.eval()


def _take_steps(
    loss: Callable[[], Tensor],
    parameters: list[nn.Parameter],
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


def _fit_decoder(fit: Fit) -> None:
    """Fit the decoder to what is imagined, by eq. 7.

    What happens is what the teacher predicts, and beside it what it left unexplained of some interaction that
    was made with the same codes.
    """
    model, teacher, samples, decoder = fit.model, fit.teacher, fit.samples, fit.config.decoder
    model.eval()
    with torch.no_grad():
        features, _ = fit.imagine(decoder.imagined)
        _, actions = fit.imagine(decoder.imagined)
        objects, chosen = codes = fit.codes_of(features, actions)
        unexplained = samples.effects - teacher.effects(samples.features, samples.actions)
        known = fit.codes_of(samples.features, samples.actions)
        rows = draw_alike(torch.cat(codes, 1), torch.cat(known, 1), fit.generator)
        effects = teacher.effects(features, actions) + unexplained[rows]

    def loss_of(rows: Tensor) -> Tensor:
        return prediction_loss(model, objects[rows], chosen[rows], effects[rows])

    fit.descend_decoder(loss_of, len(effects), decoder.imagined_epochs)


def draw_alike(
    wanted: Float[Tensor, "N K"], there: Float[Tensor, "M K"], generator: torch.Generator
) -> Int[Tensor, "N"]:
    """Draw for each code one of those that are there which differs from it in as few bits as possible.

    Args:
        wanted: Codes, of +-1.
        there: Codes to draw from.
        generator: Source of randomness, owned by the caller.
    """
    drawn = torch.empty(len(wanted), dtype=torch.long)
    for code in torch.unique(wanted, dim=0):
        agreement = there @ code
        pool = torch.nonzero(agreement == agreement.max())[:, 0]
        places = torch.nonzero((wanted == code).all(1))[:, 0]
        drawn[places] = pool[torch.randint(len(pool), (len(places),), generator=generator)]
    return drawn


RECIPES: dict[str, Callable[[Fit], None]] = {
    "joint": _fit_jointly,
    "refit": _fit_and_refit,
    "taught": _fit_as_taught,
}
