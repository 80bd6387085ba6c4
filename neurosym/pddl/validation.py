"""Replaying a plan with the exact displacements that its operators promise, before it is believed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.relational_replay import Following
from neurosym.problems import Problem
from neurosym.promises import promised
from neurosym.related import is_relational, relating
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.footprints import footprints_apart, overlapping
from neurosym.tasks.places import with_places
from neurosym.tasks.puts import put_named
from neurosym.wording import in_millimetres


@dataclass(frozen=True, slots=True, eq=False)
class Validation:
    """What a plan promises, step by step.

    Attributes:
        positions: Centres of the objects before the first step and after each [m]; a plan that fails ends
            with the step that is impossible.
        possible: Whether every step is possible.
        valid: Whether every step is possible and the goal is met.
        reason: Why not; empty if valid.
        failed: The step that is impossible, and why, if one is.
        concerned: Names of the objects that the reason is about, the one that was moved first.
        number: Number of the step that is impossible, counted from 1; putting down belongs to its lift.
    """

    positions: Float[np.ndarray, "steps M 3"]
    possible: bool
    valid: bool
    reason: str
    failed: tuple[PlanStep, str] | None = None
    concerned: tuple[str, ...] = ()
    number: int | None = None


def validate(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Validation:
    """Replay a plan with exact displacements.

    Args:
        steps: The plan.
        problem: The problem it is for, which has every object that the plan names.
        grounding: The learned domain.
    """
    if is_relational(problem, grounding) or any(relating(step.base, grounding) for step in steps):
        return _validate_relations(steps, problem, grounding)
    if any(step.place for step in steps):
        problem = with_places(problem, grounding)
    positions = [problem.scene().positions]
    room, apart = problem.room(grounding.table), footprints_apart(problem)
    rests = np.ones(len(problem.objects), dtype=bool)
    held_by: PlanStep | None = None
    number = 0
    for step in steps:
        number = max(1, number + (not step.puts_down))
        operator = operator_for(step, problem, grounding)
        moved = problem.object_names.index(step.object)
        if reason := _hand_problem(step, operator, held_by):
            held = (held_by.object,) if held_by and not step.puts_down else ()
            return _failed(positions, number, step, reason, held)
        positions.append(_moved(positions[-1], moved, step, operator, problem, grounding))
        held_by = step if is_lift(operator) and not step.puts_down else None
        rests[moved] = held_by is None
        if found := _place_problem(positions[-1], moved, rests, room, apart, problem.object_names):
            return _failed(positions, number, step, *found)
    missed = _missed_goal(positions[-1], problem)
    name, reason = missed or ("", "")
    return Validation(np.array(positions), True, not missed, reason, concerned=(name,) if missed else ())


def _validate_relations(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Validation:
    """Replay a plan that puts objects on and into one another, or takes them from there."""
    now = Following(problem, grounding)
    positions = [now.positions]
    for number, step in enumerate(steps, start=1):
        words = (step.operator, step.object, step.place)
        found = now.why_impossible(words)
        if found and not _is_known(step, now):
            return _failed(positions, number, step, *found)
        positions.append(now.do(words))
        if found:
            return _failed(positions, number, step, *found)
    missed = now.missed() or _missed_goal(positions[-1], problem)
    name, reason = missed or ("", "")
    return Validation(np.array(positions), True, not missed, reason, concerned=(name,) if missed else ())


def _is_known(step: PlanStep, now: Following) -> bool:
    """Say whether it is known where a step would lead."""
    return put_named(step.operator, now.task.grounding) is not None or step.operator in {
        one.name for one in carriers_of(now.task.grounding)
    }


def hand_problem(steps: Sequence[PlanStep], grounding: Grounding) -> str:
    """Say which step of a plan asks the hand for what it cannot do, or nothing if none does.

    Args:
        steps: The plan.
        grounding: The learned domain.
    """
    held_by: PlanStep | None = None
    number = 0
    for step in steps:
        number = max(1, number + (not step.puts_down))
        if relating(step.base, grounding):
            continue
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
    positions: Float[np.ndarray, "M 3"],
    moved: int,
    step: PlanStep,
    operator: Operator,
    problem: Problem,
    grounding: Grounding,
) -> Float[np.ndarray, "M 3"]:
    if step.place:
        return _carried(positions, moved, problem.place_named(step.place))
    by = grounding.put_down_displacement if step.puts_down else grounding.displacement
    after = positions.copy()
    after[moved] += by(operator)
    return after


def _carried(
    positions: Float[np.ndarray, "M 3"], moved: int, spot: tuple[float, float]
) -> Float[np.ndarray, "M 3"]:
    """Put an object over a spot of the table: who carries it makes up for where it hangs from the hand."""
    after = positions.copy()
    after[moved, :2] = spot
    return after


def operator_for(step: PlanStep, problem: Problem, grounding: Grounding) -> Operator:
    """Return the operator of a step as it promises for the step's object.

    Args:
        step: The step.
        problem: The problem, which has the object.
        grounding: The learned domain.

    Raises:
        UnknownChoice: If there is no such operator or object.
    """
    item = problem.object_named(step.object)
    found = promised(grounding, item, problem.tolerance).get(step.base)
    return found or grounding.operator_named(step.base)


def _place_problem(
    here: Float[np.ndarray, "M 3"],
    moved: int,
    rests: Bool[np.ndarray, " M"],
    room: Float[np.ndarray, "2 M 2"],
    apart: Float[np.ndarray, "M M 2"],
    names: Sequence[str],
) -> tuple[str, tuple[str, ...]] | None:
    """Say why an object cannot be where it was moved to, and which others are in its way, if any are."""
    spot = here[moved, :2]
    if not np.all((spot >= room[0, moved]) & (spot <= room[1, moved])):
        return f"{names[moved]} leaves the table at x = {spot[0]:.3f}, y = {spot[1]:.3f} m", ()
    if rests[moved]:
        for other in np.flatnonzero(overlapping(spot, here[:, :2], apart[moved]) & rests):
            return f"{names[moved]} ends where {names[int(other)]} is", (names[int(other)],)
    return None


def _missed_goal(positions: Float[np.ndarray, "M 3"], problem: Problem) -> tuple[str, str] | None:
    """Name the first object that misses its goal, and say by how much, if one does."""
    for name, distance in problem.distances(positions).items():
        if distance > problem.tolerance:
            far = in_millimetres(distance, problem.tolerance)
            return name, f"{name} ends {far} from its goal, {1000 * problem.tolerance:g} mm are allowed"
    return None


def _failed(
    positions: list[Float[np.ndarray, "M 3"]],
    number: int,
    step: PlanStep,
    reason: str,
    others: tuple[str, ...] = (),
) -> Validation:
    said = f"step {number}, {step.operator} {step.object}: {reason}"
    concerned = tuple(dict.fromkeys((step.object, *others)))
    return Validation(np.array(positions), False, False, said, (step, reason), concerned, number)
