"""Why a run missed its goals, in words: which goal, what ended the run, and which step went otherwise."""

from collections.abc import Sequence

from neurosym.execution.record import Ended, Replanning, StepRecord
from neurosym.operators import TOLERANCE
from neurosym.wording import counted, in_millimetres


def why_missed(
    ended: Ended,
    records: Sequence[StepRecord],
    replannings: Sequence[Replanning],
    distances: dict[str, float],
    tolerance: float,
    relations: str = "",
    work: int = 0,
) -> str:
    """Say which goal was missed, and what ended the run; nothing if the goal was reached.

    Args:
        ended: What ended it.
        records: The steps.
        replannings: The new plans that were asked for.
        distances: How far each object with a goal ended from it [m].
        tolerance: How far it may be [m].
        relations: Which goals by relation were missed, in words.
        work: How much might be looked at for all new plans [states].
    """
    if ended == "goal":
        return ""
    missed = [relations] if relations else []
    name, distance = max(distances.items(), key=lambda item: item[1], default=("", 0.0))
    if name and not (relations and distance <= tolerance):
        allowed = f"{1000 * tolerance:g} mm allowed"
        missed += [f"{name} is {in_millimetres(distance, tolerance)} from its goal ({allowed})"]
    return "; ".join([*missed, _what_ended(ended, records, replannings, work)])


def _what_ended(
    ended: Ended, records: Sequence[StepRecord], replannings: Sequence[Replanning], work: int
) -> str:
    number = len(records)
    if ended == "lost":
        lost = [records[-1].object] if records[-1].happened == "lost" else []
        lost += [name for name, how in records[-1].disturbed.items() if how == "lost"]
        return f"step {number} threw {' and '.join(lost)} off the table"
    if ended == "out of reach":
        return f"{records[-1].object} was out of the arm's reach in step {number}"
    if ended == "no plan":
        return f"no new plan after step {number}: {replannings[-1].reason}{_toppled(records)}"
    if ended == "stopped":
        return f"it was stopped before step {number + 1}"
    if ended == "budget":
        return f"all {counted(len(replannings), 'new plan')} were used up{_toppled(records)}"
    if ended == "work":
        count = counted(len(replannings), "new plan")
        spent = f"the budget of {work:,} states for new plans was used up after {count}"
        return f"gave up planning anew: {spent}{_toppled(records)}"
    if ended == "no progress":
        return f"the last new plans came no nearer to the goal, after {len(replannings)}{_toppled(records)}"
    return f"the plan came to its end; {_first_otherwise(records)}"


def _toppled(records: Sequence[StepRecord]) -> str:
    """Say which step toppled something last, if one did."""
    for number, record in reversed([*enumerate(records, 1)]):
        fell = [record.object] if record.happened == "toppled" else []
        fell += [name for name, how in record.disturbed.items() if how == "toppled"]
        if fell:
            return f"; {' and '.join(fell)} toppled in step {number}"
    return ""


def _first_otherwise(records: Sequence[StepRecord]) -> str:
    """Say which step was the first not to do as promised."""
    for number, record in enumerate(records, 1):
        if not record.as_promised:
            apart = (
                ""
                if record.apart is None
                else f", {in_millimetres(record.apart, TOLERANCE)} from the promise"
            )
            promised, happened = record.promised_state or record.promised, record.state or record.happened
            told = f"promised {promised}, ended {happened}{apart}"
            return f"step {number}, {record.operator}: {told}"
    if not records:
        return "it has no step"
    return f"every step did as promised within {1000 * TOLERANCE:.0f} mm"
