"""No plan is an answer: which goal cannot be met, why, and how near its object can come.

Some of it is proved: a goal is out of reach or off the table, however often primitives are done; two objects
would have to be in the air, while there is one hand; there is no room at a goal. The rest is what counting
saw (see `counting`), up to where it looked: then a plan was not found, and there may be one.

Two things bound where an object can come to be, however often it is moved. It stays in its room. And every
end at rest is the start plus a sum of displacements. If the goal lies beyond the cone of those sums, there
is a direction in which no displacement leads, and in which the goal is farther away than allowed (Farkas'
lemma). It is found by non-negative least squares, and then checked by itself.
"""

import dataclasses
import itertools
import math
from dataclasses import dataclass
from typing import NamedTuple

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
    plan_nearest,
)
from neurosym.planners.bfs import Branching, branching_of
from neurosym.planners.planner import Effort, Planner, PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.options import carriers_for
from neurosym.tasks.supports import is_relational
from neurosym.tasks.task import footprints_apart
from neurosym.tasks.transition import primitives

MOST_PRIMITIVES = 1_000_000
"""Rounding is reckoned with for so many primitives."""
WORK_TO_COUNT = 40_000
"""How much counting looks at for a plan by the rehearsed effects, where the planner has none."""


class Explanation(NamedTuple):
    """Why there is no plan.

    Attributes:
        reason: Why, in words; empty if nothing is known to stand against a plan.
        is_proved: Whether it proves that there is none.
    """

    reason: str
    is_proved: bool = False


def explain_no_plan(
    problem: Problem, grounding: Grounding, *, branching: Branching | None = None, depth: int | None = None
) -> Explanation:
    """Say which goals cannot be met, and why.

    Args:
        problem: The problem.
        grounding: The learned domain.
        branching: What is predicted for each object; what the live operators promise, if not given.
        depth: How many primitives the planner looks ahead, if it is limited.
    """
    found = _reaches(problem, grounding, branching)
    proved = {name: reach.is_impossible() for name, reach in found.items()}
    fewest = {name: None if proved[name] else reach.fewest() for name, reach in found.items()}
    if out := [reach.explain(proved[name]) for name, reach in found.items() if fewest[name] is None]:
        return Explanation("; ".join(out), any(proved.values()))
    if clash := explain_clash(problem, grounding, branching=branching):
        return Explanation(clash, True)
    needed = {name: count for name, count in fewest.items() if count}
    if depth is None or sum(needed.values()) <= depth:
        return Explanation(_in_the_way(problem, found))
    only = f"only {depth} {'is' if depth == 1 else 'are'} looked at"
    if deep := [f"{name} {count}" for name, count in needed.items() if count > depth]:
        return Explanation(f"too deep: {' and '.join(deep)} primitives away from the goal, and {only}")
    each = " and ".join(f"{name} {count}" for name, count in needed.items())
    return Explanation(
        f"too deep: each goal can be reached alone, but together they take {sum(needed.values())} primitives "
        f"({each}), and {only}"
    )


def explain_clash(problem: Problem, grounding: Grounding, *, branching: Branching | None = None) -> str:
    """Say which goals provably cannot be met together, however objects move; empty if none are known.

    Args:
        problem: The problem.
        grounding: The learned domain.
        branching: As in `explain_no_plan`.
    """
    high = [
        name
        for name, goal in problem.goals.items()
        if abs(goal[2] - problem.object_named(name).position[2]) > problem.tolerance
    ]
    crowded = _crowded(problem)
    if len(high) < 2 and not crowded:
        return ""
    found = _reaches(problem, grounding, branching)
    if len(high := [name for name in high if found[name].must_be_held()]) > 1:
        return f"{' and '.join(high)} would have to be held at the end, and there is one hand"
    for name, other in crowded:
        rests = all(found[one].must_rest() for one in (name, other) if one in found)
        if rests and other in problem.goals:
            return f"there is no room for both {name} and {other}, so near are their goals"
        if rests and other not in problem.goals and _never_moves(problem, other, grounding, branching):
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
    """Where there is no plan, say whether counting has one, or go as near to the goal as can be.

    Args:
        result: What the planner says.
        problem: The problem.
        grounding: The learned domain.
        planner: The planner.
        time_limit: The user's ceiling [s]; none if not given.
        goes_near: Whether to plan to the nearest points that can be reached instead.
    """
    has_ended = result.status in (PlanStatus.UNSOLVABLE, PlanStatus.NOT_FOUND, PlanStatus.FAILED)
    if is_relational(problem, grounding) or not has_ended:
        return result
    if goes_near:
        ceiling = math.inf if time_limit is None else time_limit
        return _nearest(result, plan_nearest(problem, grounding, time_limit=ceiling), grounding, planner)
    is_open = planner.reads == "network" or result.status is not PlanStatus.UNSOLVABLE
    if planner.is_exact or not is_open:
        return result
    found = plan_counting(problem, grounding, work=WORK_TO_COUNT)
    if found.status is not PlanStatus.SOLVED:
        return result
    count = counted(primitives(found.steps), "primitive")
    known = f"by the {grounding.operators.effects} there is a plan of {count}"
    return dataclasses.replace(result, reason=f"{result.reason}; {known}: try another planner, say counting")


def _nearest(none: PlanResult, found: PlanResult, grounding: Grounding, planner: Planner) -> PlanResult:
    """Keep saying why the planner had no plan that comes nearer."""
    if not found.has_plan:
        status = found.status if found.status is PlanStatus.TIMEOUT else none.status
        return PlanResult(status, (), none.seconds + found.seconds, f"{none.reason}; {found.reason}")
    if found.status is PlanStatus.NEAREST:
        return dataclasses.replace(found, reason=f"{found.reason}; {none.reason}")
    over = ", over what the network predicts," if planner.reads == "network" else ""
    said = f"it meets the goal by the {grounding.operators.effects}; {planner.name}{over} found none"
    return dataclasses.replace(found, reason=said)


