"""Plans joined in turns: what can be carried, and what is led over cells, out of each other's way.

On the page, what is led does not know that it must keep clear of what was carried. So what stands in the way
of what is led is carried out of it first, and the rest afterwards.
"""

import dataclasses
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.planners.planner import PlanResult, PlanStatus
from neurosym.problems import Problem, spot_name
from neurosym.tasks.task import GAP, LEAST_GAP, footprints_apart, near_some, understand, with_places
from neurosym.tasks.transition import PlanStep, validate

IN_TURNS = "joined from plans of what is carried and what is led over cells, in turns"
"""What is said of a plan that was made so."""
NEARER = 0.5
"""What is led is to come so near to its goal if others have no room else, as a share of the tolerance.

What makes way comes as near to where it is to wait, lest it be set down beside that, and in the way.
"""
BESIDE = 0.02
"""Room for the hand beside the way of what is led [m]."""
_CANDIDATES = 2000
_EDGE = 0.02  # how far inside the edge of the table objects are put aside [m]
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
    """What is asked, who plans the turns, and the names of the objects that can be carried.

    If the problem names places of its own, objects are carried to no others.
    """

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
            task = self._task(now, wanted, nearness)
            result = solve(task) if task.unmet else _NOTHING
            if result.status is not PlanStatus.SOLVED:
                return result
            checked = validate(result.steps, task, self.grounding)
            if not checked.valid:
                return PlanResult(PlanStatus.FAILED, (), 0.0, checked.reason)
            ends = zip(task.objects, map(vector, checked.positions[-1]), strict=True)
            moved = tuple(msgspec.structs.replace(item, position=end) for item, end in ends)
            steps, now = steps + result.steps, msgspec.structs.replace(task, objects=moved)
        checked = validate(steps, problem, self.grounding)
        if checked.valid:
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
            alone = self._task(msgspec.structs.replace(self.problem, objects=others, goals={}), led, near)
            way = self.lead(alone) if alone.unmet else _NOTHING
            if way.status is not PlanStatus.SOLVED:
                return way, {}
            path = validate(way.steps, alone, self.grounding).positions
            to_clear = _Way(path, alone.object_names, self.problem, self.grounding)
            before = to_clear.cleared(can_be, carried, everything=everything)
            if not (stuck := to_clear.in_the_way(can_be) - before.keys()):
                return way, before
            stays |= stuck

    def _task(self, now: Problem, goals: _Goals, near: float) -> Problem:
        tolerance = near * self.problem.tolerance
        return msgspec.structs.replace(now, goals=dict(goals), tolerance=tolerance)

    def _carried(self, task: Problem) -> PlanResult:
        """Carry objects, by way of places that suit where everything stands now, named by where they lie.

        Only places of the whole problem keep their names.
        """
        placed, printed = with_places(task, self.grounding), with_places(self.problem, self.grounding)
        result, spots = self.carry(placed), list[PlanStep]()
        for step in result.steps:
            if step.place and printed.places.get(step.place) != placed.place_named(step.place):
                step = dataclasses.replace(step, place=spot_name(*placed.place_named(step.place)))
            spots.append(step)
        # With these places there may be no plan, and one with others.
        is_open = result.status is PlanStatus.UNSOLVABLE
        status = PlanStatus.NOT_FOUND if is_open else result.status
        return dataclasses.replace(result, status=status, steps=tuple(spots))


@dataclass(frozen=True, eq=False)
class _Way:
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
        half = np.array(self.now.object_named(name).features[:2], dtype=float) / 2
        low, high = np.array([self.grounding.table.x, self.grounding.table.y]).T
        inside = np.minimum(half + _EDGE, (high - low) / 2)
        drawn = np.random.default_rng(0).uniform(size=(_CANDIDATES, 2))
        return np.asarray(low + inside + drawn * (high - low - 2 * inside))

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
