"""Operators for pairs of any kind: what a primitive does, over all kinds of pairs that it was rehearsed with.

A kind gets no operator for what few of its pairs allow. Yet with some of them a primitive that was chosen for
another kind is foreseen to do it. So each primitive has an operator for pairs of any kind, for each state
that it promises some kind. Only pairs of which that is foreseen are offered it, and nothing that rests on a
target goes along: two things that are unsure at once seldom go well.
"""

from functools import lru_cache

import numpy as np

from neurosym.place_operators import Kept
from neurosym.relation_operators import ANY_KIND, PairEnd, RelationOperator, RelationOperators

COMES_TRUE = 0.6
"""What is foreseen of such an operator comes true in this share of the cases: it is the best of many, with
pairs unlike those that its primitive was auditioned with.

Measured with the shipped domain, on pairs that fit (`python -m tools.benchmarks.relations.pooled`): 25 of
40 were put in where 94 % was foreseen, 23 where it was 81 %, 18 where it was 58 %, 17 where it was 43 %.
"""
LEAST, HOPED = 0.1, 0.2
"""What is foreseen less surely than the first is not said of a pair; the rest is hoped to come true as often
as the second says, or more.

Measured by the same command: of 40 pairs with which 10 to 20 % was foreseen, an action written by hand put 12
in, and what was foreseen 4. With less, the action by hand put in 2 of 40.
"""


FAINT, FAINTEST = 0.02, 4
"""Where nothing is foreseen more surely than `LEAST`, a problem keeps so many operators for the state that
are foreseen as surely as the first number or more. They serve goals only: whoever asks for something may know
that it can be done."""


@lru_cache(maxsize=8)
def pooled(table: RelationOperators) -> tuple[RelationOperator, ...]:
    """Make of each primitive's operators for the same state one for pairs of any kind.

    Args:
        table: What was learned of pairs.
    """
    straight = {state.symbol: state.name for state in table.states if state.bears and not state.leans}
    found = dict[tuple[str, str], list[tuple[RelationOperator, PairEnd]]]()
    for one in table.operators:
        if one.promise is not None and one.promise.state in straight:
            found.setdefault((one.label, one.promise.state), []).append((one, one.promise))
    return tuple(_pooled(f"{straight[state]}-by-{label}", rows) for (label, state), rows in found.items())


def _pooled(name: str, rows: list[tuple[RelationOperator, PairEnd]]) -> RelationOperator:
    first, end = rows[0]
    trials, count = sum(one.trials for one, _ in rows), sum(end.count for _, end in rows)
    weights = np.array([end.count for _, end in rows]) / count
    offsets, spreads = (np.array([getattr(end, what) for _, end in rows]) for what in ("offset", "spread"))
    mean = weights @ offsets
    spread = np.sqrt(weights @ (spreads**2 + (offsets - mean) ** 2))
    return RelationOperator(
        name,
        ANY_KIND,
        first.primitive,
        trials,
        (PairEnd(end.state, count, count / trials, _three(mean), _three(spread)),),
        borne=_sum(name, [one.borne for one, _ in rows]),
        occupied=_sum(name, [one.occupied for one, _ in rows]),
        laden=Kept(name, 0, 0),
        variant=first.variant,
    )


def _sum(name: str, rows: list[Kept]) -> Kept:
    return Kept(name, sum(one.trials for one in rows), sum(one.kept for one in rows))


def _three(values: np.ndarray) -> tuple[float, float, float]:
    x, y, z = (round(float(value), 4) for value in values)
    return x, y, z


def share_with_any(foreseen: float) -> float | None:
    """Say how surely an operator for any pair does what is foreseen; None if that is not worth a try.

    Args:
        foreseen: The chance that a network foresees.
    """
    return max(HOPED, COMES_TRUE * foreseen) if foreseen >= LEAST else None
