"""What can be done to one object, as vectors of counts: how often each move, in whatever order.

Displacements commute, so where an object comes to rest depends only on how often it was moved how. With k
moves there are C(d + k - 1, k - 1) vectors of d steps, and one matrix product says where all of them lead.
The order matters only for staying on the table, and is looked for afterwards.
"""

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
from jaxtyping import Bool, Float, Int

from neurosym.operators import Vector

MOST_STEPS = 20
"""How many moves of one object are counted with."""
MOST_VECTORS = 500_000
"""Lengths with more count vectors than this are not looked at."""


@dataclass(frozen=True, slots=True, eq=False)
class Choices:
    """The k moves that one object can make, where it stands, and where it may.

    Attributes:
        settled: Displacement by each move once the hand is empty again [m].
        lifted: Displacement at the end of the rise [m].
        held: Whether the object is held then.
        costs: What each move costs.
        start: Centre of the object [m].
        room: Least and greatest x and y that its centre may have [m].
        dead: Count vectors known to have no order that stays in the room.
    """

    settled: Float[np.ndarray, "k 3"]
    lifted: Float[np.ndarray, "k 3"]
    held: Bool[np.ndarray, " k"]
    costs: Int[np.ndarray, " k"]
    start: Float[np.ndarray, "3"]
    room: Float[np.ndarray, "2 2"]
    dead: set[tuple[int, ...]] = field(default_factory=set)

    def is_inside(self, positions: Float[np.ndarray, "*n 3"]) -> Bool[np.ndarray, "*n"]:
        """Say which positions are in the object's room."""
        low, high = self.room
        return np.asarray(np.all((positions[..., :2] >= low) & (positions[..., :2] <= high), axis=-1))


@dataclass(frozen=True, slots=True)
class Candidate:
    """A way to bring one object somewhere.

    Attributes:
        moves: The moves in an order that stays in the object's room.
        held: Whether the last of them is a lift without a put-down.
        cost: What they cost together.
        end: Where the object ends [m].
        miss: How far from the goal that is, if farther than allowed [m].
    """

    moves: tuple[int, ...]
    held: bool
    cost: int
    end: Vector
    miss: float = 0.0


@lru_cache(maxsize=128)
def count_vectors(kinds: int, total: int) -> Int[np.ndarray, "n k"]:
    """List all vectors of counts that sum up to a total.

    Args:
        kinds: How many moves there are.
        total: How many steps.
    """
    if kinds == 0:
        return np.zeros((int(total == 0), 0), dtype=np.int8)
    if kinds == 1:
        return np.full((1, 1), total, dtype=np.int8)
    blocks = []
    for first in range(total, -1, -1):
        rest = count_vectors(kinds - 1, total - first)
        blocks.append(np.concatenate([np.full((len(rest), 1), first, dtype=np.int8), rest], axis=1))
    return np.concatenate(blocks)


def is_countable(choices: Choices, length: int) -> bool:
    """Say whether the count vectors of a length are few enough to be looked at."""
    kinds = max(len(choices.costs), 1)
    return length <= MOST_STEPS and math.comb(length + kinds - 1, kinds - 1) <= MOST_VECTORS


def ends(choices: Choices, length: int) -> Iterator[tuple[int | None, Float[np.ndarray, "n 3"]]]:
    """List where an object can end after so many moves: at rest (None), then held by each of the lifts.

    Args:
        choices: What can be done to the object.
        length: How many moves; the vectors of the others, in order, belong to a lift.
    """
    yield None, choices.start + count_vectors(len(choices.costs), length) @ choices.settled
    if length:
        before = choices.start + count_vectors(len(choices.costs), length - 1) @ choices.settled
        for lift in np.flatnonzero(choices.held):
            yield int(lift), before + choices.lifted[lift]


