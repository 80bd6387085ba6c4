"""No plan is an answer: which goal cannot be met, why, and how near its object can come.

Some of it is proved (see `impossible`): a goal is out of reach or off the table, however often primitives are
done; two objects would have to be in the air, while there is one hand; there is no room at a goal. The rest
is what counting saw (see `count_vectors`), up to where it looked: then a plan was not found, and there may
be one.
"""

import itertools
import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.operators import Vector
from neurosym.planners.branching import Branching, Names, branching_of
from neurosym.planners.count_vectors import Choices, candidates, looked_at, nearest
from neurosym.planners.counting import MOST_WORK
from neurosym.planners.effort import Effort, within
from neurosym.planners.impossible import is_off_table, is_out_of_reach
from neurosym.planners.joins import Join, choices_of
from neurosym.planners.ordering import mend
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.tasks.carriers import carriers_for
from neurosym.tasks.footprints import footprints_apart
from neurosym.wording import in_millimetres

DEPTH = 8
"""How many primitives with an object are looked at for how near it can come."""


class Explanation(NamedTuple):
    """Why there is no plan.

    Attributes:
        reason: Why, in words; empty if nothing is known to stand against a plan.
        is_proved: Whether it proves that there is none.
    """

    reason: str
    is_proved: bool = False


def explain_no_plan(
    problem: Problem,
    grounding: Grounding,
    *,
    branching: tuple[Branching, Names] | None = None,
    depth: int | None = None,
) -> Explanation:
    """Say which goals cannot be met, and why.

    Args:
        problem: The problem.
        grounding: The learned domain.
        branching: What is predicted for each object, and the operators' names; what the live operators
            promise, if not given.
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
        return Explanation(f"too deep: {_listed(deep)} primitives away from the goal, and {only}")
    return Explanation(
        f"too deep: each goal can be reached alone, but together they take {sum(needed.values())} primitives "
        f"({_listed([f'{name} {count}' for name, count in needed.items()])}), and {only}"
    )


def explain_clash(
    problem: Problem, grounding: Grounding, *, branching: tuple[Branching, Names] | None = None
) -> str:
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
        return f"{_listed(high)} would have to be held at the end, and there is one hand"
    for name, other in crowded:
        rests = [found[one].must_rest() for one in (name, other) if one in found]
        if other in problem.goals and all(rests):
            return f"there is no room for both {name} and {other}, so near are their goals"
        if other not in problem.goals and all(rests) and _never_moves(problem, other, grounding, branching):
            return f"{other} stands where {name} is to end, and no primitive moves it"
    return ""


def _reaches(
    problem: Problem, grounding: Grounding, branching: tuple[Branching, Names] | None
) -> dict[str, "_Reach"]:
    """Say for each object with a goal what can be done to it."""
    table, names = branching or branching_of(problem, grounding)
    rows = zip(problem.objects, choices_of(problem, table, grounding, names), strict=True)
    return {
        item.name: _Reach(item.name, choices, problem.goals[item.name], problem.tolerance)
        for item, choices in rows
        if item.name in problem.goals
    }


def _never_moves(
    problem: Problem, name: str, grounding: Grounding, branching: tuple[Branching, Names] | None
) -> bool:
    """Say whether nothing is known to be done to an object."""
    if branching is None and carriers_for(problem.object_named(name), grounding, problem.tolerance):
        return False
    table, _ = branching or branching_of(problem, grounding)
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


def plan_nearest(problem: Problem, grounding: Grounding, *, time_limit: float = math.inf) -> PlanResult:
    """Plan to the goals, where they can be reached, and else as near to them as objects come.

    Args:
        problem: The problem.
        grounding: The learned domain.
        time_limit: The user's ceiling [s].

    Returns:
        A plan that is solved, or nearest and says how far objects stay from their goals.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """

    def search(deadline: float) -> PlanResult:
        join = Join(problem, grounding, Effort(MOST_WORK, deadline), nearest_depth=DEPTH)
        for steps in join.plans():
            ordered, checked = mend(steps, problem, grounding, join.effort)
            if checked.valid:
                return PlanResult(PlanStatus.SOLVED, ordered, 0.0)
            if checked.possible:
                return PlanResult(PlanStatus.NEAREST, ordered, 0.0, _misses(problem, checked.positions[-1]))
            join.missed = checked.reason
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, f"no plan to the nearest point: {join.why_none()}")

    return within(time_limit, search)


def _misses(problem: Problem, ends: Float[np.ndarray, "M 3"]) -> str:
    allowed = problem.tolerance
    misses = problem.distances(ends).items()
    far = [f"{name} {in_millimetres(miss, allowed)}" for name, miss in misses if miss > allowed]
    goals = "its goal" if len(far) == 1 else "their goals"
    return f"at the end, {_listed(far)} from {goals}; up to {DEPTH} primitives with each were looked at"


@dataclass(frozen=True, slots=True, eq=False)
class _Reach:
    """One object and its goal."""

    name: str
    choices: Choices
    goal: Vector
    tolerance: float

    def fewest(self) -> int | None:
        """Return how many primitives bring the object to its goal, or None if none were found to."""
        effort = Effort(MOST_WORK)
        found = next(candidates(self.choices, self.goal, self.tolerance, effort), None)
        return None if found is None else len(found.moves)

    def is_impossible(self) -> bool:
        """Say whether it is proved that the object cannot meet its goal."""
        if math.dist(self.choices.start, self.goal) <= self.tolerance:
            return False
        place = (self.choices, self.goal, self.tolerance)
        return is_off_table(*place) or is_out_of_reach(*place)

    def must_be_held(self) -> bool:
        """Say whether it is proved that the object cannot meet its goal at rest."""
        if math.dist(self.choices.start, self.goal) <= self.tolerance:
            return False
        return is_out_of_reach(self.choices, self.goal, self.tolerance, at_rest=True)

    def must_rest(self) -> bool:
        """Say whether it is proved that no lift can end at the goal."""
        lifts = np.flatnonzero(self.choices.held).tolist()
        return all(
            is_out_of_reach(self.choices.ending_with(lift), self.goal, self.tolerance) for lift in lifts
        )

    def explain(self, is_proved: bool) -> str:
        """Say why the goal cannot be met, or where it was looked for in vain."""
        depth, _ = looked_at(self.choices, DEPTH)
        near = in_millimetres(nearest(self.choices, self.goal, depth=DEPTH).miss, self.tolerance)
        allowed = f"{near} from it, {1000 * self.tolerance:g} mm are allowed"
        anywhere = nearest(self.choices, self.goal, depth=DEPTH, anywhere=True).miss <= self.tolerance
        if is_proved and not is_off_table(self.choices, self.goal, self.tolerance):
            said = f"{self.name} cannot reach its goal: out of every primitive's reach"
        elif is_proved:
            said = f"{self.name} cannot reach its goal without leaving the table"
        else:
            steps, vectors = looked_at(self.choices)
            said = f"{self.name} was not brought to its goal by up to {steps} primitives"
            said += " without leaving the table" if anywhere else ""
            said += f" ({vectors:,} combinations looked at)"
        return f"{said}; up to {depth} primitives bring it to {allowed}"


def _listed(words: list[str]) -> str:
    return " and ".join(words)
