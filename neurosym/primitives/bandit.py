"""Contests: candidates perform where that may change most what plans can do.

What is predicted of a candidate counts as a few performances, so that what is foreseen to fail is hardly ever
performed. Each further performance is given to whom it may most likely make the best, by the knowledge
gradient (Frazier et al., 2008, A Knowledge-Gradient Policy for Sequential Information Collection), weighed by
how often the objects are met. What was performed to choose also tells what the chosen do.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from neurosym.operators import Primitive
from neurosym.primitives.reliability import CandidateEffects, Judgement, best_set, worths_in_place
from neurosym.world import Outcome, Scene

AT_ONCE = 4
"""Performances that a candidate is given at a time."""
BLOCK = 256
"""Performances between two looks at who may become the best."""
LEAST_GAIN = 2e-6
"""What a performance must be expected to add to what operators are worth; see `reliability.py`."""
FORESEEN_COUNTS = 4
"""What is predicted of a candidate counts as so many performances."""
_BEHIND = 4  # what carries counts by this power of how sure its symbol is beside the surest
_TRUST = 20  # performances after which predictions are half believed to be as far off as they were so far

Groups = list[list[Primitive]]
"""Candidates, in groups of which one is chosen each."""
Perform = Callable[[Sequence[tuple[Primitive, Scene]]], Sequence[Outcome]]
"""Has candidates perform in scenes."""


@dataclass(slots=True, eq=False)
class Contest:
    """Candidates that perform on the same scenes."""

    share: float  # how often such scenes are met
    scenes: Sequence[Scene]  # what they perform in; each begins with the first
    groups: Groups  # the candidates
    foreseen: dict[Primitive, Judgement]  # what is predicted of each
    judge: Callable[[Sequence[Outcome]], Judgement]  # judges what was seen of one
    counts: int = FORESEEN_COUNTS  # as how many performances a prediction counts
    # what each did, in the first scenes
    seen: dict[Primitive, list[Outcome]] = field(default_factory=dict, init=False)

    def judged(self, one: Primitive, trust: float = 1.0) -> Judgement:
        """Judge a candidate by what was seen and foreseen of it, which is so sure as it turned out before."""
        prior, outcomes = self.foreseen[one], self.seen.get(one, [])
        sureness = min(1.0, trust * prior.sureness)
        if not outcomes:
            return Judgement(prior.kind, prior.mean, sureness)
        found, count = self.judge(outcomes), len(outcomes)
        mixed = (count * found.sureness + self.counts * sureness) / (count + self.counts)
        return Judgement(found.kind or prior.kind, found.mean if found.kind else prior.mean, mixed)

    def best(self, trust: float, *, is_seen: bool = False) -> list[Primitive]:
        """Return the best of each group that has candidates; if asked for, of those that performed."""
        groups = self.groups
        if is_seen:
            groups = [[one for one in group if one in self.seen] or group for group in groups]
        worths = _worths([[self.judged(one, trust) for one in group] for group in groups])
        return [g[int(np.argmax(values))] for g, (values, _) in zip(groups, worths, strict=True) if g]


@dataclass(slots=True, eq=False)
class _Arm:
    """A candidate of a contest, and what it is worth beside the best of the others of its group.

    The slope says by how much it is worth more if it is surer.
    """

    contest: Contest
    one: Primitive
    lead: float
    slope: float
    sureness: float
    count: int

    @property
    def gain(self) -> float:
        """What one of the next performances is expected to add to what operators are worth."""
        if self.count + AT_ONCE > len(self.contest.scenes):
            return 0.0
        counts, variance = self.count + self.contest.counts, self.sureness * (1 - self.sureness)
        spread = self.slope * math.sqrt(variance * AT_ONCE / (counts * (counts + AT_ONCE)))
        return self.contest.share * _expected_excess(abs(self.lead), spread) / AT_ONCE


def _expected_excess(ahead: float, spread: float) -> float:
    """Return by how much a normal variable of mean zero exceeds what is so far ahead, on average."""
    if spread <= 0.0:
        return 0.0
    z = ahead / spread
    return spread * (math.exp(-z * z / 2) / math.sqrt(2 * math.pi) - z * math.erfc(z / math.sqrt(2)) / 2)


def hold(contests: Sequence[Contest], perform: Perform, *, budget: int, least: float) -> None:
    """Perform candidates as long as that is worth it.

    Args:
        contests: Those that go on at the same time.
        perform: Has candidates perform.
        budget: How often at most.
        least: What a performance must be expected to add to what operators are worth.
    """
    while given := _allotted(contests, min(BLOCK, budget), least):
        rows = [(arm, number) for arm, first in given for number in range(first, arm.count)]
        outcomes = perform([(arm.one, arm.contest.scenes[number]) for arm, number in rows])
        for (arm, _), outcome in zip(rows, outcomes, strict=True):
            arm.contest.seen.setdefault(arm.one, []).append(outcome)
        budget -= len(rows)


def _allotted(contests: Sequence[Contest], count: int, least: float) -> list[tuple[_Arm, int]]:
    """Allot so many performances at most; return who gets some, and how many it had."""
    trust = trusted(contests)
    arms = [arm for contest in contests for arm in _arms(contest, trust)]
    gains, before = np.array([arm.gain for arm in arms]), [arm.count for arm in arms]
    while count >= AT_ONCE and len(arms) and gains.max() > least:
        best = int(gains.argmax())
        arms[best].count += AT_ONCE
        gains[best] = arms[best].gain
        count -= AT_ONCE
    return [(arm, first) for arm, first in zip(arms, before, strict=True) if arm.count > first]


def trusted(contests: Sequence[Contest]) -> float:
    """Return how sure candidates were so far, beside what was foreseen of them."""
    seen = foreseen = float(_TRUST)
    for contest in contests:
        for one, outcomes in contest.seen.items():
            seen += len(outcomes) * contest.judge(outcomes).sureness
            foreseen += len(outcomes) * contest.foreseen[one].sureness
    return seen / foreseen


def _arms(contest: Contest, trust: float) -> list[_Arm]:
    judged = [[contest.judged(one, trust) for one in group] for group in contest.groups]
    arms = []
    for group, found, (values, slopes) in zip(contest.groups, judged, _worths(judged), strict=True):
        for place, one in enumerate(group):
            rival = max((value for other, value in enumerate(values) if other != place), default=0.0)
            count = len(contest.seen.get(one, ()))
            arms.append(
                _Arm(contest, one, values[place] - rival, slopes[place], found[place].sureness, count)
            )
    return arms


def _worths(judged: Sequence[Sequence[Judgement]]) -> list[tuple[list[float], list[float]]]:
    """Say what the candidates of each group are worth, and how much more if they were surer.

    What displaces objects is worth what the others do not do; of what carries them, one is enough.
    """
    flat = [one for group in judged for one in group]
    if not flat:
        return [([], []) for _ in judged]
    if any(one.kind == "carried" for one in flat):
        surest = max(one.sureness for one in flat) or 1.0
        weights = [(max((o.sureness for o in g), default=0.0) / surest) ** _BEHIND for g in judged]
        return [
            ([weight * one.sureness for one in group], [weight] * len(group))
            for weight, group in zip(weights, judged, strict=True)
        ]
    numbers = iter(range(len(flat)))
    groups = [[next(numbers) for _ in group] for group in judged]
    sureness = np.array([[one.sureness] for one in flat])
    effects = CandidateEffects(np.array([[one.mean] for one in flat]), sureness, np.ones(1))
    chosen, place = best_set([group for group in groups if group], effects), 0
    found = list[tuple[list[float], list[float]]]()
    for group in groups:
        of_others, own = worths_in_place(chosen, place, group, effects) if group else ([], [])
        values = [one + other for one, other in zip(of_others, own, strict=True)]
        slopes = [2 * one / max(sureness[n, 0], 1e-3) for n, one in zip(group, own, strict=True)]
        found.append((values, slopes))
        place += bool(group)
    return found
