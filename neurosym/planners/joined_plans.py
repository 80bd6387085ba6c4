"""Plans joined from plans of single objects, and from plans of what is carried and what is led over cells.

On the page, what is led does not know that it must keep clear of what was carried. So what stands in the way
of what is led is carried out of it first, and the rest afterwards: in turns.

A plan for one object alone may lead it through others. Then each way is searched for among footprints: A*
over where the object can come to rest. The order of the objects is searched for depth first; an object that
keeps others from their goals in every order is first put aside. Each way is the cheapest there is to within a
cell; all together they need not be.
"""

import dataclasses
import heapq
import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import count

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.planners.action_counts import Choices, choices_of, ends_held, mend
from neurosym.planners.planner import PLACE, Effort, PlanResult, PlanStatus
from neurosym.problems import Problem, spot_name
from neurosym.tasks.task import (
    GAP,
    LEAST_GAP,
    drawn_spots,
    footprints_apart,
    near_some,
    overlapping,
    understand,
    with_places,
)
from neurosym.tasks.transition import PlanStep, validate

IN_TURNS = "joined from plans of what is carried and what is led over cells, in turns"
"""What is said of a plan that was made so."""
NEARER = 0.5
"""What is led is to come so near to its goal if others have no room else, as a share of the tolerance.

What makes way comes as near to where it is to wait, lest it be set down beside that, and in the way.
"""
BESIDE = 0.02
"""Room for the hand beside the way of what is led [m]."""
_NOTHING = PlanResult(PlanStatus.SOLVED, (), 0.0)
_Spots = Float[np.ndarray, "N 2"]
_Solve = Callable[[Problem], PlanResult]
_Goals = Mapping[str, Vector]


def plan_in_turns(problem: Problem, grounding: Grounding, carry: _Solve, lead: _Solve) -> PlanResult:
    """Carry what stands in the way of what must be led, then lead this, and then carry the rest.

    At first all ways are cleared, and what has its goal beside them is carried there before. If that fails,
    only what stands in the ways is moved, and what is led comes nearer to its goals. What cannot be led to
    its goal even alone has no plan.
    """
    turns = _Turns(problem, grounding, carry, lead, understand(problem, grounding).carried)
    result = turns.plan(1.0, everything=True)
    if result.status in (PlanStatus.SOLVED, PlanStatus.UNSOLVABLE):
        return result
    return turns.plan(NEARER, everything=False)


@dataclass(frozen=True, slots=True)
class _Turns:
    """What is asked, who plans the turns, and the names of the objects that can be carried."""

    problem: Problem
    grounding: Grounding
    carry: _Solve
    lead: _Solve
    can_be: Sequence[str]

    def plan(self, near: float, *, everything: bool) -> PlanResult:
        """Look for a way among what cannot be carried, clear it, lead along it, and carry the rest."""
        problem, goals = self.problem, self.problem.goals
        led = {name: goal for name, goal in goals.items() if name not in self.can_be}
        carried = {name: goal for name, goal in goals.items() if name in self.can_be}
        way, before = self._cleared_way(led, carried, near, everything=everything)
        if way.status is not PlanStatus.SOLVED:
            return way
        steps, now = tuple[PlanStep, ...](), problem
        turns = ((self._carried, before, NEARER), (lambda _: way, led, near), (self._carried, carried, 1.0))
        for solve, wanted, nearness in turns:
            nearer = nearness * problem.tolerance
            task = msgspec.structs.replace(now, goals=dict(wanted), tolerance=nearer)
            result = solve(task) if task.unmet else _NOTHING
            if result.status is not PlanStatus.SOLVED:
                return result
            checked = validate(result.steps, task, self.grounding)
            if not checked.valid:
                return PlanResult(PlanStatus.FAILED, (), 0.0, checked.reason)
            ends = zip(task.objects, map(vector, checked.positions[-1]), strict=True)
            moved = tuple(msgspec.structs.replace(item, position=end) for item, end in ends)
            steps, now = steps + result.steps, msgspec.structs.replace(task, objects=moved)
        if (checked := validate(steps, problem, self.grounding)).valid:
            return PlanResult(PlanStatus.SOLVED, steps, 0.0, IN_TURNS)
        return PlanResult(PlanStatus.FAILED, (), 0.0, checked.reason)

    def _cleared_way(
        self, led: _Goals, carried: _Goals, near: float, *, everything: bool
    ) -> tuple[PlanResult, _Goals]:
        """Return a way around what there is no room for elsewhere, and where to carry what stands in it."""
        stays = frozenset[str]()
        while True:
            can_be = [name for name in self.can_be if name not in stays]
            others = tuple(one for one in self.problem.objects if one.name not in can_be)
            wanted = {"objects": others, "goals": led, "tolerance": near * self.problem.tolerance}
            alone = msgspec.structs.replace(self.problem, **wanted)
            way = self.lead(alone) if alone.unmet else _NOTHING
            if way.status is not PlanStatus.SOLVED:
                return way, {}
            path = validate(way.steps, alone, self.grounding).positions
            to_clear = _Course(path, alone.object_names, self.problem, self.grounding)
            before = to_clear.cleared(can_be, carried, everything=everything)
            if not (stuck := to_clear.in_the_way(can_be) - before.keys()):
                return way, before
            stays |= stuck

    def _carried(self, task: Problem) -> PlanResult:
        """Carry objects by places that suit where all stands now, named by where they lie if they are new."""
        placed, printed = with_places(task, self.grounding), with_places(self.problem, self.grounding)
        result, spots = self.carry(placed), list[PlanStep]()
        for step in result.steps:
            if step.place and printed.places.get(step.place) != placed.place_named(step.place):
                step = dataclasses.replace(step, place=spot_name(*placed.place_named(step.place)))
            spots.append(step)
        # With these places there may be no plan, and one with others.
        status = PlanStatus.NOT_FOUND if result.status is PlanStatus.UNSOLVABLE else result.status
        return dataclasses.replace(result, status=status, steps=tuple(spots))


