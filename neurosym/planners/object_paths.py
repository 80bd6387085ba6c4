"""Ways around each other: one object after another is brought to its goal, each around where the others are.

A plan for one object alone may lead it through others. So each way is searched for among footprints: A* over
where the object can come to rest. The order of the objects is searched for depth first; an object that keeps
others from their goals in every order is first put aside. Each way is the cheapest there is to within a cell;
all together they need not be.
"""

import heapq
import math
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass
from itertools import count

import numpy as np

from neurosym.checks import Float
from neurosym.grounding import Grounding
from neurosym.planners.action_counts import Choices, choices_of
from neurosym.planners.planner import PLACE, Effort, PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.task import footprints_apart, near_some, overlapping
from neurosym.tasks.transition import PlanStep, validate

WORK = 150_000
"""How many places are looked at in all."""
WORK_A_WAY = 2_000
"""How many places are looked at for one way; where it takes more, another order is tried."""
CELL = 0.005
"""Edge of a cell of which only one place is looked at: the one that is reached most cheaply [m]."""
ASIDE = 2
"""How many objects are put aside at most."""
_SWEEPS = 200

_Place = Float[np.ndarray, "3"]
_State = tuple[Float[np.ndarray, "M 3"], frozenset[int], tuple[PlanStep, ...]]
"""Where the objects are [m], who has still to be moved, and the steps so far."""
_IsEnd = Callable[[_Place], bool]
"""Says whether an object may end at rest in a place."""
_CostToGo = Callable[[Sequence[float]], float]
"""Estimates what it costs to go on from a place [m]."""


@dataclass(frozen=True, slots=True)
class _Way:
    """A way of one object: its moves, whether it ends held, and where it rests after each move [m]."""

    moves: tuple[int, ...]
    held: bool
    places: tuple[tuple[float, ...], ...]


def plan_around(
    problem: Problem, grounding: Grounding, *, deadline: float = math.inf, work: int = WORK
) -> PlanResult:
    """Find a plan in which no object is put where another stands, one object after another.

    Args:
        problem: The problem.
        grounding: The learned domain.
        deadline: When the user's time is up, by `time.perf_counter()` [s].
        work: How many places are looked at.

    Raises:
        TimeIsUp: If the deadline passes.
    """
    search = _Search(problem, grounding, Effort(work, deadline))
    found = next((steps for steps in search.plans() if validate(steps, problem, grounding).valid), None)
    spent = search.effort.spent
    if found is not None:
        return PlanResult(PlanStatus.SOLVED, found, 0.0, work=PLACE * spent)
    reason = f"no ways around each other were found; {spent:,} places looked at"
    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, work=PLACE * spent)


