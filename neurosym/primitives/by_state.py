"""Judging actions that are aimed at other objects: by the state that the pair ends in.

An action is good for a kind of pair if it surely brings about one state in which the reference bears the
target, whichever that is, with the target not turned over, and nothing else moved.
"""

from collections import Counter
from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from neurosym.pair_states import describe_pair, touching_units
from neurosym.primitives.judging import TURNED, Judgement, Judging, Performance
from neurosym.relation_operators import PairStates
from neurosym.table import OtherObject
from neurosym.world import Outcome, OutcomeKind

EXACT = 0.5
"""A spread at which an action is still 1 / sqrt(2) as sure as one without any [touching units]."""
_TILTED, _CARRIED = 4, 5  # columns of what is predicted
_LEAST_CHANCE = 0.1


def by_state(states: PairStates) -> Judging:
    """Return how actions are judged that are aimed at other objects.

    Args:
        states: The states of pairs.
    """
    bearing = states.bearing

    def watch(outcome: Outcome) -> Performance:
        state = found if (found := end_state(outcome, states)) in bearing else ""
        assert isinstance(outcome.reference, OtherObject), "aimed at another object"
        where = touching_units(outcome.end, outcome.target, outcome.reference.index)
        kind: OutcomeKind = "carried" if state else "missed"
        return Performance(
            kind, tuple(where.tolist()), outcome.peak_height, outcome.turn, bool(outcome.disturbed), state
        )

    return Judging(foresee_relating, watch, judge_by_state)


def end_state(outcome: Outcome, states: PairStates) -> str:
    """Return the code of the state that a pair ended in; empty if the target was not carried there.

    Args:
        outcome: What happened, aimed at another object.
        states: The states of pairs.
    """
    if not outcome.carried or outcome.lost or not isinstance(outcome.reference, OtherObject):
        return ""
    described = describe_pair(outcome.end, outcome.target, outcome.reference.index, outcome.contacts)
    return states.of(described.tolist()).symbol


def foreseen_state(predicted: Float[np.ndarray, "N O"], states: PairStates) -> str:
    """Return the code of the state that an action is foreseen to bring pairs to; empty if that bears nothing.

    Args:
        predicted: What is predicted of each pair: its end as data have it, and the greatest height.
        states: The states of pairs.
    """
    chances = np.clip(predicted[:, _CARRIED], 0.0, 1.0)
    x, y, up, touching, tilted = predicted[:, :_CARRIED].sum(0) / max(float(chances.sum()), _LEAST_CHANCE)
    state = states.of((max(abs(x), abs(y)), up, touching, tilted, 0.0))
    return state.symbol if state.symbol in states.bearing else ""


def judge_by_state(performances: Sequence[Performance]) -> Judgement:
    """Judge how surely an action brings pairs of a kind into one state.

    Args:
        performances: One for each pair.
    """
    good = [one for one in performances if one.state and not one.disturbs and one.turn <= TURNED]
    if not good:
        return Judgement(None, np.zeros(4), 0.0)
    state, count = Counter(one.state for one in good).most_common(1)[0]
    rows = np.array([[*one.outcome, one.peak_height] for one in good if one.state == state])
    return Judgement("carried", rows.mean(0), count / len(performances) * _likeness(rows[:, :3]))


def foresee_relating(predicted: Float[np.ndarray, "N O"]) -> Judgement:
    """Judge an action that is aimed at another object by what is predicted of some pairs.

    Args:
        predicted: What is predicted of each pair: its end as data have it, and the greatest height.
    """
    chances = np.clip(predicted[:, _CARRIED], 0.0, 1.0)
    likely = chances >= chances.max() / 2
    ends = predicted[likely, :3] / np.maximum(chances[likely, None], _LEAST_CHANCE)
    upright = 1 - np.clip(predicted[:, _TILTED], 0.0, 1.0)
    sureness = float((chances * upright).mean() * _likeness(ends))
    mean = np.array([*predicted[:, :3].mean(0), predicted[:, -1].mean()])
    return Judgement("carried", mean, sureness)


def _likeness(ends: Float[np.ndarray, "N 3"]) -> float:
    variance = float(((ends - ends.mean(0)) ** 2).sum(1).mean())
    return float(1 / np.sqrt(1 + variance / EXACT**2))
