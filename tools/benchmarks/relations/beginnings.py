"""After how many interactions can the robot put on, and put in? With those it chose, and with random ones.

From the first interactions it learns states of pairs, and to foresee them. For each state the action that was
foreseen to bring the most new pairs there, of those that carried something, is performed on some of these.
Geometry says what it did: on one half of them it names it, on the other it judges.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.data.origin import StrategyName
from neurosym.learning.state_codes import carried, ended_in, ends_in, fit_chances, foreseen_by, learn_states
from neurosym.learning.training_config import STATE_BITS, regime_named
from neurosym.pair_operators import PairStates, describe_pair
from neurosym.primitives.sampling import draw_scene
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import RELATION_INTERACTIONS, WORLD
from neurosym.stages.learning import TO_OBJECTS, explore_stage
from neurosym.tasks.supports import ChancesOfStates
from neurosym.world import Outcome, Scene
from neurosym.worlds.aims import REFERENCE, TARGET, RelatedFactory
from neurosym.worlds.workers import Task, perform_all
from neurosym.worlds.world_file import read_world
from tools.benchmarks.relations.geometry import relation
from tools.benchmarks.relations.learned import NEW_PAIRS, REGIME, copy_start
from tools.benchmarks.relations.summary import PUTS
from tools.benchmarks.relations.symbols import REHEARSED, SURE

NUMBERS = 160, 320, 640, 1_280, 2_560
"""So many interactions are learned from."""
PAIRS, ACTIONS = 2_000, 256
"""New pairs that are looked at, and actions that may be chosen."""
_STREAM = 0x6265


def found_after(
    places: Path, explored: Path, folder: Path, seed: int, strategy: StrategyName
) -> list[dict[str, Any]]:
    """Find out what can be done after some interactions and after more.

    Returns:
        For each number of interactions how many of them ended in a state that bears, and how often what puts
        on and what puts in did so, with the share of all pairs with which that was foreseen; None if nothing
        did it mostly.
    """
    if not (explored / RELATION_INTERACTIONS).exists():
        copy_start(places, folder)
        domain, explored = DomainFolder(folder), folder
        stage = explore_stage(
            domain, TO_OBJECTS, strategy=strategy, steps=NUMBERS[-1], seed=seed, regime=REGIME, workers=1
        )
        domain.perform(stage, again=False)
    every = Interactions.load(explored / RELATION_INTERACTIONS)
    assert len(every) >= NUMBERS[-1], "so many were made"
    factory = RelatedFactory(read_world(explored / WORLD))
    return [_found(every[:number], factory, seed) for number in NUMBERS]


def _found(interactions: Interactions, factory: RelatedFactory, seed: int) -> dict[str, Any]:
    world, rng = factory(), np.random.default_rng([NEW_PAIRS + seed, _STREAM])
    scenes = [draw_scene(world, NEW_PAIRS + seed, _STREAM, number) for number in range(PAIRS)]
    fresh = np.array([describe_pair(scene.whole, TARGET, REFERENCE, ()) for scene in scenes])  # type: ignore[attr-defined]
    states = learn_states(fresh, *ends_in(interactions), STATE_BITS, rng)
    found = {"interactions": len(interactions), "borne": float(ended_in(interactions, states).sum())}
    if not states.bearing:
        return found | dict.fromkeys(PUTS)
    training = regime_named(REGIME).training
    model = fit_chances(interactions, states, training, seed=seed, progress=lambda *_: None)
    candidates = rng.permutation(interactions.actions[carried(interactions)])[:ACTIONS]
    tried = _tried(states, foreseen_by(model), candidates, scenes, factory)
    return found | {name: _best(tried, name) for name in PUTS}


def _tried(
    states: PairStates,
    foresee: ChancesOfStates,
    candidates: np.ndarray,
    scenes: Sequence[Scene],
    factory: RelatedFactory,
) -> list[tuple[float, list[Outcome]]]:
    """Perform for each state what is foreseen to bring the most pairs there, on some of these."""
    features = np.concatenate([scene.features for scene in scenes])
    foreseen = np.array([foresee(features, np.tile(action, (PAIRS, 1))) for action in candidates])
    sure = foreseen >= SURE  # (candidates, pairs, states)
    tried = []
    for column in range(len(states.bearing)):
        best = int(sure[:, :, column].sum(1).argmax())
        rows = np.flatnonzero(sure[best, :, column])
        if len(rows) >= REHEARSED:
            tasks = [Task(scenes[row], candidates[best]) for row in rows[:REHEARSED]]
            tried.append((len(rows) / PAIRS, [*perform_all(factory, tasks, 1)]))
    return tried


def _best(tried: Sequence[tuple[float, list[Outcome]]], name: str) -> dict[str, float] | None:
    """Say how often what mostly does what geometry calls so did it on the other half of its pairs."""
    known = []
    for share, outcomes in tried:
        did = [
            outcome.carried and not outcome.disturbed and relation(outcome, TARGET, REFERENCE) == name
            for outcome in outcomes
        ]
        known.append((float(np.mean(did[::2])), share, float(np.mean(did[1::2]))))
    first, share, second = max(known, key=lambda one: one[:2], default=(0.0, 0.0, 0.0))
    return {"right": second, "pairs": share} if first > 0.5 else None
