"""Replanning: whether what is left of a plan still leads to the goal, and asking for a new plan if not."""

from collections.abc import Sequence

from neurosym.execution.experience import Experience, believed_name, learned_name
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.validation import validate
from neurosym.planners.registry import Replanner
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem

REPLANS = 10
"""How many new plans a run may ask for."""


def why_not_go_on(left: Sequence[PlanStep], seen: Problem, experience: Experience) -> str:
    """Say why what is left of a plan would miss the goal by what is believed now, or nothing.

    Args:
        left: The steps that are left.
        seen: The problem as it stands now.
        experience: What the objects were seen to do.
    """
    if not left and seen.is_met(seen.scene().positions):
        return ""
    believed, grounding = experience.believed(seen)
    checked = validate([believed_name(step, grounding) for step in left], believed, grounding)
    if checked.failed is None:
        return checked.reason
    step, why = learned_name(checked.failed[0]), checked.failed[1]
    return f"{step.operator} {step.object}: {why}"


def new_plan(
    replanner: Replanner, seen: Problem, experience: Experience
) -> tuple[PlanResult, tuple[PlanStep, ...], Experience]:
    """Ask for a new plan from where things are; where experience stands against any, forget it and ask again.

    Args:
        replanner: Whom to ask.
        seen: The problem as it stands now.
        experience: What the objects were seen to do.

    Returns:
        What was answered, the steps by the names of learned operators, and what is to be believed from now.
    """
    result = replanner(*experience.believed(seen))
    if result.status is not PlanStatus.SOLVED and experience.says_something:
        experience = Experience(experience.grounding)  # hope again for what did not come
        result = replanner(seen, experience.grounding)
    return result, tuple(learned_name(step) for step in result.steps), experience
