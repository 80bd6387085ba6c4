"""Plans joined from plans of single objects that are led over cells, and ways around each other.

A plan for one object alone may lead it through others. Then each way is searched for among footprints: A*
over where the object can come to rest. The order of the objects is searched for depth first; an object that
keeps others from their goals in every order is first put aside. Each way is the cheapest there is to within a
cell; all together they need not be.
"""

import dataclasses
import heapq
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import count

import numpy as np

from neurosym.checks import Float
from neurosym.grounding import Grounding
from neurosym.planners.action_counts import Choices, choices_of
from neurosym.planners.plan_order import ends_held, mend
from neurosym.planners.planner import PLACE, Effort, PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.task import footprints_apart, near_some, overlapping
from neurosym.tasks.transition import PlanStep, validate

JOINED = "joined from plans of single objects"
"""What is said of a plan that was made so."""
WORK = 150_000
"""How many places are looked at in all."""
WORK_A_WAY = 2_000
"""How many places are looked at for one way; where it takes more, another order is tried."""
CELL = 0.005
"""Edge of a cell of which only one place is looked at: the one that is reached most cheaply [m]."""
ASIDE = 1
"""How many objects are put aside at most."""
_SWEEPS = 200

_Place = Float[np.ndarray, "3"]
_Here = Float[np.ndarray, "M 3"]
_CostToGo = Callable[[Sequence[float]], float]
"""Estimates what it costs to go on from a place [m]."""


@dataclass(frozen=True, slots=True)
class _Way:
    """A way of one object: its moves, whether it ends held, and where it rests after each move [m]."""

    moves: tuple[int, ...]
    held: bool
    places: tuple[tuple[float, ...], ...]


def plan_singly(
    problem: Problem, grounding: Grounding, solve: Callable[[Problem], PlanResult], effort: Effort
) -> PlanResult:
    """Plan for one object at a time, or for all if the hand would have to hold two in the end.

    Objects do not interact but by standing in each other's way, so every plan is the cheapest. One that ends
    with its object held comes last.
    """
    plans = dict[str, PlanResult]()
    for name in problem.goals:
        plans[name] = solve(problem.only(name))
        if plans[name].status is not PlanStatus.SOLVED:
            return plans[name]
    held = [name for name, one in plans.items() if ends_held(one.steps, grounding)]
    if len(held) > 1:
        return solve(problem)
    in_order = sorted(plans, key=lambda name: name in held)
    steps, checked = mend([step for name in in_order for step in plans[name].steps], problem, grounding)
    if checked.valid:
        said = "; ".join(dict.fromkeys((JOINED, *filter(None, (one.reason for one in plans.values())))))
        return PlanResult(PlanStatus.SOLVED, steps, 0.0, said)
    effort.check()
    found = plan_around(problem, grounding, deadline=effort.deadline)
    effort.spend(found.work)
    if found.status is PlanStatus.SOLVED:
        said = "they would have stood in each other's way, so ways around each other were taken"
        return dataclasses.replace(found, reason=f"{JOINED}: {said}")
    reason = f"no plan was true when replayed; the last: {checked.reason}"
    return PlanResult(PlanStatus.FAILED, (), 0.0, reason)


def plan_around(
    problem: Problem, grounding: Grounding, *, deadline: float = math.inf, work: int = WORK
) -> PlanResult:
    """Find a plan in which no object is put where another stands, one object after another.

    It looks at so many places. `TimeIsUp` is raised at a deadline by `time.perf_counter()` [s].
    """
    search = _Search(problem, grounding, Effort(work, deadline))
    start, todo = problem.scene().positions, frozenset(search.wanted)
    plans = (steps for aside in range(ASIDE + 1) for steps in search.plans(start, todo, (), aside))
    found = next((steps for steps in plans if validate(steps, problem, grounding).valid), None)
    spent = PLACE * search.effort.spent
    if found is not None:
        return PlanResult(PlanStatus.SOLVED, found, 0.0, work=spent)
    reason = f"no ways around each other were found; {search.effort.spent:,} places looked at"
    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, work=spent)


