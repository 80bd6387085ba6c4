"""What a page says of plans and runs in plain sentences, from the words of a step to what came of it all."""

from typing import Any

from neurosym.execution.record import Replanning
from neurosym.planners import PlanStatus
from neurosym.stages.plan_records import PlanRecord
from neurosym.studio.messages import Failed, Performed, Planned, Ran
from neurosym.studio.saying import Word
from neurosym.wording import counted


def step_words(*names: str) -> str:
    """Name a step of a plan.

    Args:
        names: Its operator, its object, and the place or the other object; that may be empty, or not there.
    """
    return " ".join(filter(None, names))


def plan_word(record: PlanRecord) -> Word:
    """Return what is said when a planner is done.

    Args:
        record: How planning went.
    """
    found = len(record.steps)
    if record.status is PlanStatus.SOLVED:
        return Word(f"{record.planner} found a plan of {counted(found, 'step')}")
    towards = ", but one towards it" if found else ""
    return Word(f"{record.planner}: no plan to the goal{towards}", is_bad=True)


def plan_lines(planned: Planned) -> tuple[str, ...]:
    """Say what a planner found: a sentence, and then a line for each step.

    Args:
        planned: How planning went.
    """
    record = planned.record
    if not planned.plan_file:
        reason = record.reason or record.status.value
        return (f"No plan was found: {reason.removesuffix('.')}.",)
    is_nearest = record.status is PlanStatus.NEAREST
    if not record.steps:
        return ("No plan was found that comes nearer to the goal." if is_nearest else "All is at its goal.",)
    head = f"The plan has {counted(len(record.steps), 'step')}."
    if is_nearest:
        head = f"There is no plan to the goal, but one that comes near. {head}"
    sure = f" The chance that all go as promised is {record.chance:.0%}." if record.chance is not None else ""
    steps = (f"{number}. {step_words(*step)}" for number, step in enumerate(record.steps, start=1))
    return head + sure, *steps


def replanned(replanning: Replanning) -> str:
    """Say what came of asking for a new plan.

    Args:
        replanning: What came of it.
    """
    when = f"before step {replanning.before_step}"
    if replanning.reason and not replanning.plan:
        return f"No new plan was found {when}: {replanning.reason}"
    return f"Planned anew {when}: {replanning.why}"


def end_word(said: Any) -> Word | None:
    """Return what is said at the end of a run or of an action, as its process answers; None if nothing is.

    Args:
        said: The answer.
    """
    if isinstance(said, Ran):
        steps = counted(len(said.run.steps), "step")
        text = f"{said.run.outcome} in {steps}" if said.run.reached else f"goal missed: {said.run.reason}"
        again = f"; the record says {'the same' if said.course != 'another' else 'otherwise'}"
        return Word(text + (again if said.course else ""), not said.run.reached)
    if isinstance(said, Performed):
        return Word(said.said or f"it ended {said.kind}", said.kind in ("lost", "toppled"))
    return Word(said.sentence, is_bad=True) if isinstance(said, Failed) else None
