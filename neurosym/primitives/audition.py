"""Choosing among distilled actions: many encode to a symbol, and some are more predictable than others.

A good action does nearly the same to all objects of a category, and something that no other symbol's action
does to them (`variety.py`). That is first reckoned from what a network without a bottleneck predicts, and
then measured: the few best of each symbol are auditioned in the world, and the best of those once more. By
default, categories of objects are then given actions of their own where those do better (`own.py`). The paper
takes the candidate whose embedding is nearest to the code.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import groupby

import numpy as np

from neurosym.checks import Float, check_all, check_array, check_callable, check_count, check_kind, check_seed
from neurosym.contract import made
from neurosym.errors import InvalidValue, OpenBar, Progress, UnknownChoice, part, silent
from neurosym.operators import Categorise, Primitive, symbols_of
from neurosym.primitives.rehearsal import Search
from neurosym.primitives.reliability import (
    LITTLE,
    CandidateEffects,
    Foresee,
    Judgement,
    Performance,
    PredictOutcomes,
    best_set,
    foresee_displacement,
    judge,
    observe,
    performance,
    worth_in_place,
)
from neurosym.primitives.sampling import (
    Repertoire,
    perform_each,
    sample_by_category,
    shared_by_all,
    tasks_of,
    with_own,
)
from neurosym.world import ActionBox, Outcome, Scene, WorldFactory
from neurosym.worlds.workers import Task

# Own parameters: for each category of objects the candidates of each symbol that do best there.
#
# One action for a symbol has to serve every category, and is exact on few. So candidates are shortlisted
# for each category by what a network without a bottleneck predicts, and auditioned on objects of that
# category: many candidates on a few of them first, then fewer on others. Each performance has its action
# moved by about a millimetre, so that what lies on an edge, and does something else a hair beside it, looks
# as bad as it is.


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
OWN_OBJECTS_TO_PREDICT = 40
"""Objects of the category on which the effects of every candidate are predicted."""
MOVED = 0.001
"""Standard deviation of the change of each length of an action [m]."""
_MOST_MOVED = 0.02  # as a share of what the length can be, where the box is small
SAME, DIFFERENT = 0.02, 0.03
"""Outcomes nearer than the first are the same, farther apart than the second clearly different [m]."""
WORTH_KEEPING = 0.25
"""Least sureness of a shared action that stays beside one of a category's own."""

_OWN_STREAM, _MOVES = 0x6F77, 0x6F78  # keep these draws apart from those of other auditions and rehearsals


@dataclass(slots=True, eq=False)
class Contest(ABC):
    """Candidates that perform in rounds, fewer of them in each.

    Attributes:
        scenes: What they perform on, one object in each.
        seen: How they turned out.
    """

    scenes: tuple[Scene, ...]
    seen: dict[Primitive, list[Performance]] = field(default_factory=dict, init=False)

    @abstractmethod
    def left(self) -> list[Primitive]:
        """Return those that are left."""

    @abstractmethod
    def most_left(self, candidates: int) -> int:
        """Say how many are left at most when so many of a symbol are."""

    @abstractmethod
    def close_round(self, kept: int) -> None:
        """Keep so many of a symbol, the best by what was seen."""


def audition_in_rounds(
    search: Search,
    contests: Sequence[Contest],
    rounds: Sequence[Round],
    world_factory: WorldFactory,
    observe: Callable[[Outcome], Performance],
    progress: Progress,
) -> None:
    """Perform the candidates of all contests in rounds, their actions moved a little.

    Args:
        search: What the candidates are searched with.
        contests: Who performs on what.
        rounds: How many are left in each, and on how many scenes they perform.
        world_factory: Builds the world of the auditions.
        observe: Says of an outcome what is judged.
        progress: Called after each performance.
    """
    box = made(world_factory).action_box
    total = sum(one.objects * contest.most_left(one.candidates) for one in rounds for contest in contests)
    done, end = 0, 0
    for one, kept in zip(rounds, [*(one.candidates for one in rounds[1:]), 1], strict=True):
        which = slice(end, end := end + one.objects)
        jobs = [(contest, primitive) for contest in contests for primitive in contest.left()]
        tasks = [
            [
                *map(
                    Task,
                    contest.scenes[which],
                    moved(primitive, len(contest.scenes), box, search.seed)[which],
                )
            ]
            for contest, primitive in jobs
        ]
        performed = perform_each(world_factory, tasks, search.workers, part(progress, done, total))
        for (contest, primitive), outcomes in zip(jobs, performed, strict=True):
            contest.seen.setdefault(primitive, []).extend(map(observe, outcomes))
        done += sum(map(len, tasks))
        for contest in contests:
            contest.close_round(kept)
    if done < total:
        progress(total, total)


