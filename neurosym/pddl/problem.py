"""Printing a problem as PDDL, and which names its objects may have."""

import re
from collections.abc import Sequence
from functools import lru_cache

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.domain import check_encoding
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.ground_plan import GroundPlan
from neurosym.pddl.moves import NUMERIC, STRIPS, Encoding
from neurosym.pddl.numeric import STEPS as NUMERIC_STEPS
from neurosym.pddl.numeric import numeric_problem
from neurosym.pddl.strips import page
from neurosym.pddl.strips_problem import STEPS, StripsProblem
from neurosym.problems import Problem, SceneObject
from neurosym.spots import SPOT
from neurosym.tasks.task import Task, understand

_PARTICULAR = r"[xy]\d*|d[xy](-?\d+)?|cost\d+|way\d+|m-[01]+[a-z]*(-.*)?"
"""What problems call cells, steps, prices, ways and motions."""
_OF_PLACES = rf"(start|goal|park)-.*|n\d+|{SPOT.pattern}"


def problem_text(
    problem: Problem,
    grounding: Grounding,
    encoding: Encoding = STRIPS,
    *,
    steps: int = STEPS,
    plans: Sequence[GroundPlan] = (),
    costs: bool = True,
) -> str:
    """Print a problem.

    Args:
        problem: The problem.
        grounding: The learned domain.
        encoding: The encoding of the domain it is for.
        steps: How many steps the rounding of is taken off the goal regions; in numbers ten times as many.
        plans: Plans that the replay takes, and that stand beside the problem: it is printed such that they
            are its plans.
        costs: Whether what steps cost is printed; some planners take no costs.

    Raises:
        InvalidValue: If an object stands off the table, its name means something else in the domain, or the
            domain knows nothing of relations and the problem asks for some.
        UnknownChoice: If an object is of a category that the domain does not have, or there is no such
            encoding.
    """
    check_encoding(encoding)
    for item in problem.objects:
        check_object(item, grounding)
    task = understand(problem, grounding)
    if encoding == NUMERIC:
        return numeric_problem(task, steps=steps * NUMERIC_STEPS).text(costs=costs)
    return strips_text(task, plans, steps=steps, costs=costs)


def strips_text(
    task: Task, plans: Sequence[GroundPlan] = (), *, steps: int = STEPS, costs: bool = True
) -> str:
    """Print a task for the page; see `problem_text`."""
    led = {name for plan in plans for name in plan.led}
    printed = StripsProblem(
        task,
        led=[name for name in task.names if name in led or name in task.led],
        kept=[move for plan in plans for move in plan.moves],
        steps=steps,
    )
    facts = [fact for plan in plans for fact in plan.facts]
    spots = sorted({spot for plan in plans for spot in plan.spots})
    return printed.data(sorted(facts), spots).text(costs=costs)


def check_object(item: SceneObject, grounding: Grounding) -> None:
    """Raise `InvalidValue` unless an object stands on the table and its name is free in the domain."""
    grounding.category(item.category)
    check_on_table(item, grounding)
    by_name = grounding.places or grounding.relations
    if is_taken(item.name, grounding) or (by_name and re.fullmatch(_OF_PLACES, item.name)):
        raise InvalidValue(f"No object can be called {item.name}, the domain uses that; try item-01.")


def is_taken(name: str, grounding: Grounding) -> bool:
    """Say whether the domain itself uses a name, so that no object or place of a problem can have it."""
    return name in _words(grounding) or bool(re.fullmatch(_PARTICULAR, name))


@lru_cache(maxsize=8)
def _words(grounding: Grounding) -> frozenset[str]:
    """List what the page calls its types, actions and constants."""
    domain = page(grounding)
    names = [name for name, _ in (*domain.types, *domain.constants)]
    return frozenset(["object", *names, *(action.name for action in domain.actions)])
