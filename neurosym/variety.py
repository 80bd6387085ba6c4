"""Variety: of the candidates for each symbol, take those that together do most.

What an action is worth among others is how predictable it is, squared, times how far what it does is from
what the nearest other does, or from doing nothing. Distances count by their logarithm: it matters that
something else happens, and less how much else.
"""

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

LITTLE = 0.01
"""An effect that counts as much as none, and a difference that counts as hardly any [m]."""


def profile(values: Float[np.ndarray, "M D"], symbols: np.ndarray) -> Float[np.ndarray, "L"]:
    """Describe an action by the means over each category of what it did, such that distances are per object.

    Args:
        values: What it did to each object [m].
        symbols: Symbol of each object.
    """
    members = [values[symbols == symbol] for symbol in np.unique(symbols)]
    return np.concatenate([np.sqrt(len(rows) / len(values)) * rows.mean(0) for rows in members])


def worths(scores: Float[np.ndarray, "S"], profiles: Float[np.ndarray, "S L"]) -> Float[np.ndarray, "S"]:
    """Compute what each action of a set is worth.

    Args:
        scores: How predictable each is.
        profiles: What each does.
    """
    from_nothing = np.linalg.norm(profiles, axis=1)
    apart = np.linalg.norm(profiles[:, None] - profiles, axis=2)
    np.fill_diagonal(apart, np.inf)
    return np.asarray(scores**2 * np.log1p(np.minimum(apart.min(1), from_nothing) / LITTLE))


def best_set(
    rivals: Sequence[Sequence[int]], scores: Float[np.ndarray, "N"], profiles: Float[np.ndarray, "N L"]
) -> list[int]:
    """Choose one candidate of each symbol so that the set is worth most, changing one at a time.

    Args:
        rivals: For each symbol, the numbers of its candidates.
        scores: How predictable each candidate is.
        profiles: What each does.
    """
    chosen = [max(group, key=lambda number: scores[number]) for group in rivals]
    changed = True
    while changed:
        changed = False
        for place, group in enumerate(rivals):
            values = worth_in_place(chosen, place, group, scores, profiles)
            best = int(np.argmax(values))
            if values[best] > values[group.index(chosen[place])] + 1e-9:
                chosen[place], changed = group[best], True
    return chosen


def worth_in_place(
    chosen: Sequence[int],
    place: int,
    group: Sequence[int],
    scores: Float[np.ndarray, "N"],
    profiles: Float[np.ndarray, "N L"],
) -> list[float]:
    """Compute what a set is worth with each of some candidates in one place of it.

    Args:
        chosen: The set.
        place: Which of it is exchanged.
        group: The candidates for that place.
        scores: How predictable each candidate is.
        profiles: What each does.
    """
    sets = [[*chosen[:place], rival, *chosen[place + 1 :]] for rival in group]
    return [float(worths(scores[members], profiles[members]).sum()) for members in sets]
