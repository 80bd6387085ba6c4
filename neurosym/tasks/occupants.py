"""Which objects may be carried to which place, such that no two that stand at places stand in each other.

An object may be carried to its goal. It may also wait on a place to park on, and where there are too few of
these, on the goal of another. For that it must have room whatever stands at the other places.
"""

from collections.abc import Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.problems import ROUNDED, Problem
from neurosym.tasks.places import PARK, is_at, parks_wanted


def occupants(problem: Problem, carried: Sequence[str]) -> dict[str, tuple[str, ...]]:
    """Return the objects that may be carried to each place.

    Args:
        problem: The problem, with its places.
        carried: The objects that can be carried.
    """
    assert isinstance(problem.places, dict), "with_places gives them"
    names, spots = list(problem.places), np.array([*problem.places.values()], dtype=float)
    sizes = {name: _size(problem, name) for name in problem.object_names}
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
            if thing not in found[name] and not _overlaps(spots[row], spots[others], apart):
                found[name].append(thing)
                rooms[row] = np.maximum(rooms[row], sizes[thing])
    return {name: tuple(sorted(things)) for name, things in found.items()}


def _owners(place: str, problem: Problem) -> tuple[str, ...]:
    """Name the objects whose goal is met at a place that is none to park on."""
    if place.startswith(PARK):
        return ()
    return tuple(name for name in problem.goals if is_at(name, problem.place_named(place), problem))


def _size(problem: Problem, name: str) -> Float[np.ndarray, "2"]:
    return np.array(problem.object_named(name).features[:2], dtype=float)


def _overlaps(
    spot: Float[np.ndarray, "2"], others: Float[np.ndarray, "N 2"], apart: Float[np.ndarray, "N 2"]
) -> bool:
    return bool(np.any(np.all(np.abs(others - spot) < apart, axis=1)))
