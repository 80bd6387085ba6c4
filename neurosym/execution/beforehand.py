"""What is refused before a plan is executed: a run that could not come to its end in order."""

from collections.abc import Sequence

from neurosym.checks import check_all, check_callable, check_count, check_kind, check_seed
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.object_limits import limits_of
from neurosym.planners.registry import Replanner
from neurosym.problems import Problem
from neurosym.related import relating
from neurosym.tasks.steps import PlanStep
from neurosym.world import World


def check_run(
    world: World,
    problem: Problem,
    grounding: Grounding,
    plan: Sequence[PlanStep],
    replanner: Replanner | None,
    replans: int | None,
    seed: int | None,
) -> None:
    """Refuse what cannot be executed before anything moves.

    Args:
        world: The world to act in.
        problem: The scene to start from.
        grounding: What the operators' names mean.
        plan: The steps.
        replanner: Whom to ask for new plans, if anybody.
        replans: How many new plans may be asked for, if it is said.
        seed: From which a nudge is drawn, if one is.

    Raises:
        InvalidValue: If something is not what it should be, or a step names an object that there is not.
        UnknownChoice: If a step names an operator that there is not.
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
    if replanner is not None:
        check_callable("replanner", replanner, "a function from a problem and a grounding to a plan result")
    if limits := limits_of(world):
        if reason := limits.too_many(len(problem.objects)):
            raise InvalidValue(f"The problem {problem.name} cannot be executed: {reason}.")
        for item in problem.objects:
            limits.check(item.name, item.features)


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
