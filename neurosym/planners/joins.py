"""Joining the ways to move each object into plans for all of them (conflict-based search).

At most one object ends held, and comes last. Objects that would end in each other, or in one that stands
there, get their next way.
"""

import heapq
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import count

import numpy as np

from neurosym.grounding import Grounding
from neurosym.planners.branching import Branching, Names, branching_of
from neurosym.planners.count_vectors import Candidate, Choices, candidates, looked_at, nearest
from neurosym.planners.effort import Effort
from neurosym.problems import Problem
from neurosym.promises import promised
from neurosym.tasks.footprints import footprints_apart, overlapping
from neurosym.tasks.moves import PUT_DOWN, step_cost
from neurosym.tasks.steps import PlanStep

Listing = Callable[[Choices, str, bool], Iterable[Candidate]]
"""Lists candidates: what can be done to an object, its name, and whether it may not end held."""
GAIN = 0.005
"""How much nearer to a goal out of reach more primitives must bring an object to be done [m]."""


def choices_of(
    problem: Problem, branching: Branching, grounding: Grounding, names: Names
) -> tuple[Choices, ...]:
    """Return what can be done to each object, in the columns of a branching table that have a prediction.

    Args:
        problem: The problem.
        branching: What each column does to each object.
        grounding: The learned domain, for what steps cost and where the table ends.
        names: Name of the operator for each object and column.
    """
    room, found = problem.room(grounding.table), []
    for index, item in enumerate(problem.objects):
        used, promises = branching.usable(index), promised(grounding, item, problem.tolerance)
        costs = [step_cost(promises[names[index][column]], grounding) for column in used]
        found.append(
            Choices(
                settled=branching.settled[index, used],
                lifted=branching.effects[index, used],
                held=branching.held[index, used],
                costs=np.array(costs, dtype=int),
                start=np.array(item.position),
                room=room[:, index],
            )
        )
    return tuple(found)


@dataclass(slots=True)
class _Listed:
    """Candidates that are made as they are asked for."""

    source: Iterator[Candidate]
    known: list[Candidate] = field(default_factory=list)

    def at(self, index: int) -> Candidate | None:
        while len(self.known) <= index:
            following = next(self.source, None)
            if following is None:
                return None
            self.known.append(following)
        return self.known[index]


_Pick = tuple[bool, int]
"""Whether an object must end at rest, and which of its candidates is picked."""