@dataclass(frozen=True, eq=False)
class _Course:
    """The way of what is led, among objects that can be carried out of it."""

    path: Float[np.ndarray, "steps L 3"]  # where what cannot be carried stands after each step [m]
    led: Sequence[str]  # names of these objects, in the order of the path
    now: Problem  # the problem; objects wait at its places, or anywhere if it has none
    grounding: Grounding  # the learned domain

    def cleared(self, can_be: Collection[str], goals: _Goals, *, everything: bool) -> dict[str, Vector]:
        """Return where objects are to be carried before anything is led along the way [m].

        What stands in the way goes to its goal if that is free and beside the way, and else aside, if there
        is room; the largest first. If everything shall, others with goals beside the way go there, too.
        """
        in_it, before = self.in_the_way(can_be), dict[str, Vector]()
        names = can_be if everything else in_it
        items = [item for item in self.now.objects if item.name in names]
        for item in sorted(items, key=lambda one: (-max(one.features[:2]), one.name)):
            goal = goals.get(item.name)
            if goal and self._is_free(item.name, _spots(goal), before, BESIDE)[0]:
                before[item.name] = goal
            elif item.name in in_it and (spot := self._aside(item.name, before, goals)):
                before[item.name] = (*spot, item.position[2])
        return before

    def in_the_way(self, names: Collection[str]) -> set[str]:
        """Name those of some objects that stand in the way."""
        items = [item for item in self.now.objects if item.name in names]
        return {item.name for item in items if self._in_it(item.name, _spots(item.position))[0]}

    def _aside(self, name: str, moved: _Goals, goals: _Goals) -> tuple[float, float] | None:
        """Return a spot where an object can wait [m], off the goals of others if possible."""
        spots, others = self._candidates(name), [other for other in goals if other != name]
        wanted, apart = _spots(*(goals[other] for other in others)), self._apart(name, others)
        for gap, keeps_off in ((GAP, True), (LEAST_GAP, True), (LEAST_GAP, False)):
            fit = self._is_free(name, spots, moved, gap)
            if keeps_off:
                fit &= ~near_some(spots, wanted, apart + gap)
            if fit.any():
                x, y = spots[fit.argmax()].tolist()
                return x, y
        return None

    def _candidates(self, name: str) -> _Spots:
        """List where an object may wait: the same spots for the same object and table."""
        if self.now.places:
            return _spots(*self.now.places.values())
        size = np.array(self.now.object_named(name).features[:2], dtype=float)
        return drawn_spots(size, self.grounding.table)

    def _is_free(self, name: str, spots: _Spots, moved: _Goals, gap: float) -> Bool[np.ndarray, " N"]:
        """Say at which spots an object is out of the way and clear of others, some of which were moved."""
        others = [item for item in self.now.objects if item.name != name]
        here = _spots(*(moved.get(item.name, item.position) for item in others))
        apart = self._apart(name, [item.name for item in others]) + gap
        return np.asarray(~(near_some(spots, here, apart) | self._in_it(name, spots)))

    def _in_it(self, name: str, spots: _Spots) -> Bool[np.ndarray, " N"]:
        """Say at which spots an object would stand in the way."""
        apart = np.tile(self._apart(name, self.led) + BESIDE, (len(self.path), 1))  # (steps * L, 2)
        return near_some(spots, self.path[..., :2].reshape(-1, 2), apart)

    def _apart(self, name: str, others: Sequence[str]) -> _Spots:
        """Return how far an object must be from others along x and y [m]."""
        row = self.now.object_names.index
        return footprints_apart(self.now)[row(name), [row(other) for other in others]]


def _spots(*positions: Sequence[float]) -> _Spots:
    return np.array([position[:2] for position in positions], dtype=float).reshape(-1, 2)


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
        """Search for the cheapest way of an object to rest at an end, or to be held near the goal."""
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
