"""The next-best plans: other choices of steps, the cheapest first, each of them replayed."""

from collections import Counter
from collections.abc import Sequence
from itertools import takewhile

from neurosym.grounding import Grounding
from neurosym.planners.count_vectors import Candidate, Choices, candidates
from neurosym.planners.effort import Effort
from neurosym.planners.joins import Join
from neurosym.planners.ordering import mend
from neurosym.problems import Problem
from neurosym.tasks.steps import PlanStep

LONGER = 2
"""How many primitives more than the fewest an alternative may need for an object."""
_TRIES = 50
WORK = 20_000
"""How many candidates, ways to join them and beginnings of plans are looked at for each alternative."""


def alternatives(
    problem: Problem,
    grounding: Grounding,
    count: int,
    *,
    besides: Sequence[PlanStep] = (),
) -> tuple[tuple[PlanStep, ...], ...]:
    """Find the cheapest plans that consist of other steps; the same steps in another order do not count.

    For each object plans of up to `LONGER` primitives more than the fewest are looked at, without those that
    do all that a cheaper one does, and more.

    Args:
        problem: The problem.
        grounding: The learned domain.
        count: How many plans there shall be at most.
        besides: A plan that is known already.

    Raises:
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    effort = Effort(WORK * (count + 1))

    def cheapest(choices: Choices, name: str, at_rest: bool) -> list[Candidate]:
        goal, tolerance = problem.goals[name], problem.tolerance
        source = candidates(choices, goal, tolerance, effort, at_rest=at_rest)
        first = next(source, None)
        if first is None:
            return []
        near = takewhile(lambda one: len(one.moves) <= len(first.moves) + LONGER, source)
        return _without_detours(sorted([first, *near], key=lambda one: (one.cost, len(one.moves))))

    found: list[tuple[PlanStep, ...]] = []
    known = [Counter(besides)]
    join = Join(problem, grounding, effort, listing=cheapest, by_cost=True)
    for tried, steps in enumerate(join.plans()):
        if len(found) == count or tried >= _TRIES * (count + 1):
            break
        ordered, checked = mend(steps, problem, grounding, effort)
        if checked.valid and Counter(steps) not in known:
            known.append(Counter(steps))
            found.append(ordered)
    return tuple(found)


def _without_detours(ways: Sequence[Candidate]) -> list[Candidate]:
    """Drop what does all that an earlier one does, and more."""
    kept: list[tuple[Candidate, Counter[int]]] = []
    for way in ways:
        counts = Counter(way.moves)
        if not any(other.held == way.held and smaller <= counts for other, smaller in kept):
            kept.append((way, counts))
    return [way for way, _ in kept]
