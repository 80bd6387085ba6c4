"""Choosing among distilled actions: many encode to a symbol, and some are more predictable than others.

A good action does nearly the same to all objects of a category, and something that no other symbol's action
does to them (`reliability.py`). That is first reckoned from what a network without a bottleneck predicts, and
then measured: the few best of each symbol are auditioned in the world, and the best of those once more. By
default, categories of objects are then given actions of their own where those do better. The paper
takes the candidate whose embedding is nearest to the code.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache, partial
from itertools import groupby
from typing import Any

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
    draw_scene,
    perform_each,
    sample_by_category,
    shared_by_all,
    with_own,
)
from neurosym.world import ActionBox, Outcome, Scene, WorldFactory
from neurosym.worlds.workers import Task

# Contests: candidates perform in rounds, fewer of them in each


@dataclass(frozen=True, slots=True)
class Round:
    """One round of auditions.

    Attributes:
        candidates: How many of a symbol are auditioned, at most.
        objects: On how many objects each performs, others than in the rounds before.
    """

    candidates: int
    objects: int


ROUNDS = Round(6, 8), Round(3, 8)
"""Auditions of actions that displace objects of one category."""
CARRYING_ROUNDS = Round(16, 4), Round(8, 4), Round(4, 8), Round(2, 16)
"""Auditions of actions that carry objects: plans use the best of them only, so that it must be sure."""
SHARED_ROUNDS = Round(4, 24), Round(2, 24)
"""Auditions of actions that serve all categories: who shone by luck is found out by the second."""
MOVED = 0.001
"""Standard deviation of the change of each length of an action [m]."""
_MOST_MOVED = 0.02  # as a share of what the length can be, where the box is small
_MOVES = 0x6F78  # keeps these draws apart from those of other auditions and rehearsals

Groups = list[list[Primitive]]
"""Candidates, in groups of which some are left each."""


@dataclass(slots=True, eq=False)
class Contest:
    """Candidates that perform on the same scenes.

    Attributes:
        scenes: What they perform on, one object in each.
        groups: Those that are left.
        close_round: Says from the groups, what was seen, and how many of a group are kept, who is left.
        besides: How many of a group may be left in addition.
        is_moved: Whether actions are moved a little.
        seen: How they turned out.
    """

    scenes: Sequence[Scene]
    groups: Groups
    close_round: Callable[[Groups, dict[Primitive, list[Any]], int], Groups]
    besides: int = 0
    is_moved: bool = True
    seen: dict[Primitive, list[Any]] = field(default_factory=dict, init=False)

    def tasks(self, which: slice, box: ActionBox, seed: int) -> list[tuple[Primitive, list[Task]]]:
        """Say what it takes to have those that are left perform on some of the scenes."""
        left, count = [one for group in self.groups for one in group], len(self.scenes)
        actions = [
            moved(one, count, box, seed)
            if self.is_moved
            else np.tile(np.array(one.action, dtype=np.float64), (count, 1))
            for one in left
        ]
        return [
            (one, [*map(Task, self.scenes[which], rows[which])])
            for one, rows in zip(left, actions, strict=True)
        ]


def audition_in_rounds(
    search: Search,
    contests: Sequence[Contest],
    rounds: Sequence[Round],
    world_factory: WorldFactory,
    observed: Callable[[Outcome], Any],
    progress: Progress,
) -> None:
    """Perform the candidates of all contests in rounds.

    Of each round its number of candidates are left, and perform on so many further scenes.
    """
    box, done, end = made(world_factory).action_box, 0, 0
    groups = [(len(group), contest.besides) for contest in contests for group in contest.groups]
    total = sum(one.objects * min(size, one.candidates + more) for one in rounds for size, more in groups)
    for one, kept in zip(rounds, [*(one.candidates for one in rounds[1:]), 1], strict=True):
        which = slice(end, end := end + one.objects)
        jobs = [(contest, *job) for contest in contests for job in contest.tasks(which, box, search.seed)]
        tasks = [tasks for *_, tasks in jobs]
        performed = perform_each(world_factory, tasks, search.workers, part(progress, done, total))
        done += sum(map(len, tasks))
        for (contest, primitive, _), outcomes in zip(jobs, performed, strict=True):
            seen = contest.seen.setdefault(primitive, [])
            begin = len(seen) if contest.is_moved else which.start  # where the same action is there twice
            seen[begin:] = map(observed, outcomes)
        for contest in contests:
            contest.groups = contest.close_round(contest.groups, contest.seen, kept)
    if done < total:
        progress(total, total)


def moved(primitive: Primitive, count: int, box: ActionBox, seed: int) -> Float[np.ndarray, "N A"]:
    """Move the lengths of an action a little, once for each object: on an object for all actions alike.

    What lies on an edge, and does something else a hair beside it, then looks as bad as it is.

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


