"""Judging actions that are aimed at other objects: by the state that the pair ends in.

An action is good for a kind of pair and a state in which the reference bears the target, if it surely brings
that about, with the target not turned over, and nothing else moved.
"""

from collections.abc import Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.pair_states import describe_pair, touching_units
from neurosym.primitives.judging import TURNED, Performance
from neurosym.relation_operators import PairStates
from neurosym.table import OtherObject
from neurosym.world import Outcome, OutcomeKind

EXACT = 0.5
"""A spread at which an action is still 1 / sqrt(2) as sure as one without any [touching units]."""


def watch(outcome: Outcome, states: PairStates) -> Performance:
    """Say of an outcome what is judged.

    Args:
        outcome: What happened, aimed at another object.
        states: The states of pairs.
    """
    state = found if (found := end_state(outcome, states)) in states.bearing else ""
    assert isinstance(outcome.reference, OtherObject), "aimed at another object"
    where = touching_units(outcome.end, outcome.target, outcome.reference.index)
    kind: OutcomeKind = "carried" if state else "missed"
    return Performance(
        kind, tuple(where.tolist()), outcome.peak_height, outcome.turn, bool(outcome.disturbed), state
    )


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


def sureness(performances: Sequence[Performance], state: str) -> float:
    """Say how surely an action brings pairs of a kind into a state, and how alike: from 0 to 1.

    Args:
        performances: One for each pair.
        state: Code of the state.
    """
    good = [one for one in performances if one.state == state and not one.disturbs and one.turn <= TURNED]
    if not good:
        return 0.0
    return len(good) / len(performances) * _likeness(np.array([one.outcome for one in good]))


def _likeness(ends: Float[np.ndarray, "N 3"]) -> float:
    variance = float(((ends - ends.mean(0)) ** 2).sum(1).mean())
    return float(1 / np.sqrt(1 + variance / EXACT**2))