class Join:
    """Picks a candidate for each object with a goal, the fewest moves and then the cheapest first.

    Attributes:
        effort: What may be spent, and was.
        missed: Why the last plan that was tried is not true; whoever tries them says so.
    """

    def __init__(
        self,
        problem: Problem,
        grounding: Grounding,
        effort: Effort,
        *,
        nearest_depth: int | None = None,
        listing: Listing | None = None,
        by_cost: bool = False,
    ) -> None:
        """Look at what can be done to each object.

        Args:
            problem: The problem.
            grounding: The learned domain.
            effort: What may be spent.
            nearest_depth: Where no candidate reaches a goal, take the nearest with so many moves, if given.
            listing: Lists the candidates of an object in place of `candidates`, if given.
            by_cost: Whether the cheapest plans come first, and not those with the fewest primitives.
        """
        self.effort, self._nearest_depth = effort, nearest_depth
        self.missed = ""
        self._bystanders: Counter[str] = Counter()
        self._listing, self._by_cost = listing, by_cost
        for item in problem.objects:
            grounding.category(item.category)
        branching, names = branching_of(problem, grounding)
        self._problem, self._names = problem, list(problem.goals)
        self._operators = {
            item.name: [names[index][column] for column in branching.usable(index)]
            for index, item in enumerate(problem.objects)
        }
        self._choices = dict(
            zip(problem.object_names, choices_of(problem, branching, grounding, names), strict=True)
        )
        self._apart = footprints_apart(problem)
        self._listed: dict[tuple[str, bool], _Listed] = {}

    def candidate(self, name: str, at_rest: bool, index: int) -> Candidate | None:
        """Return a candidate of an object, counted from the best, or None if there are not so many."""
        key = (name, at_rest)
        if key not in self._listed:
            self._listed[key] = _Listed(self._candidates(name, at_rest))
        return self._listed[key].at(index)

    def _candidates(self, name: str, at_rest: bool) -> Iterator[Candidate]:
        choices, goal = self._choices[name], self._problem.goals[name]
        if self._listing:
            yield from self._listing(choices, name, at_rest)
            return
        found = candidates(choices, goal, self._problem.tolerance, self.effort, at_rest=at_rest)
        first = next(found, None)
        if first is None and self._nearest_depth is not None:
            first = nearest(choices, goal, depth=self._nearest_depth, at_rest=at_rest, gain=GAIN)
        if first is not None:
            yield first
        yield from found

    def plans(self) -> Iterator[tuple[PlanStep, ...]]:
        """List plans in which no two objects end in each other or in the hand; orders are not looked at.

        The list ends where no object has more candidates, or with the budget of work.

        Raises:
            TimeIsUp: If the deadline passes.
        """
        first: tuple[_Pick, ...] = tuple((False, 0) for _ in self._names)
        seen, ticket = {first}, count()
        waiting: list[tuple[float, int, int, int, tuple[_Pick, ...]]] = []

        def push(picks: tuple[_Pick, ...]) -> None:
            picked = self._picked(picks)
            if picked is not None:
                miss, moves = sum(one.miss for one in picked), sum(len(one.moves) for one in picked)
                costs = sum(one.cost for one in picked)
                order = (costs, moves) if self._by_cost else (moves, costs)
                heapq.heappush(waiting, (miss, *order, next(ticket), picks))

        push(first)
        while waiting and self.effort.spend():
            picks = heapq.heappop(waiting)[-1]
            picked = self._picked(picks)
            assert picked is not None, "only what can be picked waits"
            conflict = self._conflict(picked)
            if conflict is None:
                yield self._steps(picked)
                following = [_next(picks, index) for index in range(len(picks))]
            else:
                both_held, pair = conflict
                following = [_next(picks, index, resting=both_held) for index in pair]
            for one in following:
                if one not in seen:
                    seen.add(one)
                    push(one)

    def why_none(self) -> str:
        """Say up to where plans were looked for in vain."""
        looked = [looked_at(self._choices[name]) for name in self._names]
        steps, vectors = min(steps for steps, _ in looked), sum(vectors for _, vectors in looked)
        said = f"none within {steps} primitives with an object; {vectors:,} combinations looked at"
        if self.effort.is_used_up:
            said = f"none within {self.effort.work:,} candidates, joins and orders looked at"
        if self._bystanders:
            said += f"; {self._bystanders.most_common(1)[0][0]} was in the way most often"
        return said + (f"; the last that was tried: {self.missed}" if self.missed else "")

    def _picked(self, picks: tuple[_Pick, ...]) -> list[Candidate] | None:
        found = [self.candidate(name, *pick) for name, pick in zip(self._names, picks, strict=True)]
        kept = [one for one in found if one is not None]
        return kept if len(kept) == len(found) else None

    def _conflict(self, picked: list[Candidate]) -> tuple[bool, tuple[int, ...]] | None:
        """Find who cannot have their picks together, and whether that is because of the hand."""
        held = [index for index, one in enumerate(picked) if one.held]
        if len(held) > 1:
            return True, tuple(held[:2])
        spots = self._problem.scene().positions[:, :2]
        rows = [self._problem.object_names.index(name) for name in self._names]
        for row, one in zip(rows, picked, strict=True):
            spots[row] = one.end[:2] if not one.held else np.inf
        for index, row in enumerate(rows):
            if not picked[index].held and picked[index].moves:
                hit = overlapping(spots[row], spots, self._apart[row])
                if hit.any():
                    other = int(np.flatnonzero(hit)[0])
                    if other in rows:
                        return False, (index, rows.index(other))
                    self._bystanders[self._problem.object_names[other]] += 1
                    return False, (index,)
        return None

    def _steps(self, picked: list[Candidate]) -> tuple[PlanStep, ...]:
        """Write the moves as steps, each lift with its put-down, and who is held in the end last."""
        steps: list[PlanStep] = []
        for name, one in sorted(zip(self._names, picked, strict=True), key=lambda pair: pair[1].held):
            for move in one.moves:
                operator = self._operators[name][move]
                steps.append(PlanStep(operator, name))
                if self._choices[name].held[move]:
                    steps.append(PlanStep(PUT_DOWN + operator, name))
            if one.held:
                steps.pop()
        return tuple(steps)


def _next(picks: tuple[_Pick, ...], index: int, *, resting: bool = False) -> tuple[_Pick, ...]:
    """Pick the next candidate of one object, or the first that ends at rest."""
    at_rest, number = picks[index]
    return (*picks[:index], (True, 0) if resting else (at_rest, number + 1), *picks[index + 1 :])
