"""The exact planner: the fewest steps there can be, by counting instead of searching.

Displacements commute, so where an object comes to rest depends only on how often each move was made. With k
moves there are C(d + k - 1, k - 1) vectors of d counts, and where they lead follows from those of d - 1. The
order matters only for staying on the table, and is looked for afterwards. There are ever more vectors, so
looking ends somewhere: `looked_at` says where.

The shortest ways of each object are listed so, and joined by conflict-based search: objects that would end in
each other, or in one that stands there, get their next way; at most one ends held, and comes last. The first
join whose steps have an order that works has provably the fewest primitives, and costs the least among those.
"""

import heapq
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import count, islice

import numpy as np

from neurosym.checks import Bool, Float, Int
from neurosym.errors import in_millimetres
from neurosym.grounding import Grounding
from neurosym.operators import Vector
from neurosym.planners.bfs import Branching, branching_of
from neurosym.planners.plan_order import mend
from neurosym.planners.planner import PLACE, Effort, PlanResult, PlanStatus, within
from neurosym.problems import Problem
from neurosym.tasks.options import PUT_DOWN, step_cost
from neurosym.tasks.promises import promised
from neurosym.tasks.task import footprints_apart, overlapping
from neurosym.tasks.transition import PlanStep

MOST_STEPS = 60
"""How many moves of one object are counted with."""
MOST_VECTORS = 500_000
"""Lengths with more count vectors than this are not looked at."""
MOST_WORK = 200_000
"""How many candidates, ways to join them and beginnings of plans are looked at; some tens of seconds."""
DEPTH = 8
"""How many primitives with an object are looked at for how near it can come."""
GAIN = 0.005
"""How much nearer to a goal out of reach more primitives must bring an object to be done [m]."""


def plan_counting(
    problem: Problem, grounding: Grounding, *, time_limit: float = math.inf, work: int = MOST_WORK
) -> PlanResult:
    """Find a plan with the fewest primitives, and among those the cheapest.

    Args:
        problem: The problem.
        grounding: The learned domain.
        time_limit: The user's ceiling [s].
        work: How much is looked at.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    return within(time_limit, lambda deadline: _joined(_Join(problem, grounding, Effort(work, deadline))))


def plan_nearest(problem: Problem, grounding: Grounding, *, time_limit: float = math.inf) -> PlanResult:
    """Plan to the goals, where they can be reached, and else as near to them as objects come.

    Args:
        problem: The problem.
        grounding: The learned domain.
        time_limit: The user's ceiling [s].

    Returns:
        A plan that is solved, or nearest and says how far objects stay from their goals.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """

    def search(deadline: float) -> PlanResult:
        found = _joined(_Join(problem, grounding, Effort(MOST_WORK, deadline), goes_near=True))
        reason = found.reason if found.has_plan else f"no plan to the nearest point: {found.reason}"
        return replace(found, reason=reason)

    return within(time_limit, search)


def fewest_steps(problem: Problem, grounding: Grounding) -> int | None:
    """Return the fewest primitives that can solve a problem, put-downs not counted; None if none are found.

    Each object stays on the table, and at most one ends held. No plan that replays well has fewer; where
    objects stand in each other's way it may need more.

    Args:
        problem: The problem.
        grounding: The learned domain.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    join = _Join(problem, grounding, Effort(MOST_WORK))
    saved, total, must_be_held = [0], 0, 0
    for name in problem.goals:
        free, resting = join.candidate(name, False, 0), join.candidate(name, True, 0)
        if free is None:
            return None
        if resting is None:
            must_be_held += 1
        else:
            saved.append(len(resting.moves) - len(free.moves))
        total += len((resting or free).moves)
    if must_be_held > 1:
        return None
    return total - (0 if must_be_held else max(saved))


def _joined(join: "_Join") -> PlanResult:
    """Return the first join whose steps have an order that works, be it only to the nearest points."""
    for steps in join.plans():
        ordered, checked = mend(steps, join.problem, join.grounding, join.effort)
        if checked.valid or (join.goes_near and checked.possible):
            status = PlanStatus.SOLVED if checked.valid else PlanStatus.NEAREST
            reason = "" if checked.valid else _misses(join.problem, checked.positions[-1])
            return PlanResult(status, ordered, 0.0, reason, work=PLACE * join.effort.spent)
        join.missed = checked.reason
    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, join.why_none(), work=PLACE * join.effort.spent)