@dataclass(slots=True, eq=False)
class _OfCategory(Contest):
    """The candidates for one category: for each symbol those that are left, the shared one first."""

    groups: list[list[Primitive]]

    def left(self) -> list[Primitive]:
        return [one for group in self.groups for one in group]

    def most_left(self, candidates: int) -> int:
        return sum(min(len(group), 1 + candidates) for group in self.groups)

    def close_round(self, kept: int) -> None:
        """Keep the best of each symbol, best first; the shared one stays in front until the last."""
        judged = [[judge(self.seen[one]) for one in group] for group in self.groups]
        ranked = zip(self.groups, _ranked(judged), strict=True)
        if kept == 1:
            self.groups = [[group[best[0]], *([group[0]] if best[0] else [])] for group, best in ranked]
        else:
            self.groups = [
                [group[0], *[group[number] for number in best if number][:kept]] for group, best in ranked
            ]


def choose_own(
    search: Search,
    shared: Sequence[Primitive],
    world_factory: WorldFactory,
    *,
    foresee: Foresee = foresee_displacement,
    rounds: Sequence[Round] = ROUNDS,
) -> Repertoire:
    """Choose for each category and symbol the candidate that does best there; keep the shared one if it adds.

    Args:
        search: What there is to choose from.
        shared: The action that each symbol shares among categories, in the order of the symbols.
        world_factory: Builds the world of the auditions.
        foresee: How actions are judged by what is predicted.
        rounds: Of the auditions, with fewer candidates in each.
    """
    world, features = made(world_factory), search.features
    least = sum(one.objects for one in rounds)
    sample = sample_by_category(world, search.categorise, least=least, seed=search.seed, stream=_OWN_STREAM)
    symbols = np.array(symbols_of(search.categorise, features))
    rivals = [
        [other for other in search.candidates if other.symbol == one.symbol and other != one]
        for one in shared
    ]
    contests = {}
    for category, scenes in sample.scenes.items():
        objects = np.concatenate([features[symbols == category], *(scene.features for scene in scenes)])
        objects, count = objects[:OWN_OBJECTS_TO_PREDICT], rounds[0].candidates
        few = shortlist_own(rivals, search.predict, objects, world.action_box, count, search.seed, foresee)
        groups = [[one, *best] for one, best in zip(shared, few, strict=True)]
        contests[category] = _OfCategory(scenes, groups)
    with search.open_bar("auditioning for each category") as advance:
        audition_in_rounds(search, [*contests.values()], rounds, world_factory, performance, advance)
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


def _chosen(contest: _OfCategory) -> list[Primitive]:
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


CHOICES = ("own", "predictable", "lowest-error")
AUDITIONED = (4, 2)
"""Candidates of each symbol that are auditioned, the first time and again."""
AUDITION_OBJECTS = 24
"""Objects on which each of them is performed, others each time."""
OBJECTS_TO_PREDICT = 200
"""Objects on which the effects of every candidate are predicted."""

_STREAM = 0x6175  # keeps the objects of auditions apart from those of rehearsals


def choose(
    candidates: Sequence[Primitive],
    choice: str,
    *,
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    categorise: Categorise,
    world_factory: WorldFactory | None,
    seed: int,
    workers: int = 1,
    open_bar: OpenBar = silent,
) -> Repertoire:
    """Choose one of the candidates for each symbol, and others for single categories if `choice` is "own".

    Args:
        candidates: Distilled actions.
        choice: One of `CHOICES`. Without a world, "own" is the same as "predictable".
        predict: A network that sees the objects themselves and not their symbols.
        features: Objects to predict the effects on.
        categorise: Gives the object symbols of features.
        world_factory: Builds the world of the auditions; None if there is none.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        open_bar: Shows how far the auditions have come.

    Raises:
        UnknownChoice: If there is no such choice.
        InvalidValue: If something is not what it should be.
        InvalidWorld: If it is a world of one's own that fails.
    """
    check_all("candidates", candidates, Primitive, "primitives, as distill returns them")
    if not candidates:
        raise InvalidValue("There are no candidates; distill gives at least one for a symbol that it found.")
    check_kind("choice", choice, str, f"one of {', '.join(CHOICES)}")
    check_callable("predict", predict, "a function from features and actions to outcomes")
    check_array("features", features, (None, None))
    check_seed(seed)
    check_count("workers", workers)
    if choice not in CHOICES:
        raise UnknownChoice("choice", choice, CHOICES)
    if world_factory is None:
        few = shortlist(candidates, predict, features[:OBJECTS_TO_PREDICT], categorise, 1)
        return shared_by_all(lowest_error(candidates) if choice == "lowest-error" else few)
    search = Search(
        tuple(candidates),
        predict,
        features,
        categorise,
        world_factory,
        world_factory,
        seed=seed,
        workers=workers,
        open_bar=open_bar,
    )
    return choose_among(search, choice)