class _Search:
    """The search for an order of the objects, and for their ways."""

    def __init__(self, problem: Problem, grounding: Grounding, effort: Effort):
        self.problem, self.effort = problem, effort
        self.choices = choices_of(problem, grounding)
        self.goals = problem.goal_positions()  # (M, 3), NaN without a goal
        self.wanted = np.flatnonzero(np.isfinite(self.goals[:, 0])).tolist()
        self.apart = footprints_apart(problem)
        self.to_go: dict[tuple[int, bool], _CostToGo] = {}
        self.known: dict[Hashable, tuple[_Way | None, int]] = {}

    def plans(self) -> Iterator[tuple[PlanStep, ...]]:
        """List plans: with nobody put aside first, and then with ever more objects put aside."""
        start = self.problem.scene().positions
        for aside in range(ASIDE + 1):
            yield from self._from((start, frozenset(self.wanted), ()), aside)

    def _from(self, state: _State, aside: int) -> Iterator[tuple[PlanStep, ...]]:
        """List the plans from a state on, in which exactly so many objects are put aside."""
        here, todo, steps = state
        if not todo:
            if aside == 0:
                yield steps
            return
        blocked = []
        for row in sorted(todo, key=lambda row: (float(np.linalg.norm(here[row] - self.goals[row])), row)):
            if self.effort.is_used_up:
                return
            if way := self._to_goal(row, here, todo):
                yield from self._from(self._after(state, row, way, is_done=True), aside)
            else:
                blocked.append(row)
        for row in blocked if aside else ():
            yield from self._from_aside(state, row, aside)

    def _from_aside(self, state: _State, row: int, aside: int) -> Iterator[tuple[PlanStep, ...]]:
        """List the plans in which somebody makes way for an object that is blocked."""
        here, todo, _ = state
        wanted = self._to_goal(row, here, todo, alone=True)
        if wanted is None:
            return
        path = np.array([*wanted.places, self.goals[row]])[:, :2]
        for other in sorted(todo - {row}):
            if self.effort.is_used_up or not self._stands_on(path, row, here[other], other):
                continue
            if way := self._out_of(path, row, other, here):
                yield from self._from(self._after(state, other, way, is_done=False), aside - 1)

    def _to_goal(
        self, row: int, here: Float[np.ndarray, "M 3"], todo: frozenset[int], *, alone: bool = False
    ) -> _Way | None:
        """Return a way of an object to its goal, and count what finding it took; it is searched for once."""
        case = (row, here.tobytes(), todo, alone)
        if case in self.known:
            way, took = self.known[case]
            return way if self.effort.spend(took) else None
        before = self.effort.spent
        way = self._search_to_goal(row, here, todo, alone=alone)
        self.known[case] = (way, self.effort.spent - before)
        return way

    def _search_to_goal(
        self, row: int, here: Float[np.ndarray, "M 3"], todo: frozenset[int], *, alone: bool
    ) -> _Way | None:
        """Search for a way of an object to its goal; one that keeps off the goals of others, if there is."""
        goal, tolerance = self.goals[row], self.problem.tolerance
        others = [other for other in todo if other != row]

        def is_near(place: _Place) -> bool:
            return bool(np.linalg.norm(place - goal) <= tolerance)

        def is_clear(place: _Place) -> bool:
            return is_near(place) and not self._is_on_goals(place, row, others)

        for is_end in (is_clear, is_near) if others else (is_near,):
            if way := self._way(row, here, is_end, goal, may_hold=len(todo) == 1, alone=alone):
                return way
        return None

    def _out_of(
        self, path: Float[np.ndarray, "n 2"], row: int, other: int, here: Float[np.ndarray, "M 3"]
    ) -> _Way | None:
        """Search for the cheapest way of an object out of another's path, and off everybody's goal."""
        wanted = [one for one in self.wanted if one != other]

        def is_end(place: _Place) -> bool:
            on_goals = self._is_on_goals(place, other, wanted)
            return not on_goals and not self._stands_on(path, row, place, other)

        return self._way(other, here, is_end, None)

    def _is_on_goals(self, place: _Place, row: int, others: list[int]) -> bool:
        """Say whether an object would stand where others are to end."""
        return bool(overlapping(place[:2], self.goals[others, :2], self.apart[row, others]).any())

    def _stands_on(self, path: Float[np.ndarray, "n 2"], row: int, place: _Place, other: int) -> bool:
        return bool(overlapping(place[:2], path, self.apart[row, other]).any())

    def _way(
        self,
        row: int,
        here: Float[np.ndarray, "M 3"],
        is_end: _IsEnd,
        goal: _Place | None,
        *,
        may_hold: bool = False,
        alone: bool = False,
    ) -> _Way | None:
        """Search for the cheapest way of an object to an end, among the others unless it is alone."""
        others = np.zeros(0, dtype=int) if alone else np.delete(np.arange(len(here)), row)
        in_the_way = here[others, :2], self.apart[row, others]
        held_end = (goal, self.problem.tolerance) if may_hold and goal is not None else None
        far = self._far(row, goal, may_hold=may_hold)
        return _cheapest_way(self.choices[row], here[row], in_the_way, is_end, far, self.effort, held_end)

    def _far(self, row: int, goal: _Place | None, *, may_hold: bool) -> _CostToGo:
        """Return what it costs an object to go on to its goal."""
        if goal is None:
            return lambda _: 0.0
        if (row, may_hold) not in self.to_go:
            tolerance = self.problem.tolerance
            self.to_go[row, may_hold] = _cost_to_go(self.choices[row], goal, tolerance, may_hold=may_hold)
        return self.to_go[row, may_hold]

    def _after(self, state: _State, row: int, way: _Way, *, is_done: bool) -> _State:
        here, todo, steps = state
        after = here.copy()
        after[row] = way.places[-1]
        made = self.choices[row].steps(self.problem.object_names[row], way.moves, held=way.held)
        return after, todo - {row} if is_done else todo, (*steps, *made)


