"""Own parameters: for each category of objects the candidates of each symbol that do best there.

One action for a symbol has to serve every category, and is exact on few. So candidates are shortlisted for
each category by what a network without a bottleneck predicts, and auditioned on objects of that category:
many candidates on a few of them first, then fewer on others. Each performance has its action moved by about a
millimetre, so that what lies on an edge, and does something else a hair beside it, looks as bad as it is.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import accumulate

import numpy as np

from neurosym.actions import ActionBox
from neurosym.arrays import Float
from neurosym.guarded import made
from neurosym.operators import Primitive
from neurosym.primitives.judging import (
    Foresee,
    Judgement,
    Performance,
    foresee_displacement,
    judge,
    performance,
)
from neurosym.primitives.performing import perform
from neurosym.primitives.repertoire import Repertoire, with_own
from neurosym.primitives.sampling import sample_by_category
from neurosym.primitives.variety import (
    LITTLE,
    CandidateEffects,
    PredictOutcomes,
    best_set,
    worth_in_place,
)
from neurosym.progress import Progress, part
from neurosym.symbols import Categorise, symbols_of
from neurosym.world import Scene, WorldFactory
from neurosym.worlds.workers import Task


@dataclass(frozen=True, slots=True)
class Round:
    """One round of auditions.

    Attributes:
        candidates: How many of a symbol are auditioned for a category.
        objects: On how many objects of the category each performs, others than in the rounds before.
    """

    candidates: int
    objects: int


ROUNDS = Round(6, 8), Round(3, 8)
"""Auditions of actions that displace objects."""
CARRYING_ROUNDS = Round(16, 4), Round(8, 4), Round(4, 8), Round(2, 16)
"""Auditions of actions that carry objects: plans use the best of them only, so that it must be sure."""
OBJECTS_TO_PREDICT = 40
"""Objects of the category on which the effects of every candidate are predicted."""
MOVED = 0.001
"""Standard deviation of the change of each length of an action [m]."""
_MOST_MOVED = 0.02  # as a share of what the length can be, where the box is small
SAME, DIFFERENT = 0.02, 0.03
"""Outcomes nearer than the first are the same, farther apart than the second clearly different [m]."""
WORTH_KEEPING = 0.25
"""Least sureness of a shared action that stays beside one of a category's own."""

_STREAM, _MOVES = 0x6F77, 0x6F78  # keep these draws apart from those of other auditions and rehearsals


@dataclass(frozen=True, slots=True, eq=False)
class _Contest:
    """The candidates for one category.

    Attributes:
        scenes: An object of the category in each.
        groups: For each symbol, those that are left, the shared one first.
        seen: How they turned out.
    """

    scenes: tuple[Scene, ...]
    groups: list[list[Primitive]]
    seen: dict[Primitive, list[Performance]] = field(default_factory=dict)

    def judged(self) -> list[list[Judgement]]:
        """Judge those that are left."""
        return [[judge(self.seen[one]) for one in group] for group in self.groups]