def choose_among(search: Search, choice: str) -> Repertoire:
    """Choose among what is searched; see `choose`."""
    if choice == "lowest-error":
        return shared_by_all(lowest_error(search.candidates))
    features = search.features[:OBJECTS_TO_PREDICT]
    few = shortlist(search.candidates, search.predict, features, search.categorise, AUDITIONED[0])
    shared = audition(search, few)
    return shared_by_all(shared) if choice == "predictable" else choose_own(search, shared, search.shown)


def lowest_error(candidates: Sequence[Primitive]) -> tuple[Primitive, ...]:
    """Choose for each symbol the candidate of the lowest error to its code (the paper)."""
    ordered, groups = _by_symbol(candidates)
    return tuple(min((ordered[n] for n in group), key=lambda one: one.code_error) for group in groups)


def shortlist(
    candidates: Sequence[Primitive],
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    categorise: Categorise,
    count: int,
) -> tuple[Primitive, ...]:
    """Keep for each symbol the candidates that are predicted to be worth most among those of the others.

    Args:
        candidates: Distilled actions.
        predict: A network that sees the objects themselves and not their symbols.
        features: Objects to predict the effects on.
        categorise: Gives the object symbols of features.
        count: How many candidates are kept for each symbol.
    """
    symbols = np.array(symbols_of(categorise, features))
    ordered, groups = _by_symbol(candidates)
    happens = [predict(features, np.tile(np.array(c.action), (len(features), 1))) for c in ordered]
    return tuple(ordered[number] for number in _best_of_each(groups, np.array(happens), symbols, count))


def audition(
    search: Search, shortlisted: Sequence[Primitive], *, objects: int = AUDITION_OBJECTS
) -> tuple[Primitive, ...]:
    """Perform the candidates on the same sampled objects, and choose those that together are worth most.

    Two that move an object equally far differ if one carries it higher on the way. Who shone by luck is found
    out by a second audition of the best. The objects are others than those that primitives are rehearsed on
    afterwards.

    Args:
        search: What the candidates are searched with.
        shortlisted: Candidates, one or more for each symbol.
        objects: How many objects are sampled for each audition.
    """
    world = made(search.shown)
    few, groups = _by_symbol(shortlisted)
    again = sum(min(AUDITIONED[1], len(group)) for group in groups)
    total, scenes, done = objects * (len(few) + again), list[Scene](), 0
    happened = [list[list[float]]() for _ in few]
    with search.open_bar("auditioning") as advance:
        for kept in (AUDITIONED[1], 1):
            numbers = range(len(scenes), len(scenes) + objects)
            scenes += [
                world.sample_scene(np.random.default_rng([search.seed, _STREAM, n]), 1) for n in numbers
            ]
            tasks = [tasks_of(one, scenes[-objects:]) for one in few]
            performed = perform_each(search.shown, tasks, search.workers, part(advance, done, total))
            done += objects * len(few)
            for rows, outcomes in zip(happened, performed, strict=True):
                rows += [[*outcome.effect, outcome.peak_height] for outcome in outcomes]
            features = np.concatenate([scene.features for scene in scenes])
            symbols = np.array(symbols_of(search.categorise, features))
            best = _best_of_each(groups, np.array(happened), symbols, kept)
            few, happened = [few[number] for number in best], [happened[number] for number in best]
            groups = _by_symbol(few)[1]
    return tuple(few)


def _best_of_each(
    groups: Sequence[Sequence[int]],
    happens: Float[np.ndarray, "N M O"],
    symbols: np.ndarray,
    count: int,
) -> list[int]:
    """Keep those of each symbol that are worth most among the best set of the others, best first.

    Args:
        groups: For each symbol, the numbers of its candidates.
        happens: What each candidate does to each object.
        symbols: Symbol of each object.
        count: How many are kept of each symbol.
    """
    effects = observe(happens, symbols)
    chosen, kept = best_set(groups, effects), []
    for place, group in enumerate(groups):
        values = worth_in_place(chosen, place, group, effects)
        kept += [group[number] for number in np.argsort(-np.array(values), kind="stable")[:count]]
    return kept


def _by_symbol(candidates: Sequence[Primitive]) -> tuple[list[Primitive], list[list[int]]]:
    """Sort candidates by their symbols; returns them, and the numbers of those of each symbol."""
    ordered = sorted(candidates, key=lambda candidate: candidate.symbol)
    groups = groupby(range(len(ordered)), key=lambda number: ordered[number].symbol)
    return ordered, [list(numbers) for _, numbers in groups]
