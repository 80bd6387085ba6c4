"""The six kinds of primitive of Table II, and when a kind counts as found.

The rule was fixed before any result was looked at:

* A push (right, left, forward, or pull) ends at rest upright, `LEAST_MOVE` or more along its direction, at
  most `MOST_OFF_AXIS` of that along the other horizontal axis, never higher than `CARRIED` on the way.
* A grasp ends held, half the lift or more above the start.
* A pick and place ends at rest upright, `LEAST_MOVE` or more away horizontally, after more than `CARRIED` in
  the air.

An object symbol says what its objects afford. So a primitive is of a kind if there is an object symbol with
`LEAST_OBJECTS` or more of the objects on which at least `LEAST_SHARE` of its rehearsals were of that kind.
"""

from collections.abc import Mapping

import numpy as np

from neurosym.naming import CARRIED
from neurosym.operators import Rehearsal
from neurosym.primitives.rehearsal import Rehearsals
from neurosym.symbols import Symbol
from neurosym.world import Outcome

KINDS = ("right push", "left push", "forward push", "pull", "grasp", "pick and place")
LEAST_MOVE = 0.03
"""Least displacement of a push or a placement [m]."""
MOST_OFF_AXIS = 0.5
"""Greatest displacement across the direction of a push, as a share of that along it."""
LEAST_SHARE = 0.6
"""Least share of the rehearsals."""
LEAST_OBJECTS = 0.1
"""Least share of the objects that an object symbol must hold to count."""


def kind_of(outcome: Outcome | Rehearsal, lift_height: float) -> str | None:
    """Say which of the six kinds an outcome is, if any.

    Args:
        outcome: What happened to the target.
        lift_height: How high a grasped object is lifted [m].
    """
    if outcome.kind == "held":
        return "grasp" if outcome.effect[2] >= lift_height / 2 else None
    if outcome.kind != "resting":
        return None
    x, y, _ = outcome.resting_effect
    if outcome.peak_height > CARRIED:
        return "pick and place" if np.hypot(x, y) >= LEAST_MOVE else None
    along, across = max(abs(x), abs(y)), min(abs(x), abs(y))
    if along < LEAST_MOVE or across > MOST_OFF_AXIS * along:
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
    found: dict[str, list[tuple[Symbol, Symbol]]] = {kind: [] for kind in KINDS}
    for number, primitive in enumerate(rehearsals.primitives):
        for symbol in telling:
            kinds = [kind_of(outcome, lift_height) for outcome in rehearsals.on(symbol, number)]
            for kind in KINDS:
                pair = (primitive.symbol, symbol)
                often = bool(kinds) and kinds.count(kind) / len(kinds) >= LEAST_SHARE
                if often and pair not in found[kind]:
                    found[kind].append(pair)
    return {kind: tuple(pairs) for kind, pairs in found.items()}
