"""Planning with places: objects that can be carried are, and only the others are led over cells, in turns.

A plan for all at once does not know that what is led must keep clear of what was carried. So a way is looked
for as if there were nothing that can be carried; what stands in it is carried out of it, and then it is free.
"""

import dataclasses
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice, permutations

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.planners.planner import PlanResult, PlanStatus
from neurosym.problems import Problem, spot_name
from neurosym.tasks.task import (
    GAP,
    LEAST_GAP,
    PARK,
    footprints_apart,
    near_some,
    overlapping,
    understand,
    with_places,
)
from neurosym.tasks.transition import PlanStep, validate
from neurosym.world import Table

NEARER = 0.5
"""What is led is to come so near to its goal if others have no room else, as a share of the tolerance.

What makes way comes as near to where it is to wait, lest it be set down beside that, and in the way.
"""
ENOUGH = 0.08
"""Room beside an object along y, along which the fingers open, beyond which more makes no difference [m]."""
FINGER = 0.02
"""An object that leaves so much room along x is not in the way of the fingers [m]."""
MOST_LED = 4
"""Objects that could be carried are led over cells, where no plan carries them, if there are no more.

With eight, the search for such a plan took tens of seconds, though some of them had no goal.
"""
MOST_ORDERS = 6
"""In how many orders objects are led one after another at most, where all ways at once cannot be cleared."""
IN_TURNS = "joined from plans of what is carried and what is led over cells, in turns"
"""What is said of a plan that was made so."""
BESIDE = 0.02
"""Room for the hand beside the way of what is led [m]."""
_CANDIDATES = 2000
_EDGE = 0.02  # how far inside the edge of the table objects are put aside [m]
_Spots = Float[np.ndarray, "N 2"]
_Solve = Callable[[Problem], PlanResult]
_Goals = Mapping[str, Vector]
_Turn = tuple[PlanResult, Problem]
"""A plan, and the problem with the objects where the plan leads them."""


def is_by_places(problem: Problem, grounding: Grounding) -> bool:
    """Say whether some object of a problem can be carried to its goal."""
    if not (grounding.is_refined and grounding.carriers):
        return False
    return any(name in problem.goals for name in understand(problem, grounding).carried)


def plan_by_places(
    problem: Problem, grounding: Grounding, solve: Callable[[Problem], PlanResult]
) -> PlanResult:
    """Plan for all objects at once, by whoever plans with places, and believe a plan that is true."""
    problem = understand(problem, grounding).flat
    result = solve(problem)
    if result.status is PlanStatus.UNSOLVABLE:
        return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=_why_none(problem))
    if result.status is not PlanStatus.SOLVED:
        return result
    checked = validate(result.steps, problem, grounding)
    if checked.valid:
        return dataclasses.replace(result, steps=_carefully(result.steps, problem, grounding))
    reason = f"the plan with places is not true when replayed: {checked.reason}"
    return dataclasses.replace(result, status=PlanStatus.FAILED, steps=(), reason=reason)


def _why_none(problem: Problem) -> str:
    """Say with which places there is no plan; with others there may be one."""
    parks = sum(name.startswith(PARK) for name in problem.places)
    return f"there is no plan with the places of the problem, of which {parks} are free to park on"


def _carefully(steps: tuple[PlanStep, ...], problem: Problem, grounding: Grounding) -> tuple[PlanStep, ...]:
    """Carry first what has most room, if nothing else is done and the plan stays true."""
    if not all(step.place for step in steps):
        return steps
    ordered = clearest_first(steps, problem)
    return ordered if validate(ordered, problem, grounding).valid else steps


def clearest_first(steps: Sequence[PlanStep], problem: Problem) -> tuple[PlanStep, ...]:
    """Put steps that carry in another order: first what has most room where it stands and where it goes.

    Steps with one object keep their order, and no object is carried to where another stands. If there is no
    such order, nothing is changed.
    """
    names, apart = problem.object_names, footprints_apart(problem)
    here = problem.scene().positions[:, :2].copy()
    left, ordered = list(steps), list[PlanStep]()
    while left:
        rooms: list[tuple[float, int]] = []
        for number, step in enumerate(left):
            row = names.index(step.object)
            if any(earlier.object == step.object for earlier in left[:number]):
                continue
            there = np.array(problem.place_named(step.place))
            others = np.arange(len(names)) != row
            if overlapping(there, here[others], apart[row, others]).any():
                continue
            gap = min(_gap(spot, here[others], apart[row, others]) for spot in (here[row], there))
            rooms.append((-min(gap, ENOUGH), number))
        if not rooms:
            return tuple(steps)
        step = left.pop(min(rooms)[1])
        here[names.index(step.object)] = problem.place_named(step.place)
        ordered.append(step)
    return tuple(ordered)


