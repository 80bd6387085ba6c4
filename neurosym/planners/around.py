"""Ways around each other: one object after another is brought to its goal, each around where the others are.

A plan for one object alone may lead it through others. So each way is searched for among footprints (`ways`).
The order of the objects is searched for depth first; an object that keeps others from their goals in every
order is first put aside. Each way is the cheapest there is to within a cell; all together they need not be.
"""

import dataclasses
import math
from collections.abc import Hashable, Iterator
from dataclasses import dataclass, field

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.pddl.chances import expected_success
from neurosym.planners.branching import branching_of
from neurosym.planners.cost_to_go import CostToGo, cost_to_go
from neurosym.planners.count_vectors import Choices
from neurosym.planners.effort import PLACE, Effort
from neurosym.planners.joins import choices_of
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.planners.ways import HeldEnd, IsEnd, Way, cheapest_way
from neurosym.problems import Problem
from neurosym.tasks.footprints import footprints_apart
from neurosym.tasks.moves import PUT_DOWN
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import validate

WORK = 150_000
"""How many places are looked at in all."""
ASIDE = 2
"""How many objects are put aside at most."""
NEARER = (1.0, 0.75, 0.5)
"""How near to the middle of its goal an object is to end, as shares of what is allowed."""


_State = tuple[Float[np.ndarray, "M 3"], frozenset[int], tuple[PlanStep, ...]]
"""Where the objects are [m], who has still to be moved, and the steps so far."""


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


def plan_likeliest(problem: Problem, grounding: Grounding, *, deadline: float = math.inf) -> PlanResult:
    """Find the likeliest to come true of the cheapest and the shortest plans to ever smaller goals.

    The cheapest plan ends where it happens to, often at the edge of what is allowed.

    Args:
        problem: The problem.
        grounding: The learned domain.
        deadline: When the user's time is up, by `time.perf_counter()` [s].

    Raises:
        TimeIsUp: If the deadline passes.
    """
    without_costs = msgspec.structs.replace(grounding, unit_costs=True)
    results = [
        plan_around(
            msgspec.structs.replace(problem, tolerance=share * problem.tolerance), by, deadline=deadline
        )
        for share in NEARER
        for by in (grounding, without_costs)
    ]
    solved = [result for result in results if result.status is PlanStatus.SOLVED]
    best = max(solved, key=lambda one: expected_success(one.steps, problem, grounding), default=results[0])
    return dataclasses.replace(best, work=sum(result.work for result in results))


