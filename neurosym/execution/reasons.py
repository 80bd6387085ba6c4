"""Why a run missed its goals, in words: which goal, what ended the run, and which step went otherwise."""

from collections.abc import Sequence

from neurosym.execution.record import Run, StepRecord
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from neurosym.problems import Problem
from neurosym.relation_goals import RelationGoal
from neurosym.wording import counted, in_millimetres


def why_missed(run: Run, problem: Problem, grounding: Grounding, work: int = 0) -> str:
    """Say which goals of a run were missed, and what ended it; nothing if all were reached.

    Args:
        run: The run, without a reason.
        problem: What it was to solve.
        grounding: The learned domain.
        work: How much might be looked at for all new plans [states].
    """
    if run.reached:
        return ""
    unmet = run.unmet if isinstance(run.unmet, tuple) else ()
    relations = ", ".join(_missed(goal, run.steps, grounding) for goal in unmet)
    missed = [relations] if relations else []
    name, distance = max(run.distances.items(), key=lambda item: item[1], default=("", 0.0))
    if name and not (relations and distance <= problem.tolerance):
        allowed = f"{1000 * problem.tolerance:g} mm allowed"
        missed += [f"{name} is {in_millimetres(distance, problem.tolerance)} from its goal ({allowed})"]
    return "; ".join([*missed, _what_ended(run, work)])


def _missed(goal: RelationGoal, records: Sequence[StepRecord], grounding: Grounding) -> str:
    """Say what is so in the place of a goal by relation, and in which step that ended if it held."""
    target, reference, name = goal
    state = grounding.relations.state_named(name).name if grounding.relations else name
    wanted, told = f"{state} {reference}", [_relations(record).get(target) for record in records]
    now = (told[-1] or "borne by nothing") if records else "where it was"
    said, held = f"{target} is {now}, not {wanted}", [one == wanted for one in told]
    if not any(held) or held[-1]:
        return said
    number = len(held) - held[::-1].index(True) + 1
    return f"{said} as after step {number - 1}: that ended in step {number}"


def _relations(record: StepRecord) -> dict[str, str]:
    return record.relations if isinstance(record.relations, dict) else {}


def _what_ended(run: Run, work: int) -> str:
    ended, records, count = run.ended, run.steps, counted(run.replans, "new plan")
    number = len(records)
    if ended == "lost":
        lost = [records[-1].object] if records[-1].happened == "lost" else []
        lost += [name for name, how in records[-1].disturbed.items() if how == "lost"]
        return f"step {number} threw {' and '.join(lost)} off the table"
    if ended == "out of reach":
        return f"{records[-1].object} was out of the arm's reach in step {number}"
    if ended == "stopped":
        return f"it was stopped before step {number + 1}"
    spent = f"the budget of {work:,} states for new plans was used up after {count}"
    why = {
        "no plan": f"no new plan after step {number}: {run.replannings[-1].reason if run.replans else ''}",
        "budget": f"all {count} were used up",
        "work": f"gave up planning anew: {spent}",
        "no progress": f"the last new plans came no nearer to the goal, after {run.replans}",
    }
    if ended in why:
        return why[ended] + _toppled(records)
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
