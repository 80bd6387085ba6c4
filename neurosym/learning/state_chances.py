"""The chances that an action brings a pair into states in which its reference bears its target.

They are learned by a network without a bottleneck that sees the pair itself, and not only its kind. Where
some pairs of a kind end in one way and some in another, a mean end would say nothing of either.
"""

from dataclasses import replace

import numpy as np

from neurosym.actions import Mirror
from neurosym.arrays import Float
from neurosym.data.interactions import Interactions
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.losses import FitProgress, reproducible
from neurosym.learning.network import tensor
from neurosym.learning.recipes import fit_direct
from neurosym.learning.samples import dimensions_of, samples_of
from neurosym.learning.state_codes import carried, described_ends
from neurosym.learning.training_config import TrainingConfig
from neurosym.pair_sight import ChancesOfStates
from neurosym.relation_operators import PairStates

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
    begin = int(np.random.default_rng([seed, _STREAM]).integers(2**62))
    with reproducible(begin) as generator:
        model = DirectModel(dimensions, replace(config.teacher.network, peaks=False))
        model.set_scale(reached, ())
        fit_direct(model, samples, config, generator, progress)
    return model


def foreseen_by(model: DirectModel) -> ChancesOfStates:
    """Return what foresees the chances of the states that bear.

    Args:
        model: What `fit_chances` returned.
    """
    return lambda features, actions: np.clip(model.predict(features, actions), 0.0, 1.0)


def ended_in(interactions: Interactions, states: PairStates) -> Float[np.ndarray, "N S"]:
    """Say of each interaction which of the states that bear it ended in: 1 for that one, else 0.

    Args:
        interactions: The data, each aimed at another object.
        states: The states of pairs.
    """
    order = states.bearing_order
    reached = np.zeros((len(interactions), len(order)))
    ends = described_ends(interactions).tolist()
    for row in np.flatnonzero(carried(interactions)):
        symbol = states.of(ends[row]).symbol
        if symbol in order:
            reached[row, order.index(symbol)] = 1.0
    return reached
