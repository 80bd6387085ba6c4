"""The places of a problem: those of the goals, and free ones to park on."""

import math
from collections.abc import Mapping

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.table import Table
from neurosym.tasks.footprints import near_some
from neurosym.tasks.goal_spots import goal_spots

START, GOAL, PARK = "start-", "goal-", "park-"
"""What the names of places begin with."""
GAP, LEAST_GAP = 0.05, 0.01
"""Room that is left around places to park on, for the hand; less, if else there are few [m]."""
MOST_PARKS = 8
"""Places to park on at most: who waits is carried on before long, and planners try each for each object."""
_CANDIDATES = 2000
_EDGE = 0.02  # how far inside the edge of the table places to park on lie [m]


def with_places(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with the places that its objects may be carried to, unless it has its own.

    There is one for each goal on the table, moved a little where objects would nearly touch; see
    `goal_spots`. There are as many to park on as there are objects, though eight at most, where there is
    room: none of them overlaps an object as it stands, a goal or another one, whichever object stands there,
    or at least if a small one does.

    Args:
        problem: The problem.
        grounding: The learned domain; if nothing in it carries objects to places, the problem stays as it is.
    """
    if grounding.places is None or problem.places is not msgspec.UNSET:
        return problem
    names = tuple(
        name
        for name, goal in sorted(problem.goals.items())
        if grounding.table.contains(np.array(goal))
        and abs(goal[2] - problem.object_named(name).position[2]) <= problem.tolerance
    )
    spots = goal_spots(problem, grounding.table, names)
    goals = {f"{GOAL}{name}": spots[name] for name in names}
    parks = _parks(problem, grounding.table, goals)
    found = {f"{PARK}{number:02d}": spot for number, spot in enumerate(parks, start=1)}
    return msgspec.structs.replace(problem, places={**goals, **found})


def check_place(name: str, problem: Problem, grounding: Grounding) -> None:
    """Raise an error unless a problem has a place of a name, and it lies on the table.

    Args:
        name: The name; spots say themselves where they lie.
        problem: The problem, with its places.
        grounding: The learned domain.

    Raises:
        InvalidValue: If no name is given, or it lies off the table.
        UnknownChoice: If there is none of that name.
    """
    grounding.table.check(name, *problem.place_named(name))


def _parks(
    problem: Problem, table: Table, goals: Mapping[str, tuple[float, float]]
) -> list[tuple[float, float]]:
    """Draw places to park on, the same for the same problem; smaller ones where large ones are few."""
    sizes = np.array([item.features[:2] for item in problem.objects], dtype=float)
    spots = [
        *problem.scene().positions[:, :2],
        *map(np.array, (goals.get(f"{GOAL}{name}", goal[:2]) for name, goal in problem.goals.items())),
    ]
    rooms = [*sizes, *(sizes[problem.object_names.index(name)] for name in problem.goals)]
    low, high = np.array([table.x, table.y]).T
    parks = list[tuple[float, float]]()
    drawn = np.random.default_rng(0).uniform(size=(_CANDIDATES, 2))
    largest, usual, smallest = sizes.max(0), np.median(sizes, axis=0), sizes.min(0)
    for size, gap in ((largest, GAP), (largest, LEAST_GAP), (usual, LEAST_GAP), (smallest, LEAST_GAP)):
        inside = np.minimum(size / 2 + _EDGE, (high - low) / 2)
        candidates = low + inside + drawn * (high - low - 2 * inside)
        free = ~near_some(candidates, np.array(spots), (np.array(rooms) + size) / 2 + gap)
        while free.any() and len(parks) < parks_wanted(problem):
            spot = candidates[free.argmax()]
            parks.append((round(float(spot[0]), 4), round(float(spot[1]), 4)))
            spots.append(spot)
            rooms.append(size)
            free &= ~near_some(candidates, spot[None], (size + gap)[None])
    return parks


def parks_wanted(problem: Problem) -> int:
    """Return how many places to park on a problem has where there is room."""
    return min(len(problem.objects), MOST_PARKS)


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