class _Search:
    """The search for an order of the objects, and for their ways."""

    def __init__(self, problem: Problem, grounding: Grounding, effort: Effort):
        self.problem, self.effort = problem, effort
        self.choices = choices_of(problem, grounding)
        self.goals = problem.goal_positions()  # (M, 3), NaN without a goal
        self.wanted = np.flatnonzero(np.isfinite(self.goals[:, 0])).tolist()
        self.apart = footprints_apart(problem)
        self.to_go: dict[tuple[int, bool], _CostToGo] = {}
        self.known: dict[tuple[int, bytes, frozenset[int], bool], _Way | None] = {}

    def plans(
        self, here: _Here, todo: frozenset[int], steps: tuple[PlanStep, ...], aside: int
    ) -> Iterator[tuple[PlanStep, ...]]:
        """List plans for those who have still to be moved, in which exactly so many are put aside first."""
        if not todo:
            yield from () if aside else (steps,)
            return
        blocked = []
        for row in sorted(todo, key=lambda row: (float(np.linalg.norm(here[row] - self.goals[row])), row)):
            if self.effort.is_used_up:
                return
            if way := self._to_goal(row, here, todo):
                there, moved = self._after(here, row, way)
                yield from self.plans(there, todo - {row}, steps + moved, aside)
            else:
                blocked.append(row)
        for row in blocked if aside else ():
            for other, way in self._out_of_the_way(row, here, todo):
                there, moved = self._after(here, other, way)
                yield from self.plans(there, todo, steps + moved, aside - 1)

    def _after(self, here: _Here, row: int, way: _Way) -> tuple[_Here, tuple[PlanStep, ...]]:
        there = here.copy()
        there[row] = way.places[-1]
        name = self.problem.object_names[row]
        return there, self.choices[row].steps(name, way.moves, held=way.held)

    def _out_of_the_way(self, row: int, here: _Here, todo: frozenset[int]) -> Iterator[tuple[int, _Way]]:
        """List who stands in the way of an object, each with the cheapest way out, off everybody's goal."""
        wanted = self._to_goal(row, here, todo, alone=True)
        if wanted is None:
            return
        path = np.array([*wanted.places, self.goals[row]])[:, :2]

        def is_in_it(other: int, place: _Place) -> bool:
            return bool(overlapping(place[:2], path, self.apart[row, other]).any())

        def is_out(other: int, place: _Place) -> bool:
            goals = [one for one in self.wanted if one != other]
            return not is_in_it(other, place) and not self._is_on_goals(place, other, goals)

        for other in sorted(todo - {row}):
            if self.effort.is_used_up or not is_in_it(other, here[other]):
                continue
            if way := self._way(other, here, partial(is_out, other)):
                yield other, way

    def _to_goal(self, row: int, here: _Here, todo: frozenset[int], *, alone: bool = False) -> _Way | None:
        """Return a way of an object to its goal, one that keeps off the goals of others, if there is."""
        case = (row, here.tobytes(), todo, alone)
        if case not in self.known:
            goal, others = self.goals[row], [other for other in todo if other != row]

            def is_near(place: _Place) -> bool:
                return bool(np.linalg.norm(place - goal) <= self.problem.tolerance)

            def is_clear(place: _Place) -> bool:
                return is_near(place) and not self._is_on_goals(place, row, others)

            ways = (
                self._way(row, here, is_end, goal, may_hold=len(todo) == 1, alone=alone)
                for is_end in ((is_clear, is_near) if others else (is_near,))
            )
            self.known[case] = next((way for way in ways if way), None)
        return self.known[case]

    def _is_on_goals(self, place: _Place, row: int, others: list[int]) -> bool:
        """Say whether an object would stand where others are to end."""
        return bool(overlapping(place[:2], self.goals[others, :2], self.apart[row, others]).any())

    def _way(
        self,
        row: int,
        here: _Here,
        is_end: Callable[[_Place], bool],
        goal: _Place | None = None,
        *,
        may_hold: bool = False,
        alone: bool = False,
    ) -> _Way | None:
        """Search for the cheapest way of an object to rest at an end, among the others unless it is alone.

        It may end held near the goal. None is found where it takes more than `WORK_A_WAY`.
        """
        choices, ticket, budget = self.choices[row], count(), WORK_A_WAY
        others = [] if alone else [other for other in range(len(here)) if other != row]
        in_the_way = here[others, :2], self.apart[row, others]
        lifts = np.flatnonzero(choices.held & may_hold)
        if goal is not None and (row, may_hold) not in self.to_go:
            known = _cost_to_go(choices, goal, self.problem.tolerance, may_hold=may_hold)
            self.to_go[row, may_hold] = known
        costs, far = choices.costs.tolist(), (lambda _: 0.0) if goal is None else self.to_go[row, may_hold]
        places, came = [here[row].tolist()], [(-1, -1)]  # of each node; the node before it, and the move
        cheapest = {_cell(places[0]): 0}
        waiting = [(far(places[0]), 0, next(ticket), 0)]
        while waiting and budget and self.effort.spend():
            budget -= 1
            _, owed, _, node = heapq.heappop(waiting)
            if -owed > cheapest[_cell(places[node])]:
                continue
            at = np.array(places[node])
            if is_end(at):
                return _traced(node, came, places)
            lifted, settled = at + choices.lifted, at + choices.settled
            possible = choices.is_inside(lifted)
            if len(lifts) and goal is not None:
                near = np.linalg.norm(lifted[lifts] - goal, axis=1) <= self.problem.tolerance
                if len(good := lifts[near & possible[lifts]]):
                    return _traced(node, came, places, int(good[np.argmin(choices.costs[good])]))
            possible &= choices.is_inside(settled) & ~near_some(settled[:, :2], *in_the_way)
            for move in np.flatnonzero(possible).tolist():
                place, cost = settled[move].tolist(), costs[move] - owed
                cell = _cell(place)
                if cost < cheapest.get(cell, cost + 1):
                    cheapest[cell] = cost
                    # Of equal ones, the one that has come farthest is first.
                    heapq.heappush(waiting, (cost + far(place), -cost, next(ticket), len(places)))
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
    for lift in np.flatnonzero(choices.held & may_hold):
        there = np.linalg.norm(at + choices.lifted[lift] - goal, axis=-1) <= tolerance
        costs[there] = np.minimum(costs[there], choices.costs[lift])
    moves = [
        (_window(shape[0], round(dx / CELL)), _window(shape[1], round(dy / CELL)), float(cost))
        for (dx, dy, _), cost in zip(choices.settled.tolist(), choices.costs, strict=True)
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
