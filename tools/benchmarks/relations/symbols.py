"""How well do learned symbols of pairs agree with geometry that a person wrote?

Geometry names what operators do on one half of new rehearsals, and judges them on the other. Codes are
matched with names on one half of new pairs, and scored on the other. The robot is never told a name.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.formats import PairFile, PlaceFile
from neurosym.learning.network import EffectModel
from neurosym.operators import Operator, labelled
from neurosym.pair_operators import PairStates, RelationOperators, describe_pair
from neurosym.primitives.reliability import end_state
from neurosym.primitives.sampling import draw_scene
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import MODEL, PLACE_OPERATORS, RELATION_OPERATORS, WORLD
from neurosym.stages.learning import carriers_of
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.tasks.supports import PairSight
from neurosym.world import Outcome, World
from neurosym.worlds.aims import REFERENCE, TARGET, KnownMotions, RelatedFactory
from neurosym.worlds.workers import Task, perform_all
from neurosym.worlds.world_file import read_world
from tools.benchmarks.carrying.tasks import is_graspable
from tools.benchmarks.relations.geometry import fits, relation
from tools.benchmarks.relations.summary import PUTS

REHEARSED = 48  # new rehearsals of an operator
SURE = 0.8  # an operator is tried on pairs with which it is foreseen to keep its promise so often: `surely`
PAIRS = 12_000  # new pairs, some of which are taken for each operator
NAMES = ("on", "in", "beside", "apart")
"""Relations that codes are matched with; those of `PUTS` are asked for by states that bear."""
RANDOM = 600  # new actions whose ends are predicted
PRECISE = 0.7
"""So much of what is foreseen to end on the reference does, at least, where the least chance is chosen; more
than is asked for, since half of so few actions say little."""
_STREAM = 0x6765


def measure(folder: Path, seed: int, workers: int) -> dict[str, Any]:
    """Try the operators of a domain on new pairs, and match its codes with names."""
    table, sight, factory = _learned(folder)
    tried = _rehearsed(table, sight, factory, seed, workers)
    outcomes = _all_of(tried)
    judged = _pairs_of(outcomes[1::2], table, NAMES)
    called = _matched(*_pairs_of(outcomes[::2], table, NAMES))
    words = _words(outcomes[::2], table)
    return {
        "operators": {name: _best(tried, table, name) for name in PUTS},
        "state_bits": {**_balanced(called, *judged), "pairs": len(judged[0])},
        "static_bits": _static_accuracy(sight, factory, seed),
        "recall_on": _recall(folder, sight, table, words["on"], seed, workers),
        "words": words,
        "operators_tried": len(tried),
    }


def words_of(folder: Path, seed: int, workers: int) -> dict[str, list[str]]:
    """Say which states of a domain mean what geometry calls so, by new pairs."""
    table, sight, factory = _learned(folder)
    return _words(_all_of(_rehearsed(table, sight, factory, seed, workers)), table)


def _learned(folder: Path) -> tuple[RelationOperators, PairSight, RelatedFactory]:
    sight, domain = sight_of_pairs(DomainFolder(folder)), DomainFolder(folder)
    assert sight is not None, "relations were learned"
    factory = RelatedFactory(read_world(folder / WORLD), aim=carriers_of(domain))
    return PairFile.load(folder / RELATION_OPERATORS).table(), sight, factory


def _words(outcomes: Sequence[Outcome], table: RelationOperators) -> dict[str, list[str]]:
    words: dict[str, list[str]] = {name: [] for name in NAMES}
    for code, name in sorted(_matched(*_pairs_of(outcomes, table, (*NAMES, "leaning"))).items()):
        if name in NAMES and (name not in PUTS or code in table.bearing):
            words[name].append(code)
    return words


def _all_of(tried: "Sequence[Tried]") -> list[Outcome]:
    return [outcome for *_, ends in tried for outcome in ends]


Tried = tuple[Operator, float, list[Outcome]]
"""An operator, the share of all pairs with which it is sure, and what it did to some of these."""


def _rehearsed(
    table: RelationOperators, sight: PairSight, factory: RelatedFactory, seed: int, workers: int
) -> Sequence[Tried]:
    """Rehearse operators on new pairs with which they are foreseen to keep their promises."""
    world, order = factory(), table.bearing
    scenes = [draw_scene(world, seed, _STREAM, number) for number in range(PAIRS)]
    features = np.concatenate([scene.features for scene in scenes])
    kinds, asked = np.array(sight.kinds(features)), list[tuple[Operator, np.ndarray]]()
    assert sight.chances is not None, "learned with the kinds"
    for one in table.operators:
        if one.promise is None or one.promise.kind not in order:
            continue
        rows, action = (
            np.flatnonzero(kinds == one.subject),
            np.array(labelled(table.primitives, one.label).action),
        )
        if len(rows) < REHEARSED:
            continue
        foreseen = sight.chances(features[rows], np.tile(action, (len(rows), 1)))
        sure = rows[foreseen[:, order.index(one.promise.kind)] >= SURE]
        if len(sure) >= REHEARSED:  # else such pairs are too rare to judge it
            asked.append((one, sure))
    chosen = [
        (row, labelled(table.primitives, one.label).action) for one, sure in asked for row in sure[:REHEARSED]
    ]
    tasks = [Task(scenes[row], np.array(action)) for row, action in chosen]
    performed = perform_all(factory, tasks, workers)
    return [(one, len(sure) / PAIRS, [next(performed) for _ in range(REHEARSED)]) for one, sure in asked]


def _best(tried: Sequence[Tried], states: PairStates, name: str) -> dict[str, Any] | None:
    """Find the operator that on the first half of its rehearsals does most surely what geometry calls so.

    Returns:
        Its name, and how often it is right on both halves; None if none does it mostly.
    """
    known = []
    for one, share, outcomes in tried:
        assert one.promise is not None, "only what is sure is tried"
        right = [
            not outcome.disturbed
            and end_state(outcome, states) == one.promise.kind
            and relation(outcome, TARGET, REFERENCE) == name
            for outcome in outcomes
        ]
        known.append((float(np.mean(right[::2])), share, float(np.mean(right[1::2])), one.name))
    first, share, second, operator = max(known, key=lambda one: one[:2], default=(0.0, 0.0, 0.0, ""))
    if first <= 0.5:
        return None
    return {"operator": operator, "first_half": first, "right": second, "pairs": share}


def _pairs_of(outcomes: Sequence[Outcome], states: PairStates, told: Sequence[str]) -> list[list[str]]:
    """Tell of all pairs of objects their states, and what geometry calls them, if that is to be told."""
    codes, names = list[str](), list[str]()
    for outcome in outcomes:
        for pair in permutations(range(len(outcome.end)), 2):
            if (name := relation(outcome, *pair)) in told:
                described = describe_pair(outcome.end, *pair, outcome.contacts)
                codes.append(states.of(described.tolist()).symbol)
                names.append(name)
    return [codes, names]


def _static_accuracy(sight: PairSight, factory: RelatedFactory, seed: int) -> dict[str, Any]:
    """Match kinds of pairs with what can carry and what fits, as a person would say."""
    world, rng = factory(), np.random.default_rng([seed, _STREAM])
    scenes = [world.sample_scene(rng, 1) for _ in range(4 * RANDOM)]
    codes = sight.kinds(np.concatenate([scene.features for scene in scenes]))
    pairs = [(scene.whole.features[TARGET], scene.whole.features[REFERENCE]) for scene in scenes]
    carries, fit = [str(is_graspable(one)) for one, _ in pairs], [str(fits(*pair)) for pair in pairs]
    found = {
        name: _balanced(_matched(codes[::2], told[::2]), codes[1::2], told[1::2])["balanced"]
        for name, told in (("carries", carries), ("fits", fit))
    }
    return {"balanced": float(np.mean([*found.values()])), **found}


def known_motions(folder: Path, world: World) -> KnownMotions:
    """Return the motions that exploring begins with: those that a domain carries to places with."""
    table, model = PlaceFile.load(folder / PLACE_OPERATORS).table(), EffectModel.load(folder / MODEL)
    return KnownMotions(table, model.object_symbols, world.action_box)


def _recall(
    folder: Path, sight: PairSight, states: PairStates, on: Sequence[str], seed: int, workers: int
) -> dict[str, float]:
    """Predict of new actions which end on the reference, and count which of those that do are recalled.

    Actions are drawn as exploring draws them. On the first half the least chance is chosen for which
    `PRECISE` of what is predicted to be on is so; the second half counts.
    """
    plain = read_world(folder / WORLD)
    factory = RelatedFactory(plain, known_motions(folder, plain()))
    world, rng = factory(), np.random.default_rng([seed, _STREAM, 1])
    scenes = [world.sample_scene(rng, 1) for _ in range(RANDOM)]
    actions = np.concatenate([world.draw_actions(rng, scene, 2)[:1] for scene in scenes])
    tasks = [Task(scene, action) for scene, action in zip(scenes, actions, strict=True)]
    ends = perform_all(factory, tasks, workers)
    is_on = np.array([end.carried and relation(end, TARGET, REFERENCE) == "on" for end in ends])
    assert sight.chances is not None, "learned with the kinds"
    order = states.bearing
    foreseen = sight.chances(np.concatenate([scene.features for scene in scenes]), actions)
    chances = foreseen[:, [order.index(symbol) for symbol in on if symbol in order]].sum(1)
    found, right = is_on[::2], is_on[1::2]
    first = chances[::2]
    precise = (chance for chance in first if chance > 0 and found[first >= chance].mean() >= PRECISE)
    least = min(precise, default=np.inf)
    said = chances[1::2] >= least
    return {
        "share": float(right.mean()),
        "recall": float(said[right].mean()) if right.any() else 0.0,
        "precision": float(right[said].mean()) if said.any() else 0.0,
    }


def _matched(codes: Sequence[str], names: Sequence[str]) -> dict[str, str]:
    """Match each code with the name whose share of its own pairs is greatest; frequent ones take not all."""
    of_name, both = Counter(names), Counter(zip(codes, names, strict=True))
    told = sorted(of_name)
    return {code: max(told, key=lambda name: both[code, name] / of_name[name]) for code in sorted(set(codes))}


def _balanced(called: Mapping[str, str], codes: Sequence[str], names: Sequence[str]) -> dict[str, Any]:
    """Say of each name how often the name that its code was matched with is that, and the mean of these."""
    rows = list(zip(codes, names, strict=True))
    recalls = {
        name: float(np.mean([called.get(code) == name for code, own in rows if own == name]))
        for name in sorted(set(names))
    }
    return {"balanced": float(np.mean([*recalls.values()])) if recalls else 0.0, "recalls": recalls}
