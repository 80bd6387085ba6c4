"""The stages that learn to carry objects to places: data of their own, networks, and operators.

They do once more what `exploring.py`, `training.py` and `distilling.py` do, in a world in which every action
is aimed at a place, and leave what these have made as it is.
"""

from typing import Any

from neurosym.checks import check_count
from neurosym.console import progress_bar
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile
from neurosym.files import write_json
from neurosym.learning.model_config import PLACE_BITS
from neurosym.learning.training_config import regime_named
from neurosym.stages.aimed_learning import aimed_interactions, check_takes, explore_aimed, train_aimed
from neurosym.stages.exploring import check_choices
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    MODEL,
    PLACE_DIRECT_MODEL,
    PLACE_INTERACTIONS,
    PLACE_MODEL,
    PLACE_OPERATORS,
    PLACE_TRAINING,
    PLACES,
    WORLD,
)
from neurosym.stages.manifest import Claim, Stage
from neurosym.strategies import StrategyName, own_name
from neurosym.worlds.aimed import PLACE_AXES, AimedFactory
from neurosym.worlds.workers import check_workers
from neurosym.worlds.world_file import read_world


def explore_places_stage(
    folder: DomainFolder,
    *,
    strategy: StrategyName,
    steps: int,
    seed: int,
    regime: str,
    workers: int,
    ray: str | None = None,
) -> Stage:
    """Explore with actions that are aimed at places: `world.toml` -> `places/interactions.npz`."""
    chosen, name = check_choices(strategy, regime), own_name(strategy)

    def work() -> None:
        from neurosym.worlds.world_file import origin_of

        check_count("places", steps)
        factory = read_world(folder.require(WORLD))
        check_takes(factory(), "place")
        explore_aimed(
            AimedFactory(factory),
            folder / PLACES,
            what="places",
            regime=chosen,
            strategy=strategy,
            steps=steps,
            seed=seed,
            workers=workers,
            ray=ray,
            origin={**origin_of(factory), "reference": "place"},
        )

    options: dict[str, Any] = {"strategy": name, "steps": steps, "seed": seed, "regime": regime}
    return Stage("explore-places", (WORLD,), (PLACE_INTERACTIONS,), work, options, Claim.ALONE)


def train_places_stage(folder: DomainFolder, *, seed: int, regime: str) -> Stage:
    """Fit the networks of actions that are aimed at places: `places/interactions.npz` -> the networks."""
    chosen = regime_named(regime)

    def work() -> None:
        interactions = aimed_interactions(folder.require(PLACE_INTERACTIONS), PLACE_AXES)
        trained = train_aimed(interactions, what="places", regime=chosen, bits=PLACE_BITS, seed=seed)
        write_json(folder / PLACE_TRAINING, trained.report)
        trained.direct.save(folder / PLACE_DIRECT_MODEL)
        trained.model.save(folder / PLACE_MODEL)

    outputs = (PLACE_MODEL, PLACE_DIRECT_MODEL, PLACE_TRAINING)
    options = {"seed": seed, "regime": regime}
    return Stage("train-places", (PLACE_INTERACTIONS,), outputs, work, options, Claim.ALONE)


def distill_places_stage(folder: DomainFolder, *, objects: int, seed: int, workers: int) -> Stage:
    """Distil and rehearse what carries objects: networks, data and world -> `places/operators.json`."""
    check_count("objects", objects)
    check_workers(workers)

    def work() -> None:
        from neurosym.learning.direct_model import DirectModel
        from neurosym.learning.effect_model import EffectModel
        from neurosym.primitives.carrying import find_carriers
        from neurosym.primitives.table import NothingDistilled

        factory = read_world(folder.require(WORLD))
        categorise = EffectModel.load(folder.require(MODEL)).object_symbols
        try:
            found = find_carriers(
                EffectModel.load(folder.require(PLACE_MODEL)),
                DirectModel.load(folder.require(PLACE_DIRECT_MODEL)).predict_outcomes,
                Interactions.load(folder.require(PLACE_INTERACTIONS)),
                factory().action_box,
                categorise,
                world_factory=factory,
                objects=objects,
                seed=seed,
                workers=workers,
                open_bar=progress_bar,
            )
        except NothingDistilled as error:
            raise InvalidFile(folder / PLACE_MODEL, "no action encodes to its symbol; train again") from error
        write_json(folder / PLACE_OPERATORS, found)

    inputs = (WORLD, MODEL, PLACE_MODEL, PLACE_DIRECT_MODEL, PLACE_INTERACTIONS)
    options = {"objects": objects, "seed": seed}
    return Stage("distill-places", inputs, (PLACE_OPERATORS,), work, options, Claim.ALONE)