def candidates(
    choices: Choices, goal: Vector, tolerance: float, *, at_rest: bool = False, deadline: float = math.inf
) -> Iterator[Candidate]:
    """List the ways to bring an object to its goal: fewest moves first, among those the cheapest first.

    Args:
        choices: What can be done to the object.
        goal: Where its centre shall come to be [m].
        tolerance: How near it must come [m].
        at_rest: Whether it may not end held.
        deadline: When to stop, by `time.perf_counter()` [s].
    """
    length = 0
    while is_countable(choices, length):
        found: list[tuple[int, int, int]] = []  # cost, lift or -1, row
        for lift, places in ends(choices, length):
            if lift is not None and at_rest:
                continue
            away = places - np.array(goal)
            rows = np.flatnonzero(np.einsum("ij,ij->i", away, away) <= tolerance**2)
            rows = rows[choices.is_inside(places[rows]) | (length == 0)]
            counts = count_vectors(len(choices.costs), length - (lift is not None))[rows]
            costs = counts @ choices.costs + (0 if lift is None else choices.costs[lift])
            found += [
                (int(cost), -1 if lift is None else lift, int(row))
                for cost, row in zip(costs, rows, strict=True)
            ]
        for _, lift, row in sorted(found):
            if time.perf_counter() > deadline:
                return
            if candidate := in_order(choices, length, row, None if lift < 0 else lift):
                yield candidate
        if time.perf_counter() > deadline:
            return
        length += 1


def nearest(
    choices: Choices,
    goal: Vector,
    *,
    depth: int,
    at_rest: bool = False,
    anywhere: bool = False,
    gain: float = 1e-9,
) -> Candidate:
    """Find how to bring an object as near to its goal as it comes.

    Args:
        choices: What can be done to the object.
        goal: Where its centre shall come to be [m].
        depth: Most moves.
        at_rest: Whether it may not end held.
        anywhere: Whether it may leave its room; the moves are in no particular order then.
        gain: How much nearer more moves must bring it to be worth it [m].
    """
    room = np.array([[-np.inf], [np.inf]]).repeat(2, axis=1) if anywhere else choices.room
    free = replace(choices, room=room, dead=set())
    x, y, z = map(float, choices.start)
    best = Candidate((), False, 0, (x, y, z), math.dist(choices.start, goal))
    for length in range(1, depth + 1):
        if not is_countable(choices, length):
            break
        for lift, places in ends(choices, length):
            if lift is not None and at_rest:
                continue
            misses = np.linalg.norm(places - np.array(goal), axis=-1)
            rows = np.flatnonzero((misses < best.miss - gain) & free.is_inside(places))
            for row in rows[np.argsort(misses[rows], kind="stable")]:
                if found := in_order(free, length, int(row), lift):
                    best = replace(found, miss=float(misses[row]))
                    break
    return best


def in_order(choices: Choices, length: int, row: int, lift: int | None) -> Candidate | None:
    """Put the moves of a count vector in an order that stays in the object's room, if there is one.

    Args:
        choices: What can be done to the object.
        length: How many moves there are, the last lift counted.
        row: Which count vector it is.
        lift: The lift that the object ends held by, if any.
    """
    counts = count_vectors(len(choices.costs), length - (lift is not None))[row]
    order = _order(choices, tuple(map(int, counts)), lift)
    if order is None:
        return None
    end = choices.start + counts @ choices.settled + (0 if lift is None else choices.lifted[lift])
    cost = int(counts @ choices.costs) + (0 if lift is None else int(choices.costs[lift]))
    x, y, z = map(float, end)
    return Candidate(order, lift is not None, cost, (x, y, z))


def _order(choices: Choices, counts: tuple[int, ...], lift: int | None) -> tuple[int, ...] | None:
    """Search backwards, depth first; the counts say where the object is, so nothing is looked at twice."""
    if lift is not None and not choices.is_inside(_place(choices, counts) + choices.lifted[lift]):
        return None
    seen: set[tuple[int, ...]] = set()
    waiting: list[tuple[tuple[int, ...], tuple[int, ...]]] = [(counts, () if lift is None else (lift,))]
    while waiting:
        done, then = waiting.pop()
        if not any(done):
            return then
        if done in seen or done in choices.dead:
            continue
        seen.add(done)
        here = _place(choices, done)
        if choices.is_inside(here):
            possible = choices.is_inside(here - choices.settled + choices.lifted)
            for move in np.flatnonzero(possible & (np.array(done) > 0)).tolist():
                waiting.append(((*done[:move], done[move] - 1, *done[move + 1 :]), (move, *then)))
    choices.dead.update(seen)
    return None


def _place(choices: Choices, counts: tuple[int, ...]) -> Float[np.ndarray, "3"]:
    """Return where the object is after so many of each move [m]."""
    return np.asarray(choices.start + np.array(counts) @ choices.settled)
