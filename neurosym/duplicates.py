"""Operators that do the same as another: a planner needs one of them, and a reader, too.

Many action symbols share what can be done among them, so some do the same to a category.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence

from neurosym.operators import Operator, Vector


def find_duplicates(
    operators: Iterable[Operator], moves: Callable[[Operator], Sequence[Vector]], apart: float
) -> dict[str, str]:
    """Say of each operator that does the same as a more reliable one, which one that is and how they compare.

    The same means: to the same category, with the same kind of promise, and with displacements that differ
    by less than `apart` on every axis. Of equally reliable operators the first by name is kept.

    Args:
        operators: Operators with a promise.
        moves: Returns the displacements that an operator promises [m].
        apart: From which difference on displacements are not the same [m].

    Returns:
        Reasons to leave operators out, by their names.
    """
    kept = defaultdict[tuple[str, str], list[tuple[Operator, Sequence[Vector]]]](list)
    reasons = {}
    for operator in sorted(operators, key=lambda one: (-_reliability(one), one.name)):
        promise, own = operator.promise, moves(operator)
        assert promise is not None, f"{operator.name} promises nothing"
        others = kept[operator.category, promise.kind]
        other = next((other for other, its in others if _alike(own, its, apart)), None)
        if other is None:
            others.append((operator, own))
        else:
            how = "less" if _reliability(operator) < _reliability(other) else "as"
            reasons[operator.name] = f"does the same as {other.name}, {how} reliably"
    return reasons


def _reliability(operator: Operator) -> float:
    return (operator.successes + 1) / (
        operator.trials + 2
    )  # the mean chance of success, after so many trials


def _alike(one: Sequence[Vector], other: Sequence[Vector], apart: float) -> bool:
    return all(
        abs(a - b) < apart
        for mine, its in zip(one, other, strict=True)
        for a, b in zip(mine, its, strict=True)
    )
