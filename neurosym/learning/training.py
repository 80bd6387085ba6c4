"""The final fit: from a data set of interactions to an effect model whose bits can be relied on.

The report sets the model's error beside what predictors that look at nothing achieve.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from neurosym.checks import Float, check_kind, check_seed
from neurosym.data.interactions import Interactions
from neurosym.data.origin import is_explored, strategy_of, too_few
from neurosym.errors import InvalidValue
from neurosym.learning.losses import FitProgress, dimensions_of, reproducible, samples_of
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.learning.recipes import RECIPES, Fit, fit_direct, keep_bits
from neurosym.learning.training_config import DEFAULT_BITS, ModelConfig, TrainingConfig
from neurosym.learning.training_report import TrainingReport
from neurosym.operators import all_symbols

# What predictors achieve that look at nothing: every table of errors shows them beside the model

TEST_ROWS = 2400
"""Interactions of a test set that are used: the first ones with a high effect, as many as the paper's."""


def trivial_predictions(
    seen: Float[np.ndarray, "N E"], count: int
) -> dict[str, Float[np.ndarray, "{count} E"]]:
    """Predict effects without looking at objects and actions [m].

    Args:
        seen: The effects that were learned from.
        count: How many predictions.
    """
    shape = (count, seen.shape[1])
    return {
        "always zero": np.zeros(shape),
        "always mean": np.broadcast_to(seen.mean(0), shape),
        "per-axis median": np.broadcast_to(np.median(seen, axis=0), shape),
    }


_LEAST_SPREAD = 1e-4  # an axis on which effects in a world spread less says nothing of a model [m]
_DIRECT = 0x6469  # keeps the draws of the network without a bottleneck apart


@dataclass(frozen=True, slots=True)
class Trained:
    """What training makes."""

    model: EffectModel  #: The effect model, whose bits are the symbols
    direct: DirectModel  #: A network without a bottleneck on the same data: what the bits could tell at best
    report: TrainingReport  #: How well both predict


def train(
    interactions: Interactions,
    *,
    config: TrainingConfig | None = None,
    model_config: ModelConfig | None = None,
    seed: int,
    direct: DirectModel | None = None,
    more: Interactions | None = None,
    bits: EffectModel | None = None,
    progress: FitProgress | None = None,
) -> Trained:
    """Fit an effect model to a data set; the same seed gives the same bytes.

    What is known of the actions (which are gripper values, their box, mirrors of the world) is read from the
    data's origin where it stands there. If the data was explored with one of the paper's baselines, the model
    has a deterministic head, and learns only from what that baseline learns from.

    Args:
        interactions: The data.
        config: How the fit is made.
        model_config: How the network is built.
        seed: Where all draws start.
        direct: A network without a bottleneck that was fitted to the same data before; else one is.
        more: Interactions that this network also learns from; they are not as they come, so that bits and
            decoder only learn what it says of others.
        bits: A model whose encoders are kept, so that symbols stay what they are; else they are fitted.
        progress: Called with the stage and the share of it that is done.

    Raises:
        InvalidValue: If there are too few interactions to hold some out.
    """
    check_kind("interactions", interactions, Interactions, "Interactions, as explore returns them")
    check_seed(seed)
    config = TrainingConfig() if config is None else config
    model_config = ModelConfig(*DEFAULT_BITS) if model_config is None else model_config
    check_kind("config", config, TrainingConfig, "a TrainingConfig, like regime_named('quick').training")
    check_kind("model_config", model_config, ModelConfig, "a ModelConfig, like regime_named('quick').model")
    progress = progress or (lambda *_: None)
    if strategy := strategy_of(interactions.origin):
        model_config = replace(model_config, head=strategy.head)
        interactions = interactions[strategy.learns_from(interactions.effects)]
    kept, held_out = split(interactions, config.validation_share, seed)
    samples = samples_of(kept, mirrors=config.mirrors)
    trained_by = {
        "training": config.as_stored(),
        "seed": seed,
        "interactions": len(interactions),
        "origin": interactions.origin,
    }
    if direct is None:
        taught = samples_of(kept.join(more), mirrors=config.mirrors) if more is not None else samples
        direct = fit_direct(taught, dimensions_of(interactions), config, _seed(seed, _DIRECT), progress)
        direct.trained_by = trained_by
    with reproducible(_seed(seed, 0)) as generator:
        model = EffectModel(direct.dimensions, model_config)
        if config.standardise:
            model.set_scale(samples.effects, samples.mirrored_axes)
        fit = Fit(model, direct, samples, config, generator, progress)
        if bits is None:
            RECIPES[config.recipe](fit)
        else:
            keep_bits(fit, bits)
    model.trained_by = trained_by
    return Trained(model, direct, assess(model, direct, kept, held_out))


