"""No plan is an answer: which goal cannot be met, why, and how near its object can come.

Counting (see `count_vectors`) says it exactly: a goal may be out of every primitive's reach, on the table or
anywhere; to be had only by leaving the table; too many primitives away for a planner that looks only so deep;
in the air together with another, while there is one hand; or so near another goal that both objects do not
fit there.
"""

import itertools
import time
from dataclasses import dataclass

import numpy as np

from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Vector
from neurosym.pddl.validation import footprints_apart
from neurosym.planners.branching import Branching, Names, branching_of
from neurosym.planners.count_vectors import Choices, candidates, nearest
from neurosym.planners.counting import Join, choices_of
from neurosym.planners.ordering import mend
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.wording import in_millimetres

DEPTH = 8
"""How many primitives with an object are looked at for how near it can come."""


def explain_no_plan(
    problem: Problem,
    grounding: Grounding,
    *,
    branching: tuple[Branching, Names] | None = None,
    depth: int | None = None,
) -> str:
    """Say which goals cannot be met, and why; empty if nothing is known to stand against a plan.

    Args:
        problem: The problem.
        grounding: The learned domain.
        branching: What is predicted for each object, and the operators' names; what the live operators
            promise, if not given.
        depth: How many primitives the planner looks ahead, if it is limited.
    """
    table, names = branching or branching_of(problem, grounding)
    rows = zip(problem.objects, choices_of(problem, table, grounding, names), strict=True)
    found = {
        item.name: _Reach(item.name, choices, problem.goals[item.name], problem.tolerance)
        for item, choices in rows
        if item.name in problem.goals
    }
    fewest = {name: reach.fewest() for name, reach in found.items()}
    if out := [reach.explain() for name, reach in found.items() if fewest[name] is None]:
        return "; ".join(out)
    if clash := explain_clash(problem, grounding):
        return clash
    needed = {name: count for name, count in fewest.items() if count}
    if depth is None or sum(needed.values()) <= depth:
        return ""
    if deep := [f"{name} {count}" for name, count in needed.items() if count > depth]:
        return f"too deep: {_listed(deep)} primitives away from the goal, and only {depth} are looked at"
    return (
        f"too deep: each goal can be reached alone, but together they take {sum(needed.values())} primitives "
        f"({_listed([f'{name} {count}' for name, count in needed.items()])}), and only {depth} are looked at"
    )


def explain_clash(problem: Problem, grounding: Grounding) -> str:
    """Say which goals cannot be met together, however objects move; empty if nothing stands against it."""
    return _explain_hand(problem) or _explain_room(problem, grounding)


def _explain_hand(problem: Problem) -> str:
    """Say which objects would have to be held at the end, if it is more than one.

    An object whose goal is farther above or below it than the tolerance cannot meet it at rest.
    """
    items = ((name, problem.object_named(name), goal) for name, goal in problem.goals.items())
    names = [name for name, item, goal in items if abs(goal[2] - item.position[2]) > problem.tolerance]
    if len(names) < 2:
        return ""
    return f"{_listed(names)} would have to be held at the end, and there is one hand"


def _explain_room(problem: Problem, grounding: Grounding) -> str:
    """Say which two objects would have to stand in each other at the end, if any would."""
    apart, names = footprints_apart(problem), problem.object_names
    rows = [names.index(name) for name in problem.goals if _must_rest(problem, name, grounding)]
    for one, other in itertools.combinations(sorted(rows), 2):
        ends = np.array([problem.goals[names[row]] for row in (one, other)])
        most = np.abs(ends[0, :2] - ends[1, :2]) + 2 * problem.tolerance
        if np.all(most < apart[one, other]):
            return f"there is no room for both {names[one]} and {names[other]}, so near are their goals"
    return ""


def _must_rest(problem: Problem, name: str, grounding: Grounding) -> bool:
    """Say whether no lift holds an object as high as its goal is."""
    item, goal = problem.object_named(name), problem.goals[name]
    heights = (
        grounding.displacement(operator)[2]
        for operator in grounding.live
        if operator.category == item.category and is_lift(operator)
    )
    return all(abs(item.position[2] + height - goal[2]) > problem.tolerance for height in heights)


def plan_nearest(problem: Problem, grounding: Grounding, *, time_limit: float = 60.0) -> PlanResult:
    """Plan to the goals, where they can be reached, and else as near to them as objects come.

    Args:
        problem: The problem.
        grounding: The learned domain.
        time_limit: When to give up [s].

    Returns:
        A plan that is solved, or nearest and says how far objects stay from their goals.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    begin = time.perf_counter()
    for steps in Join(problem, grounding, deadline=begin + time_limit, nearest_depth=DEPTH).plans():
        ordered, checked = mend(steps, problem, grounding)
        seconds = time.perf_counter() - begin
        if checked.valid:
            return PlanResult(PlanStatus.SOLVED, ordered, seconds)
        if checked.possible:
            misses = problem.distances(checked.positions[-1]).items()
            allowed = problem.tolerance
            far = [f"{name} {in_millimetres(miss, allowed)}" for name, miss in misses if miss > allowed]
            reason = f"at the end, {_listed(far)} from its goal" if len(far) == 1 else ""
            reason = reason or f"at the end, {_listed(far)} from their goals"
            return PlanResult(PlanStatus.NEAREST, ordered, seconds, reason)
        if seconds > time_limit:
            break
    seconds = time.perf_counter() - begin
    return PlanResult(PlanStatus.TIMEOUT, (), seconds, f"no plan to the nearest point in {time_limit:g} s")


@dataclass(frozen=True, slots=True, eq=False)
class _Reach:
    """One object and its goal."""

    name: str
    choices: Choices
    goal: Vector
    tolerance: float

    def fewest(self) -> int | None:
        """Return how many primitives bring the object to its goal, or None if none do."""
        found = next(candidates(self.choices, self.goal, self.tolerance), None)
        return None if found is None else len(found.moves)

    def explain(self) -> str:
        """Say why the goal cannot be met."""
        on_table = nearest(self.choices, self.goal, depth=DEPTH).miss
        near = in_millimetres(on_table, self.tolerance)
        allowed = f"{near} from it, {1000 * self.tolerance:g} mm are allowed"
        if nearest(self.choices, self.goal, depth=DEPTH, anywhere=True).miss <= self.tolerance:
            return (
                f"{self.name} cannot reach its goal without leaving the table: on it, it comes to {allowed}"
            )
        return (
            f"{self.name} cannot reach its goal: out of every primitive's reach, up to {DEPTH} primitives "
            f"bring it to {allowed}"
        )


def _listed(words: list[str]) -> str:
    return " and ".join(words)
