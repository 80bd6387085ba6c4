"""States of pairs: which of the ways in which one object stands to another are worth a code.

Pairs are described in touching units (`pair_states.py`), before anybody touched them and as actions left
them. k-means finds the ways that are typical, and codes are given such that states one bit apart are alike. A
reference bears its target in states that fresh pairs are never in, and that targets are carried into.
Names are made afterwards, from the numbers that are typical of a state.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from neurosym.checks import Bool, Float
from neurosym.data.interactions import Interactions
from neurosym.learning.coclustering import gray_order, kmeans, nearest
from neurosym.learning.losses import FitProgress, dimensions_of, samples_of
from neurosym.learning.network import DirectModel, tensor
from neurosym.learning.recipes import fit_direct
from neurosym.learning.training_config import TrainingConfig
from neurosym.operators import all_symbols
from neurosym.pair_operators import DESCRIPTION, LEANING, PairState, PairStates
from neurosym.tasks.supports import ChancesOfStates
from neurosym.world import Mirror

STARTS = 20
"""How often k-means starts; the best is kept."""
# What touching or not counts beside the other numbers: what sits in a ring does so, touching it or not.
_TOUCHING_COUNTS = 0.5
_RARE = 0.01  # what fresh pairs are so rarely is what actions made of them
_DIGITS = 4
_OVER, _TOUCHING, _NEAR = 0.75, 0.5, 1.5  # how names tell states apart


def learn_states(
    fresh: Float[np.ndarray, "M D"],
    ends: Float[np.ndarray, "N D"],
    turned: Float[np.ndarray, "N D"],
    bits: int,
    rng: np.random.Generator,
) -> PairStates:
    """Find typical states of pairs, as many as codes of so many bits at most.

    Args:
        fresh: Descriptions of pairs that nobody touched.
        ends: Descriptions of targets relative to references that they were carried to.
        turned: The same the other way round: of these references relative to the targets.
        bits: How many bits a code has.
        rng: Source of randomness, owned by the caller.

    """
    points = np.concatenate([fresh[rng.permutation(len(fresh))[: len(ends)]], ends, turned])
    scales = np.maximum(points.std(0), 1e-3)
    scales[DESCRIPTION.index("touching")] /= _TOUCHING_COUNTS
    kinds, scaled = 2**bits, points / scales
    labels = min((kmeans(scaled, kinds, rng) for _ in range(STARTS)), key=lambda one: _error(scaled, one))
    centres = np.array([scaled[labels == kind].mean(0) for kind in range(kinds) if np.any(labels == kind)])
    padded = np.concatenate([centres, np.repeat(centres[-1:], kinds - len(centres), axis=0)])
    codes = np.array(all_symbols(bits))[gray_order(padded, rng)[: len(centres)]].tolist()
    labelled = (nearest(rows / scales, centres)[0] for rows in (fresh, ends, turned))
    shares = [np.bincount(found, minlength=len(centres)) / max(1, len(found)) for found in labelled]
    states = [
        PairState(
            symbol=symbol,
            name=f"{name_state(centre * scales)}-{symbol}",
            centre=tuple(round(float(value), _DIGITS) for value in centre * scales),
            share=float(untouched),
            bears=bool(untouched < _RARE and 2 * lifted > other_way),
        )
        for symbol, centre, untouched, lifted, other_way in zip(codes, centres, *shares, strict=True)
    ]
    found = tuple(sorted(states, key=lambda one: one.symbol))
    return PairStates(found, tuple(round(float(scale), _DIGITS) for scale in scales))


def ends_in(interactions: Interactions) -> tuple[Float[np.ndarray, "N D"], Float[np.ndarray, "N D"]]:
    """Describe how pairs stand in the end if the target was carried; and the same the other way round.

    Seen from the target, the reference is as far below.

    Args:
        interactions: The data, each aimed at another object.
    """
    ends = described_ends(interactions)[carried(interactions)]
    away, up, touching, tilted, reference_tilted = ends.T
    return ends, np.column_stack([away, -up, touching, reference_tilted, tilted])


def described_ends(interactions: Interactions) -> Float[np.ndarray, "N D"]:
    """Describe how each pair stands in the end, where the target was carried.

    References are taken to stand straight: they mostly do, and data do not tell.
    """
    x, y, up, touching, tilted, _ = np.asarray(interactions.effects, dtype=np.float64).T
    return np.column_stack([np.maximum(np.abs(x), np.abs(y)), up, touching, tilted, np.zeros_like(x)])


def carried(interactions: Interactions) -> Bool[np.ndarray, "N"]:
    """Say of each interaction whether the target was carried to the reference."""
    return np.asarray(interactions.effects[:, -1] > 0)


def name_state(centre: Sequence[float] | Float[np.ndarray, "5"]) -> str:
    """Say in a word or two how a target mostly stands to a reference in a state."""
    away, up, touching, tilted, reference_tilted = (float(value) for value in centre)
    if tilted > LEANING:
        return "leans-on"
    if reference_tilted > LEANING:
        return "props-up"
    if away < _OVER:
        return "rests-on" if up > _OVER else "lies-under" if up < -_OVER else "sits-in"
    if touching > _TOUCHING:
        return "touches"
    return "beside" if away < _NEAR else "apart-from"


def _error(points: Float[np.ndarray, "N D"], labels: np.ndarray) -> float:
    members = (points[labels == kind] for kind in set(labels.tolist()))
    return float(sum(((rows - rows.mean(0)) ** 2).sum() for rows in members))


# The chances that an action brings a pair into states in which its reference bears its target.
#
# They are learned by a network without a bottleneck that sees the pair itself, and not only its kind. Where
# some pairs of a kind end in one way and some in another, a mean end would say nothing of either.

_STREAM = 0x7363  # keeps these draws apart from those of other fits


def fit_chances(
    interactions: Interactions,
    states: PairStates,
    config: TrainingConfig,
    *,
    seed: int,
    progress: FitProgress,
) -> DirectModel:
    """Fit the network to what happened, by squared error: its outputs are chances then.

    Args:
        interactions: The data, each aimed at another object.
        states: The states of pairs.
        config: How a network without a bottleneck is fitted.
        seed: Where all draws start.
        progress: Told how far it has come.

    Returns:
        A network whose outputs are the chances of the states that bear, in the order of their codes.
    """
    reached = tensor(ended_in(interactions, states))
    samples = samples_of(interactions, mirrors=config.mirrors)
    unsigned = tuple(Mirror(mirror.actions, ()) for mirror in samples.mirrors)
    samples = replace(samples, effects=reached, mirrors=unsigned)
    dimensions = replace(dimensions_of(interactions), effects=reached.shape[1])
    teacher = replace(config.teacher, network=replace(config.teacher.network, peaks=False))
    begin = int(np.random.default_rng([seed, _STREAM]).integers(2**62))
    return fit_direct(samples, dimensions, replace(config, teacher=teacher), begin, progress)


def foreseen_by(model: DirectModel) -> ChancesOfStates:
    """Return what foresees the chances of the states that bear.

    Args:
        model: What `fit_chances` returned.
    """
    return lambda features, actions: np.clip(model.predict(features, actions), 0.0, 1.0)


def ended_in(interactions: Interactions, states: PairStates) -> Float[np.ndarray, "N S"]:
    """Say of each interaction which of the states that bear it ended in: 1 for that one, else 0."""
    order = states.bearing
    reached = np.zeros((len(interactions), len(order)))
    ends = described_ends(interactions).tolist()
    for row in np.flatnonzero(carried(interactions)):
        symbol = states.of(ends[row]).symbol
        if symbol in order:
            reached[row, order.index(symbol)] = 1.0
    return reached