def split(interactions: Interactions, share: float, seed: int) -> tuple[Interactions, Interactions]:
    """Split a data set into the part to train on and the part held out."""
    if problem := too_few(len(interactions)):
        raise InvalidValue(f"{problem}.")
    order = np.random.default_rng([seed, len(interactions)]).permutation(len(interactions))
    held_out = max(2, round(share * len(interactions)))
    return interactions[order[held_out:]], interactions[order[:held_out]]


def assess(
    model: EffectModel, direct: DirectModel, kept: Interactions, held_out: Interactions
) -> TrainingReport:
    """Measure a model on interactions that it was not trained on.

    Trivial predictors come from what it was trained on.
    """
    effects, bits = np.asarray(held_out.effects, dtype=np.float64), model.config
    seen = held_out.features, held_out.actions
    coded, uncut = model.predict_from_codes(*seen)[0], model.predict(*seen)[0]
    by_axis = [r_squared(guess, effects) for guess in (coded, uncut, direct.predict(*seen))]
    least = _LEAST_SPREAD if is_explored(kept.origin) else 0.0
    means = [mean_over_axes(r2, effects, least) for r2 in by_axis]
    predictors = {"model": coded, **trivial_predictions(kept.effects, len(effects))}
    return TrainingReport(
        held_out=len(held_out),
        r2_through_codes=means[0],
        r2_through_codes_by_axis=tuple(by_axis[0].tolist()),
        r2=means[1],
        r2_by_axis=tuple(by_axis[1].tolist()),
        r2_direct=means[2],
        r2_direct_by_axis=tuple(by_axis[2].tolist()),
        share=share_of(means[0], means[2]),
        mae={name: np.abs(guess - effects).mean(0).tolist() for name, guess in predictors.items()},
        object_symbols=_shares(model.object_symbols(held_out.features)),
        action_symbols=_shares(model.action_symbols(held_out.actions)),
        restarts=(means[0],),
        empty_object_codes=_empty(bits.object_bits, model.object_symbols, kept.features, held_out.features),
        empty_action_codes=_empty(bits.action_bits, model.action_symbols, kept.actions, held_out.actions),
    )


def share_of(through_codes: float, direct: float) -> float | None:
    """Divide the R2 through the codes by that without a bottleneck; None if the latter explains nothing."""
    return through_codes / direct if direct > 0 else None


def r_squared(
    predicted: Float[np.ndarray, "N E"], observed: Float[np.ndarray, "N E"]
) -> Float[np.ndarray, "E"]:
    """Compute the share of the variance that is explained, per axis; 0 where there is no variance."""
    residual = ((predicted - observed) ** 2).sum(0)
    total = ((observed - observed.mean(0)) ** 2).sum(0)
    return np.where(total > 1e-12, 1 - residual / np.maximum(total, 1e-12), 0.0)


def mean_over_axes(
    r2: Float[np.ndarray, "E"], observed: Float[np.ndarray, "N E"], least: float = 0.0
) -> float:
    """Return the mean of R2 over the axes that vary; 0 if none does.

    Args:
        r2: R2 on each axis.
        observed: The effects that were observed.
        least: An axis varies if its standard deviation is larger than this.
    """
    varies = observed.std(0) > least
    return float(r2[varies].mean()) if varies.any() else 0.0


def _seed(seed: int, stream: int) -> int:
    return int(np.random.default_rng([seed, stream]).integers(2**62))


def _shares(symbols: tuple[str, ...]) -> dict[str, float]:
    names, counts = np.unique(symbols, return_counts=True)
    return {str(name): float(count) / len(symbols) for name, count in zip(names, counts, strict=True)}


def _empty(
    bits: int, encode: Callable[[np.ndarray], tuple[str, ...]], *parts: Float[np.ndarray, "_ D"]
) -> tuple[str, ...]:
    """List the codes of so many bits that no row of the data has."""
    used = {symbol for rows in parts for symbol in encode(rows)}
    return tuple(symbol for symbol in all_symbols(bits) if symbol not in used)
