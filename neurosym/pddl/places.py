"""The places of a problem: those of the goals, and free ones to park on."""

import math
from itertools import product

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.table import Table

GOAL, PARK = "goal-", "park-"
"""What the names of places begin with."""
GAPS = (0.05, 0.01)
"""Room that is left around places to park on, for the hand; less, if else there are few [m]."""
MOST_PARKS = 8
"""Places to park on at most: who waits is carried on before long, and planners try each for each object."""
_CANDIDATES = 2000
_EDGE = 0.02  # how far inside the edge of the table places to park on lie [m]


def with_places(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with the places that its objects may be carried to, unless it has its own.

    There is one for each goal on the table, and as many to park on as there are objects, though eight at
    most, where there is room: none of them overlaps an object as it stands, a goal or another one, whichever
    object stands there.

    Args:
        problem: The problem.
        grounding: The learned domain; if nothing in it carries objects to places, the problem stays as it is.
    """
    if grounding.places is None or problem.places is not msgspec.UNSET:
        return problem
    goals = {
        f"{GOAL}{name}": (x, y)
        for name, (x, y, z) in sorted(problem.goals.items())
        if grounding.table.contains(np.array([x, y, z]))
        and abs(z - problem.object_named(name).position[2]) <= problem.tolerance
    }
    parks = _parks(problem, grounding.table)
    found = {f"{PARK}{number:02d}": spot for number, spot in enumerate(parks, start=1)}
    return msgspec.structs.replace(problem, places={**goals, **found})


def _parks(problem: Problem, table: Table) -> list[tuple[float, float]]:
    """Draw places to park on, the same for the same problem."""
    sizes = np.array([item.features[:2] for item in problem.objects], dtype=float)
    spots = [*problem.scene().positions[:, :2], *(goal[:2] for goal in problem.goals.values())]
    rooms = [*sizes, *(sizes[problem.object_names.index(name)] for name in problem.goals)]
    largest = sizes.max(0)
    low, high = np.array([table.x, table.y]).T
    inside = np.minimum(largest / 2 + _EDGE, (high - low) / 2)
    parks = list[tuple[float, float]]()
    candidates = np.random.default_rng(0).uniform(low + inside, high - inside, (_CANDIDATES, 2))
    for gap, spot in product(GAPS, candidates):
        if len(parks) == min(len(problem.objects), MOST_PARKS):
            break
        if _is_free(spot, np.array(spots), (np.array(rooms) + largest) / 2 + gap):
            parks.append((round(float(spot[0]), 4), round(float(spot[1]), 4)))
            spots.append(spot)
            rooms.append(largest)
    return parks


def _is_free(
    spot: Float[np.ndarray, "2"], others: Float[np.ndarray, "N 2"], apart: Float[np.ndarray, "N 2"]
) -> bool:
    return not bool(np.any(np.all(np.abs(others - spot) < apart, axis=1)))


def blockers(
    name: str, spot: tuple[float, float], problem: Problem, apart: Float[np.ndarray, "M M 2"]
) -> tuple[str, ...]:
    """Name the other objects that stand where an object would come to stand.

    Args:
        name: The object.
        spot: Where its centre would be [m].
        problem: The problem, with the objects as they stand now.
        apart: How far apart two objects must be; see `footprints_apart`.
    """
    row = problem.object_names.index(name)
    here = problem.scene().positions[:, :2]
    over = np.all(np.abs(here - np.array(spot)) < apart[row], axis=1)
    return tuple(
        other for other, is_over in zip(problem.object_names, over, strict=True) if is_over and other != name
    )


def is_at(name: str, spot: tuple[float, float], problem: Problem) -> bool:
    """Say whether an object with a goal would be at it with its centre over a spot of the table.

    Args:
        name: The object.
        spot: Where its centre would be [m].
        problem: The problem.
    """
    x, y, z = problem.goals[name]
    return math.dist((*spot, problem.object_named(name).position[2]), (x, y, z)) <= problem.tolerance