def choose_own(
    world_factory: WorldFactory,
    candidates: Sequence[Primitive],
    shared: Sequence[Primitive],
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    categorise: Categorise,
    *,
    foresee: Foresee = foresee_displacement,
    rounds: Sequence[Round] = ROUNDS,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> Repertoire:
    """Choose for each category and symbol the candidate that does best there; keep the shared one if it adds.

    Args:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        candidates: Distilled actions.
        shared: The action that each symbol shares among categories, in the order of the symbols.
        predict: A network that sees the objects themselves and not their symbols.
        features: Objects to predict the effects on.
        categorise: Gives the object symbols of features.
        foresee: How actions are judged by what is predicted.
        rounds: Of the auditions, with fewer candidates in each.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each performance.
    """
    world = made(world_factory)
    ends = list(accumulate(one.objects for one in rounds))
    sample = sample_by_category(world, categorise, least=ends[-1], seed=seed, stream=_STREAM)
    symbols = np.array(symbols_of(categorise, features))
    rivals = [
        [other for other in candidates if other.symbol == one.symbol and other != one] for one in shared
    ]
    contests = {}
    for category, scenes in sample.scenes.items():
        objects = np.concatenate([features[symbols == category], *(scene.features for scene in scenes)])
        objects = objects[:OBJECTS_TO_PREDICT]
        few = shortlist_own(rivals, predict, objects, world.action_box, rounds[0].candidates, seed, foresee)
        groups = [[one, *best] for one, best in zip(shared, few, strict=True)]
        contests[category] = _Contest(scenes, groups)
    kept = [one.candidates for one in rounds[1:]] + [1]
    total, done = _performances(contests.values(), rounds), 0
    for count, end, one in zip(kept, ends, rounds, strict=True):
        tasks, owners = _tasks(contests.values(), slice(end - one.objects, end), world.action_box, seed)
        outcomes = perform(world_factory, tasks, workers, part(progress, done, total))
        for seen, outcome in zip(owners, outcomes, strict=True):
            seen.append(performance(outcome))
        done += len(tasks)
        for contest in contests.values():
            contest.groups[:] = _keep_best(contest, count)
    return with_own(shared, {category: _chosen(contest) for category, contest in contests.items()})


def shortlist_own(
    groups: Sequence[Sequence[Primitive]],
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    box: ActionBox,
    count: int,
    seed: int,
    foresee: Foresee = foresee_displacement,
) -> list[list[Primitive]]:
    """Keep of each symbol the few candidates that are predicted to do best, beside those of the others.

    Args:
        groups: The candidates of each symbol.
        predict: A network that sees the objects themselves and not their symbols.
        features: Objects of one category.
        box: What actions must stay inside.
        count: How many are kept of each symbol.
        seed: Where the changes of actions are drawn from.
        foresee: How actions are judged by what is predicted.
    """
    judged: list[list[Judgement]] = [[] for _ in groups]
    for group, judgements in zip(groups, judged, strict=True):
        if not group:
            continue
        actions = np.concatenate([moved(one, len(features), box, seed) for one in group])
        predicted = np.split(predict(np.tile(features, (len(group), 1)), actions), len(group))
        judgements += map(foresee, predicted)
    return [
        [group[number] for number in best[:count]]
        for group, best in zip(groups, _ranked(judged), strict=True)
    ]


def moved(primitive: Primitive, count: int, box: ActionBox, seed: int) -> Float[np.ndarray, "N A"]:
    """Move the lengths of an action a little, once for each object: on an object for all actions alike.

    Args:
        primitive: Whose action.
        count: How many objects.
        box: What actions must stay inside.
        seed: Where the changes are drawn from.
    """
    most = np.where(box.gripper, 0.0, np.minimum(MOVED, _MOST_MOVED * (box.high - box.low)))
    moves = most * _moves(count, len(most), seed)
    actions: np.ndarray = np.clip(np.array(primitive.action) + moves, box.low, box.high)
    return actions


@cache
def _moves(count: int, size: int, seed: int) -> Float[np.ndarray, "N A"]:
    """Draw by how much actions are moved, in standard deviations."""
    return np.array([np.random.default_rng([seed, _MOVES, n]).normal(size=size) for n in range(count)])


def _performances(contests: Iterable[_Contest], rounds: Sequence[Round]) -> int:
    """Count the performances of all rounds."""
    groups = [len(group) for contest in contests for group in contest.groups]
    first, *others = rounds
    return first.objects * sum(groups) + sum(
        one.objects * min(group, 1 + one.candidates) for one in others for group in groups
    )


def _tasks(
    contests: Iterable[_Contest], which: slice, box: ActionBox, seed: int
) -> tuple[list[Task], list[list[Performance]]]:
    """Have all that are left perform on a part of the objects of their category.

    Returns:
        What is to be performed, and for each task the list that its performance is to be added to.
    """
    tasks, owners = list[Task](), list[list[Performance]]()
    for contest in contests:
        for primitive in (one for group in contest.groups for one in group):
            actions = moved(primitive, len(contest.scenes), box, seed)
            for scene, action in zip(contest.scenes[which], actions[which], strict=True):
                tasks.append(Task(scene, action))
                owners.append(contest.seen.setdefault(primitive, []))
    return tasks, owners


def _keep_best(contest: _Contest, count: int) -> list[list[Primitive]]:
    """Keep the best of each symbol, best first; the shared one stays, in the first place, until the last."""
    ranked = zip(contest.groups, _ranked(contest.judged()), strict=True)
    if count == 1:
        return [[group[best[0]], *([group[0]] if best[0] else [])] for group, best in ranked]
    return [[group[0], *[group[number] for number in best if number][:count]] for group, best in ranked]


def _ranked(judged: Sequence[Sequence[Judgement]]) -> list[list[int]]:
    """Rank the candidates of each symbol by what they are worth beside the best of the others.

    What carries objects is ranked by how surely it does: one that does is as good as several.
    """
    if any(one.kind == "carried" for group in judged for one in group):
        return [np.argsort([-one.sureness for one in group], kind="stable").tolist() for group in judged]
    ends = np.cumsum([len(group) for group in judged]).tolist()
    groups = [list(range(end - len(group), end)) for group, end in zip(judged, ends, strict=True)]
    filled = [numbers for numbers in groups if numbers]
    if not filled:
        return [[] for _ in groups]
    flat = [judgement for group in judged for judgement in group]
    effects = CandidateEffects(
        np.array([[one.mean] for one in flat]), np.array([[one.sureness] for one in flat]), np.ones(1)
    )
    chosen, ranked = best_set(filled, effects), list[list[int]]()
    for numbers in groups:
        place = filled.index(numbers) if numbers else 0
        values = worth_in_place(chosen, place, numbers, effects)
        ranked.append(np.argsort(-np.array(values), kind="stable").tolist())
    return ranked


def _chosen(contest: _Contest) -> list[Primitive]:
    """Return the best of each symbol, and the shared ones that add something to them."""
    best = [group[0] for group in contest.groups]
    effects = {one: judge(contest.seen[one]) for group in contest.groups for one in group}
    kept = [*best]
    if any(one.kind == "carried" for one in effects.values()):
        return kept
    for own, *beside in contest.groups:
        for shared in beside:
            mine = effects[shared]
            others = [effects[one] for one in kept if one != own]
            crowded = any(_apart(effects[own], other) <= SAME for other in others)
            if (
                mine.sureness >= WORTH_KEEPING
                and np.linalg.norm(mine.mean[:-1]) > LITTLE
                and all(_apart(mine, other) > SAME for other in others)
                and (crowded or _apart(mine, effects[own]) > DIFFERENT)
            ):
                kept.append(shared)
    return kept


def _apart(one: Judgement, other: Judgement) -> float:
    """Return how far apart two outcomes are [m], infinitely if they differ in kind."""
    return float(np.linalg.norm(one.mean[:-1] - other.mean[:-1])) if one.kind == other.kind else np.inf
