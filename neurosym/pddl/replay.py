"""Replaying a plan with the exact displacements that its operators promise, before it is believed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from neurosym.operators import Operator
from neurosym.pddl.grounding import Grounding, is_lift
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem


@dataclass(frozen=True, slots=True, eq=False)
class Replay:
    """What a plan promises, step by step.

    Attributes:
        positions: Centres of the objects before the first step and after each [m]; a plan that fails ends
            with the step that is impossible.
        possible: Whether every step is possible.
        valid: Whether every step is possible and the goal is met.
        reason: Why not; empty if valid.
    """

    positions: Float[np.ndarray, "steps M 3"]
    possible: bool
    valid: bool
    reason: str


def replay(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Replay:
    """Replay a plan with exact displacements.

    Args:
        steps: The plan.
        problem: The problem it is for, which has every object that the plan names.
        grounding: The learned domain.
    """
    positions = [problem.scene().positions]
    rests = np.ones(len(problem.objects), dtype=bool)
    held_by: PlanStep | None = None
    for number, step in enumerate(steps, start=1):
        operator = grounding.operator_named(step.base)
        moved = problem.object_names.index(step.object)
        problem_with_hand = _hand_problem(step, operator, held_by)
        if problem_with_hand:
            return _failed(positions, number, step, problem_with_hand)
        positions.append(_moved(positions[-1], moved, step, operator, grounding))
        held_by = step if is_lift(operator) and not step.puts_down else None
        rests[moved] = held_by is None
        if reason := _place_problem(positions, moved, rests, problem, grounding):
            return _failed(positions, number, step, reason)
    reason = _missed_goal(positions[-1], problem)
    return Replay(np.array(positions), True, not reason, reason)


def hand_problem(steps: Sequence[PlanStep], grounding: Grounding) -> str:
    """Say which step of a plan asks the hand for what it cannot do, or nothing if none does.

    Args:
        steps: The plan.
        grounding: The learned domain.
    """
    held_by: PlanStep | None = None
    for number, step in enumerate(steps, start=1):
        operator = grounding.operator_named(step.base)
        if operator.promise and (problem := _hand_problem(step, operator, held_by)):
            return f"step {number}, {step.operator} {step.object}: {problem}"
        held_by = step if is_lift(operator) and not step.puts_down else None
    return ""


def _hand_problem(step: PlanStep, operator: Operator, held_by: PlanStep | None) -> str:
    if operator.promise is None:
        return "the operator promises nothing"
    if step.puts_down:
        lifted = held_by is not None and (held_by.operator, held_by.object) == (step.base, step.object)
        return "" if lifted else f"{step.object} is not held by {step.base}"
    return "" if held_by is None else f"the hand still holds {held_by.object}"


def _moved(
    positions: Float[np.ndarray, "M 3"], moved: int, step: PlanStep, operator: Operator, grounding: Grounding
) -> Float[np.ndarray, "M 3"]:
    by = grounding.put_down_displacement if step.puts_down else grounding.displacement
    after = positions.copy()
    after[moved] += by(operator)
    return after


def _place_problem(
    positions: Sequence[Float[np.ndarray, "M 3"]],
    moved: int,
    rests: np.ndarray,
    problem: Problem,
    grounding: Grounding,
) -> str:
    here = positions[-1]
    name = problem.object_names[moved]
    if not grounding.table.contains(here[moved]):
        return f"{name} leaves the table at x = {here[moved][0]:.3f}, y = {here[moved][1]:.3f} m"
    for other in range(len(here)):
        if other == moved or not (rests[moved] and rests[other]):
            continue
        if _overlap(problem, here, moved, other) and not _overlap(problem, positions[0], moved, other):
            return f"{name} ends where {problem.object_names[other]} is"
    return ""


def _overlap(problem: Problem, positions: Float[np.ndarray, "M 3"], one: int, other: int) -> bool:
    """Say whether the footprints of two objects overlap, as boxes along the axes."""
    sizes = [problem.objects[index].features[:2] for index in (one, other)]
    reach = (np.array(sizes[0]) + np.array(sizes[1])) / 2
    return bool(np.all(np.abs(positions[one][:2] - positions[other][:2]) < reach))


def _missed_goal(positions: Float[np.ndarray, "M 3"], problem: Problem) -> str:
    for name, distance in problem.distances(positions).items():
        if distance > problem.tolerance:
            allowed = problem.tolerance * 1000
            return f"{name} ends {distance * 1000:.0f} mm from its goal, {allowed:.0f} mm are allowed"
    return ""


def _failed(positions: list[Float[np.ndarray, "M 3"]], number: int, step: PlanStep, reason: str) -> Replay:
    return Replay(
        np.array(positions), False, False, f"step {number}, {step.operator} {step.object}: {reason}"
    )
