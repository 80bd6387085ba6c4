"""Planners of your own: `module:factory` names what makes one, and what it returns is checked."""

import math
import reprlib
from collections.abc import Container
from contextlib import chdir, redirect_stdout
from dataclasses import replace
from io import StringIO
from pathlib import Path

from neurosym.errors import InvalidPlanner, InvalidValue, shortened
from neurosym.factories import admit, load_factory, one_line, told
from neurosym.planners.planner import Planner, PlannerMissing, Query
from neurosym.planners.result import LONGEST_REASON, PlanResult, PlanStatus
from neurosym.related import relating
from neurosym.spots import spot_named
from neurosym.tasks.places import with_places
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import validate


def load_planner(name: str, domain_folder: Path | None, taken: Container[str]) -> Planner:
    """Make a planner of one's own.

    Args:
        name: `module:factory`; what it names is called without arguments, unless it is a `Planner` already.
        domain_folder: Where a domain lies, which must not bring code of its own; if there is one.
        taken: Names that it cannot have.

    Raises:
        InvalidPlanner: If it is not found, cannot be made, is no `Planner`, or its name is taken.
    """
    if domain_folder is not None:
        admit(name, domain_folder, InvalidPlanner)
    made = load_factory(name, InvalidPlanner)
    if callable(made) and not isinstance(made, Planner):
        try:
            made = made()
        except (InvalidPlanner, KeyboardInterrupt):
            raise
        except BaseException as error:
            raise InvalidPlanner(name, f"cannot be made: {told(error)}") from error
    check_planner(made, name)
    if made.name in taken:
        raise InvalidPlanner(name, f"has the name {made.name!r}, which one of ours has; give it another")
    return made  # type: ignore[no-any-return]


def check_planner(planner: object, name: str) -> None:
    """Raise `InvalidPlanner` unless something is a planner.

    Args:
        planner: What should be one.
        name: What messages call it.
    """
    if not isinstance(planner, Planner):
        kind = type(planner).__name__
        raise InvalidPlanner(
            name, f"is no Planner but of type {kind}; return what neurosym.pddl_planner makes"
        )


def solve_checked(planner: Planner, query: Query) -> PlanResult:
    """Ask somebody's own planner, and believe of what it returns only what comes true.

    Args:
        planner: The planner.
        query: What it is asked.

    Raises:
        InvalidPlanner: If it raises an error, or returns no `PlanResult`.
    """
    try:
        # What it prints is no part of our answer, and where it goes to is not where we write.
        with redirect_stdout(StringIO()), chdir(Path.cwd()):
            result = planner.solve(query)
    except (InvalidValue, KeyboardInterrupt):
        raise
    except BaseException as error:
        raise InvalidPlanner(planner.name, f"raises an error in solve: {told(error)}") from error
    _check_result(planner.name, result)
    result = replace(result, reason=one_line(result.reason, LONGEST_REASON))
    if unknown := _unknown(result, query):
        return PlanResult(PlanStatus.FAILED, (), result.seconds, f"its plan names {unknown}")
    if result.status is PlanStatus.SOLVED and planner.reads == "operators":
        checked = validate(result.steps, query.problem, query.grounding)
        if not checked.valid:
            reason = f"its plan is not true when replayed: {checked.reason}"
            return PlanResult(PlanStatus.FAILED, (), result.seconds, reason)
    return result


def check_installed(planner: Planner) -> None:
    """Raise `PlannerMissing`, which says what to do, unless a planner is installed.

    Raises:
        InvalidPlanner: If it cannot say whether it is.
    """
    try:
        with redirect_stdout(StringIO()):
            remedy = planner.missing()
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        raise InvalidPlanner(planner.name, f"raises an error in missing: {told(error)}") from error
    if not isinstance(remedy, str):
        raise InvalidPlanner(planner.name, f"gives {remedy!r} from missing; valid: text")
    if remedy:
        raise PlannerMissing(planner.name, remedy)


def _check_result(name: str, result: object) -> None:
    """Raise `InvalidPlanner` unless something is a result, part by part."""
    if not isinstance(result, PlanResult):
        raise InvalidPlanner(name, f"gives a {type(result).__name__} from solve; valid: a PlanResult")
    is_steps = isinstance(result.steps, tuple | list) and all(
        isinstance(step, PlanStep) and isinstance(step.operator, str) and isinstance(step.object, str)
        for step in result.steps
    )
    for part, is_right, valid in (
        ("status", isinstance(result.status, PlanStatus), "a PlanStatus"),
        ("steps", is_steps, "a tuple of PlanStep"),
        ("seconds", isinstance(result.seconds, int | float) and math.isfinite(result.seconds), "a number"),
        ("reason", isinstance(result.reason, str), "text"),
    ):
        if not is_right:
            given = reprlib.repr(getattr(result, part))
            raise InvalidPlanner(name, f"gives a result with {part} = {given}; valid: {valid}")


def _unknown(result: PlanResult, query: Query) -> str:
    """Name the first operator, object or place of a plan that there is not, or return nothing."""
    grounding, names = query.grounding, query.problem.object_names
    carries = {operator.name: grounding.carries(operator) for operator in grounding.every_operator}
    places = with_places(query.problem, grounding).places if any(carries.values()) else {}
    for step in result.steps:
        if relating(step.base, grounding):
            if unknown := [name for name in (step.object, step.place) if name not in names]:
                return f"the object {shortened(unknown[0])!r}, which the problem does not have"
            continue
        if step.base not in carries:
            return f"the operator {shortened(step.operator)!r}, which the domain does not have"
        if step.object not in names:
            return f"the object {shortened(step.object)!r}, which the problem does not have"
        known = places if carries[step.base] and isinstance(places, dict) else {"": None}
        if step.place not in known and not (carries[step.base] and spot_named(step.place)):
            return f"the place {shortened(step.place)!r} for {step.operator}, which the problem does not have"
    return ""
