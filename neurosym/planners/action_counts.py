"""The exact planner: the fewest steps there can be, by counting instead of searching.

Displacements commute, so where an object comes to rest depends only on how often each move was made. With k
moves there are C(d + k - 1, k - 1) vectors of d counts, and where they lead follows from those of d - 1. The
order matters only for staying on the table, and is looked for afterwards. There are ever more vectors, so
looking ends somewhere: `looked_at` says where.

The shortest ways of each object are listed so, and joined by conflict-based search: objects that would end in
each other, or in one that stands there, get their next way; at most one ends held, and comes last. The first
join whose steps have an order that works has the fewest primitives, and costs the least among those.
"""

import heapq
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import combinations_with_replacement, count, islice

import numpy as np

from neurosym.checks import Bool, Float, Int
from neurosym.errors import in_millimetres
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Vector
from neurosym.planners.bfs import Branching, branching_of
from neurosym.planners.planner import PLACE, Effort, PlanResult, PlanStatus, within
from neurosym.problems import Problem
from neurosym.tasks.options import PUT_DOWN, step_cost
from neurosym.tasks.promises import promised
from neurosym.tasks.task import footprints_apart, is_within, overlapping
from neurosym.tasks.transition import PlanStep, Replay, expected_success, operator_for, validate

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
    problem: Problem,
    grounding: Grounding,
    *,
    time_limit: float = math.inf,
    work: int = MOST_WORK,
    goes_near: bool = False,
) -> PlanResult:
    """Find a plan with the fewest primitives, and among those the cheapest.

    It may go as near to goals that cannot be reached as objects come; such a plan is nearest, and says how
    far objects stay from their goals.
    """

    def search(deadline: float) -> PlanResult:
        join = _Join(problem, grounding, Effort(work, deadline), goes_near=goes_near)
        missed = ""
        for steps in join.plans():
            ordered, checked = mend(steps, problem, grounding, join.effort)
            if checked.valid or (goes_near and checked.possible):
                status = PlanStatus.SOLVED if checked.valid else PlanStatus.NEAREST
                reason = "" if checked.valid else _misses(problem, checked.positions[-1])
                return PlanResult(status, ordered, 0.0, reason, work=PLACE * join.effort.spent)
            missed = f"; the last that was tried: {checked.reason}"
        reason = join.why_none() + missed
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, work=PLACE * join.effort.spent)

    return within(time_limit, search)


def _misses(problem: Problem, ends: Float[np.ndarray, "M 3"]) -> str:
    allowed = problem.tolerance
    misses = problem.distances(ends).items()
    far = [f"{name} {in_millimetres(miss, allowed)}" for name, miss in misses if miss > allowed]
    goals = "its goal" if len(far) == 1 else "their goals"
    return f"at the end, {' and '.join(far)} from {goals}; up to {DEPTH} primitives with each were looked at"


@dataclass(frozen=True, slots=True, eq=False)
class Choices:
    """The k moves that one object can make, where it stands, and where it may."""

    settled: Float[np.ndarray, "k 3"]  # displacement by each move once the hand is empty again [m]
    lifted: Float[np.ndarray, "k 3"]  # displacement at the end of the rise [m]
    held: Bool[np.ndarray, " k"]  # whether the object is held then
    costs: Int[np.ndarray, " k"]  # what each move costs
    start: Float[np.ndarray, "3"]  # centre of the object [m]
    room: Float[np.ndarray, "2 2"]  # least and greatest x and y that its centre may have [m]
    operators: tuple[str, ...] = ()  # name of the operator of each move
    # count vectors known to have no order that stays in the room
    dead: set[tuple[int, ...]] = field(default_factory=set)

    def is_inside(self, positions: Float[np.ndarray, "*n 3"]) -> Bool[np.ndarray, "*n"]:
        """Say which positions are in the object's room."""
        return is_within(positions, self.room)

    def steps(self, name: str, moves: Sequence[int], *, held: bool) -> tuple[PlanStep, ...]:
        """Write moves of an object as steps, each lift with its put-down unless it ends held."""
        steps: list[PlanStep] = []
        for move in moves:
            steps.append(PlanStep(self.operators[move], name))
            if self.held[move]:
                steps.append(PlanStep(PUT_DOWN + self.operators[move], name))
        return tuple(steps[:-1] if held else steps)