def _gap(
    spot: Float[np.ndarray, "2"], others: Float[np.ndarray, "M 2"], apart: Float[np.ndarray, "M 2"]
) -> float:
    """Return the room along y between the footprint of an object and the next in the fingers' way [m]."""
    room = np.abs(others - spot) - apart
    return float(room[room[:, 0] < FINGER, 1].min(initial=np.inf))


def not_proved(result: PlanResult) -> PlanResult:
    """Say of what has no plan over cells that it was not found: something could have been carried."""
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    reason = f"no plan with the places that were drawn; without: {result.reason or 'unsolvable'}"
    return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=reason)


def not_found(result: PlanResult) -> PlanResult:
    """Say that there is no plan with the places that were drawn, and none over cells was looked for."""
    if result.status is PlanStatus.TIMEOUT:
        return result
    said = result.reason or "no plan with the places that were drawn"
    reason = f"{said}; among more than {MOST_LED} objects, none is led over cells that could be carried"
    return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, steps=(), reason=reason)


def plan_in_turns(problem: Problem, grounding: Grounding, carry: _Solve, lead: _Solve) -> PlanResult:
    """Carry what stands in the way of what must be led, then lead this, and then carry the rest.

    At first all ways are cleared at once, and what has its goal beside them is carried there before; or only
    what stands in them. If that fails, one object is led after another, each way cleared when it is needed.
    If that fails, and there are few objects, they are led around all others as they stand. What cannot be led
    to its goal even alone has no plan.

    Args:
        problem: The problem.
        grounding: The learned domain.
        carry: Plans for objects that can be carried.
        lead: Plans for others.
    """
    can_be = understand(problem, grounding).carried
    carried = {name: goal for name, goal in problem.goals.items() if name in can_be}
    led = {name: goal for name, goal in problem.goals.items() if name not in can_be}
    result = PlanResult(PlanStatus.FAILED, (), 0.0, "everything that has a goal can be carried")
    if not led:
        return result
    turns = _Turns(problem, grounding, _once(carry), _once(lead), can_be, carried)
    for result in turns.plans(led):
        if result.status in (PlanStatus.SOLVED, PlanStatus.UNSOLVABLE):
            return result
    return result


