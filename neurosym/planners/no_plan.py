"""No plan is an answer: which goal cannot be met, why, and how near its object can come.

Some of it is proved: a goal is out of reach or off the table, however often primitives are done; two objects
would have to be in the air, while there is one hand; there is no room for two goals. The rest is what
counting saw (see `action_counts`), up to where it looked: then a plan was not found, and there may be one.

Two things bound where an object can come to be, however often it is moved. It stays in its room. And every
end at rest is the start plus a sum of displacements. If the goal lies beyond the cone of those sums, there
is a direction in which no displacement leads, and in which the goal is farther away than allowed (Farkas'
lemma). It is found by non-negative least squares, and then checked by itself.
"""

import dataclasses
import itertools
import math
from dataclasses import dataclass

import numpy as np

from neurosym.checks import Float
from neurosym.errors import counted, in_millimetres
from neurosym.grounding import Grounding
from neurosym.operators import Vector
from neurosym.planners.action_counts import (
    DEPTH,
    MOST_WORK,
    Choices,
    candidates,
    choices_of,
    looked_at,
    nearest,
    plan_counting,
)
from neurosym.planners.bfs import Branching, branching_of
from neurosym.planners.planner import Effort, Planner, PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.options import carriers_for
from neurosym.tasks.task import footprints_apart, is_relational
from neurosym.tasks.transition import primitives

MOST_PRIMITIVES = 1_000_000
"""Rounding is reckoned with for so many primitives."""
WORK_TO_COUNT = 40_000
"""How much counting looks at for a plan by the rehearsed effects, where the planner has none."""


def explain_no_plan(
    problem: Problem, grounding: Grounding, *, branching: Branching | None = None, depth: int | None = None
) -> tuple[str, bool]:
    """Say which goals cannot be met, and why, empty if nothing is known; and whether that is proved.

    What is predicted for each object may be given in place of what the live operators promise, and how many
    primitives the planner looks ahead.
    """
    found = _reaches(problem, grounding, branching)
    proved = {name for name, reach in found.items() if reach.is_impossible()}
    fewest = {name: None if name in proved else reach.fewest() for name, reach in found.items()}
    if out := [reach.explain(name in proved) for name, reach in found.items() if fewest[name] is None]:
        return "; ".join(out), bool(proved)
    if clash := explain_clash(problem, grounding, branching=branching):
        return clash, True
    needed = {name: count for name, count in fewest.items() if count}
    if depth is None or sum(needed.values()) <= depth:
        crowded = [(name, other) for name, other in _crowded(problem) if other not in problem.goals]
        ways = [f"{one} stands where {name} is to end; give {one} a goal elsewhere" for name, one in crowded]
        return "; ".join(ways[:1]), False
    only = f"only {depth} {'is' if depth == 1 else 'are'} looked at"
    if deep := [f"{name} {count}" for name, count in needed.items() if count > depth]:
        return f"too deep: {' and '.join(deep)} primitives away from the goal, and {only}", False
    each = " and ".join(f"{name} {count}" for name, count in needed.items())
    together = f"together they take {sum(needed.values())} primitives ({each}), and {only}"
    return f"too deep: each goal can be reached alone, but {together}", False


def explain_clash(problem: Problem, grounding: Grounding, *, branching: Branching | None = None) -> str:
    """Say which goals provably cannot be met together, however objects move; empty if none are known.

    What is predicted for each object may be given in place of what the live operators promise.
    """
    heights = {item.name: item.position[2] for item in problem.objects}
    high = [name for name, goal in problem.goals.items() if abs(goal[2] - heights[name]) > problem.tolerance]
    if len(high) < 2 and not _crowded(problem):
        return ""
    found = _reaches(problem, grounding, branching)
    if len(high := [name for name in high if found[name].must_be_held()]) > 1:
        return f"{' and '.join(high)} would have to be held at the end, and there is one hand"
    for name, other in _crowded(problem):
        if not all(found[one].must_rest() for one in (name, other) if one in found):
            continue
        if other in found:
            return f"there is no room for both {name} and {other}, so near are their goals"
        carriers = carriers_for(problem.object_named(other), grounding, problem.tolerance)
        table = branching or branching_of(problem, grounding)
        if not table.usable(problem.object_names.index(other)) and (branching or not carriers):
            return f"{other} stands where {name} is to end, and no primitive moves it"
    return ""