def choices_of(
    problem: Problem, grounding: Grounding, branching: Branching | None = None
) -> tuple[Choices, ...]:
    """Return what can be done to each object; by what the live operators promise, if not given."""
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
    """A way to bring one object somewhere."""

    moves: tuple[int, ...]  # the moves in an order that stays in the object's room
    held: bool  # whether the last of them is a lift without a put-down
    cost: int  # what they cost together
    end: Vector  # where the object ends [m]
    miss: float = 0.0  # how far from the goal that is, if farther than allowed [m]


@dataclass(frozen=True, slots=True, eq=False)
class _Ends:
    """Where an object can end after so many moves [m], and at what costs: held by a lift, at rest if -1."""

    length: int
    lift: int
    places: Float[np.ndarray, "n 3"]
    costs: Int[np.ndarray, " n"]


def looked_at(choices: Choices, depth: int = MOST_STEPS) -> tuple[int, int]:
    """Say up to how many moves of an object are looked at, and how many count vectors that are."""
    kinds = len(choices.costs)
    if kinds == 0:
        return depth, 1
    fits = (steps for steps in range(depth, -1, -1) if math.comb(steps + kinds - 1, steps) <= MOST_VECTORS)
    steps = next(fits)
    return steps, math.comb(steps + kinds, kinds)


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


def _ends(choices: Choices, depth: int, *, at_rest: bool) -> Iterator[tuple[_Ends, ...]]:
    """List where an object can end after 0, 1, 2 and more moves: at rest, then held by each of the lifts."""
    now = _Ends(0, -1, choices.start[None], np.zeros(1, dtype=int))
    yield (now,)
    lifts = [] if at_rest else np.flatnonzero(choices.held).tolist()
    for length in range(1, looked_at(choices, depth)[0] + 1 if len(choices.costs) else 1):
        parents, moves = _level(len(choices.costs), length)
        held = (
            _Ends(length, lift, now.places + choices.lifted[lift], now.costs + choices.costs[lift])
            for lift in lifts
        )
        places = now.places[parents] + choices.settled[moves]
        rest = _Ends(length, -1, places, now.costs[parents] + choices.costs[moves])
        yield (rest, *held)
        now = rest


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
    """List the ways to bring an object near a goal [m]: fewest moves first, among those the cheapest first.

    They end at rest, if they must, and have no more moves and costs than allowed. The list ends where
    `looked_at` says, or with the budget of work; ways that are too dear are looked at, too.
    """
    for ends in _ends(choices, min(moves, MOST_STEPS), at_rest=at_rest):
        effort.spend(0)
        found: list[tuple[int, int, int]] = []  # cost, lift or -1, row
        for end in ends:
            away = end.places - np.array(goal)
            rows = np.flatnonzero(np.einsum("ij,ij->i", away, away) <= tolerance**2)
            rows = rows[choices.is_inside(end.places[rows]) | (end.length == 0)]
            found += [(int(end.costs[row]), end.lift, int(row)) for row in rows]
        for one_cost, lift, row in sorted(found):
            if not effort.spend():
                return
            if one_cost <= cost and (candidate := _in_order(choices, ends[0].length, row, lift)):
                yield candidate


def nearest(choices: Choices, goal: Vector, *, at_rest: bool = False, gain: float = 1e-9) -> Candidate:
    """Find how to bring an object as near to its goal as it comes, with up to `DEPTH` moves.

    More moves are worth it if they bring it nearer by the gain [m].
    """
    x, y, z = map(float, choices.start)
    best = Candidate((), False, 0, (x, y, z), math.dist(choices.start, goal))
    for end in (end for ends in islice(_ends(choices, DEPTH, at_rest=at_rest), 1, None) for end in ends):
        misses = np.linalg.norm(end.places - np.array(goal), axis=-1)
        rows = np.flatnonzero((misses < best.miss - gain) & choices.is_inside(end.places))
        for row in rows[np.argsort(misses[rows], kind="stable")]:
            if found := _in_order(choices, end.length, int(row), end.lift):
                best = replace(found, miss=float(misses[row]))
                break
    return best