@dataclass(frozen=True, slots=True)
class _Turns:
    """What is asked, and who plans the turns.

    Attributes:
        problem: The problem; if it names places of its own, objects are carried to no others.
        grounding: The learned domain.
        carry: Plans for objects that can be carried.
        lead: Plans for others.
        can_be: Names of the objects that can be carried.
        carried: Goals of those among them that have one.
    """

    problem: Problem
    grounding: Grounding
    carry: _Solve
    lead: _Solve
    can_be: Sequence[str]
    carried: _Goals

    def plans(self, led: _Goals) -> Iterator[PlanResult]:
        """List what becomes of one attempt after another to lead objects to their goals."""
        for everything in (True, False):
            yield self._rounds((led,), 1.0, everything=everything)
        yield self._rounds((led,), NEARER, everything=False)
        for order in islice(permutations(self._nearest_first(led)), MOST_ORDERS) if len(led) > 1 else ():
            yield self._rounds([{name: led[name]} for name in order], 1.0, everything=False)
        if len(self.problem.objects) <= MOST_LED:
            task = self._task(self.problem, led)
            begun, now = self._after(self.lead(task), task)
            yield begun if begun.status is not PlanStatus.SOLVED else self._finished(begun, now)

    def _nearest_first(self, led: _Goals) -> list[str]:
        away = self.problem.distances(self.problem.scene().positions)
        return sorted(led, key=lambda name: (away[name], name))

    def _rounds(self, rounds: Sequence[_Goals], near: float, *, everything: bool) -> PlanResult:
        """Lead some objects after others, and then carry what is left to carry."""
        steps, now = tuple[PlanStep, ...](), self.problem
        for led in rounds:
            result, now = self._round(now, led, near, everything=everything)
            if result.status is not PlanStatus.SOLVED:
                return result
            steps += result.steps
        return self._finished(PlanResult(PlanStatus.SOLVED, steps, 0.0), now)

    def _finished(self, begun: PlanResult, now: Problem) -> PlanResult:
        """Carry what is left to carry, and believe the whole plan if it is true when replayed."""
        last, _ = self._carry(now, self.carried)
        if last.status is not PlanStatus.SOLVED:
            return last
        steps = (*begun.steps, *last.steps)
        checked = validate(steps, self.problem, self.grounding)
        if checked.valid:
            return dataclasses.replace(last, steps=steps, reason=IN_TURNS)
        return PlanResult(PlanStatus.FAILED, (), 0.0, checked.reason)

    def _round(self, now: Problem, led: _Goals, near: float, *, everything: bool) -> _Turn:
        """Look for a way, around what there is no room for elsewhere, then clear it and lead along it."""
        stays = frozenset[str]()
        while True:
            others = tuple(one for one in now.objects if one.name not in self.can_be or one.name in stays)
            alone = self._task(msgspec.structs.replace(now, objects=others, goals={}), led, near)
            way = self.lead(alone) if alone.unmet else PlanResult(PlanStatus.SOLVED, (), 0.0)
            if way.status is not PlanStatus.SOLVED:
                return way, now
            positions = validate(way.steps, alone, self.grounding).positions
            to_clear = _Way(positions, alone.object_names, now, self.grounding.table)
            can_be = [name for name in self.can_be if name not in stays]
            before = to_clear.cleared(can_be, self.carried, everything=everything)
            if not (stuck := to_clear.in_the_way(can_be) - before.keys()):
                break
            stays |= stuck
        first, begun = self._carry(now, before, NEARER)
        if first.status is not PlanStatus.SOLVED:
            return first, now
        return self._after(way, self._task(begun, led, near), first)

    def _task(self, now: Problem, goals: _Goals, near: float = 1.0) -> Problem:
        tolerance = near * self.problem.tolerance
        return msgspec.structs.replace(now, goals=dict(goals), tolerance=tolerance)

    def _carry(self, now: Problem, goals: _Goals, near: float = 1.0) -> _Turn:
        """Carry objects to some goals, by way of places that suit where everything stands now."""
        task = self._task(now, goals, near)
        if not task.unmet:
            return PlanResult(PlanStatus.SOLVED, (), 0.0), now
        placed, printed = with_places(task, self.grounding), with_places(self.problem, self.grounding)
        result = self.carry(placed)
        if result.status is PlanStatus.UNSOLVABLE:  # with these places; with others it may be
            result = dataclasses.replace(result, status=PlanStatus.NOT_FOUND)
        spots = tuple(_to_spot(step, placed, printed) for step in result.steps)
        return self._after(dataclasses.replace(result, steps=spots), task)

    def _after(self, result: PlanResult, task: Problem, first: PlanResult | None = None) -> _Turn:
        """Put a plan behind another, if it is true where that one ends."""
        if result.status is not PlanStatus.SOLVED:
            return result, task
        checked = validate(result.steps, task, self.grounding)
        if not checked.valid:
            return PlanResult(PlanStatus.FAILED, (), 0.0, checked.reason), task
        moved = zip(task.objects, map(vector, checked.positions[-1]), strict=True)
        objects = tuple(msgspec.structs.replace(item, position=end) for item, end in moved)
        steps = (*(first.steps if first else ()), *result.steps)
        return PlanResult(PlanStatus.SOLVED, steps, 0.0), msgspec.structs.replace(task, objects=objects)


def _once(solve: _Solve) -> _Solve:
    """Have each problem planned for only once: orders that begin alike share their first rounds."""
    known: dict[bytes, PlanResult] = {}

    def solved(problem: Problem) -> PlanResult:
        case = msgspec.json.encode(problem)
        if case not in known:
            known[case] = solve(problem)
        return known[case]

    return solved


