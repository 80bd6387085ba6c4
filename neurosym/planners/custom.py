"""Planners of your own: `module:factory` names what makes one, and what it returns is checked."""

from collections.abc import Container
from pathlib import Path

from neurosym.errors import InvalidPlanner, InvalidValue
from neurosym.factories import admit, load_factory, told
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.validation import validate
from neurosym.planners.planner import Planner, Query
from neurosym.planners.result import PlanResult, PlanStatus


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
        except (Exception, SystemExit) as error:
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
        result = planner.solve(query)
    except InvalidValue:
        raise
    except (Exception, SystemExit) as error:
        raise InvalidPlanner(planner.name, f"raises an error in solve: {told(error)}") from error
    if not isinstance(result, PlanResult) or not all(isinstance(step, PlanStep) for step in result.steps):
        raise InvalidPlanner(planner.name, f"gives a {type(result).__name__} from solve; valid: a PlanResult")
    if result.status is PlanStatus.SOLVED and planner.reads == "operators":
        checked = validate(result.steps, query.problem, query.grounding)
        if not checked.valid:
            reason = f"its plan is not true when replayed: {checked.reason}"
            return PlanResult(PlanStatus.FAILED, (), result.seconds, reason)
    return result
