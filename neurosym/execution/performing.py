"""Performing one step of a plan in a world, and recording it."""

import numpy as np

from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.execution.record import StepRecord, record_step
from neurosym.execution.relating import record_put, with_relations
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Primitive
from neurosym.problems import Problem
from neurosym.related import relating
from neurosym.table import Reference
from neurosym.tasks.steps import PlanStep
from neurosym.world import FrameSink, Outcome, Scene, World, relative_to


def perform(
    world: World,
    problem: Problem,
    grounding: Grounding,
    step: PlanStep,
    scene: Scene,
    put_down: bool,
    on_frame: FrameSink | None = None,
    *,
    reference: Reference | None = None,
) -> Outcome | None:
    """Perform one step of a plan.

    Args:
        world: The world to act in.
        problem: What the objects are called, and where pictures show their goals.
        grounding: What the operator's name means.
        step: The step.
        scene: Where everything is.
        put_down: Whether to put the object down if it is held.
        on_frame: Called with pictures of the motion as it happens, if given.
        reference: What the step is aimed at besides its object, if anything.

    Returns:
        What happened; None if the object was out of the arm's reach.
    """
    action = np.array(_primitive(step, grounding).action)
    target = problem.object_names.index(step.object)
    ghosts = problem.goal_positions()
    try:
        aim = relative_to(world, reference)
        return world.interact(
            scene, action, target, put_down=put_down, on_frame=on_frame, ghosts=ghosts, **aim
        )
    except InvalidWorld:
        raise
    except InvalidValue:  # the object has been moved out of the arm's reach
        return None


def recorded(
    step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome, *, put_down: bool
) -> StepRecord:
    """Record a step that was performed, whether it puts its object on another one or not.

    Args:
        step: The step.
        problem: The problem, whose objects are those of the outcome.
        grounding: What the operator promises.
        outcome: What happened.
        put_down: Whether the object was to be put down if it was held.
    """
    if relating(step.operator, grounding):
        record = record_put(step, problem, grounding, outcome)
    else:
        record = record_step(step, problem, grounding, outcome, put_down=put_down)
    return with_relations(record, problem, grounding, outcome)


def lifts(step: PlanStep, grounding: Grounding) -> bool:
    """Say whether a step promises to end with its object held."""
    return not relating(step.operator, grounding) and is_lift(grounding.operator_named(step.operator))


def _primitive(step: PlanStep, grounding: Grounding) -> Primitive:
    operator = relating(step.operator, grounding)
    if operator and grounding.relations:
        return grounding.relations.primitive_of(operator)
    return grounding.primitive_of(grounding.operator_named(step.operator))