def _in_order(choices: Choices, length: int, row: int, lift: int) -> Candidate | None:
    """Put so many moves, the last lift counted, in an order that stays in the room, if there is one."""
    kinds, is_held = len(choices.costs), lift >= 0
    counts = np.zeros(kinds, dtype=int)
    for shorter in range(length - is_held, 0, -1):
        parents, moves = _level(kinds, shorter)
        counts[moves[row]] += 1
        row = int(parents[row])
    end, cost = choices.start + counts @ choices.settled, int(counts @ choices.costs)
    if is_held:
        end, cost = end + choices.lifted[lift], cost + int(choices.costs[lift])
    if is_held and not choices.is_inside(end):
        return None
    order = _order(choices, tuple(counts.tolist()))
    x, y, z = map(float, end)
    return None if order is None else Candidate((*order, *[lift][: int(is_held)]), is_held, cost, (x, y, z))


def _order(choices: Choices, counts: tuple[int, ...], effort: Effort | None = None) -> tuple[int, ...] | None:
    """Search backwards, depth first; the counts say where the object is, so nothing is looked at twice."""
    effort = effort or Effort()
    seen, waiting = set[tuple[int, ...]](), [(counts, tuple[int, ...]())]
    while waiting:
        done, then = waiting.pop()
        if not any(done):
            return then
        if not effort.spend():
            return None
        if done in seen or done in choices.dead:
            continue
        seen.add(done)
        here = choices.start + np.array(done) @ choices.settled
        if choices.is_inside(here):
            possible = choices.is_inside(here - choices.settled + choices.lifted)
            for move in np.flatnonzero(possible & (np.array(done) > 0)).tolist():
                waiting.append(((*done[:move], done[move] - 1, *done[move + 1 :]), (move, *then)))
    choices.dead.update(seen)
    return None


_Pick = tuple[bool, int]
"""Whether an object must end at rest, and which of its candidates is picked."""


class _Join:
    """Picks a candidate for each object with a goal, the fewest moves and then the cheapest first."""

    def __init__(self, problem: Problem, grounding: Grounding, effort: Effort, *, goes_near: bool = False):
        for item in problem.objects:
            grounding.category(item.category)
        self.effort = effort
        self._problem, self._names, self._goes_near = problem, list(problem.goals), goes_near
        self._choices = dict(zip(problem.object_names, choices_of(problem, grounding), strict=True))
        self._apart = footprints_apart(problem)
        self._listed: dict[tuple[str, bool], tuple[list[Candidate], Iterator[Candidate]]] = {}

    def candidate(self, name: str, at_rest: bool, index: int) -> Candidate | None:
        """Return a candidate of an object, counted from the best, or None if there are not so many."""
        if (name, at_rest) not in self._listed:
            self._listed[name, at_rest] = [], self._candidates(name, at_rest)
        known, source = self._listed[name, at_rest]
        known += islice(source, max(0, index + 1 - len(known)))
        return known[index] if index < len(known) else None

    def _candidates(self, name: str, at_rest: bool) -> Iterator[Candidate]:
        choices, goal = self._choices[name], self._problem.goals[name]
        found = candidates(choices, goal, self._problem.tolerance, self.effort, at_rest=at_rest)
        first = next(found, None)
        if first is None and self._goes_near:
            first = nearest(choices, goal, at_rest=at_rest, gain=GAIN)
        if first is not None:
            yield first
        yield from found

    def plans(self) -> Iterator[tuple[PlanStep, ...]]:
        """List plans in which no two objects end in each other or in the hand; orders are not looked at."""
        following: list[tuple[_Pick, ...]] = [tuple((False, 0) for _ in self._names)]
        seen, ticket = set[tuple[_Pick, ...]](), count()
        waiting: list[tuple[float, int, int, int, tuple[_Pick, ...], list[Candidate]]] = []
        while following or waiting:
            for picks in following:
                found = [self.candidate(name, *pick) for name, pick in zip(self._names, picks, strict=True)]
                picked = [one for one in found if one is not None]
                if picks not in seen and len(picked) == len(found):
                    miss, moves = sum(one.miss for one in picked), sum(len(one.moves) for one in picked)
                    costs = sum(one.cost for one in picked)
                    heapq.heappush(waiting, (miss, moves, costs, next(ticket), picks, picked))
                seen.add(picks)
            if not waiting or not self.effort.spend():
                return
            *_, picks, picked = heapq.heappop(waiting)
            rests, rows = self._conflict(picked)
            if not rows:
                yield self._steps(picked)
            following = [
                (*picks[:row], (True, 0) if rests else (picks[row][0], picks[row][1] + 1), *picks[row + 1 :])
                for row in rows or range(len(picks))
            ]

    def why_none(self) -> str:
        """Say up to where plans were looked for in vain."""
        if self.effort.is_used_up:
            return f"none within {self.effort.work:,} candidates, joins and orders looked at"
        looked = [looked_at(self._choices[name]) for name in self._names]
        steps, vectors = min(steps for steps, _ in looked), sum(vectors for _, vectors in looked)
        return f"none within {steps} primitives with an object; {vectors:,} combinations looked at"

    def _conflict(self, picked: list[Candidate]) -> tuple[bool, tuple[int, ...]]:
        """Find who cannot have their picks together, nobody if all can, and whether two would be held."""
        held = [index for index, one in enumerate(picked) if one.held]
        if len(held) > 1:
            return True, tuple(held[:2])
        spots = self._problem.scene().positions[:, :2]
        rows = [self._problem.object_names.index(name) for name in self._names]
        for row, one in zip(rows, picked, strict=True):
            spots[row] = one.end[:2] if not one.held else np.inf
        for index, row in enumerate(rows):
            if not picked[index].held and picked[index].moves:
                hit = np.flatnonzero(overlapping(spots[row], spots, self._apart[row]))
                if len(hit):
                    return False, (index, *(rows.index(other) for other in hit[:1] if other in rows))
        return False, ()

    def _steps(self, picked: list[Candidate]) -> tuple[PlanStep, ...]:
        """Write the moves as steps, and who is held in the end last."""
        last = sorted(zip(self._names, picked, strict=True), key=lambda pair: pair[1].held)
        return tuple(
            step for name, one in last for step in self._choices[name].steps(name, one.moves, held=one.held)
        )


