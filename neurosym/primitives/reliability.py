"""Judging: how surely an action does to the objects of a category what it mostly does.

Exactness counts on a scale of its own, not relative to how far the object moves: plans add up what misses by
millimetres, however long the way. An object that is turned is not the one that was categorised, and what is
done to it next misses by more; so turning counts against an action, too.

An action that is aimed at another object is good for a kind of pair and a state in which the reference bears
the target, if it surely brings that about, with the target not turned over, and nothing else moved.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.checks import Float
from neurosym.operators import PROMISING, Effect, Symbol
from neurosym.pair_operators import PairStates, describe_pair
from neurosym.world import OtherObject, Outcome, OutcomeKind

# Variety: of the candidates for each symbol, take those that together do most.
#
# What an action does to the objects of one category is worth how sure it is, squared, times how different
# it is from what the nearest other action does to them, and from doing nothing. An action is worth the mean
# over objects. It matters that something else happens, and hardly how much else: differences beyond
# `PLENTY` count alike, or else what reaches far would be preferred to what is sure.

PredictOutcomes = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""Predicts effects, and peak heights behind them, (N, O) [m], from features (N, F) and actions (N, A)."""

LITTLE = 0.01
"""An effect that counts as much as none [m]."""
PLENTY = 0.05
"""A difference that counts as three quarters of the greatest [m]."""
_STARTS = 8


@dataclass(frozen=True, slots=True, eq=False)
class CandidateEffects:
    """What N actions mostly do to the objects of L categories [m], how surely, and the shares of these."""

    means: Float[np.ndarray, "N L D"]
    sureness: Float[np.ndarray, "N L"]
    shares: Float[np.ndarray, "L"]


def observe(values: Float[np.ndarray, "N M D"], symbols: Sequence[Symbol] | np.ndarray) -> CandidateEffects:
    """Summarise what each action did to the objects of each category.

    Effects of `LITTLE` are put to the unexplained, so that doing nothing at all is not sure.
    """
    symbols = np.asarray(symbols)
    members = [values[:, symbols == symbol] for symbol in np.unique(symbols)]
    means = np.stack([rows.mean(1) for rows in members], axis=1)
    squares = np.stack([(rows**2).sum(2).mean(1) for rows in members], axis=1)
    shares = np.array([rows.shape[1] for rows in members]) / len(symbols)
    return CandidateEffects(means, (means**2).sum(2) / (squares + LITTLE**2), shares)


def best_set(groups: Sequence[Sequence[int]], effects: CandidateEffects) -> list[int]:
    """Choose one candidate of each symbol so that the set is worth most, changing one at a time.

    That can get stuck; so it is begun from the surest candidates and from some drawn at random.
    """
    rng = np.random.default_rng(0)
    sure = effects.sureness @ effects.shares
    begun = [[max(group, key=lambda number: sure[number]) for group in groups]]
    begun += [[group[int(rng.integers(len(group)))] for group in groups] for _ in range(_STARTS - 1)]
    sets = [_improve(chosen, groups, effects) for chosen in begun]
    return max(sets, key=lambda chosen: worth_in_place(chosen, 0, chosen[:1], effects)[0])


def worth_in_place(
    chosen: Sequence[int], place: int, group: Sequence[int], effects: CandidateEffects
) -> list[float]:
    """Compute what a set is worth with each of some candidates in one place of it, all at once."""
    of_others, own = worths_in_place(chosen, place, group, effects)
    return [one + other for one, other in zip(of_others, own, strict=True)]


