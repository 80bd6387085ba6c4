"""What can be done to one object, as vectors of counts: how often each move, in whatever order.

Displacements commute, so where an object comes to rest depends only on how often it was moved how. With k
moves there are C(d + k - 1, k - 1) vectors of d steps, and where they lead follows from those of d - 1 steps.
The order matters only for staying on the table, and is looked for afterwards.

There are ever more vectors, so looking ends somewhere: `looked_at` says where.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from neurosym.arrays import Bool, Float, Int
from neurosym.operators import Vector
from neurosym.planners.effort import Effort

MOST_STEPS = 60
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
        (x_low, y_low), (x_high, y_high) = self.room
        x, y = positions[..., 0], positions[..., 1]
        return np.asarray((x >= x_low) & (x <= x_high) & (y >= y_low) & (y <= y_high))

    def ending_with(self, lift: int) -> "Choices":
        """Return the choices of an object that a lift has left where it leads, and that is lifted no more."""
        return replace(self, start=self.start + self.lifted[lift], held=np.zeros_like(self.held), dead=set())


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


@dataclass(frozen=True, slots=True, eq=False)
class _Ends:
    """Where an object can end after so many moves.

    Attributes:
        length: How many moves.
        lift: The lift that it ends held by, which comes last; None if it ends at rest.
        places: The ends, one for each count vector of the other moves [m].
        costs: What it costs to get there.
    """

    length: int
    lift: int | None
    places: Float[np.ndarray, "n 3"]
    costs: Int[np.ndarray, " n"]


def looked_at(choices: Choices, depth: int = MOST_STEPS) -> tuple[int, int]:
    """Say up to how many moves of an object are looked at, and how many count vectors that are."""
    kinds = len(choices.costs)
    if kinds == 0:
        return depth, 1
    steps = next(length for length in range(depth, -1, -1) if _vectors(kinds, length) <= MOST_VECTORS)
    return steps, math.comb(steps + kinds, kinds)


def _vectors(kinds: int, length: int) -> int:
    return math.comb(length + kinds - 1, length)


@lru_cache(maxsize=256)
def _level(kinds: int, length: int) -> tuple[Int[np.ndarray, " n"], Int[np.ndarray, " n"]]:
    """List the count vectors of a length: which of the length before they continue, and by which move.

    Moves are numbered such that none is followed by a lesser one, so each vector is there once.
    """
    before = _level(kinds, length - 1)[1] if length > 1 else np.zeros(1, dtype=np.int32)
    widths = kinds - before
    parents = np.repeat(np.arange(len(before), dtype=np.int32), widths)
    first = np.repeat(np.cumsum(widths) - widths - before, widths)
    return parents, np.arange(len(parents), dtype=np.int32) - first.astype(np.int32)


def count_vector(kinds: int, length: int, row: int) -> Int[np.ndarray, " k"]:
    """Return a count vector by its row.

    Args:
        kinds: How many moves there are.
        length: How many of them are made.
        row: Which of the vectors of that length it is.
    """
    counts = np.zeros(kinds, dtype=int)
    for shorter in range(length, 0, -1):
        parents, moves = _level(kinds, shorter)
        counts[moves[row]] += 1
        row = int(parents[row])
    return counts


def _ends(choices: Choices, depth: int) -> Iterator[tuple[_Ends, ...]]:
    """List where an object can end after 0, 1, 2 and more moves: at rest, then held by each of the lifts."""
    now = _Ends(0, None, choices.start[None], np.zeros(1, dtype=int))
    yield (now,)
    kinds = len(choices.costs)
    for length in range(1, looked_at(choices, depth)[0] + 1 if kinds else 1):
        before = now
        parents, moves = _level(kinds, length)
        places = before.places[parents] + choices.settled[moves]
        now = _Ends(length, None, places, before.costs[parents] + choices.costs[moves])
        lifts = np.flatnonzero(choices.held).tolist()
        held = (
            _Ends(length, lift, before.places + choices.lifted[lift], before.costs + choices.costs[lift])
            for lift in lifts
        )
        yield (now, *held)


def candidates(
    choices: Choices,
    goal: Vector,
    tolerance: float,
    effort: Effort,
    *,
    at_rest: bool = False,
    moves: int = MOST_STEPS,
    cost: float = math.inf,
) -> Iterator[Candidate]:
    """List the ways to bring an object to its goal: fewest moves first, among those the cheapest first.

    The list ends where `looked_at` says, or with the budget of work.

    Args:
        choices: What can be done to the object.
        goal: Where its centre shall come to be [m].
        tolerance: How near it must come [m].
        effort: What may be spent; dearer ways are looked at, too.
        at_rest: Whether it may not end held.
        moves: How many moves ways have at most.
        cost: What they cost at most.

    Raises:
        TimeIsUp: If the deadline passes.
    """
    for ends in _ends(choices, min(moves, MOST_STEPS)):
        effort.spend(0)
        found: list[tuple[int, int, int]] = []  # cost, lift or -1, row
        for end in ends:
            if end.lift is not None and at_rest:
                continue
            away = end.places - np.array(goal)
            rows = np.flatnonzero(np.einsum("ij,ij->i", away, away) <= tolerance**2)
            rows = rows[choices.is_inside(end.places[rows]) | (end.length == 0)]
            lift = -1 if end.lift is None else end.lift
            found += [(int(end.costs[row]), lift, int(row)) for row in rows]
        for one_cost, lift, row in sorted(found):
            if not effort.spend():
                return
            if one_cost > cost:
                continue
            if candidate := _in_order(choices, ends[0].length, row, None if lift < 0 else lift):
                yield candidate


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
        depth: Most moves; fewer are looked at if `looked_at` says so.
        at_rest: Whether it may not end held.
        anywhere: Whether it may leave its room; the moves are in no particular order then.
        gain: How much nearer more moves must bring it to be worth it [m].
    """
    room = np.array([[-np.inf], [np.inf]]).repeat(2, axis=1) if anywhere else choices.room
    free = replace(choices, room=room, dead=set())
    x, y, z = map(float, choices.start)
    best = Candidate((), False, 0, (x, y, z), math.dist(choices.start, goal))
    for ends in _ends(choices, depth):
        for end in ends:
            if end.length == 0 or (end.lift is not None and at_rest):
                continue
            misses = np.linalg.norm(end.places - np.array(goal), axis=-1)
            rows = np.flatnonzero((misses < best.miss - gain) & free.is_inside(end.places))
            for row in rows[np.argsort(misses[rows], kind="stable")]:
                if found := _in_order(free, end.length, int(row), end.lift):
                    best = replace(found, miss=float(misses[row]))
                    break
    return best


def _in_order(choices: Choices, length: int, row: int, lift: int | None) -> Candidate | None:
    """Put the moves of a count vector in an order that stays in the object's room, if there is one.

    Args:
        choices: What can be done to the object.
        length: How many moves there are, the last lift counted.
        row: Which count vector it is.
        lift: The lift that the object ends held by, if any.
    """
    counts = count_vector(len(choices.costs), length - (lift is not None), row)
    order = _order(choices, tuple(counts.tolist()), lift)
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
