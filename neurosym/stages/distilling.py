"""The stage that distils: networks, data and world -> `primitives.json`."""

from pathlib import Path

from neurosym.actions import ActionBox
from neurosym.console import progress_bar
from neurosym.data.check import model_misfit, world_misfit
from neurosym.data.interactions import Interactions
from neurosym.data.origin import box_of
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import write_json
from neurosym.primitives.audition import CHOICES
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DIRECT_MODEL, INTERACTIONS, MODEL, PRIMITIVES, WORLD
from neurosym.stages.manifest import Claim, Stage
from neurosym.world import WorldFactory
from neurosym.worlds.workers import check_workers
from neurosym.worlds.world_file import read_world


def distill_stage(
    folder: DomainFolder, *, objects: int, seed: int, workers: int, choice: str = "own"
) -> Stage:
    """Distil primitives and rehearse them: model, data and world -> `primitives.json`.

    Without a `world.toml`, nothing is rehearsed: effects are averaged from the data, whose origin, or else
    least and greatest values, are the action box.
    """
    if objects < 1:
        raise InvalidValue(f"objects = {objects} must be at least 1.")
    check_workers(workers)
    if choice not in CHOICES:
        raise UnknownChoice("choice", choice, CHOICES)

    def work() -> None:
        from neurosym.learning.direct_model import DirectModel
        from neurosym.learning.effect_model import EffectModel
        from neurosym.primitives.table import NothingDistilled, find_operators

        factory = read_world(folder / WORLD) if (folder / WORLD).exists() else None
        model = EffectModel.load(folder.require(MODEL))
        direct = DirectModel.load(folder.require(DIRECT_MODEL))
        interactions = Interactions.load(folder.require(INTERACTIONS))
        for name, network in ((MODEL, model), (DIRECT_MODEL, direct)):
            if problem := model_misfit(network.dimensions, interactions.columns, interactions.origin):
                raise InvalidFile(folder / name, problem)
        try:
            table = find_operators(
                model,
                direct,
                interactions,
                _box(folder / INTERACTIONS, interactions, factory),
                world_factory=factory,
                objects=objects,
                choice=choice,
                seed=seed,
                workers=workers,
                open_bar=progress_bar,
            )
        except NothingDistilled as error:
            raise InvalidFile(folder / MODEL, "no action encodes to its symbol; train again") from error
        write_json(folder / PRIMITIVES, table)

    options = {"objects": objects, "seed": seed, "choice": choice}
    inputs = (WORLD, MODEL, DIRECT_MODEL, INTERACTIONS)
    return Stage("distill", inputs, (PRIMITIVES,), work, options, Claim.ALONE)


def _box(path: Path, interactions: Interactions, factory: WorldFactory | None) -> ActionBox:
    """Return the action box: the world's, or where there is none, the data's."""
    if factory is None:
        low, high, is_gripper = box_of(interactions.actions, interactions.origin)
        return ActionBox(low, high, is_gripper)
    world = factory()
    features, actions = len(world.feature_names), len(world.action_box.low)
    if problem := world_misfit(world.name, features, actions, interactions.columns):
        raise InvalidFile(path, problem)
    return world.action_box