@dataclass(slots=True)
class _Search:
    """The search for an order of the objects, and for their ways."""

    problem: Problem
    grounding: Grounding
    effort: Effort
    choices: tuple[Choices, ...] = field(init=False)
    names: list[list[str]] = field(init=False)
    goals: Float[np.ndarray, "M 3"] = field(init=False)
    apart: Float[np.ndarray, "M M 2"] = field(init=False)
    to_go: dict[tuple[int, bool], CostToGo] = field(default_factory=dict)
    known: dict[Hashable, tuple[Way | None, int]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        branching, names = branching_of(self.problem, self.grounding)
        self.choices = choices_of(self.problem, branching, self.grounding, names)
        rows = range(len(self.problem.objects))
        self.names = [[names[row][column] for column in branching.usable(row)] for row in rows]
        self.goals = self.problem.goal_positions()
        self.apart = footprints_apart(self.problem)

    def plans(self) -> Iterator[tuple[PlanStep, ...]]:
        """List plans: with nobody put aside first, and then with ever more objects put aside."""
        start = self.problem.scene().positions
        todo = frozenset(np.flatnonzero(np.isfinite(self.goals[:, 0])).tolist())
        for aside in range(ASIDE + 1):
            yield from self._from((start, todo, ()), aside)

    def _from(self, state: _State, aside: int) -> Iterator[tuple[PlanStep, ...]]:
        """List the plans from a state on, in which exactly so many objects are put aside."""
        here, todo, steps = state
        if not todo:
            if aside == 0:
                yield steps
            return
        blocked = []
        for row in self._nearest_first(here, todo):
            if self.effort.is_used_up:
                return
            way = self._to_goal(row, here, todo, may_hold=len(todo) == 1)
            if way:
                yield from self._from(self._after(state, row, way, is_done=True), aside)
            else:
                blocked.append(row)
        for row in blocked if aside else ():
            yield from self._from_aside(state, row, aside)

    def _from_aside(self, state: _State, row: int, aside: int) -> Iterator[tuple[PlanStep, ...]]:
        """List the plans in which somebody makes way for an object that is blocked."""
        here, todo, _ = state
        wanted = self._to_goal(row, here, todo, may_hold=len(todo) == 1, alone=True)
        if wanted is None:
            return
        path = np.array([*wanted.places, self.goals[row]])[:, :2]
        for other in sorted(todo - {row}):
            if self.effort.is_used_up or not self._stands_on(path, row, here[other], other):
                continue
            if way := self._out_of(path, row, other, here):
                yield from self._from(self._after(state, other, way, is_done=False), aside - 1)

    def _nearest_first(self, here: Float[np.ndarray, "M 3"], todo: frozenset[int]) -> list[int]:
        return sorted(todo, key=lambda row: (float(np.linalg.norm(here[row] - self.goals[row])), row))

    def _to_goal(
        self,
        row: int,
        here: Float[np.ndarray, "M 3"],
        todo: frozenset[int],
        *,
        may_hold: bool,
        alone: bool = False,
    ) -> Way | None:
        """Return a way of an object to its goal, and count what finding it took; it is searched for once."""
        case = (row, here.tobytes(), todo, may_hold, alone)
        if case in self.known:
            way, took = self.known[case]
            return way if self.effort.spend(took) else None
        before = self.effort.spent
        way = self._search_to_goal(row, here, todo, may_hold=may_hold, alone=alone)
        self.known[case] = (way, self.effort.spent - before)
        return way

    def _search_to_goal(
        self, row: int, here: Float[np.ndarray, "M 3"], todo: frozenset[int], *, may_hold: bool, alone: bool
    ) -> Way | None:
        """Search for a way of an object to its goal; one that keeps off the goals of others, if there is."""
        goal, tolerance = self.goals[row], self.problem.tolerance
        others = [other for other in todo if other != row]

        def is_near(place: Float[np.ndarray, "3"]) -> bool:
            return bool(np.linalg.norm(place - goal) <= tolerance)

        def is_clear(place: Float[np.ndarray, "3"]) -> bool:
            off = np.abs(self.goals[others, :2] - place[:2])
            return is_near(place) and not bool(np.any(np.all(off < self.apart[row, others], axis=-1)))

        for is_end in (is_clear, is_near) if others else (is_near,):
            if way := self._way(row, here, is_end, goal, may_hold=may_hold, alone=alone):
                return way
        return None

    def _out_of(
        self, path: Float[np.ndarray, "n 2"], row: int, other: int, here: Float[np.ndarray, "M 3"]
    ) -> Way | None:
        """Search for the cheapest way of an object out of another's path, and off everybody's goal."""
        wanted = [one for one in np.flatnonzero(np.isfinite(self.goals[:, 0])).tolist() if one != other]

        def is_end(place: Float[np.ndarray, "3"]) -> bool:
            off = np.abs(self.goals[wanted, :2] - place[:2])
            on_goals = bool(np.any(np.all(off < self.apart[other, wanted], axis=-1)))
            return not on_goals and not self._stands_on(path, row, place, other)

        return self._way(other, here, is_end, None)

    def _stands_on(
        self, path: Float[np.ndarray, "n 2"], row: int, place: Float[np.ndarray, "3"], other: int
    ) -> bool:
        return bool(np.any(np.all(np.abs(path - place[:2]) < self.apart[row, other], axis=-1)))

    def _way(
        self,
        row: int,
        here: Float[np.ndarray, "M 3"],
        is_end: IsEnd,
        goal: Float[np.ndarray, "3"] | None,
        *,
        may_hold: bool = False,
        alone: bool = False,
    ) -> Way | None:
        """Search for the cheapest way of an object to an end, among the others unless it is alone."""
        others = np.zeros(0, dtype=int) if alone else np.delete(np.arange(len(here)), row)
        far, in_the_way = self._far(row, goal, may_hold=may_hold), (here[others, :2], self.apart[row, others])
        held_end = HeldEnd(goal, self.problem.tolerance) if may_hold and goal is not None else None
        return cheapest_way(self.choices[row], here[row], in_the_way, is_end, far, self.effort, held_end)

    def _far(self, row: int, goal: Float[np.ndarray, "3"] | None, *, may_hold: bool) -> CostToGo:
        """Return what it costs an object to go on to its goal."""
        if goal is None:
            return lambda _: 0.0
        if (row, may_hold) not in self.to_go:
            tolerance = self.problem.tolerance
            self.to_go[row, may_hold] = cost_to_go(self.choices[row], goal, tolerance, may_hold=may_hold)
        return self.to_go[row, may_hold]

    def _after(self, state: _State, row: int, way: Way, *, is_done: bool) -> _State:
        here, todo, steps = state
        after = here.copy()
        after[row] = way.places[-1]
        name, made = self.problem.object_names[row], list[PlanStep]()
        for move in way.moves:
            made.append(PlanStep(self.names[row][move], name))
            if self.choices[row].held[move]:
                made.append(PlanStep(PUT_DOWN + self.names[row][move], name))
        if way.held:
            made.pop()
        return after, todo - {row} if is_done else todo, (*steps, *made)
