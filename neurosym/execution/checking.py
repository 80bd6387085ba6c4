"""Refusing what cannot be executed before anything moves."""

from collections.abc import Sequence

from neurosym.checks import check_all, check_count, check_kind, check_seed
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem
from neurosym.related import relating


def check_execution(
    problem: Problem, grounding: Grounding, plan: Sequence[PlanStep], replans: int | None, seed: int | None
) -> None:
    """Raise unless a plan can be executed, as far as names and numbers tell.

    Args:
        problem: The problem.
        grounding: The learned domain.
        plan: The steps.
        replans: How many new plans may be asked for, if given.
        seed: The seed of a nudge, if given.

    Raises:
        InvalidValue: If something is not what it should be.
        UnknownChoice: If a step names what there is not.
    """
    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    check_all("plan", plan, PlanStep, "steps, as in PlanResult.steps")
    for step in plan:
        if not relating(step.base, grounding):
            grounding.operator_named(step.base)
        problem.object_named(step.object)
    if replans is not None:
        check_count("replans", replans, least=0)
    if seed is not None:
        check_seed(seed, "nudge_seed")


def check_references(problem: Problem, grounding: Grounding, plan: Sequence[PlanStep]) -> None:
    """Refuse steps that carry an object nowhere, off the table, or to what there is not.

    Args:
        problem: The problem, with its places.
        grounding: The learned domain.
        plan: The steps.

    Raises:
        InvalidValue: If a step leads nowhere.
        UnknownChoice: If it names what there is not.
    """
    for step in plan:
        if relating(step.base, grounding):
            others = [name for name in problem.object_names if name != step.object]
            if step.place not in others:
                raise UnknownChoice("other object", step.place, others)
        elif grounding.carries(grounding.operator_named(step.base)):
            grounding.table.check(step.place, *problem.place_named(step.place))
        elif step.place:
            raise InvalidValue(f"{step.operator} carries nothing, so it cannot lead to {step.place}.")
