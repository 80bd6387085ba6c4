"""Running a record again: the same world, step by step, must give the same record, byte by byte."""

from collections.abc import Callable

import msgspec

from neurosym.execution.executor import perform
from neurosym.execution.nudges import nudged
from neurosym.execution.record import Run, StepRecord, record_refusal, record_step
from neurosym.grounding import Grounding
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem
from neurosym.world import FrameSink, World


def rerun(
    world: World,
    problem: Problem,
    grounding: Grounding,
    run: Run,
    *,
    on_frame: FrameSink | None = None,
    on_step: Callable[[StepRecord], None] | None = None,
) -> Run:
    """Perform the steps of a record again, with the same nudge, up to the first that goes another way.

    Args:
        world: The world that the run was made in.
        problem: The problem that it was made for.
        grounding: The grounding that it was made with.
        run: The record.
        on_frame: Called with pictures of the motion as it happens, if given.
        on_step: Called with each step's record as soon as it is done, if given.

    Raises:
        UnknownChoice: If the record names an operator that the grounding does not have.
    """
    scene, records = problem.scene(), []
    for number, recorded in enumerate(run.steps, start=1):
        if run.nudge and run.nudge.before_step == number:
            scene = nudged(scene, run.nudge, problem)
        step, put_down = PlanStep(recorded.operator, recorded.object), recorded.put_down
        outcome = perform(world, problem, grounding, step, scene, put_down, on_frame)
        if outcome is None:
            records.append(record_refusal(step, problem, scene))
        else:
            scene = outcome.end
            records.append(record_step(step, problem, grounding, outcome, put_down=put_down))
        if on_step:
            on_step(records[-1])
        if _encoded(records[-1]) != _encoded(recorded):
            break
    if run.nudge and run.nudge.before_step == len(records) + 1:
        scene = nudged(scene, run.nudge, problem)
    return msgspec.structs.replace(
        run,
        steps=tuple(records),
        reached=problem.is_met(scene.positions),
        distances=problem.distances(scene.positions),
    )


def first_difference(recorded: Run, again: Run) -> str:
    """Say where two records of the same steps differ first, or nothing if their bytes are the same.

    Args:
        recorded: The record.
        again: What happened when it was run again.
    """
    for number, (one, other) in enumerate(zip(recorded.steps, again.steps, strict=False), start=1):
        if field := _differing(one, other):
            return f"{field} of step {number}, {one.operator} {one.object}"
    return _differing(recorded, again)


def _differing(one: msgspec.Struct, other: msgspec.Struct) -> str:
    """Name the first field that differs, or nothing if none does."""
    for field in one.__struct_fields__:
        if _encoded(getattr(one, field)) != _encoded(getattr(other, field)):
            return field
    return ""


def _encoded(value: object) -> bytes:
    return msgspec.json.encode(value)
