"""Choosing among distilled actions: many encode to a symbol, and some are more predictable than others.

A good action does nearly the same to all objects of a category, and something that no other symbol's action
does to them (`variety.py`). That is first reckoned from what a network without a bottleneck predicts, and
then measured: the few best of each symbol are auditioned in the world, and the best of those once more. By
default, categories of objects are then given actions of their own where those do better (`own.py`). The paper
takes the candidate whose embedding is nearest to the code.
"""

from collections.abc import Sequence
from itertools import groupby

import numpy as np

from neurosym.arrays import Float
from neurosym.checks import check_all, check_array, check_callable, check_count, check_kind, check_seed
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.guarded import made
from neurosym.operators import Primitive
from neurosym.primitives.own import choose_own
from neurosym.primitives.performing import perform_each, tasks_of
from neurosym.primitives.repertoire import Repertoire, shared_by_all
from neurosym.primitives.search import Search
from neurosym.primitives.variety import PredictOutcomes, best_set, observe, worth_in_place
from neurosym.progress import OpenBar, part, silent
from neurosym.symbols import Categorise, symbols_of
from neurosym.world import Scene, WorldFactory

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
