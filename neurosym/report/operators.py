"""The table of operators, for the page: what each promises, and why it is in the domain or not."""

from dataclasses import dataclass

from neurosym.explain.action_words import spread_in_words
from neurosym.explain.explanation import mode_in_words
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable
from neurosym.tasks.moves import cost


@dataclass(frozen=True, slots=True)
class OperatorRow:
    """What an operator promises.

    Attributes:
        name: Its name, as in the PDDL domain.
        trials: How many rehearsals there were, or rows of the data.
        promised: How many of them ended as promised.
        ends: How the object is to end, and in which share of the trials it did.
        effect: How far it is to move, in words.
        spread: Standard deviation of that, in words.
        cost: What a step costs a planner; None if it is in no domain.
        left_out: Why it is not in the domain; empty if it is, or nobody knows.
    """

    name: str
    trials: int
    promised: int
    ends: str
    effect: str
    spread: str
    cost: int | None
    left_out: str


def operator_rows(table: OperatorTable, grounding: Grounding | None) -> tuple[OperatorRow, ...]:
    """List operators, those of the domain if it was compiled, and those first that are in it."""
    rows = []
    for operator in grounding.every_operator if grounding else table.operators:
        promise = operator.promise
        reason = grounding.why_left_out(operator) if grounding else None
        in_domain = grounding is not None and reason is None
        rows.append(
            OperatorRow(
                name=operator.name,
                trials=operator.trials,
                promised=operator.successes,
                ends=f"{promise.kind} {promise.share:.0%}" if promise else "never as it could promise",
                effect=mode_in_words(promise) if promise else "",
                spread=spread_in_words(promise.scatter) if promise else "",
                cost=cost(operator) if in_domain else None,
                left_out=reason or "",
            )
        )
    return tuple(sorted(rows, key=lambda row: row.left_out != ""))
