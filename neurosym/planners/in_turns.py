"""Planning in turns for what can be carried and for what must be led over cells.

A plan for all at once does not know that what is led must keep clear of what was carried. So a way is looked
for as if there were nothing that can be carried; what stands in it is carried out of it, and then it is free.
"""

import dataclasses
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, permutations

import msgspec

from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.planners.by_places import MOST_LED
from neurosym.planners.making_way import Way
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.spots import spot_name
from neurosym.tasks.places import with_places
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import understand
from neurosym.tasks.transition import validate

NEARER = 0.5
"""What is led is to come so near to its goal if others have no room else, as a share of the tolerance.

What makes way comes as near to where it is to wait, lest it be set down beside that, and in the way.
"""
MOST_ORDERS = 6
"""In how many orders objects are led one after another at most, where all ways at once cannot be cleared."""
IN_TURNS = "joined from plans of what is carried and what is led over cells, in turns"
"""What is said of a plan that was made so."""
_Solve = Callable[[Problem], PlanResult]
_Goals = Mapping[str, Vector]
_Turn = tuple[PlanResult, Problem]
"""A plan, and the problem with the objects where the plan leads them."""


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
    turns = _Turns(problem, grounding, carry, lead, can_be, carried)
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
        ways: The ways that were looked for already.
        rounds: What was planned already.
    """

    problem: Problem
    grounding: Grounding
    carry: _Solve
    lead: _Solve
    can_be: Sequence[str]
    carried: _Goals
    ways: dict[bytes, PlanResult] = field(default_factory=dict)
    rounds: dict[bytes, _Turn] = field(default_factory=dict)

    def plans(self, led: _Goals) -> Iterator[PlanResult]:
        """List what becomes of one attempt after another.

        Args:
            led: Goals of the objects that must be led.
        """
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
            result, now = self._round_once(now, led, near, everything=everything)
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

    def _round_once(self, now: Problem, led: _Goals, near: float, *, everything: bool) -> _Turn:
        """Clear the way of some objects, and lead them; orders that begin alike share their first rounds."""
        case = msgspec.json.encode((now, led, near, everything))
        if case not in self.rounds:
            self.rounds[case] = self._round(now, led, near, everything=everything)
        return self.rounds[case]

    def _round(self, now: Problem, led: _Goals, near: float, *, everything: bool) -> _Turn:
        """Look for a way, around what there is no room for elsewhere, then clear it and lead along it."""
        stays = frozenset[str]()
        while True:
            others = tuple(one for one in now.objects if one.name not in self.can_be or one.name in stays)
            alone = self._task(msgspec.structs.replace(now, objects=others, goals={}), led, near)
            way = self._way(alone)
            if way.status is not PlanStatus.SOLVED:
                return way, now
            positions = validate(way.steps, alone, self.grounding).positions
            to_clear = Way(positions, alone.object_names, now, self.grounding.table)
            can_be = [name for name in self.can_be if name not in stays]
            before = to_clear.cleared(can_be, self.carried, everything=everything)
            if not (stuck := to_clear.in_the_way(can_be) - before.keys()):
                break
            stays |= stuck
        first, begun = self._carry(now, before, NEARER)
        if first.status is not PlanStatus.SOLVED:
            return first, now
        return self._after(way, self._task(begun, led, near), first)

    def _way(self, alone: Problem) -> PlanResult:
        """Look for a way of objects among those that cannot be carried."""
        if not alone.unmet:
            return PlanResult(PlanStatus.SOLVED, (), 0.0)
        case = msgspec.json.encode(alone)
        if case not in self.ways:
            self.ways[case] = self.lead(alone)
        return self.ways[case]

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


def _to_spot(step: PlanStep, now: Problem, printed: Problem) -> PlanStep:
    """Name the place of a step by where it lies, unless it has its name in the whole problem, too."""
    known = printed.places if isinstance(printed.places, dict) else {}
    if not step.place or known.get(step.place) == now.place_named(step.place):
        return step
    return dataclasses.replace(step, place=spot_name(*now.place_named(step.place)))