# Putting the steps of a plan in another order: what changes is where the objects are on the way. One order
# leads an object off the table or into another, and the next does not. What is left to do says where
# everything stands, so no set of steps is looked at twice.
MOST_STATES = 5_000
"""How many beginnings of plans are tried."""
EXCHANGED = 2
"""So many moves of an object are exchanged for others at most, where cells round a plan beside its goal."""
MOST_EXCHANGES = 100
"""How many of the cheapest such ways are judged."""
MOST_LOOKED_AT = 100_000
"""How many states are looked at for the orders of all such ways of an object."""


def ends_held(steps: Sequence[PlanStep], grounding: Grounding) -> bool:
    """Say whether a plan ends with an object in the hand."""
    return bool(steps) and not steps[-1].puts_down and is_lift(grounding.operator_named(steps[-1].base))


def mend(
    steps: Sequence[PlanStep],
    problem: Problem,
    grounding: Grounding,
    effort: Effort | None = None,
    *,
    cell: float = 0.0,
) -> tuple[tuple[PlanStep, ...], Replay]:
    """Find an order of the steps in which all are possible, beginning with the one given.

    Where they miss a goal by no more than cells round, few of them are exchanged.

    Args:
        steps: The steps.
        problem: What they are to solve.
        grounding: What their operators promise.
        effort: What is tried is counted there.
        cell: Edge of the cells that they were planned over [m]; 0 if there were none.

    Returns:
        The steps, as they were given if nothing is found, and their replay.
    """
    ordered, replay = _in_possible_order(steps, problem, grounding, effort)
    if replay.possible and not replay.valid and cell:
        return _brought_near(ordered, replay, problem, grounding, cell)
    return ordered, replay


def _in_possible_order(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, effort: Effort | None
) -> tuple[tuple[PlanStep, ...], Replay]:
    given = validate(steps, problem, grounding)
    if given.possible or not steps:
        return tuple(steps), given  # valid, or missing its goal in every order
    blocks = list[tuple[PlanStep, ...]]()  # steps that an empty hand begins, each with its put-down
    for step in steps:
        if step.puts_down and blocks:
            blocks[-1] += (step,)
        else:
            blocks.append((step,))
    last = blocks.pop() if ends_held(steps, grounding) else ()
    found = _ordered(blocks, problem, grounding, effort or Effort())
    if found and (checked := validate((*found, *last), problem, grounding)).possible:
        return (*found, *last), checked
    return tuple(steps), given


