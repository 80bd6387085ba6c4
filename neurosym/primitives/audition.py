"""Choosing among distilled actions: many encode to a symbol, and some are more predictable than others.

A good action does nearly the same to all objects of a category, and something that no other symbol's action
does to them (`reliability.py`). That is first reckoned from what a network without a bottleneck predicts. Of
each symbol the few that it says most of are then auditioned on objects of each category (`bandit.py`). The
paper takes the candidate whose embedding is nearest to the code.
"""

from collections.abc import Sequence
from functools import cache
from itertools import groupby

import numpy as np

from neurosym.checks import Float, check_all, check_array, check_callable, check_count, check_kind, check_seed
from neurosym.contract import made
from neurosym.errors import InvalidValue, OpenBar, UnknownChoice, silent
from neurosym.operators import Categorise, Primitive, symbols_of
from neurosym.primitives.bandit import LEAST_GAIN, Contest, Groups, hold, trusted
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.rehearsal import rehearsal_sample
from neurosym.primitives.reliability import (
    CandidateEffects,
    Foresee,
    Judgement,
    PredictOutcomes,
    best_set,
    foresee_displacement,
    judge_outcomes,
    observe,
    worth_in_place,
)
from neurosym.primitives.sampling import Repertoire, Sample, shared_by_all, tasks_of, with_own
from neurosym.primitives.search import Search
from neurosym.world import ActionBox, WorldFactory

MOVED = 0.001
"""Standard deviation by which the lengths of actions are changed when it is predicted what they do [m]."""
_MOST_MOVED = 0.02  # as a share of what the length can be, where the box is small
_MOVES = 0x6F78  # keeps these draws apart from those of other auditions and rehearsals


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


# Own parameters: for each category of objects the candidates of each symbol that do best there

CANDIDATES = 8
"""How many candidates of a symbol are auditioned at most for a category."""
_OBJECTS_TO_PREDICT = 40  # objects of the category on which the effects of every candidate are predicted
_FEW, _SURE = 5, 0.1  # rehearsals of an operator that is hardly ever sure: less than so
_CHOOSING = 0.6  # share of all performances that choose
_CATEGORIES = 4  # for so many of which the objects to rehearse on are meant