# Own parameters: for each category of objects the candidates of each symbol that do best there.
#
# One action for a symbol has to serve every category, and is exact on few. So candidates are shortlisted
# for each category by what a network without a bottleneck predicts, and auditioned on objects of that
# category: many candidates on a few of them first, then fewer on others.

_OWN_OBJECTS_TO_PREDICT = 40  # objects of the category on which the effects of every candidate are predicted
SAME, DIFFERENT = 0.02, 0.03
"""Outcomes nearer than the first are the same, farther apart than the second clearly different [m]."""
_WORTH_KEEPING = 0.25  # least sureness of a shared action that stays beside one of a category's own
_OWN_STREAM = 0x6F77  # keeps these draws apart from those of other auditions and rehearsals


def choose_own(
    search: Search,
    shared: Sequence[Primitive],
    world_factory: WorldFactory,
    *,
    foresee: Foresee = foresee_displacement,
    rounds: Sequence[Round] = ROUNDS,
) -> Repertoire:
    """Choose for each category and symbol what does best there; keep the shared one if it adds something."""
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
        objects, count = objects[:_OWN_OBJECTS_TO_PREDICT], rounds[0].candidates
        few = shortlist_own(rivals, search.predict, objects, world.action_box, count, search.seed, foresee)
        groups = [[one, *best] for one, best in zip(shared, few, strict=True)]
        contests[category] = Contest(scenes, groups, _close_own, besides=1)
    with search.open_bar("auditioning for each category") as advance:
        audition_in_rounds(search, [*contests.values()], rounds, world_factory, performance, advance)
    return with_own(shared, {category: _chosen(contest) for category, contest in contests.items()})


def _close_own(groups: Groups, seen: dict[Primitive, list[Any]], kept: int) -> Groups:
    """Keep the best of each symbol, best first; the shared one stays in front until the last round."""
    ranked, left = _ranked([[judge(seen[one]) for one in group] for group in groups]), Groups()
    for group, best in zip(groups, ranked, strict=True):
        if kept == 1:
            left.append([group[best[0]], *([group[0]] if best[0] else [])])
        else:
            left.append([group[0], *[group[number] for number in best if number][:kept]])
    return left


def shortlist_own(
    groups: Sequence[Sequence[Primitive]],
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    box: ActionBox,
    count: int,
    seed: int,
    foresee: Foresee = foresee_displacement,
) -> Groups:
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
    judged: list[list[Judgement]] = []
    for group in groups:
        actions = [moved(one, len(features), box, seed) for one in group]
        asked = np.tile(features, (len(group), 1))
        predicted = np.split(predict(asked, np.concatenate(actions)), len(group)) if group else []
        judged.append([*map(foresee, predicted)])
    return [
        [group[number] for number in best[:count]]
        for group, best in zip(groups, _ranked(judged), strict=True)
    ]


def _ranked(judged: Sequence[Sequence[Judgement]]) -> list[list[int]]:
    """Rank the candidates of each symbol by what they are worth beside the best of the others.

    What carries objects is ranked by how surely it does: one that does is as good as several.
    """
    flat = [judgement for group in judged for judgement in group]
    if not flat or any(one.kind == "carried" for one in flat):
        return [np.argsort([-one.sureness for one in group], kind="stable").tolist() for group in judged]
    numbers = iter(range(len(flat)))
    groups = [[next(numbers) for _ in group] for group in judged]
    means, sureness = [[one.mean] for one in flat], [[one.sureness] for one in flat]
    effects = CandidateEffects(np.array(means), np.array(sureness), np.ones(1))
    ranked = iter(_best_of_each([group for group in groups if group], effects))
    return [[number - group[0] for number in next(ranked)] if group else [] for group in groups]


def _chosen(contest: Contest) -> list[Primitive]:
    """Return the best of each symbol, and the shared ones that add something to them."""
    kept = [group[0] for group in contest.groups]
    effects = {one: judge(contest.seen[one]) for group in contest.groups for one in group}
    if any(one.kind == "carried" for one in effects.values()):
        return kept
    for own, *beside in contest.groups:
        for shared in beside:
            mine = effects[shared]
            others = [effects[one] for one in kept if one != own]
            crowded = any(_apart(effects[own], other) <= SAME for other in others)
            if (
                mine.sureness >= _WORTH_KEEPING
                and np.linalg.norm(mine.mean[:-1]) > LITTLE
                and all(_apart(mine, other) > SAME for other in others)
                and (crowded or _apart(mine, effects[own]) > DIFFERENT)
            ):
                kept.append(shared)
    return kept


