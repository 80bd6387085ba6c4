"""The stages that learn what can be done with one object relative to another.

They do once more what `aiming.py` does for places, in a world in which every action is aimed at another
object: data of their own, networks, states of pairs, and operators.
"""

from typing import Any

import numpy as np

from neurosym.checks import check_count
from neurosym.console import progress_bar
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile
from neurosym.files import write_json
from neurosym.learning.model_config import PAIR_BITS, STATE_BITS
from neurosym.learning.training_config import regime_named
from neurosym.stages.aimed_learning import aimed_interactions, check_takes, explore_aimed, train_aimed
from neurosym.stages.exploring import check_choices
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    MODEL,
    PLACE_OPERATORS,
    RELATION_CHANCES,
    RELATION_INTERACTIONS,
    RELATION_MODEL,
    RELATION_OPERATORS,
    RELATION_STATES,
    RELATION_TRAINING,
    RELATIONS,
    WORLD,
)
from neurosym.stages.manifest import Claim, Stage
from neurosym.strategies import StrategyName, own_name
from neurosym.worlds.related import PAIR_AXES, RelatedFactory
from neurosym.worlds.workers import check_workers
from neurosym.worlds.world_file import read_world

FRESH = 600
"""Pairs that nobody touched, to learn states from."""
_STREAM = 0x6672  # keeps their draws apart from others


def explore_relations_stage(
    folder: DomainFolder,
    *,
    strategy: StrategyName,
    steps: int,
    seed: int,
    regime: str,
    workers: int,
    ray: str | None = None,
) -> Stage:
    """Explore with actions that are aimed at other objects, from what carries objects to places.

    It reads `world.toml`, `effect_model.safetensors`, and `places/operators.json`, and writes
    `relations/interactions.npz`.
    """
    chosen, name = check_choices(strategy, regime), own_name(strategy)

    def work() -> None:
        from neurosym.learning.effect_model import EffectModel
        from neurosym.place_operators import PlaceOperators
        from neurosym.worlds.known_motions import KnownMotions
        from neurosym.worlds.world_file import origin_of

        check_count("relations", steps)
        factory = read_world(folder.require(WORLD))
        check_takes(world := factory(), "object")
        categorise = EffectModel.load(folder.require(MODEL)).object_symbols
        places = PlaceOperators.load(folder.require(PLACE_OPERATORS))
        motions = KnownMotions(places, categorise, world.action_box)
        explore_aimed(
            RelatedFactory(factory, motions),
            folder / RELATIONS,
            what="relations",
            regime=chosen,
            strategy=strategy,
            steps=steps,
            seed=seed,
            workers=workers,
            ray=ray,
            origin={**origin_of(factory), "reference": "object", "proposed": True},
        )

    options: dict[str, Any] = {"strategy": name, "steps": steps, "seed": seed, "regime": regime}
    inputs = (WORLD, MODEL, PLACE_OPERATORS)
    return Stage("explore-relations", inputs, (RELATION_INTERACTIONS,), work, options, Claim.ALONE)


def train_relations_stage(folder: DomainFolder, *, seed: int, regime: str) -> Stage:
    """Fit the networks of pairs, and find their states: `relations/interactions.npz` -> the networks."""
    chosen = regime_named(regime)

    def work() -> None:
        from neurosym.learning.state_chances import fit_chances
        from neurosym.learning.state_codes import ends_in, learn_states

        path = folder.require(RELATION_INTERACTIONS)
        interactions = aimed_interactions(path, PAIR_AXES)
        if not np.any(interactions.effects[:, -1]):
            raise InvalidFile(path, "nothing was carried to another object; explore more")
        rng = np.random.default_rng([seed, _STREAM])
        world = RelatedFactory(read_world(folder.require(WORLD)))()
        states = learn_states(_fresh(world, rng), *ends_in(interactions), STATE_BITS, rng)
        if not states.bearing:
            raise InvalidFile(path, "no object came to bear another one; explore more")
        trained = train_aimed(interactions, what="pairs", regime=chosen, bits=PAIR_BITS, seed=seed)
        with progress_bar("learning what is foreseen of pairs") as advance:
            chances = fit_chances(
                interactions,
                states,
                chosen.training,
                seed=seed,
                progress=lambda stage, share: advance(round(100 * share), 100, stage),
            )
        write_json(folder / RELATION_STATES, states)
        write_json(folder / RELATION_TRAINING, trained.report)
        chances.save(folder / RELATION_CHANCES)
        trained.model.save(folder / RELATION_MODEL)

    inputs = (WORLD, RELATION_INTERACTIONS)
    outputs = (RELATION_STATES, RELATION_MODEL, RELATION_CHANCES, RELATION_TRAINING)
    return Stage("train-relations", inputs, outputs, work, {"seed": seed, "regime": regime}, Claim.ALONE)


def distill_relations_stage(folder: DomainFolder, *, pairs: int, seed: int, workers: int) -> Stage:
    """Distil and rehearse what brings pairs into states -> `relations/operators.json`."""
    check_count("objects", pairs)
    check_workers(workers)

    def work() -> None:
        from neurosym.learning.direct_model import DirectModel
        from neurosym.learning.effect_model import EffectModel
        from neurosym.learning.state_chances import foreseen_by
        from neurosym.primitives.relating import find_relators
        from neurosym.primitives.table import NothingDistilled
        from neurosym.relation_operators import PairStates

        factory = read_world(folder.require(WORLD))
        try:
            found = find_relators(
                EffectModel.load(folder.require(RELATION_MODEL)),
                foreseen_by(DirectModel.load(folder.require(RELATION_CHANCES))),
                Interactions.load(folder.require(RELATION_INTERACTIONS)),
                factory().action_box,
                PairStates.load(folder.require(RELATION_STATES)),
                world_factory=factory,
                pairs=pairs,
                seed=seed,
                workers=workers,
                open_bar=progress_bar,
            )
        except NothingDistilled as error:
            raise InvalidFile(
                folder / RELATION_MODEL, "no action encodes to its symbol; train again"
            ) from error
        write_json(folder / RELATION_OPERATORS, found)

    inputs = (WORLD, RELATION_MODEL, RELATION_CHANCES, RELATION_INTERACTIONS, RELATION_STATES)
    options = {"objects": pairs, "seed": seed}
    return Stage("distill-relations", inputs, (RELATION_OPERATORS,), work, options, Claim.ALONE)


def _fresh(world: Any, rng: np.random.Generator) -> np.ndarray:
    """Describe pairs as they stand before anybody touched them."""
    from neurosym.pair_states import describe_pair
    from neurosym.worlds.related import REFERENCE, TARGET

    scenes = (world.sample_scene(rng, 1).whole for _ in range(FRESH))
    return np.array([describe_pair(scene, TARGET, REFERENCE, ()) for scene in scenes])