def _ordered(
    blocks: Sequence[tuple[PlanStep, ...]], problem: Problem, grounding: Grounding, effort: Effort
) -> tuple[PlanStep, ...]:
    """Search among the orders of blocks, depth first, equal blocks counted; nothing if none is found."""
    kinds = list(dict.fromkeys(blocks))
    rows = [problem.object_names.index(kind[0].object) for kind in kinds]
    shifts = list[tuple[np.ndarray, np.ndarray]]()  # after the first step, and in all [m]
    for kind in kinds:
        operator = operator_for(kind[0], problem, grounding)
        first = np.array(grounding.displacement(operator))
        down = grounding.put_down_displacement(operator) if len(kind) > 1 else (0.0, 0.0, 0.0)
        shifts.append((first, first + down))
    room, apart = problem.room(grounding.table), footprints_apart(problem)
    counts = tuple(map(blocks.count, kinds))
    seen, waiting = {counts}, [(tuple[int, ...](), counts, problem.scene().positions)]
    while waiting and len(seen) < MOST_STATES and effort.spend():
        done, left, here = waiting.pop()
        if not any(left):
            return tuple(step for number in done for step in kinds[number])
        for number in reversed(np.flatnonzero(left).tolist()):
            row, fewer = rows[number], (*left[:number], left[number] - 1, *left[number + 1 :])
            spots = np.array([here[row] + shift for shift in shifts[number]])
            stays = is_within(spots, room[:, row]).all()
            if fewer in seen or not stays or overlapping(spots[1, :2], here[:, :2], apart[row]).any():
                continue
            seen.add(fewer)
            after = here.copy()
            after[row] = spots[1]
            waiting.append(((*done, number), fewer, after))
    return ()


def _brought_near(
    steps: tuple[PlanStep, ...], replay: Replay, problem: Problem, grounding: Grounding, cell: float
) -> tuple[tuple[PlanStep, ...], Replay]:
    """Give objects that cells round away the likeliest of the cheapest ways that differ by few moves."""
    for name, miss in problem.distances(replay.positions[-1]).items():
        own = [step for step in steps if step.object == name]
        rounded = len(own) * cell / math.sqrt(2)
        if not problem.tolerance < miss <= problem.tolerance + rounded or ends_held(own, grounding):
            continue
        alone = problem.only(name)
        (choices,) = choices_of(alone, grounding)
        counts = np.array([sum(step.operator == one for step in own) for one in choices.operators])
        near = islice(_variations(choices, counts, alone.goals[name], alone.tolerance), MOST_EXCHANGES)
        ways = [choices.steps(name, one, held=False) for one in near]
        first, others = steps.index(own[0]), [step for step in steps if step.object != name]
        for way in sorted(ways, key=lambda way: -expected_success(way, alone, grounding)):
            varied = (*others[:first], *way, *others[first:])
            if (checked := validate(varied, problem, grounding)).possible:
                steps, replay = varied, checked
                break
    return steps, replay


def _variations(
    choices: Choices, counts: Int[np.ndarray, " k"], goal: Vector, tolerance: float
) -> Iterator[tuple[int, ...]]:
    """List the ways near a goal [m] that differ by few moves from one, the cheapest first; none is held."""
    kinds = range(len(counts))
    some = [one for size in range(EXCHANGED + 1) for one in combinations_with_replacement(kinds, size)]
    changes = np.array([np.bincount(one, minlength=len(counts)) for one in some], dtype=int)
    left = counts - changes
    left = left[(left >= 0).all(1)]
    ends = choices.start + (left @ choices.settled)[:, None] + changes @ choices.settled
    costs = (left @ choices.costs)[:, None] + changes @ choices.costs
    rows = np.argwhere(np.linalg.norm(ends - np.array(goal), axis=-1) <= tolerance)
    ranked = rows[np.argsort(costs[*rows.T], kind="stable")].tolist()
    effort = Effort(MOST_LOOKED_AT)
    for varied in dict.fromkeys(tuple((left[out] + changes[new]).tolist()) for out, new in ranked):
        if (order := _order(choices, varied, effort)) is not None:
            yield order
