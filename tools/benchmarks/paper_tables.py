"""The six kinds of primitive of the paper's Table II, and which of them were found.

The rule was fixed before any result was looked at:
- A push (right, left, forward, or pull) ends at rest upright, `_LEAST_MOVE` or more along its direction, at
  most `_MOST_OFF_AXIS` of that along the other horizontal axis, and never higher than `CARRIED` on the way.
- A grasp ends held, half the lift or more above the start.
- A pick and place ends at rest upright, `_LEAST_MOVE` or more away, after more than `CARRIED` in the air.
An object symbol says what its objects afford. So a primitive is of a kind if there is an object symbol with
`LEAST_OBJECTS` or more of the objects on which at least `LEAST_SHARE` of its rehearsals were of that kind.
"""

from collections.abc import Collection, Mapping

import numpy as np

from neurosym.operators import CARRIED, Rehearsal, Symbol
from neurosym.primitives.rehearsal import Rehearsals
from neurosym.world import Outcome

KINDS = ("right push", "left push", "forward push", "pull", "grasp", "pick and place")
_LEAST_MOVE = 0.03
"""Least displacement of a push or a placement [m]."""
_MOST_OFF_AXIS = 0.5
"""Greatest displacement across the direction of a push, as a share of that along it."""
LEAST_SHARE = 0.6
"""Least share of the rehearsals."""
LEAST_OBJECTS = 0.1
"""Least share of the objects that an object symbol must hold to count."""


def kind_of(outcome: Outcome | Rehearsal, lift_height: float) -> str | None:
    """Say which of the six kinds an outcome is, if any.

    `lift_height` is how high a grasped object is lifted [m].
    """
    if outcome.kind == "held":
        return "grasp" if outcome.effect[2] >= lift_height / 2 else None
    if outcome.kind != "resting":
        return None
    x, y, _ = outcome.resting_effect
    if outcome.peak_height > CARRIED:
        return "pick and place" if np.hypot(x, y) >= _LEAST_MOVE else None
    along, across = max(abs(x), abs(y)), min(abs(x), abs(y))
    if along < _LEAST_MOVE or across > _MOST_OFF_AXIS * along:
        return None
    if abs(x) > abs(y):
        return "forward push" if x > 0 else "pull"
    return "left push" if y > 0 else "right push"


def kinds_found(
    rehearsals: Rehearsals, lift_height: float
) -> Mapping[str, tuple[tuple[Symbol, Symbol], ...]]:
    """Say for each kind which primitives are of it, and for which object symbols.

    Args:
        rehearsals: Actions performed on objects of the categories that they serve.
        lift_height: How high a grasped object is lifted [m].
    """
    telling = [str(s) for s in np.unique(rehearsals.symbols) if rehearsals.share(s) >= LEAST_OBJECTS]
    found: dict[str, dict[tuple[Symbol, Symbol], None]] = {kind: {} for kind in KINDS}
    for number, primitive in enumerate(rehearsals.primitives):
        for symbol in telling:
            kinds = [kind_of(outcome, lift_height) for outcome in rehearsals.on(symbol, number)]
            for kind in KINDS:
                if kinds and kinds.count(kind) / len(kinds) >= LEAST_SHARE:
                    found[kind][primitive.symbol, symbol] = None
    return {kind: tuple(pairs) for kind, pairs in found.items()}


def kinds_table(
    found: Mapping[str, Mapping[str, Collection[str]]], repetition: str
) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of Table II: in how many repetitions each kind was found.

    Args:
        found: Which kinds were found, by strategy and repetition.
        repetition: What a repetition is called, like `seed`.
    """
    of_strategies = [[*repeated.values()] for repeated in found.values()]
    rows = [
        [kind, *(f"{sum(kind in kinds for kinds in each)} of {len(each)}" for each in of_strategies)]
        for kind in KINDS
    ]
    counts = [", ".join(str(len(kinds)) for kinds in each) for each in of_strategies]
    return ["", *found], [*rows, [f"kinds, by {repetition}", *counts]]
