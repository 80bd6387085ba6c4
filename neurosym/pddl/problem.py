"""Printing a problem as PDDL, and which names its objects may have."""

import re
from collections.abc import Sequence
from functools import lru_cache

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import STRIPS, EncodingName
from neurosym.pddl.encodings import GroundPlan, encoding_named
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.strips import page
from neurosym.pddl.strips_problem import STEPS
from neurosym.problems import Problem, SceneObject
from neurosym.spots import SPOT
from neurosym.tasks.task import understand

_PARTICULAR = r"[xy]\d*|d[xy](-?\d+)?|cost\d+|way\d+|m-[01]+[a-z]*(-.*)?"
"""What problems call cells, steps, prices, ways and motions."""
_OF_PLACES = rf"(start|goal|park)-.*|n\d+|{SPOT.pattern}"


def problem_text(
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName = STRIPS,
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
    written = encoding_named(encoding)
    for item in problem.objects:
        check_object(item, grounding)
    return written.problem(understand(problem, grounding), plans, steps).text(costs=costs)


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