def _reaches(problem: Problem, grounding: Grounding, branching: Branching | None) -> dict[str, "_Reach"]:
    """Say for each object with a goal what can be done to it."""
    rows = zip(problem.object_names, choices_of(problem, grounding, branching), strict=True)
    goals = problem.goals
    return {name: _Reach(name, one, goals[name], problem.tolerance) for name, one in rows if name in goals}


def _never_moves(problem: Problem, name: str, grounding: Grounding, branching: Branching | None) -> bool:
    """Say whether nothing is known to be done to an object."""
    if branching is None and carriers_for(problem.object_named(name), grounding, problem.tolerance):
        return False
    table = branching or branching_of(problem, grounding)
    return not table.usable(problem.object_names.index(name))


def _crowded(problem: Problem) -> list[tuple[str, str]]:
    """List objects with a goal, each with another that stands, or is to end, where it is to end.

    However both use the tolerance, they overlap, if the other without a goal stays where it is.
    """
    apart, names = footprints_apart(problem), problem.object_names
    spots = {item.name: (item.position, 0.0) for item in problem.objects}
    spots |= {name: (goal, problem.tolerance) for name, goal in problem.goals.items()}
    found = []
    for one, other in itertools.combinations(range(len(names)), 2):
        pair = sorted((names[one], names[other]), key=lambda name: name not in problem.goals)
        if pair[0] in problem.goals:
            (here, slack), (there, more) = spots[pair[0]], spots[pair[1]]
            most = np.abs(np.array(here[:2]) - there[:2]) + slack + more
            if np.all(most < apart[one, other]):
                found.append((pair[0], pair[1]))
    return found


def _in_the_way(problem: Problem, found: dict[str, "_Reach"]) -> str:
    """Say which object without a goal stands where another is to end, if one does."""
    for name, other in _crowded(problem):
        if other not in problem.goals and found[name].must_rest():
            return f"{other} stands where {name} is to end; give {other} a goal elsewhere"
    return ""


@dataclass(frozen=True, slots=True, eq=False)
class _Reach:
    """One object, what can be done to it, and its goal [m]."""

    name: str
    choices: Choices
    goal: Vector
    tolerance: float

    @property
    def is_met(self) -> bool:
        """Whether the object is at its goal already."""
        return math.dist(self.choices.start, self.goal) <= self.tolerance

    def fewest(self) -> int | None:
        """Return how many primitives bring the object to its goal, or None if none were found to."""
        found = next(candidates(self.choices, self.goal, self.tolerance, Effort(MOST_WORK)), None)
        return None if found is None else len(found.moves)

    def is_impossible(self) -> bool:
        """Say whether it is proved that the object cannot meet its goal."""
        return not self.is_met and (self.is_off_table() or self.is_out_of_reach())

    def must_be_held(self) -> bool:
        """Say whether it is proved that the object cannot meet its goal at rest."""
        return not self.is_met and self.is_out_of_reach(at_rest=True)

    def must_rest(self) -> bool:
        """Say whether it is proved that no lift can end at the goal."""
        ends = map(self.choices.ending_with, np.flatnonzero(self.choices.held).tolist())
        return all(_Reach(self.name, one, self.goal, self.tolerance).is_out_of_reach() for one in ends)

    def is_off_table(self) -> bool:
        """Say whether the object would have to leave its room to come near enough to its goal."""
        spot = np.array(self.goal[:2])
        return bool(np.linalg.norm(spot - np.clip(spot, *self.choices.room)) > self.tolerance)

    def is_out_of_reach(self, *, at_rest: bool = False) -> bool:
        """Say whether it is proved that the object cannot come near enough, on the table or anywhere."""
        away = np.array(self.goal) - self.choices.start
        lifts = np.zeros((0, 3)) if at_rest else self.choices.lifted[self.choices.held]
        ends = (away - lift for lift in (np.zeros(3), *lifts))
        return all(_is_beyond(self.choices.settled, end, self.tolerance) for end in ends)

    def explain(self, is_proved: bool) -> str:
        """Say why the goal cannot be met, or where it was looked for in vain."""
        depth, _ = looked_at(self.choices, DEPTH)
        near = in_millimetres(nearest(self.choices, self.goal).miss, self.tolerance)
        allowed = f"{near} from it, {1000 * self.tolerance:g} mm are allowed"
        if is_proved and not self.is_off_table():
            said = f"{self.name} cannot reach its goal: out of every primitive's reach"
        elif is_proved:
            said = f"{self.name} cannot reach its goal without leaving the table"
        else:
            steps, vectors = looked_at(self.choices)
            anywhere = nearest(self.choices, self.goal, anywhere=True).miss <= self.tolerance
            said = f"{self.name} was not brought to its goal by up to {steps} primitives"
            said += " without leaving the table" if anywhere else ""
            said += f" ({vectors:,} combinations looked at)"
        return f"{said}; up to {depth} primitives bring it to {allowed}"


def _is_beyond(moves: Float[np.ndarray, "k 3"], away: Float[np.ndarray, "3"], tolerance: float) -> bool:
    """Say whether a point is farther than a tolerance from all sums of moves."""
    gap = away
    if len(moves):
        from scipy.optimize import nnls

        gap = away - moves.T @ nnls(moves.T, away)[0]
    distance = float(np.linalg.norm(gap))
    if distance <= tolerance:
        return False
    direction = gap / distance
    along = max(0.0, float(np.max(moves @ direction, initial=0.0)))
    return float(direction @ away) - MOST_PRIMITIVES * along > tolerance