def worths_in_place(
    chosen: Sequence[int], place: int, group: Sequence[int], effects: CandidateEffects
) -> tuple[list[float], list[float]]:
    """Compute what the others of a set are worth beside each of some candidates, and what these are.

    Args:
        chosen: The set, a candidate in each place.
        place: The place that they would have.
        group: Those candidates.
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
    return (of_others @ effects.shares).tolist(), (own @ effects.shares).tolist()


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


EXACT = 0.015
"""A spread at which an action is still 1 / sqrt(2) as sure as one without any [m]."""
TURNED = math.radians(15)
"""By how much an object may be turned without that it counts [rad]."""


@dataclass(frozen=True, slots=True)
class Performance:
    """How an action turned out on one object."""

    kind: OutcomeKind  # how the object ended
    outcome: Effect  # its displacement as it ended: held in the air, or else at rest [m]
    peak_height: float  # its greatest height on the way [m]
    turn: float  # by what angle it was turned in the end [rad]
    disturbs: bool = False  # whether another object was moved


@dataclass(frozen=True, slots=True, eq=False)
class Judgement:
    """What an action mostly does to the objects of a category."""

    kind: OutcomeKind | None  # how most of them end, of `PROMISING`; None if none of them ends so
    # mean displacement of those as they ended, and mean of their greatest heights [m]
    mean: Float[np.ndarray, "D"]
    sureness: float  # how surely it does that: from 0 to 1


Foresee = Callable[[Float[np.ndarray, "N O"]], Judgement]
"""Judges an action by what is predicted of some objects, a row each."""


def performance(outcome: Outcome) -> Performance:
    """Say of an outcome what is judged."""
    ended = outcome.effect if outcome.kind == "held" else outcome.resting_effect
    effect = tuple(ended.tolist())
    return Performance(outcome.kind, effect, outcome.peak_height, outcome.turn, bool(outcome.disturbed))


def judge(performances: Sequence[Performance]) -> Judgement:
    """Judge what an action did to objects of one category.

    Sureness is the share that ends in the main way, times the share that is not turned, times the share that
    moves nothing else, times how exactly they end alike. Moving by no more than `LITTLE` halves it.

    Args:
        performances: One for each object.
    """
    kinds = [one.kind for one in performances]
    kind = max(PROMISING, key=kinds.count)
    if kind not in kinds:
        return Judgement(None, np.zeros(4), 0.0)
    rows = np.array([[*one.outcome, one.peak_height] for one in performances if one.kind == kind])
    unturned = np.mean([one.turn <= TURNED for one in performances])
    alone = np.mean([not one.disturbs for one in performances])
    share = len(rows) / len(performances)
    exact = likeness(rows[:, :-1]) if kind == "carried" else exactness(rows[:, :-1])
    return Judgement(kind, rows.mean(0), float(share * unturned * alone * exact))


def judge_outcomes(outcomes: Sequence[Outcome]) -> Judgement:
    """Judge an action by how it turned out on objects of one category."""
    return judge([*map(performance, outcomes)])


def foresee_displacement(predicted: Float[np.ndarray, "N O"]) -> Judgement:
    """Judge an action by the displacements that are predicted of objects, and by their greatest heights [m].

    Where these are not predicted, an object is as high as it ends.
    """
    mean = predicted.mean(0)
    highest = mean[3] if len(mean) > 3 else max(0.0, mean[2])
    return Judgement("resting", np.array([*mean[:3], highest]), exactness(predicted[:, :3]))


def foresee_carrying(predicted: Float[np.ndarray, "N O"]) -> Judgement:
    """Judge an action that is aimed at a place: how surely it is predicted to carry objects, and how alike.

    Predicted is of each object where it ends relative to the place [m], the chance that it is carried, and
    its greatest height on the way [m].
    """
    chances = np.clip(predicted[:, 3], 0.0, 1.0)
    likely = predicted[chances >= chances.max() / 2]
    return Judgement(
        "carried", np.delete(predicted.mean(0), 3), float(chances.mean() * likeness(likely[:, :2]))
    )


def exactness(outcomes: Float[np.ndarray, "N E"]) -> float:
    """Say how nearly displacements [m] are the same, and more than nothing: from 0 to 1."""
    square = float((outcomes.mean(0) ** 2).sum())
    return square / (square + LITTLE**2) * likeness(outcomes)


def likeness(outcomes: Float[np.ndarray, "N E"], exact: float = EXACT) -> float:
    """Say how nearly displacements are the same, whatever they are: from 0 to 1.

    `exact` is a spread at which it is 1 / sqrt(2) [m, or the unit of the outcomes].
    """
    variance = float(((outcomes - outcomes.mean(0)) ** 2).sum(1).mean())
    return 1 / math.sqrt(1 + variance / exact**2)


def end_state(outcome: Outcome, states: PairStates) -> str:
    """Return the code of the state that a pair ended in; empty if the target was not carried there."""
    if not outcome.carried or outcome.lost or not isinstance(outcome.reference, OtherObject):
        return ""
    described = describe_pair(outcome.end, outcome.target, outcome.reference.index, outcome.contacts)
    return states.of(described.tolist()).symbol
