"""Performing one step of a plan in a world."""

import numpy as np

from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.grounding import Grounding
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem
from neurosym.table import Reference
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
    operator = grounding.operator_named(step.operator)
    action = np.array(grounding.primitive_of(operator).action)
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