def choose_own(
    search: Search, world_factory: WorldFactory, *, foresee: Foresee = foresee_displacement
) -> Repertoire:
    """Choose for each category and symbol what does best there.

    Candidates perform on the objects that the chosen are rehearsed on, where the world is the same: what they
    did already then counts.

    Args:
        search: What there is to choose from.
        world_factory: Builds the world that candidates perform in.
        foresee: How actions are judged by what is predicted of them.
    """
    sample = rehearsal_sample(
        made(world_factory), search.categorise, objects=search.objects, seed=search.seed
    )
    contests = {kind: _contest(search, sample, kind, foresee) for kind in sample.scenes}
    every = [*contests.values()]
    with search.open_bar("auditioning for each category") as advance:
        perform = search.performer(world_factory, advance)
        hold(every, perform, budget=int(_CHOOSING * search.budget), least=LEAST_GAIN)
    trust = trusted(every)
    usual, is_same = max(1, search.objects // _CATEGORIES), world_factory is search.shown
    for is_seen in (False, True):
        chosen = {kind: contest.best(trust, is_seen=is_seen) for kind, contest in contests.items()}
        own = [(kind, contest, one) for kind, contest in contests.items() for one in chosen[kind]]
        seen = [len(contest.seen.get(one, ())) if is_same else 0 for _, contest, one in own]
        sureness = [contest.judged(one, trust).sureness for _, contest, one in own]
        most = [usual if sure >= _SURE else min(_FEW, usual) for sure in sureness]
        if (enough := search.affordable(seen, most)) >= min(_FEW, usual):
            break  # else little is left, and what did not perform would hardly be known
    times = {
        (kind, one): max(count, min(enough, limit))
        for (kind, _, one), count, limit in zip(own, seen, most, strict=True)
    }
    shared = [_most_shared(group, chosen, sample) for group in _by_symbol(search.candidates)]
    return with_own(shared, chosen, times)


def _contest(search: Search, sample: Sample, kind: str, foresee: Foresee) -> Contest:
    """Begin a contest for a category among what is predicted to do best on its objects."""
    scenes, box = sample.scenes[kind], made(search.shown).action_box
    met = search.features[np.array(symbols_of(search.categorise, search.features)) == kind]
    objects = np.concatenate([met, *(scene.features for scene in scenes)])[:_OBJECTS_TO_PREDICT]
    foreseen = _foreseen(_by_symbol(search.candidates), search.predict, objects, box, search.seed, foresee)
    few = [
        [
            (one, judged)
            for place, (one, judged) in enumerate(group)
            if place < CANDIDATES or one in search.former
        ]
        for group in foreseen
    ]
    groups = [[one for one, _ in group] for group in few]
    known = dict(pair for group in few for pair in group)
    contest = Contest(sample.shares[kind], scenes, groups, known, judge_outcomes)
    for one in known:
        if seen := search.ledger.recall(tasks_of(one, scenes)):
            contest.seen[one] = seen
    return contest


def _most_shared(group: Sequence[Primitive], chosen: dict[str, list[Primitive]], sample: Sample) -> Primitive:
    """Return the candidate of a symbol that was chosen for most objects; it serves kinds never met."""

    def share(one: Primitive) -> float:
        return sum((sample.shares[kind] for kind, own in chosen.items() if one in own), 0.0)

    return max(group, key=share)


def _foreseen(
    groups: Sequence[Sequence[Primitive]],
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    box: ActionBox,
    seed: int,
    foresee: Foresee,
) -> list[list[tuple[Primitive, Judgement]]]:
    """Rank the candidates of each symbol by what they are predicted to do beside those of the others.

    Args:
        groups: The candidates of each symbol.
        predict: A network that sees the objects themselves and not their symbols.
        features: Objects of one category.
        box: What actions must stay inside.
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
        [(group[number], found[number]) for number in best]
        for group, found, best in zip(groups, judged, _ranked(judged), strict=True)
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


# Shared parameters: for each symbol one candidate, those that together are worth most

CHOICES = ("own", "predictable", "lowest-error")
OBJECTS_TO_PREDICT = 200
"""Objects on which the effects of every candidate are predicted."""


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
        if choice == "lowest-error":
            return shared_by_all(_lowest_error(candidates))
        return shared_by_all(_most_predictable(candidates, predict, features, categorise))
    search = Search(
        tuple(candidates),
        predict,
        features,
        categorise,
        world_factory,
        world_factory,
        seed=seed,
        ledger=Ledger(workers=workers),
        open_bar=open_bar,
    )
    return choose_among(search, choice)


def choose_among(search: Search, choice: str) -> Repertoire:
    """Choose among what is searched; see `choose`."""
    if choice == "lowest-error":
        return shared_by_all(_lowest_error(search.candidates))
    if choice == "own":
        return choose_own(search, search.shown)
    known = search.candidates, search.predict, search.features, search.categorise
    return shared_by_all(_most_predictable(*known))


def _lowest_error(candidates: Sequence[Primitive]) -> tuple[Primitive, ...]:
    """Choose for each symbol the candidate of the lowest error to its code (the paper)."""
    return tuple(min(group, key=lambda one: one.code_error) for group in _by_symbol(candidates))


def _most_predictable(
    candidates: Sequence[Primitive],
    predict: PredictOutcomes,
    features: Float[np.ndarray, "M F"],
    categorise: Categorise,
) -> tuple[Primitive, ...]:
    """Choose for each symbol the candidate that is predicted to be worth most among those of the others."""
    groups, features = _by_symbol(candidates), features[:OBJECTS_TO_PREDICT]
    flat = [one for group in groups for one in group]
    happens = [predict(features, np.tile(np.array(one.action), (len(features), 1))) for one in flat]
    effects = observe(np.array(happens), np.array(symbols_of(categorise, features)))  # of (N, M, O)
    numbers = iter(range(len(flat)))
    ranked = _best_of_each([[next(numbers) for _ in group] for group in groups], effects)
    return tuple(flat[best[0]] for best in ranked)


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