def _misses(problem: Problem, ends: Float[np.ndarray, "M 3"]) -> str:
    allowed = problem.tolerance
    misses = problem.distances(ends).items()
    far = [f"{name} {in_millimetres(miss, allowed)}" for name, miss in misses if miss > allowed]
    goals = "its goal" if len(far) == 1 else "their goals"
    return f"at the end, {' and '.join(far)} from {goals}; up to {DEPTH} primitives with each were looked at"


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
        operators: Name of the operator of each move.
        dead: Count vectors known to have no order that stays in the room.
    """

    settled: Float[np.ndarray, "k 3"]
    lifted: Float[np.ndarray, "k 3"]
    held: Bool[np.ndarray, " k"]
    costs: Int[np.ndarray, " k"]
    start: Float[np.ndarray, "3"]
    room: Float[np.ndarray, "2 2"]
    operators: tuple[str, ...] = ()
    dead: set[tuple[int, ...]] = field(default_factory=set)

    def is_inside(self, positions: Float[np.ndarray, "*n 3"]) -> Bool[np.ndarray, "*n"]:
        """Say which positions are in the object's room."""
        (x_low, y_low), (x_high, y_high) = self.room
        x, y = positions[..., 0], positions[..., 1]
        return np.asarray((x >= x_low) & (x <= x_high) & (y >= y_low) & (y <= y_high))

    def steps(self, name: str, moves: Sequence[int], *, held: bool) -> tuple[PlanStep, ...]:
        """Write moves of an object as steps, each lift with its put-down unless it ends held."""
        steps: list[PlanStep] = []
        for move in moves:
            steps.append(PlanStep(self.operators[move], name))
            if self.held[move]:
                steps.append(PlanStep(PUT_DOWN + self.operators[move], name))
        return tuple(steps[:-1] if held else steps)

    def ending_with(self, lift: int) -> "Choices":
        """Return the choices of an object that a lift has left where it leads, and that is lifted no more."""
        return replace(self, start=self.start + self.lifted[lift], held=np.zeros_like(self.held), dead=set())


def choices_of(
    problem: Problem, grounding: Grounding, branching: Branching | None = None
) -> tuple[Choices, ...]:
    """Return what can be done to each object.

    Args:
        problem: The problem.
        grounding: The learned domain, for what steps cost and where the table ends.
        branching: What each choice does to each object; what the live operators promise, if not given.
    """
    branching = branching or branching_of(problem, grounding)
    room, found = problem.room(grounding.table), []
    for index, item in enumerate(problem.objects):
        used, promises = branching.usable(index), promised(grounding, item, problem.tolerance)
        operators = tuple(branching.names[index][column] for column in used)
        found.append(
            Choices(
                settled=branching.settled[index, used],
                lifted=branching.effects[index, used],
                held=branching.held[index, used],
                costs=np.array([step_cost(promises[one], grounding) for one in operators], dtype=int),
                start=np.array(item.position),
                room=room[:, index],
                operators=operators,
            )
        )
    return tuple(found)


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


def _count_vector(kinds: int, length: int, row: int) -> Int[np.ndarray, " k"]:
    """Return a count vector of a length by its row in `_level`."""
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
    at_rest: bool = False,
    anywhere: bool = False,
    gain: float = 1e-9,
) -> Candidate:
    """Find how to bring an object as near to its goal as it comes, with up to `DEPTH` moves.

    Args:
        choices: What can be done to the object.
        goal: Where its centre shall come to be [m].
        at_rest: Whether it may not end held.
        anywhere: Whether it may leave its room; the moves are in no particular order then.
        gain: How much nearer more moves must bring it to be worth it [m].
    """
    room = np.array([[-np.inf], [np.inf]]).repeat(2, axis=1) if anywhere else choices.room
    free = replace(choices, room=room, dead=set())
    x, y, z = map(float, choices.start)
    best = Candidate((), False, 0, (x, y, z), math.dist(choices.start, goal))
    for ends in _ends(choices, DEPTH):
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
    """Put so many moves, the last lift counted, in an order that stays in the room, if there is one."""
    counts = _count_vector(len(choices.costs), length - (lift is not None), row)
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


class _Listed:
    """Candidates that are made as they are asked for."""

    def __init__(self, source: Iterator[Candidate]):
        self._source, self._known = source, list[Candidate]()

    def at(self, index: int) -> Candidate | None:
        self._known += islice(self._source, max(0, index + 1 - len(self._known)))
        return self._known[index] if index < len(self._known) else None


_Pick = tuple[bool, int]
"""Whether an object must end at rest, and which of its candidates is picked."""
_Picks = tuple[_Pick, ...]


