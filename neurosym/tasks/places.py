"""The places of a problem: those of the goals, and free ones to park on; and which objects may stand there.

A goal is met by whatever lies within its tolerance. Where objects would nearly touch at their goals, they are
carried a little beside them, so that the hand has room. An object may be carried to its goal. It may also
wait on a place to park on, and where there are too few of these, on the goal of another. For that it must
have room whatever stands at the other places: no two that stand at places stand in each other.
"""

import math
from collections.abc import Mapping, Sequence
from itertools import combinations

import msgspec
import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.grounding import Grounding
from neurosym.problems import ROUNDED, Problem
from neurosym.table import Table
from neurosym.tasks.footprints import near_some, overlapping

START, GOAL, PARK = "start-", "goal-", "park-"
"""What the names of places begin with."""
ROOM = (0.02, 0.05)
"""Room along x and y that is made between objects at their goals, if these allow it [m].

The fingers of the hand open along y, so there they need more.
"""
SHARE = 0.5
"""How far beside its goal an object may be set down by choice, as a share of the tolerance."""
GAP, LEAST_GAP = 0.05, 0.01
"""Room that is left around places to park on, for the hand; less, if else there are few [m]."""
MOST_PARKS = 8
"""Places to park on at most: who waits is carried on before long, and planners try each for each object."""
_CANDIDATES = 2000
_EDGE = 0.02  # how far inside the edge of the table places to park on lie [m]
_ROUNDS = 200
_DIGITS = 4


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
    if grounding.places is None or problem.places:
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
    over = overlapping(np.array(spot), here, apart[row])
    return tuple(
        other for other, is_over in zip(problem.object_names, over, strict=True) if is_over and other != name
    )


def is_at(name: str, spot: tuple[float, float], problem: Problem) -> bool:
    """Say whether an object with a goal would be at it with its centre over a spot of the table [m]."""
    x, y, z = problem.goals[name]
    return math.dist((*spot, problem.object_named(name).position[2]), (x, y, z)) <= problem.tolerance


def goal_spots(problem: Problem, table: Table, names: tuple[str, ...]) -> dict[str, tuple[float, float]]:
    """Return where on the table each object is to be carried, at most half the tolerance beside its goal [m].

    What stands at its goal already, or has none, stays where it is, and the others keep away from it.

    Args:
        problem: The problem, with the objects as they stand now.
        table: Where objects may be set down.
        names: Objects with goals on the table.
    """
    if not names:
        return {}
    here = problem.scene().positions
    unmet = problem.unmet
    stays = [name not in unmet for name in problem.object_names]
    chosen = [row for row, name in enumerate(problem.object_names) if stays[row] or name in names]
    moves = np.array([not stays[row] for row in chosen], dtype=bool)  # (M,)
    goals = np.array(
        [here[row, :2] if stays[row] else problem.goals[problem.object_names[row]][:2] for row in chosen]
    )
    halves = np.array([problem.objects[row].features[:2] for row in chosen], dtype=float) / 2  # (M, 2)
    spots = _apart(goals, halves, moves, SHARE * problem.tolerance, table)
    found = {problem.object_names[row]: spot for row, spot in zip(chosen, spots.tolist(), strict=True)}
    return {name: (round(found[name][0], _DIGITS), round(found[name][1], _DIGITS)) for name in names}


def _apart(
    goals: Float[np.ndarray, "M 2"],
    halves: Float[np.ndarray, "M 2"],
    moves: Bool[np.ndarray, " M"],
    most: float,
    table: Table,
) -> Float[np.ndarray, "M 2"]:
    """Push boxes apart with less than `ROOM` between them, step by step, none too far from its goal."""
    low, high = np.array([table.x, table.y]).T
    pairs = [pair for pair in combinations(range(len(goals)), 2) if moves[[*pair]].any()]
    ones, others = np.array(pairs, dtype=int).reshape(-1, 2).T
    room = halves[ones] + halves[others]
    spots = goals.copy()
    for _ in range(_ROUNDS):
        push = np.zeros_like(spots)
        away = spots[others] - spots[ones]  # (pairs, 2)
        over = room - np.abs(away)
        lacking = over + np.array(ROOM)
        for number in np.flatnonzero((lacking > 0).all(1)):
            one, other = pairs[number]
            axis = int(over[number].argmin())
            step = np.sign(away[number, axis] or 1.0) * lacking[number, axis] / (moves[one] + moves[other])
            push[one, axis] -= step * moves[one]
            push[other, axis] += step * moves[other]
        if not push.any():
            break
        beside = spots + push / 2 - goals
        beside *= np.minimum(1.0, most / np.maximum(np.linalg.norm(beside, axis=1), 1e-12))[:, None]
        inside = np.clip(goals + beside, np.minimum(low, goals), np.maximum(high, goals))
        before, spots = spots, np.where(moves[:, None], inside, goals)
        if np.array_equal(before, spots):  # and so it would stay
            break
    return spots


def occupants(problem: Problem, carried: Sequence[str]) -> dict[str, tuple[str, ...]]:
    """Return which of the objects that can be carried may be carried to each place of a problem."""
    names, spots = list(problem.places), np.array([*problem.places.values()], dtype=float)
    sizes = {item.name: np.array(item.features[:2], dtype=float) for item in problem.objects}
    smallest = np.min([*sizes.values()], axis=0)
    owners = {name: _owners(name, problem) for name in names}
    rooms = np.array(  # (P, 2), what stands at each place at most [m]
        [np.max([smallest, *(sizes[one] for one in owners[name])], axis=0) for name in names]
    )
    found = {name: [one for one in carried if one in owners[name]] for name in names}
    parks = [name for name in names if name.startswith(PARK)]
    to_wait = parks if len(parks) >= parks_wanted(problem) else [*parks, *(set(names) - set(parks))]
    for name in sorted(to_wait, key=names.index):
        row = names.index(name)
        others = np.arange(len(names)) != row
        for thing in sorted(carried, key=lambda one: (tuple(sizes[one]), one)):
            apart = (sizes[thing] + rooms[others]) / 2 - ROUNDED
            if thing not in found[name] and not overlapping(spots[row], spots[others], apart).any():
                found[name].append(thing)
                rooms[row] = np.maximum(rooms[row], sizes[thing])
    return {name: tuple(sorted(things)) for name, things in found.items()}


def _owners(place: str, problem: Problem) -> tuple[str, ...]:
    """Name the objects whose goal is met at a place that is none to park on."""
    if place.startswith(PARK):
        return ()
    return tuple(name for name in problem.goals if is_at(name, problem.place_named(place), problem))