def _cheapest_way(
    choices: Choices,
    start: _Place,
    in_the_way: tuple[Float[np.ndarray, "m 2"], Float[np.ndarray, "m 2"]],
    is_end: _IsEnd,
    far: _CostToGo,
    effort: Effort,
    held_end: tuple[_Place, float] | None,
) -> _Way | None:
    """Search for the cheapest way of an object to an end; None if none is found with the work there is.

    It starts at rest. In the way are others, with how far its centre must be from theirs along x or y [m]. It
    may end held so near to a place [m], if one is given.
    """
    ticket, budget = count(), WORK_A_WAY
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
            misses = np.linalg.norm(lifted[lifts] - held_end[0], axis=1)
            good = lifts[(misses <= held_end[1]) & possible[lifts]]
            if len(good):
                return _traced(node, came, places, int(good[np.argmin(choices.costs[good])]))
        possible &= choices.is_inside(settled) & ~near_some(settled[:, :2], *in_the_way)
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
    return math.floor(place[0] / CELL + 0.5), math.floor(place[1] / CELL + 0.5)


def _traced(
    node: int, came: list[tuple[int, int]], places: list[list[float]], lift: int | None = None
) -> _Way:
    """Follow a node back to the start, and end with a lift if there is one."""
    moves = [] if lift is None else [lift]
    rests: list[tuple[float, ...]] = []
    while node >= 0:
        rests.append(tuple(places[node]))
        node, move = came[node]
        moves += [move] if node >= 0 else []
    return _Way(tuple(moves[::-1]), lift is not None, tuple(rests[::-1]))


def _cost_to_go(choices: Choices, goal: _Place, tolerance: float, *, may_hold: bool) -> _CostToGo:
    """Estimate what it costs to bring an object near its goal from everywhere in its room, if it were alone.

    Value iteration on a grid, whose cells are so small that A* among other objects hardly strays with it.
    """
    low, high = choices.room
    shape = tuple(max(0, math.floor(extent / CELL)) + 1 for extent in (high - low).tolist())
    places = np.stack(np.meshgrid(*(np.arange(cells) * CELL for cells in shape), indexing="ij"), -1) + low
    at = np.concatenate([places, np.full((*shape, 1), choices.start[2])], -1)  # (X, Y, 3)
    costs = np.where(np.linalg.norm(at - goal, axis=-1) <= tolerance, 0.0, np.inf)
    for move in np.flatnonzero(choices.held) if may_hold else ():
        there = np.linalg.norm(at + choices.lifted[move] - goal, axis=-1) <= tolerance
        costs[there] = np.minimum(costs[there], choices.costs[move])
    cells = [(round(x / CELL), round(y / CELL)) for x, y, _ in choices.settled.tolist()]
    moves = [
        (_window(shape[0], dx), _window(shape[1], dy), float(cost))
        for (dx, dy), cost in zip(cells, choices.costs, strict=True)
    ]
    for _ in range(_SWEEPS):
        before = costs.copy()
        for (here_x, there_x), (here_y, there_y), cost in moves:
            part = costs[here_x, here_y]
            np.minimum(part, costs[there_x, there_y] + cost, out=part)
        if np.array_equal(costs, before):
            break

    x_low, y_low = low.tolist()
    known = np.where(np.isfinite(costs), costs, 0.0).tolist()

    def estimate(place: Sequence[float]) -> float:
        x, y = round((place[0] - x_low) / CELL), round((place[1] - y_low) / CELL)
        return known[x][y] if 0 <= x < shape[0] and 0 <= y < shape[1] else 0.0

    return estimate


def _window(cells: int, by: int) -> tuple[slice, slice]:
    """Return the cells from which a move stays inside, and those where it leads."""
    first, last = max(0, -by), max(0, min(cells, cells - by))
    return slice(first, last), slice(first + by, max(first, last) + by)