class _Join:
    """Picks a candidate for each object with a goal, the fewest moves and then the cheapest first.

    Attributes:
        effort: What may be spent, and was.
        goes_near: Whether the nearest stands in where no candidate reaches a goal.
        missed: Why the last plan that was tried is not true; whoever tries them says so.
    """

    def __init__(self, problem: Problem, grounding: Grounding, effort: Effort, *, goes_near: bool = False):
        self.problem, self.grounding, self.effort, self.goes_near = problem, grounding, effort, goes_near
        self.missed = ""
        self._bystanders: Counter[str] = Counter()
        for item in problem.objects:
            grounding.category(item.category)
        self._names = list(problem.goals)
        self._choices = dict(zip(problem.object_names, choices_of(problem, grounding), strict=True))
        self._apart = footprints_apart(problem)
        self._listed: dict[tuple[str, bool], _Listed] = {}

    def candidate(self, name: str, at_rest: bool, index: int) -> Candidate | None:
        """Return a candidate of an object, counted from the best, or None if there are not so many."""
        key = (name, at_rest)
        if key not in self._listed:
            self._listed[key] = _Listed(self._candidates(name, at_rest))
        return self._listed[key].at(index)

    def _candidates(self, name: str, at_rest: bool) -> Iterator[Candidate]:
        choices, goal = self._choices[name], self.problem.goals[name]
        found = candidates(choices, goal, self.problem.tolerance, self.effort, at_rest=at_rest)
        first = next(found, None)
        if first is None and self.goes_near:
            first = nearest(choices, goal, at_rest=at_rest, gain=GAIN)
        if first is not None:
            yield first
        yield from found

    def plans(self) -> Iterator[tuple[PlanStep, ...]]:
        """List plans in which no two objects end in each other or in the hand; orders are not looked at.

        The list ends where no object has more candidates, or with the budget of work.

        Raises:
            TimeIsUp: If the deadline passes.
        """
        first: _Picks = tuple((False, 0) for _ in self._names)
        seen, ticket = {first}, count()
        waiting: list[tuple[float, int, int, int, _Picks, list[Candidate]]] = []

        def push(picks: _Picks) -> None:
            found = [self.candidate(name, *pick) for name, pick in zip(self._names, picks, strict=True)]
            picked = [one for one in found if one is not None]
            if len(picked) == len(found):
                miss, moves = sum(one.miss for one in picked), sum(len(one.moves) for one in picked)
                costs = sum(one.cost for one in picked)
                heapq.heappush(waiting, (miss, moves, costs, next(ticket), picks, picked))

        push(first)
        while waiting and self.effort.spend():
            *_, picks, picked = heapq.heappop(waiting)
            conflict = self._conflict(picked)
            if conflict is None:
                yield self._steps(picked)
                following = [_next(picks, index) for index in range(len(picks))]
            else:
                both_held, pair = conflict
                following = [_next(picks, index, resting=both_held) for index in pair]
            for one in following:
                if one not in seen:
                    seen.add(one)
                    push(one)

    def why_none(self) -> str:
        """Say up to where plans were looked for in vain."""
        looked = [looked_at(self._choices[name]) for name in self._names]
        steps, vectors = min(steps for steps, _ in looked), sum(vectors for _, vectors in looked)
        said = f"none within {steps} primitives with an object; {vectors:,} combinations looked at"
        if self.effort.is_used_up:
            said = f"none within {self.effort.work:,} candidates, joins and orders looked at"
        if self._bystanders:
            said += f"; {self._bystanders.most_common(1)[0][0]} was in the way most often"
        return said + (f"; the last that was tried: {self.missed}" if self.missed else "")

    def _conflict(self, picked: list[Candidate]) -> tuple[bool, tuple[int, ...]] | None:
        """Find who cannot have their picks together, and whether that is because of the hand."""
        held = [index for index, one in enumerate(picked) if one.held]
        if len(held) > 1:
            return True, tuple(held[:2])
        spots = self.problem.scene().positions[:, :2]
        rows = [self.problem.object_names.index(name) for name in self._names]
        for row, one in zip(rows, picked, strict=True):
            spots[row] = one.end[:2] if not one.held else np.inf
        for index, row in enumerate(rows):
            if not picked[index].held and picked[index].moves:
                hit = overlapping(spots[row], spots, self._apart[row])
                if hit.any():
                    other = int(np.flatnonzero(hit)[0])
                    if other in rows:
                        return False, (index, rows.index(other))
                    self._bystanders[self.problem.object_names[other]] += 1
                    return False, (index,)
        return None

    def _steps(self, picked: list[Candidate]) -> tuple[PlanStep, ...]:
        """Write the moves as steps, and who is held in the end last."""
        last = sorted(zip(self._names, picked, strict=True), key=lambda pair: pair[1].held)
        return tuple(
            step for name, one in last for step in self._choices[name].steps(name, one.moves, held=one.held)
        )


def _next(picks: _Picks, index: int, *, resting: bool = False) -> _Picks:
    """Pick the next candidate of one object, or the first that ends at rest."""
    at_rest, number = picks[index]
    return (*picks[:index], (True, 0) if resting else (at_rest, number + 1), *picks[index + 1 :])
