"""How well do learned symbols of pairs agree with geometry that a person wrote?

Geometry names what operators do on one half of new rehearsals, and judges them on the other. Codes are
matched with names on one half of new pairs, and scored on the other. The robot is never told a name.
"""

from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.learning.effect_model import EffectModel
from neurosym.pair_states import describe_pair
from neurosym.primitives.by_state import end_state
from neurosym.primitives.sampling import sample_by_category
from neurosym.relation_operators import PairStates, RelationOperator, RelationOperators
from neurosym.sim.shapes import OPEN_TOP, SOLID
from neurosym.stages.layout import RELATION_MODEL, RELATION_OPERATORS, WORLD
from neurosym.world import Outcome, Scene
from neurosym.worlds.related import REFERENCE, TARGET, RelatedFactory
from neurosym.worlds.workers import Task, perform_all
from neurosym.worlds.world_file import read_world
from tools.benchmarks.carrying.tasks import is_graspable
from tools.benchmarks.relations.geometry import relation

REHEARSED = 24
"""New rehearsals of an operator."""
SURE = 0.5
"""Only operators that kept their promise so often when they were rehearsed are tried."""
NAMES = ("on", "in", "beside", "apart")
"""Relations that codes are matched with."""
RANDOM = 400
"""New random actions whose ends are predicted."""
_WALL = 0.006
_STREAM = 0x6765


def measure(folder: Path, seed: int, workers: int) -> dict[str, Any]:
    """Try the operators of a domain on new pairs, and match its codes with names.

    Args:
        folder: The domain, with relations.
        seed: Where the draws start, far from those that the domain was learned with.
        workers: How many processes.
    """
    table, model = (
        RelationOperators.load(folder / RELATION_OPERATORS),
        EffectModel.load(folder / RELATION_MODEL),
    )
    factory = RelatedFactory(read_world(folder / WORLD))
    tried = [*_rehearsed(table, model, factory, seed, workers)]
    outcomes = [outcome for _, ends in tried for outcome in ends]
    return {
        "operators": {name: _best(tried, table, name) for name in ("on", "in")},
        "state_bits": _state_accuracy(outcomes, PairStates(table.states, table.scales)),
        "static_bits": _static_accuracy(model, factory, seed),
        "operators_tried": len(tried),
    }


Tried = tuple[RelationOperator, list[Outcome]]


def _rehearsed(
    table: RelationOperators, model: EffectModel, factory: RelatedFactory, seed: int, workers: int
) -> Sequence[Tried]:
    """Rehearse operators that are sure enough on new pairs of their kind."""
    sample = sample_by_category(factory(), model.object_symbols, least=REHEARSED, seed=seed, stream=_STREAM)
    worthy = [
        one
        for one in table.operators
        if one.promise is not None and one.promise.share >= SURE and one.pair in sample.scenes
    ]
    scenes = {one.name: sample.scenes[one.pair][:REHEARSED] for one in worthy}
    tasks = [
        Task(scene, np.array(table.primitive_of(one).action)) for one in worthy for scene in scenes[one.name]
    ]
    performed = perform_all(factory, tasks, workers)
    return [(one, [next(performed) for _ in scenes[one.name]]) for one in worthy]


def _best(tried: Sequence[Tried], table: RelationOperators, name: str) -> dict[str, Any] | None:
    """Find the operator that on the first half of its rehearsals does most surely what geometry calls so.

    Returns:
        Its name, and how often it is right on both halves; None if none does it mostly.
    """
    states = PairStates(table.states, table.scales)
    best: tuple[float, RelationOperator, float] | None = None
    for one, outcomes in tried:
        if len(outcomes) < REHEARSED:
            continue  # pairs of this kind are too rare to judge it
        assert one.promise is not None, "only what is sure is tried"
        promised = one.promise.state
        right = [
            not outcome.disturbed
            and end_state(outcome, states) == promised
            and relation(outcome, TARGET, REFERENCE) == name
            for outcome in outcomes
        ]
        first, second = float(np.mean(right[::2])), float(np.mean(right[1::2]))
        if first > 0.5 and (best is None or first > best[0]):
            best = first, one, second
    if best is None:
        return None
    return {"operator": best[1].name, "first_half": best[0], "right": best[2]}


def _state_accuracy(outcomes: Sequence[Outcome], states: PairStates) -> dict[str, Any]:
    """Match states with names on half of the pairs, and score them on the other half."""
    codes, names = list[str](), list[str]()
    for outcome in outcomes:
        for one in range(len(outcome.end)):
            for other in range(len(outcome.end)):
                if one != other and (name := relation(outcome, one, other)) in NAMES:
                    described = describe_pair(outcome.end, one, other, outcome.contacts)
                    codes.append(states.of(described.tolist()).symbol)
                    names.append(name)
    recalls = _recalls(codes, names)
    return {"balanced": float(np.mean([*recalls.values()])), "recalls": recalls, "pairs": len(codes)}


def _static_accuracy(model: EffectModel, factory: RelatedFactory, seed: int) -> dict[str, Any]:
    """Match kinds of pairs with what can carry and what fits, as a person would say."""
    world, rng = factory(), np.random.default_rng([seed, _STREAM])
    scenes = [world.sample_scene(rng, 1) for _ in range(4 * RANDOM)]
    codes = model.object_symbols(np.concatenate([scene.features for scene in scenes]))
    found = {}
    for name, says in (("carries", _carries), ("fits", _fits)):
        told = [str(says(scene.whole)) for scene in scenes]  # type: ignore[attr-defined]
        found[name] = float(np.mean([*_recalls(codes, told).values()]))
    return {"balanced": float(np.mean([*found.values()])), **found}


def _carries(scene: Scene) -> bool:
    return is_graspable(scene.features[TARGET])


def _fits(scene: Scene) -> bool:
    target, reference = scene.features[TARGET], scene.features[REFERENCE]
    is_hollow = reference[3] > (SOLID + OPEN_TOP) / 2
    return bool(is_hollow and np.all(target[:2] < reference[:2] - 2 * _WALL))


def _recalls(codes: Sequence[str], names: Sequence[str]) -> dict[str, float]:
    """Say of each name how often the name that its code was matched with on the other half is that.

    A code is matched with the name whose share of its own pairs is the greatest there, so that frequent names
    do not take every code.
    """
    of_name, together = Counter(names[::2]), Counter(zip(codes[::2], names[::2], strict=True))

    def called(code: str) -> str:
        return max(of_name, key=lambda name: together[code, name] / of_name[name])

    matched: Callable[[str], str] = {code: called(code) for code in set(codes)}.__getitem__
    rest = list(zip(codes[1::2], names[1::2], strict=True))
    return {
        name: float(np.mean([matched(code) == name for code, own in rest if own == name]))
        for name in sorted(set(names[1::2]))
    }
