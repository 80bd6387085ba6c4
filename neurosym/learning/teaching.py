"""What a network without a bottleneck teaches the effect model, in three lessons.

The teacher says what would happen in interactions that were never made. First, each encoder is fitted to name
what `code_targets.py` says that codes stand for. Then both learn end to end what to tell in their bits. The
decoder learns what to expect of each pair of codes: of actions and objects as they come, and not as somebody
curious chose them.
"""

from collections.abc import Callable
from copy import deepcopy
from functools import partial
from itertools import product

import torch
from torch import Tensor, nn

from neurosym.arrays import Float, Int
from neurosym.learning.code_targets import CodeTargets
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.effect_model import EffectModel, as_signs
from neurosym.learning.losses import BatchLoss, FitProgress, descend, prediction_loss, take_steps
from neurosym.learning.samples import Samples
from neurosym.learning.training_config import TrainingConfig

_LIKELIHOOD_WEIGHT = 0.05


def fit_names(
    model: EffectModel,
    targets: CodeTargets,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
) -> None:
    """Fit each encoder so that the codes it gives are expected to cost little; the best of several starts.

    From some starts an encoder never comes to use one of the codes.
    """
    parts = (
        ("actions", model.action_encoder, model.embed_actions, targets.actions, targets.action_costs),
        ("objects", model.object_encoder, model.embed_objects, targets.features, targets.object_costs),
    )
    for stage, encoder, embed, inputs, costs in parts:
        found: list[tuple[float, dict[str, Tensor]]] = []
        for start in range(config.naming.starts):
            if start:
                encoder.apply(_begin_anew)
            report = partial(progress, f"naming {stage}")
            _fit_naming(encoder, embed, inputs, costs, config, generator, report)
            found.append((_cost_of_names(embed, inputs, costs), deepcopy(encoder.state_dict())))
        encoder.load_state_dict(min(found, key=lambda fit: fit[0])[1])


def _fit_naming(
    encoder: nn.Module,
    embed: Callable[[Tensor], Tensor],
    inputs: Tensor,
    costs: Float[Tensor, "N L"],
    config: TrainingConfig,
    generator: torch.Generator,
    report: Callable[[float], None],
) -> None:
    """Descend the expected cost, and a little of the surprise at the cheapest code.

    Without the latter, an encoder that gives everything one code could never leave it: tanh is flat there.
    """
    cheapest = costs.argmin(1, keepdim=True)

    def loss() -> Tensor:
        rows = torch.randint(len(inputs), (config.naming.batch,), generator=generator)
        likely = code_probabilities(embed(inputs[rows]))
        right = likely.gather(1, cheapest[rows]).clamp(min=1e-6)
        return (likely * costs[rows]).sum(1).mean() - _LIKELIHOOD_WEIGHT * right.log().mean()

    encoder.train()
    take_steps(loss, list(encoder.parameters()), config.naming.steps, config.coding.rate, report)
    encoder.eval()


def _cost_of_names(embed: Callable[[Tensor], Tensor], inputs: Tensor, costs: Float[Tensor, "N L"]) -> float:
    with torch.inference_mode():
        return float(costs.gather(1, code_probabilities(embed(inputs)).argmax(1, keepdim=True)).mean())


def _begin_anew(layer: nn.Module) -> None:
    if isinstance(layer, nn.Linear | nn.BatchNorm1d):
        layer.reset_parameters()


def fit_encoders(
    model: EffectModel,
    teacher: DirectModel,
    effects: nn.Parameter,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
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
    rows, columns = config.coding.actions, config.coding.objects
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
    take_steps(loss, [*encoders.parameters(), effects], config.coding.steps, config.coding.rate / 2, report)
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


def fit_decoder(
    model: EffectModel,
    teacher: DirectModel,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
    progress: FitProgress,
) -> None:
    """Fit the decoder to what is imagined, by eq. 7.

    What happens is what the teacher predicts, and beside it what it left unexplained of some interaction that
    was made with the same codes.

    Args:
        model: Whose decoder learns; its encoders stay as they are.
        teacher: Says what would happen.
        samples: The training data.
        config: How much is imagined.
        generator: Source of randomness, owned by the caller.
        progress: Told of the epochs.
    """
    model.eval()
    with torch.no_grad():
        features, _ = samples.imagine(config.decoder.imagined, generator)
        _, actions = samples.imagine(config.decoder.imagined, generator)
        objects, chosen = codes = signs_of(model, features, actions)
        unexplained = samples.effects - teacher.effects(samples.features, samples.actions)
        known = signs_of(model, samples.features, samples.actions)
        rows = draw_alike(torch.cat(codes, 1), torch.cat(known, 1), generator)
        effects = teacher.effects(features, actions) + unexplained[rows]

    def loss_of(rows: Tensor) -> Tensor:
        return prediction_loss(model, objects[rows], chosen[rows], effects[rows])

    descend_decoder(model, loss_of, len(effects), config, generator, config.decoder.imagined_epochs, progress)


def descend_decoder(
    model: EffectModel,
    loss_of: BatchLoss,
    rows: int,
    config: TrainingConfig,
    generator: torch.Generator,
    epochs: int,
    progress: FitProgress,
) -> None:
    """Descend a loss with the decoder alone; the encoders stay as they are."""
    decoder = [*model.norm.parameters(), *model.decoder.parameters()]
    report = partial(progress, "decoder")
    descend(loss_of, rows, decoder, config, generator, epochs=epochs, report=report)


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


def signs_of(model: EffectModel, features: Tensor, actions: Tensor) -> tuple[Tensor, Tensor]:
    """Encode objects and actions into codes of +-1."""
    return as_signs(model.embed_objects(features)), as_signs(model.embed_actions(actions))