def _to_spot(step: PlanStep, now: Problem, printed: Problem) -> PlanStep:
    """Name the place of a step by where it lies, unless it has its name in the whole problem, too."""
    if not step.place or printed.places.get(step.place) == now.place_named(step.place):
        return step
    return dataclasses.replace(step, place=spot_name(*now.place_named(step.place)))


@dataclass(frozen=True, eq=False)
class _Way:
    """The way of what is led, among objects that can be carried out of it.

    Attributes:
        path: Where what cannot be carried stands after each step [m].
        led: Names of these objects, in the order of the path.
        now: The problem with the objects where they stand when the way is to be cleared; objects wait at its
            places, or anywhere if it has none.
        table: Where objects may stand.
    """

    path: Float[np.ndarray, "steps L 3"]
    led: Sequence[str]
    now: Problem
    table: Table

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of all objects."""
        return self.now.object_names

    @cached_property
    def apart(self) -> Float[np.ndarray, "M M 2"]:
        """How far apart they must be [m]."""
        return footprints_apart(self.now)

    def cleared(self, can_be: Collection[str], goals: _Goals, *, everything: bool) -> dict[str, Vector]:
        """Return where objects are to be carried before anything is led along the way [m].

        What stands in the way goes to its goal if that is free and beside the way, and else aside, if there
        is room; the largest first. If everything shall, others with goals beside the way go there, too.
        """
        items, in_it = [one for one in self.now.objects if one.name in can_be], self.in_the_way(can_be)
        before = dict[str, Vector]()
        for item in sorted(items, key=lambda one: (-max(one.features[:2]), one.name)):
            is_in_it = item.name in in_it
            if not is_in_it and not everything:
                continue
            goal = goals.get(item.name)
            if goal and self._is_free(item.name, _spots(goal), before, BESIDE)[0]:
                before[item.name] = goal
            elif is_in_it and (spot := self._aside(item.name, before, goals)):
                before[item.name] = (*spot, item.position[2])
        return before

    def in_the_way(self, names: Collection[str]) -> set[str]:
        """Name those of some objects that stand in the way."""
        items = [item for item in self.now.objects if item.name in names]
        return {item.name for item in items if self._in_it(item.name, _spots(item.position))[0]}

    def _aside(self, name: str, moved: _Goals, goals: _Goals) -> tuple[float, float] | None:
        """Return a spot where an object can wait [m], off the goals of others if possible."""
        spots = self._candidates(name)
        others = [other for other in goals if other != name]
        wanted = np.array([goals[other][:2] for other in others]).reshape(-1, 2)
        rows = [self.names.index(other) for other in others]
        apart = self.apart[self.names.index(name), rows]
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
        half = np.array(self.now.object_named(name).features[:2], dtype=float) / 2
        low, high = np.array([self.table.x, self.table.y]).T
        inside = np.minimum(half + _EDGE, (high - low) / 2)
        drawn = np.random.default_rng(0).uniform(size=(_CANDIDATES, 2))
        return np.asarray(low + inside + drawn * (high - low - 2 * inside))

    def _is_free(self, name: str, spots: _Spots, moved: _Goals, gap: float) -> Bool[np.ndarray, " N"]:
        """Say at which spots an object is out of the way and clear of others, some of which were moved."""
        others = [row for row, other in enumerate(self.names) if other != name]
        here = _spots(*(moved.get(item.name, item.position) for item in self.now.objects))
        apart = self.apart[self.names.index(name), others] + gap
        return np.asarray(~(near_some(spots, here[others], apart) | self._in_it(name, spots)))

    def _in_it(self, name: str, spots: _Spots) -> Bool[np.ndarray, " N"]:
        """Say at which spots an object would stand in the way."""
        columns = [self.names.index(one) for one in self.led]
        apart = self.apart[self.names.index(name), columns] + BESIDE
        apart = np.broadcast_to(apart, (len(self.path), *apart.shape))  # (steps, L, 2)
        return near_some(spots, self.path[..., :2].reshape(-1, 2), apart.reshape(-1, 2))


def _spots(*positions: Sequence[float]) -> _Spots:
    return np.array([position[:2] for position in positions], dtype=float).reshape(-1, 2)