def look_again(
    result: PlanResult,
    problem: Problem,
    grounding: Grounding,
    planner: Planner,
    *,
    time_limit: float | None = None,
    goes_near: bool = False,
) -> PlanResult:
    """Where a planner says that there is no plan, say whether counting has one, or go as near as can be."""
    has_ended = result.status in (PlanStatus.UNSOLVABLE, PlanStatus.NOT_FOUND, PlanStatus.FAILED)
    is_open = planner.reads == "network" or result.status is not PlanStatus.UNSOLVABLE
    asks = goes_near or (is_open and not planner.is_exact)
    if is_relational(problem, grounding) or not has_ended or not asks:
        return result
    ceiling = math.inf if time_limit is None else time_limit
    work = MOST_WORK if goes_near else WORK_TO_COUNT
    found = plan_counting(problem, grounding, time_limit=ceiling, work=work, goes_near=goes_near)
    by_effects = f"by the {grounding.objects.effects}"
    if not goes_near:
        known = f"{by_effects} there is a plan of {counted(primitives(found.steps), 'primitive')}"
        said = f"{result.reason}; {known}: try another planner, say counting"
        return dataclasses.replace(result, reason=said) if found.has_plan else result
    if not found.has_plan:
        status = found.status if found.status is PlanStatus.TIMEOUT else result.status
        reason = f"{result.reason}; no plan to the nearest point: {found.reason}"
        return PlanResult(status, (), result.seconds + found.seconds, reason)
    if found.status is PlanStatus.NEAREST:
        return dataclasses.replace(found, reason=f"{found.reason}; {result.reason}")
    over = ", over what the network predicts," if planner.reads == "network" else ""
    return dataclasses.replace(
        found, reason=f"it meets the goal {by_effects}; {planner.name}{over} found none"
    )


def _reaches(problem: Problem, grounding: Grounding, branching: Branching | None) -> dict[str, "_Reach"]:
    """Say for each object with a goal what can be done to it."""
    rows = zip(problem.object_names, choices_of(problem, grounding, branching), strict=True)
    goals = problem.goals
    return {name: _Reach(name, one, goals[name], problem.tolerance) for name, one in rows if name in goals}


def _crowded(problem: Problem) -> list[tuple[str, str]]:
    """List objects with a goal, each with another that stands, or is to end, where it is to end.

    However both use the tolerance, they overlap, if the other without a goal stays where it is.
    """
    apart, names, goals, found = footprints_apart(problem), problem.object_names, problem.goals, []
    spots = [np.array(goals.get(item.name, item.position)[:2]) for item in problem.objects]
    slack = [problem.tolerance if name in goals else 0.0 for name in names]
    for one, other in itertools.combinations(range(len(names)), 2):
        if np.all(np.abs(spots[one] - spots[other]) + slack[one] + slack[other] < apart[one, other]):
            first, then = sorted((names[one], names[other]), key=lambda name: name not in goals)
            found += [(first, then)] if first in goals else []
    return found


@dataclass(frozen=True, slots=True, eq=False)
class _Reach:
    """One object, what can be done to it, and its goal [m]."""

    name: str
    choices: Choices
    goal: Vector
    tolerance: float

    def fewest(self) -> int | None:
        """Return how many primitives bring the object to its goal, or None if none were found to."""
        found = next(candidates(self.choices, self.goal, self.tolerance, Effort(MOST_WORK)), None)
        return None if found is None else len(found.moves)

    def is_impossible(self) -> bool:
        """Say whether it is proved that the object cannot meet its goal."""
        is_met = math.dist(self.choices.start, self.goal) <= self.tolerance
        return not is_met and (self.is_off_table() or (self.must_be_held() and self.must_rest()))

    def must_be_held(self) -> bool:
        """Say whether it is proved that the object cannot meet its goal at rest, on the table or anywhere."""
        return self._is_beyond(np.zeros(3))

    def must_rest(self) -> bool:
        """Say whether it is proved that no lift can end at the goal."""
        return all(map(self._is_beyond, self.choices.lifted[self.choices.held]))

    def is_off_table(self) -> bool:
        """Say whether the object would have to leave its room to come near enough to its goal."""
        spot = np.array(self.goal[:2])
        return bool(np.linalg.norm(spot - np.clip(spot, *self.choices.room)) > self.tolerance)

    def _is_beyond(self, last: Float[np.ndarray, "3"]) -> bool:
        """Say whether the goal is too far from all sums of moves, each with a last displacement."""
        moves, away = self.choices.settled, np.array(self.goal) - self.choices.start - last
        gap = away
        if len(moves):
            from scipy.optimize import nnls

            gap = away - moves.T @ nnls(moves.T, away)[0]
        distance = float(np.linalg.norm(gap))
        if distance <= self.tolerance:
            return False
        direction = gap / distance
        along = max(0.0, float(np.max(moves @ direction, initial=0.0)))
        return float(direction @ away) - MOST_PRIMITIVES * along > self.tolerance

    def explain(self, is_proved: bool) -> str:
        """Say why the goal cannot be met, or where it was looked for in vain."""
        depth, _ = looked_at(self.choices, DEPTH)
        near = in_millimetres(nearest(self.choices, self.goal).miss, self.tolerance)
        allowed = f"{near} from it, {1000 * self.tolerance:g} mm are allowed"
        if is_proved:
            why = " without leaving the table" if self.is_off_table() else ": out of every primitive's reach"
            said = f"{self.name} cannot reach its goal{why}"
        else:
            steps, vectors = looked_at(self.choices)
            said = f"{self.name} was not brought to its goal by up to {steps} primitives"
            said += f" ({vectors:,} combinations looked at)"
        return f"{said}; up to {depth} primitives bring it to {allowed}"