def _apart(one: Judgement, other: Judgement) -> float:
    """Return how far apart two outcomes are [m], infinitely if they differ in kind."""
    return float(np.linalg.norm(one.mean[:-1] - other.mean[:-1])) if one.kind == other.kind else np.inf


# Shared parameters: for each symbol one candidate, those that together are worth most

CHOICES = ("own", "predictable", "lowest-error")
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
        return shared_by_all(_lowest_error(candidates) if choice == "lowest-error" else few)
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
        return shared_by_all(_lowest_error(search.candidates))
    features = search.features[:OBJECTS_TO_PREDICT]
    few = shortlist(
        search.candidates, search.predict, features, search.categorise, SHARED_ROUNDS[0].candidates
    )
    shared = audition(search, few)
    return shared_by_all(shared) if choice == "predictable" else choose_own(search, shared, search.shown)


def _lowest_error(candidates: Sequence[Primitive]) -> tuple[Primitive, ...]:
    """Choose for each symbol the candidate of the lowest error to its code (the paper)."""
    return tuple(min(group, key=lambda one: one.code_error) for group in _by_symbol(candidates))


def shortlist(
    candidates: Sequence[Primitive],
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    categorise: Categorise,
    count: int,
) -> tuple[Primitive, ...]:
    """Keep for each symbol the candidates that are predicted to be worth most among those of the others."""
    groups = _by_symbol(candidates)
    happens = {
        one: predict(features, np.tile(np.array(one.action), (len(features), 1)))
        for group in groups
        for one in group
    }
    few = _close_shared(np.array(symbols_of(categorise, features)), groups, happens, count)
    return tuple(one for group in few for one in group)


def audition(
    search: Search, shortlisted: Sequence[Primitive], *, rounds: Sequence[Round] = SHARED_ROUNDS
) -> tuple[Primitive, ...]:
    """Perform the candidates on the same sampled objects, and choose those that together are worth most.

    Two that move an object equally far differ if one carries it higher on the way. The objects are others
    than those that primitives are rehearsed on afterwards.
    """
    world, numbers = made(search.shown), range(sum(one.objects for one in rounds))
    scenes = [draw_scene(world, search.seed, _STREAM, number) for number in numbers]
    symbols = np.array(symbols_of(search.categorise, np.concatenate([scene.features for scene in scenes])))
    contest = Contest(scenes, _by_symbol(shortlisted), partial(_close_shared, symbols), is_moved=False)
    with search.open_bar("auditioning") as advance:
        audition_in_rounds(search, [contest], rounds, search.shown, _seen_to_do, advance)
    return tuple(one for group in contest.groups for one in group)


def _seen_to_do(outcome: Outcome) -> list[float]:
    return [*outcome.effect, outcome.peak_height]


def _close_shared(symbols: np.ndarray, groups: Groups, seen: dict[Primitive, Any], kept: int) -> Groups:
    """Keep those of each symbol that are worth most among the best set of the others, best first.

    What is seen of a candidate is for each object, or the first of them, what it does.
    """
    flat = [one for group in groups for one in group]
    happens = np.array([seen[one] for one in flat])  # (N, M, O)
    numbers = iter(range(len(flat)))
    ranked = _best_of_each(
        [[next(numbers) for _ in group] for group in groups], observe(happens, symbols[: happens.shape[1]])
    )
    return [[flat[number] for number in best[:kept]] for best in ranked]


def _best_of_each(groups: Sequence[Sequence[int]], effects: CandidateEffects) -> list[list[int]]:
    """Rank the candidates of each symbol by what they are worth among the best set of the others."""
    chosen, ranked = best_set(groups, effects), list[list[int]]()
    for place, group in enumerate(groups):
        values = worth_in_place(chosen, place, group, effects)
        ranked.append([group[number] for number in np.argsort(-np.array(values), kind="stable")])
    return ranked


def _by_symbol(candidates: Sequence[Primitive]) -> Groups:
    """Group candidates by their symbols, in the order of these."""
    ordered = sorted(candidates, key=lambda candidate: candidate.symbol)
    return [list(group) for _, group in groupby(ordered, key=lambda candidate: candidate.symbol)]
