"""Variety: of the candidates for each symbol, take those that together do most.

What an action does to the objects of one category is worth how sure it is, squared, times how different it is
from what the nearest other action does to them, and from doing nothing. An action is worth the mean over
objects. It matters that something else happens, and hardly how much else: differences beyond `PLENTY` count
alike, or else what reaches far would be preferred to what is sure.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Float
from neurosym.symbols import Symbol

PredictOutcomes = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""Predicts effects, and peak heights behind them, (N, O) [m], from features (N, F) and actions (N, A)."""

LITTLE = 0.01
"""An effect that counts as much as none [m]."""
PLENTY = 0.05
"""A difference that counts as three quarters of the greatest [m]."""
_STARTS = 8


@dataclass(frozen=True, slots=True, eq=False)
class CandidateEffects:
    """What each of some actions does to the objects of each category.

    Attributes:
        means: Mean of what it does [m].
        sureness: Share of the mean square of what it does that the mean explains.
        shares: Share of the objects that are of each category.
    """

    means: Float[np.ndarray, "N L D"]
    sureness: Float[np.ndarray, "N L"]
    shares: Float[np.ndarray, "L"]


def observe(values: Float[np.ndarray, "N M D"], symbols: Sequence[Symbol] | np.ndarray) -> CandidateEffects:
    """Summarise what each action did to the objects of each category.

    Effects of `LITTLE` are put to the unexplained, so that doing nothing at all is not sure.

    Args:
        values: What each action did to each object: displacement and peak height [m].
        symbols: Symbol of each object.
    """
    symbols = np.asarray(symbols)
    members = [values[:, symbols == symbol] for symbol in np.unique(symbols)]
    means = np.stack([rows.mean(1) for rows in members], axis=1)
    squares = np.stack([(rows**2).sum(2).mean(1) for rows in members], axis=1)
    shares = np.array([rows.shape[1] for rows in members]) / len(symbols)
    return CandidateEffects(means, (means**2).sum(2) / (squares + LITTLE**2), shares)


def worths(effects: CandidateEffects, chosen: Sequence[int]) -> Float[np.ndarray, "S"]:
    """Compute what each action of a set is worth.

    Args:
        effects: What all candidates do.
        chosen: Which of them are the set.
    """
    means = effects.means[chosen]
    from_nothing = np.linalg.norm(means, axis=2)  # (S, L)
    apart = np.linalg.norm(means[:, None] - means, axis=3)  # (S, S, L)
    apart[np.arange(len(chosen)), np.arange(len(chosen))] = np.inf
    different = np.tanh(np.minimum(apart.min(1), from_nothing) / PLENTY)
    return np.asarray((effects.sureness[chosen] ** 2 * different) @ effects.shares)


def best_set(groups: Sequence[Sequence[int]], effects: CandidateEffects) -> list[int]:
    """Choose one candidate of each symbol so that the set is worth most, changing one at a time.

    That can get stuck; so it is begun from the surest candidates and from some drawn at random.

    Args:
        groups: For each symbol, the numbers of its candidates.
        effects: What all candidates do.
    """
    rng = np.random.default_rng(0)
    sure = effects.sureness @ effects.shares
    begun = [[max(group, key=lambda number: sure[number]) for group in groups]]
    begun += [[group[int(rng.integers(len(group)))] for group in groups] for _ in range(_STARTS - 1)]
    sets = [_improve(chosen, groups, effects) for chosen in begun]
    return max(sets, key=lambda chosen: worths(effects, chosen).sum())


def worth_in_place(
    chosen: Sequence[int], place: int, group: Sequence[int], effects: CandidateEffects
) -> list[float]:
    """Compute what a set is worth with each of some candidates in one place of it, all at once.

    Args:
        chosen: The set.
        place: Which of it is exchanged.
        group: The candidates for that place.
        effects: What all candidates do.
    """
    others, group = [*chosen[:place], *chosen[place + 1 :]], list(group)
    rows, mine = effects.means[others], effects.means[group]
    apart = np.linalg.norm(rows[:, None] - rows, axis=3)  # (S - 1, S - 1, L)
    apart[np.arange(len(others)), np.arange(len(others))] = np.inf
    nearest = np.minimum(apart.min(1, initial=np.inf), np.linalg.norm(rows, axis=2))  # (S - 1, L)
    across = np.linalg.norm(mine[:, None] - rows, axis=3)  # (G, S - 1, L)
    different = np.tanh(np.minimum(across, nearest) / PLENTY)
    of_others = (effects.sureness[others] ** 2 * different).sum(1)  # (G, L)
    alone = np.minimum(across.min(1, initial=np.inf), np.linalg.norm(mine, axis=2))
    own = effects.sureness[group] ** 2 * np.tanh(alone / PLENTY)
    values: list[float] = ((of_others + own) @ effects.shares).tolist()
    return values


def _improve(chosen: list[int], groups: Sequence[Sequence[int]], effects: CandidateEffects) -> list[int]:
    changed = True
    while changed:
        changed = False
        for place, group in enumerate(groups):
            values = worth_in_place(chosen, place, group, effects)
            best = int(np.argmax(values))
            if values[best] > values[group.index(chosen[place])] + 1e-9:
                chosen[place], changed = group[best], True
    return chosen
