"""Execution: a plan runs in the world, and each step is compared with what its operator promised.

A `put-down-...` step is the second half of the lift before it: the world performs both as one interaction,
and only a lift that ends the plan is left in mid-air.
"""

import math
from collections.abc import Callable, Sequence
from typing import Literal

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidValue
from neurosym.operators import TOLERANCE, Vector
from neurosym.pddl.grounding import Grounding, is_lift
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem
from neurosym.world import Disturbance, FrameSink, Outcome, Scene, World

StepOutcome = Literal["resting", "held", "toppled", "lost", "not performed"]


class StepRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One step of a plan: what was promised and what happened.

    Attributes:
        operator: Name of the operator.
        object: Name of the object acted upon.
        promised: How the object was to end, and None if the operator never promised anything.
        promised_effect: How far it was to move [m].
        happened: How it ended.
        effect: How far it moved [m].
        deviation: Distance between the two displacements [m].
        as_promised: Whether it ended so, within the tolerance.
        positions: Centre of every object after the step [m], by name.
        touched: Names of the other objects that the robot itself touched.
        disturbed: How other objects ended that ended elsewhere (moved, toppled, lost), by name.
    """

    operator: str
    object: str
    promised: StepOutcome | None
    promised_effect: Vector | None
    happened: StepOutcome
    effect: Vector
    deviation: float | None
    as_promised: bool
    positions: dict[str, Vector]
    touched: tuple[str, ...] = ()
    disturbed: dict[str, Disturbance] = {}


class Run(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What became of a plan in the world.

    Attributes:
        problem: Name of the problem.
        plan: The steps that were asked for, as operator and object.
        steps: A record for each interaction that was performed.
        reached: Whether every goal was met at the end.
        distances: How far each object with a goal ended from it [m].
        reason: Why the goal was not reached, or empty.
    """

    problem: str
    plan: tuple[tuple[str, str], ...]
    steps: tuple[StepRecord, ...]
    reached: bool
    distances: dict[str, float]
    reason: str


def execute(
    world: World,
    problem: Problem,
    grounding: Grounding,
    plan: Sequence[PlanStep],
    *,
    on_frame: FrameSink | None = None,
    on_step: Callable[[StepRecord], None] | None = None,
) -> Run:
    """Run a plan in the world with the distilled parameters of its primitives.

    The plan is followed to its end whatever the steps do, unless an object is lost or out of reach.

    Args:
        world: The world to act in.
        problem: The scene to start from and the goals to judge by.
        grounding: What the operators' names mean.
        plan: The steps, whichever planner they come from.
        on_frame: Called with pictures of the motion as it happens, if given.
        on_step: Called with each step's record as soon as it is done, if given.
    """
    scene = problem.scene()
    records: list[StepRecord] = []
    for index, step in enumerate(plan):
        if step.puts_down:
            continue
        is_last = index == len(plan) - 1
        outcome = _perform(world, problem, grounding, step, scene, is_last, on_frame)
        if outcome is None:
            records.append(_not_performed(step, problem, scene))
            break
        scene = outcome.end
        records.append(_record(step, problem, grounding, outcome))
        if on_step:
            on_step(records[-1])
        if outcome.lost:
            break
    reached = problem.is_met(scene.positions)
    distances = problem.distances(scene.positions)
    return Run(
        problem=problem.name,
        plan=tuple((step.operator, step.object) for step in plan),
        steps=tuple(records),
        reached=reached,
        distances=distances,
        reason="" if reached else _reason(records, distances, problem.tolerance),
    )


def _perform(
    world: World,
    problem: Problem,
    grounding: Grounding,
    step: PlanStep,
    scene: Scene,
    is_last: bool,
    on_frame: FrameSink | None,
) -> Outcome | None:
    operator = grounding.operator_named(step.operator)
    action = np.array(grounding.primitive(operator.primitive).action)
    ends_held = is_last and is_lift(operator)
    target = problem.object_names.index(step.object)
    try:
        return world.interact(
            scene,
            action,
            target,
            put_down=not ends_held,
            on_frame=on_frame,
            ghosts=problem.goal_positions(),
        )
    except InvalidValue:  # the object has been moved out of the arm's reach
        return None


def _record(step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome) -> StepRecord:
    operator = grounding.operator_named(step.operator)
    effect = _vector(outcome.effect if outcome.held else outcome.resting_effect)
    promised_effect = grounding.displacement(operator) if operator.promise else None
    deviation = math.dist(effect, promised_effect) if promised_effect else None
    kept = operator.promise is not None and operator.promise.kind == outcome.kind
    return StepRecord(
        operator=step.operator,
        object=step.object,
        promised=operator.promise.kind if operator.promise else None,
        promised_effect=promised_effect,
        happened=outcome.kind,
        effect=effect,
        deviation=deviation,
        as_promised=kept and deviation is not None and deviation <= TOLERANCE,
        positions=_named(problem, outcome.end),
        touched=tuple(problem.object_names[index] for index in outcome.touched),
        disturbed={problem.object_names[index]: how for index, how in outcome.disturbed},
    )


def _not_performed(step: PlanStep, problem: Problem, scene: Scene) -> StepRecord:
    return StepRecord(
        operator=step.operator,
        object=step.object,
        promised=None,
        promised_effect=None,
        happened="not performed",
        effect=(0.0, 0.0, 0.0),
        deviation=None,
        as_promised=False,
        positions=_named(problem, scene),
    )


def _reason(records: Sequence[StepRecord], distances: dict[str, float], tolerance: float) -> str:
    name, distance = max(distances.items(), key=lambda item: item[1])
    missed = f"{name} is {1000 * distance:.0f} mm from its goal ({1000 * tolerance:.0f} mm allowed)"
    for number, record in enumerate(records, 1):
        if record.happened == "not performed":
            return f"{missed}; {record.object} was out of the arm's reach in step {number}"
        if not record.as_promised:
            apart = "" if record.deviation is None else f", {1000 * record.deviation:.0f} mm from the promise"
            told = f"promised {record.promised}, ended {record.happened}{apart}"
            return f"{missed}; step {number}, {record.operator}: {told}"
    if not records:
        return f"{missed}; the plan has no step"
    return f"{missed}, though every step did as promised within {1000 * TOLERANCE:.0f} mm"


def _named(problem: Problem, scene: Scene) -> dict[str, Vector]:
    return {name: _vector(row) for name, row in zip(problem.object_names, scene.positions, strict=True)}


def _vector(values: Float[np.ndarray, "3"]) -> Vector:
    x, y, z = (float(value) for value in values)
    return (x, y, z)
