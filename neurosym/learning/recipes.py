"""Recipes of the final fit: ways to make the bits of the symbols hold what the effect needs.

* **joint**: the paper's. The whole network descends eq. 9; the embeddings are cut to their signs afterwards.
  They were never near +-1, so the cut costs much of what had been learned.
* **refit**: after that, the codes are frozen and the decoder is fitted to them.
* **taught**: a network without a bottleneck learned the effects first, and says what would happen in
  interactions that were never made. The encoders learn end to end what to tell in their bits: an embedding z
  is read as independent bits that are 1 with probability (1 + z) / 2, and the expected squared error over
  all codes is descended, exactly. Since that has poor local optima, it begins with encoders that were fitted
  to name what a co-clustering of the teacher's predictions says that codes stand for.
  Last, the decoder is fitted to codes (eq. 7) of imagined interactions: of actions and objects as they come,
  and not as somebody curious chose them.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from dataclasses import dataclass, replace
from functools import cache, partial
from itertools import product

import numpy as np
import torch
from torch import Tensor, nn

from neurosym.checks import Float, Int
from neurosym.data.origin import Dimensions
from neurosym.learning.coclustering import cocluster, gray_order, profiles
from neurosym.learning.losses import (
    BatchLoss,
    FitProgress,
    Samples,
    prediction_loss,
    reproducible,
    run_epochs,
    squared_error,
    total_loss,
)
from neurosym.learning.network import DirectModel, EffectModel, as_signs
from neurosym.learning.training_config import ModelConfig, TrainingConfig

# What the codes shall stand for, to begin with: a co-clustering of what a teacher predicts.
#
# The teacher, a network without a bottleneck, fills a table with the effects of drawn actions on drawn
# objects. The table is co-clustered into as many kinds of action and of object as there are codes. Then the
# teacher says of many more actions and objects what it would cost to call them this or that.

_AT_ONCE = 20_000  # predictions
_THREADS = 2  # which ask the teacher; parts are the same on one processor
_OBJECTS_ASKED = 24  # to see what kind an action is
_ACTIONS_ASKED = 128  # to see what kind an object is


@dataclass(frozen=True, slots=True, eq=False)
class CodeTargets:
    """What codes stand for, and examples of what should be called how."""

    effects: Float[Tensor, "La Lo E"]  # effect that each pair of codes stands for, standardised
    actions: Float[Tensor, "R A"]  # actions to be named
    # what each code would cost as the name of each: mean squared error of the effect, less that of the best
    # code, and divided by the mean of all
    action_costs: Float[Tensor, "R La"]
    features: Float[Tensor, "C F"]  # objects to be named
    object_costs: Float[Tensor, "C Lo"]  # the same for them


def find_code_targets(
    teacher: DirectModel,
    bits: ModelConfig,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
) -> CodeTargets:
    """Co-cluster what the teacher predicts. Codes are given so that kinds one bit apart are alike."""
    rng, naming = np.random.default_rng(int(torch.randint(2**31, (1,), generator=generator))), config.naming
    features, _ = samples.imagine(naming.table_objects, generator)
    _, actions = samples.imagine(naming.table_actions, generator)
    table = _table(teacher, features, actions).numpy()  # (R, C, E)
    kinds = 2**bits.action_bits, 2**bits.object_bits
    found = cocluster(table, *kinds, rng, restarts=naming.table_restarts)
    rows, columns = np.eye(kinds[0])[found.rows], np.eye(kinds[1])[found.columns]  # (R, La), (C, Lo)
    row_codes = gray_order(_means_of_kinds(profiles(table, found.columns, kinds[1]), rows), rng)
    flipped = profiles(table.transpose(1, 0, 2), found.rows, kinds[0])
    column_codes = gray_order(_means_of_kinds(flipped, columns), rng)
    counts = np.maximum(np.outer(rows.sum(0), columns.sum(0)), 1)[:, :, None]
    effects = np.empty((*kinds, table.shape[2]))
    blocks = np.einsum("rce,rk,cl->kle", table, rows, columns, optimize=True) / counts
    effects[np.ix_(row_codes, column_codes)] = blocks
    objects = _some_of_each(found.columns, _OBJECTS_ASKED, rng)
    shown = rng.permutation(len(actions))[:_ACTIONS_ASKED]
    more_features, _ = samples.imagine(naming.objects, generator)
    _, more_actions = samples.imagine(naming.actions, generator)
    by_object = _table(teacher, features[objects], more_actions).numpy()
    by_action = _table(teacher, more_features, actions[shown]).numpy().transpose(1, 0, 2)
    object_codes, action_codes = column_codes[found.columns], row_codes[found.rows]
    return CodeTargets(
        effects=torch.from_numpy(effects).float(),
        actions=more_actions,
        action_costs=_costs(by_object, effects, object_codes[objects], object_codes),
        features=more_features,
        object_costs=_costs(by_action, effects.transpose(1, 0, 2), action_codes[shown], action_codes),
    )


def _means_of_kinds(
    points: Float[np.ndarray, "R D"], members: Float[np.ndarray, "R L"]
) -> Float[np.ndarray, "L D"]:
    """Average the points of each kind; members are 1 for the kind that a point is of, else 0."""
    means: np.ndarray = members.T @ points / np.maximum(members.sum(0), 1)[:, None]
    return means


def _costs(
    table: Float[np.ndarray, "R C E"],
    effects: Float[np.ndarray, "L K E"],
    codes: Int[np.ndarray, "C"],
    whole: Int[np.ndarray, "S"],
) -> Float[Tensor, "R L"]:
    """Reckon what each code would cost each row, columns of a code counting as often as in the whole table.

    Of this table and of the whole one, the code of each column is given.
    """
    shares = np.bincount(whole, minlength=effects.shape[1]) / len(whole)
    costs = np.zeros((len(table), len(effects)))
    for code in np.unique(codes):
        mean = table[:, codes == code].mean(1)  # (R, E)
        costs += shares[code] * ((mean[:, None] - effects[:, code]) ** 2).sum(2)
    costs -= costs.min(1, keepdims=True)
    return torch.from_numpy(costs / (costs.mean() or 1.0)).float()


def _some_of_each(labels: Int[np.ndarray, "C"], count: int, rng: np.random.Generator) -> Int[np.ndarray, "S"]:
    """Take equally many members of each kind, some of them twice if a kind has too few."""
    kinds = np.unique(labels)
    each = max(1, count // len(kinds))
    return np.concatenate([rng.choice(np.flatnonzero(labels == kind), each) for kind in kinds])


def _table(
    teacher: DirectModel, features: Float[Tensor, "C F"], actions: Float[Tensor, "R A"]
) -> Float[Tensor, "R C E"]:
    """Predict standardised effects of every action on every object, in parts, two of them at a time."""

    def predicted(part: Tensor) -> Tensor:
        with torch.no_grad():
            pairs = features.repeat(len(part), 1), part.repeat_interleave(len(features), 0)
            return teacher.standard_effects(*pairs)

    size = min(_AT_ONCE // len(features), math.ceil(len(actions) / _THREADS))
    parts = _threads().map(predicted, torch.split(actions, max(1, size)))
    return torch.cat([*parts]).view(len(actions), len(features), -1)


@cache
def _threads() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(_THREADS)


_LIKELIHOOD_WEIGHT = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """One fit of an effect model, taught by a network without a bottleneck on the same data."""

    model: EffectModel
    teacher: DirectModel
    samples: Samples
    config: TrainingConfig
    generator: torch.Generator
    progress: FitProgress

    def codes_of(self, features: Tensor, actions: Tensor) -> tuple[Tensor, Tensor]:
        """Encode objects and actions into codes of +-1."""
        return as_signs(self.model.embed_objects(features)), as_signs(self.model.embed_actions(actions))

    def descend(
        self, stage: str, loss_of: BatchLoss, rows: int, parameters: Iterable[nn.Parameter], epochs: int
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
    samples: Samples, dimensions: Dimensions, config: TrainingConfig, seed: int, progress: FitProgress
) -> DirectModel:
    """Fit a network without a bottleneck to what happened, by squared error."""
    teacher = config.teacher
    if teacher.network.peaks:
        samples = replace(samples, effects=torch.cat([samples.effects, samples.peaks[:, None]], dim=1))
    with reproducible(seed) as generator:
        model = DirectModel(dimensions, teacher.network).train()
        model.set_scale(samples.effects, samples.mirrored_axes)
        run_epochs(
            lambda rows: squared_error(model, *samples.batch(rows, generator)),
            len(samples),
            torch.optim.AdamW(
                model.parameters(), lr=teacher.rate, weight_decay=teacher.weight_decay, fused=True
            ),
            generator,
            epochs=teacher.epochs,
            batch=teacher.batch,
            clip_norm=config.clip_norm,
            decay=True,
            after_epoch=lambda done: progress("teacher", done / teacher.epochs),
        )
    return model.eval()


def _fit_jointly(fit: Fit) -> None:
    """Descend eq. 9, as the paper does."""
    config, model = fit.config, fit.model

    def loss_of(rows: Tensor) -> Tensor:
        temperature = config.temperature if config.contrastive else None
        batch = fit.samples.batch(rows, fit.generator)
        return total_loss(model, *batch, coefficient=config.loss_coefficient, temperature=temperature)

    model.train()
    fit.descend("fitting", loss_of, len(fit.samples), model.parameters(), config.epochs)
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
    _fit_only_decoder(fit)


def keep_bits(fit: Fit, known: EffectModel) -> None:
    """Take the encoders of another model, whose symbols shall stay what they are, and fit the decoder."""
    fit.model.object_encoder.load_state_dict(known.object_encoder.state_dict())
    fit.model.action_encoder.load_state_dict(known.action_encoder.state_dict())
    _fit_only_decoder(fit)


def _fit_only_decoder(fit: Fit) -> None:
    (_fit_decoder if fit.config.decoder.learns_from == "imagined" else _refit_decoder)(fit)


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
    model, config = fit.model, fit.config
    parts = (
        ("actions", model.action_encoder, model.embed_actions, targets.actions, targets.action_costs),
        ("objects", model.object_encoder, model.embed_objects, targets.features, targets.object_costs),
    )
    for stage, encoder, embed, inputs, costs in parts:
        loss = partial(_naming_loss, fit, embed, inputs, costs, costs.argmin(1, keepdim=True))
        report = partial(fit.progress, f"naming {stage}")
        found: list[tuple[float, dict[str, Tensor]]] = []
        for start in range(config.naming.starts):
            if start:
                encoder.apply(_begin_anew)
            _take_steps(loss, encoder.train(), (), config.naming.steps, config.coding.rate, report)
            with torch.inference_mode():
                named = code_probabilities(embed(inputs)).argmax(1, keepdim=True)
                cost = float(costs.gather(1, named).mean())
            found.append((cost, deepcopy(encoder.state_dict())))
        encoder.load_state_dict(min(found, key=lambda fit: fit[0])[1])


def _naming_loss(
    fit: Fit,
    embed: Callable[[Tensor], Tensor],
    inputs: Tensor,
    costs: Float[Tensor, "N L"],
    cheapest: Int[Tensor, "N 1"],
) -> Tensor:
    """Compute the expected cost of names, and a little of the surprise at the cheapest code.

    Without the latter, an encoder that gives everything one code could never leave it: tanh is flat there.
    """
    rows = torch.randint(len(inputs), (fit.config.naming.batch,), generator=fit.generator)
    likely = code_probabilities(embed(inputs[rows]))
    right = likely.gather(1, cheapest[rows]).clamp(min=1e-6)
    return (likely * costs[rows]).sum(1).mean() - _LIKELIHOOD_WEIGHT * right.log().mean()


def _begin_anew(layer: nn.Module) -> None:
    if isinstance(layer, nn.Linear | nn.BatchNorm1d):
        layer.reset_parameters()


def _fit_encoders(fit: Fit, effects: nn.Parameter) -> None:
    """Descend the expected squared error over all codes, of what the teacher says of imagined interactions.

    Each step imagines every one of some actions on every one of some objects. The effect (La, Lo, E) that
    each pair of codes stands for is learned, too.
    """
    model, samples, coding = fit.model, fit.samples, fit.config.coding
    rows, columns = coding.actions, coding.objects

    def loss() -> Tensor:
        _, actions = samples.imagine(rows, fit.generator)
        features, _ = samples.imagine(columns, fit.generator)
        targets = _table(fit.teacher, features, actions)
        by_action = code_probabilities(model.embed_actions(actions))
        by_object = code_probabilities(model.embed_objects(features))
        return expected_error(by_action, by_object, effects, targets)

    encoders = nn.ModuleList([model.object_encoder, model.action_encoder]).train()
    _take_steps(loss, encoders, (effects,), coding.steps, coding.rate / 2, partial(fit.progress, "codes"))


def _take_steps(
    loss: Callable[[], Tensor],
    learner: nn.Module,
    besides: Sequence[nn.Parameter],
    steps: int,
    rate: float,
    report: Callable[[float], None],
) -> None:
    """Descend a loss that draws its own batches, the step size rising to `rate` and falling to 0."""
    optimiser = torch.optim.Adam([*learner.parameters(), *besides], lr=rate, fused=True)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, rate, total_steps=steps)
    for step in range(steps):
        optimiser.zero_grad()
        loss().backward()  # type: ignore[no-untyped-call]
        optimiser.step()
        schedule.step()
        report((step + 1) / steps)
    learner.eval()


def expected_error(
    by_action: Float[Tensor, "R La"],
    by_object: Float[Tensor, "C Lo"],
    effects: Float[Tensor, "La Lo E"],
    targets: Float[Tensor, "R C E"],
) -> Float[Tensor, ""]:
    """Compute the squared error expected if codes are drawn, mean over actions and objects, sum over axes."""
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
        features, _ = samples.imagine(decoder.imagined, fit.generator)
        _, actions = samples.imagine(decoder.imagined, fit.generator)
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
    """Draw for each code one of those that are there which differs from it in as few bits as possible."""
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
