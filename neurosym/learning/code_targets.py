"""What the codes shall stand for, to begin with: a co-clustering of what a teacher predicts.

The teacher, a network without a bottleneck, fills a table with the effects of drawn actions on drawn objects.
The table is co-clustered into as many kinds of action and of object as there are codes. Then the teacher says
of many more actions and objects what it would cost to call them this or that.
"""

from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from neurosym.arrays import Float, Int
from neurosym.learning.coclustering import CoClustering, cocluster, gray_order, profiles
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.model_config import ModelConfig
from neurosym.learning.samples import Samples
from neurosym.learning.training_config import TrainingConfig

_AT_ONCE = 20_000  # predictions
_OBJECTS_ASKED = 24  # to see what kind an action is
_ACTIONS_ASKED = 128  # to see what kind an object is


@dataclass(frozen=True, slots=True, eq=False)
class CodeTargets:
    """What codes stand for, and examples of what should be called how.

    Attributes:
        effects: Effect that each pair of codes stands for, standardised.
        actions: Actions to be named.
        action_costs: What each code would cost as the name of each: mean squared error of the effect, less
            that of the best code, and divided by the mean of all.
        features: Objects to be named.
        object_costs: The same for them.
    """

    effects: Float[Tensor, "La Lo E"]
    actions: Float[Tensor, "R A"]
    action_costs: Float[Tensor, "R La"]
    features: Float[Tensor, "C F"]
    object_costs: Float[Tensor, "C Lo"]


def find_code_targets(
    teacher: DirectModel,
    bits: ModelConfig,
    samples: Samples,
    config: TrainingConfig,
    generator: torch.Generator,
) -> CodeTargets:
    """Co-cluster what the teacher predicts. Codes are given so that kinds one bit apart are alike.

    Args:
        teacher: The network without a bottleneck.
        bits: How many bits symbols have.
        samples: The training data.
        config: How much is asked of the teacher.
        generator: Source of randomness, owned by the caller.
    """
    rng = np.random.default_rng(int(torch.randint(2**31, (1,), generator=generator)))
    features, _ = samples.imagine(config.naming.table_objects, generator)
    _, actions = samples.imagine(config.naming.table_actions, generator)
    table = _table(teacher, features, actions)  # (R, C, E)
    kinds = 2**bits.action_bits, 2**bits.object_bits
    found = cocluster(table, *kinds, rng, restarts=config.naming.table_restarts)
    flipped = CoClustering(rows=found.columns, columns=found.rows, error=found.error)
    row_codes, column_codes = (
        gray_order(_centres(t, f, k), rng)
        for t, f, k in ((table, found, kinds), (table.transpose(1, 0, 2), flipped, kinds[::-1]))
    )
    effects = np.empty((*kinds, table.shape[2]))
    effects[np.ix_(row_codes, column_codes)] = _blocks(table, found, kinds)
    objects = _some_of_each(found.columns, _OBJECTS_ASKED, rng)
    shown = rng.permutation(len(actions))[:_ACTIONS_ASKED]
    more_features, _ = samples.imagine(config.naming.objects, generator)
    _, more_actions = samples.imagine(config.naming.actions, generator)
    by_object = _table(teacher, features[objects], more_actions)
    by_action = _table(teacher, more_features, actions[shown]).transpose(1, 0, 2)
    object_codes, action_codes = column_codes[found.columns], row_codes[found.rows]
    return CodeTargets(
        effects=torch.from_numpy(effects).float(),
        actions=more_actions,
        action_costs=_costs(by_object, effects, object_codes[objects], object_codes),
        features=more_features,
        object_costs=_costs(by_action, effects.transpose(1, 0, 2), action_codes[shown], action_codes),
    )


def _costs(
    table: Float[np.ndarray, "R C E"],
    effects: Float[np.ndarray, "L K E"],
    codes: Int[np.ndarray, "C"],
    whole: Int[np.ndarray, "S"],
) -> Float[Tensor, "R L"]:
    """Reckon what each code would cost each row, columns of a code counting as often as in the whole table.

    Args:
        table: Predicted effects.
        effects: What codes of rows and columns stand for.
        codes: Code of each column of this table.
        whole: Code of each column of the whole table.
    """
    shares = np.bincount(whole, minlength=effects.shape[1]) / len(whole)
    costs = np.zeros((len(table), len(effects)))
    for code in np.unique(codes):
        mean = table[:, codes == code].mean(1)  # (R, E)
        costs += shares[code] * ((mean[:, None] - effects[:, code]) ** 2).sum(2)
    costs -= costs.min(1, keepdims=True)
    return torch.from_numpy(costs / costs.mean()).float()


def _some_of_each(labels: Int[np.ndarray, "C"], count: int, rng: np.random.Generator) -> Int[np.ndarray, "S"]:
    """Take equally many members of each kind, some of them twice if a kind has too few."""
    kinds = np.unique(labels)
    each = max(1, count // len(kinds))
    return np.concatenate([rng.choice(np.flatnonzero(labels == kind), each) for kind in kinds])


def _table(
    teacher: DirectModel, features: Float[Tensor, "C F"], actions: Float[Tensor, "R A"]
) -> Float[np.ndarray, "R C E"]:
    """Predict standardised effects of every action on every object."""
    with torch.inference_mode():
        parts = [
            teacher.standard_effects(features.repeat(len(part), 1), part.repeat_interleave(len(features), 0))
            for part in torch.split(actions, max(1, _AT_ONCE // len(features)))
        ]
    return torch.cat(parts).numpy().reshape(len(actions), len(features), -1)


def _blocks(table: np.ndarray, found: CoClustering, kinds: tuple[int, int]) -> Float[np.ndarray, "La Lo E"]:
    """Average the table over each block."""
    rows, columns = np.eye(kinds[0])[found.rows], np.eye(kinds[1])[found.columns]
    counts = np.maximum(np.outer(rows.sum(0), columns.sum(0)), 1)[:, :, None]
    means: np.ndarray = np.einsum("rce,rk,cl->kle", table, rows, columns, optimize=True) / counts
    return means


def _centres(table: np.ndarray, found: CoClustering, kinds: tuple[int, int]) -> Float[np.ndarray, "L D"]:
    """Average the profiles of the rows of each kind."""
    points, members = profiles(table, found.columns, kinds[1]), np.eye(kinds[0])[found.rows]
    means: np.ndarray = members.T @ points / np.maximum(members.sum(0), 1)[:, None]
    return means
