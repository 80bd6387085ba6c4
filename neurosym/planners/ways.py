"""The way of one object among the footprints of others: A* over where it can come to rest.

Places are exact; of those in one small cell only the cheapest is gone on from.
"""

import heapq
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import NamedTuple

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.planners.cost_to_go import CostToGo
from neurosym.planners.count_vectors import Choices
from neurosym.planners.effort import Effort

WORK_A_WAY = 2_000
"""How many places are looked at for one way; where it takes more, another order is tried."""
SAME = 0.005
"""Edge of a cell of which only one place is looked at [m]."""

IsEnd = Callable[[Float[np.ndarray, "3"]], bool]
"""Says whether an object may end at rest in a place."""


@dataclass(frozen=True, slots=True)
class Way:
    """A way of one object: its moves, whether it ends held, and where it rests after each move [m]."""

    moves: tuple[int, ...]
    held: bool
    places: tuple[tuple[float, ...], ...]


class HeldEnd(NamedTuple):
    """Where an object may end held: how near to which place [m]."""

    place: Float[np.ndarray, "3"]
    tolerance: float


def cheapest_way(
    choices: Choices,
    start: Float[np.ndarray, "3"],
    in_the_way: tuple[Float[np.ndarray, "m 2"], Float[np.ndarray, "m 2"]],
    is_end: IsEnd,
    far: CostToGo,
    effort: Effort,
    held_end: HeldEnd | None = None,
) -> Way | None:
    """Search for the cheapest way of an object to an end; None if none is found with the work there is.

    Args:
        choices: What can be done to the object.
        start: Where it rests [m].
        in_the_way: Where others rest, and how far its centre must be from theirs along x or y [m].
        is_end: Says where it may end at rest.
        far: What it costs to go on from a place.
        effort: What may be spent.
        held_end: Where it may end held, if it may.
    """
    ticket, budget, (spots, apart) = count(), WORK_A_WAY, in_the_way
    lifts, costs = np.flatnonzero(choices.held), choices.costs.tolist()
    places, came = [start.tolist()], [(-1, -1)]  # where each node is; the node before it, and the move
    cheapest = {_cell(places[0]): 0}
    waiting = [(far(places[0]), 0, next(ticket), 0)]
    while waiting and budget and effort.spend():
        budget -= 1
        _, owed, _, node = heapq.heappop(waiting)
        spent = -owed
        if spent > cheapest[_cell(places[node])]:
            continue
        at = np.array(places[node])
        if is_end(at):
            return _traced(node, came, places)
        lifted, settled = at + choices.lifted, at + choices.settled
        possible = choices.is_inside(lifted)
        if held_end is not None and len(lifts):
            misses = np.linalg.norm(lifted[lifts] - held_end.place, axis=1)
            good = lifts[(misses <= held_end.tolerance) & possible[lifts]]
            if len(good):
                return _traced(node, came, places, int(good[np.argmin(choices.costs[good])]))
        possible &= choices.is_inside(settled) & ~_overlaps(settled[:, :2], spots, apart)
        moves = np.flatnonzero(possible)
        for move, place in zip(moves.tolist(), settled[moves].tolist(), strict=True):
            sum_of_costs, cell = spent + costs[move], _cell(place)
            if sum_of_costs < cheapest.get(cell, sum_of_costs + 1):
                cheapest[cell] = sum_of_costs
                estimate = sum_of_costs + far(place)  # of equal ones, the one that has come farthest
                heapq.heappush(waiting, (estimate, -sum_of_costs, next(ticket), len(places)))
                places.append(place)
                came.append((node, move))
    return None


def _cell(place: Sequence[float]) -> tuple[int, int]:
    return math.floor(place[0] / SAME + 0.5), math.floor(place[1] / SAME + 0.5)


def _traced(
    node: int, came: list[tuple[int, int]], places: list[list[float]], lift: int | None = None
) -> Way:
    """Follow a node back to the start, and end with a lift if there is one."""
    moves = [] if lift is None else [lift]
    rests: list[tuple[float, ...]] = []
    while node >= 0:
        rests.append(tuple(places[node]))
        node, move = came[node]
        moves += [move] if node >= 0 else []
    return Way(tuple(moves[::-1]), lift is not None, tuple(rests[::-1]))


def _overlaps(
    spots: Float[np.ndarray, "k 2"], others: Float[np.ndarray, "m 2"], apart: Float[np.ndarray, "m 2"]
) -> Bool[np.ndarray, " k"]:
    """Say which spots an object would stand in others at."""
    near = np.abs(spots[:, None] - others) < apart
    return np.asarray((near[..., 0] & near[..., 1]).any(axis=-1))
