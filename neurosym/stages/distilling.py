"""The stages of the way, each from files of a domain folder to files of a domain folder: load, call, save.

The command line performs one stage at a time; `neurosym run` performs all of them, each only where its
inputs, options or outputs have changed. What is slow to import is imported where it is used.
"""

from pathlib import Path

from neurosym.actions import ActionBox
from neurosym.console import progress_bar
from neurosym.data.check import model_misfit, world_misfit
from neurosym.data.interactions import Interactions
from neurosym.data.origin import box_of
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import write_json
from neurosym.primitives.audition import CHOICES, choose
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DIRECT_MODEL, INTERACTIONS, MODEL, PRIMITIVES, WORLD
from neurosym.stages.manifest import Stage
from neurosym.world import WorldFactory
from neurosym.worlds.world_file import read_world


def distill_stage(
    folder: DomainFolder, *, objects: int, seed: int, workers: int, choice: str = "predictable"
) -> Stage:
    """Distil primitives and rehearse them: model, data and world -> `primitives.json`.

    Without a `world.toml`, nothing is rehearsed: effects are averaged from the data, whose origin, or else
    least and greatest values, are the action box.
    """
    for name, value in (("objects", objects), ("workers", workers)):
        if value < 1:
            raise InvalidValue(f"{name} = {value} must be at least 1.")
    if choice not in CHOICES:
        raise UnknownChoice("choice", choice, CHOICES)

    def work() -> None:
        from neurosym.learning.direct_model import DirectModel
        from neurosym.learning.effect_model import EffectModel
        from neurosym.primitives.averaging import average
        from neurosym.primitives.distillation import distill
        from neurosym.primitives.rehearsal import rehearse, tabulate

        factory = read_world(folder / WORLD) if (folder / WORLD).exists() else None
        model = EffectModel.load(folder.require(MODEL))
        direct = DirectModel.load(folder.require(DIRECT_MODEL))
        interactions = Interactions.load(folder.require(INTERACTIONS))
        for name, network in ((MODEL, model), (DIRECT_MODEL, direct)):
            if problem := model_misfit(network.dimensions, interactions.columns, interactions.origin):
                raise InvalidFile(folder / name, problem)
        box = _box(folder / INTERACTIONS, interactions, factory)
        with progress_bar("distilling") as advance:
            candidates = distill(model, interactions, box, seed=seed, progress=advance)
        if not candidates:
            raise InvalidFile(folder / MODEL, "no action encodes to its symbol; train again")
        categorise = model.object_symbols
        with progress_bar("auditioning") as advance:
            primitives = choose(
                candidates,
                choice,
                predict=direct.predict_outcomes,
                features=interactions.features,
                categorise=categorise,
                world_factory=factory,
                seed=seed,
                workers=workers,
                progress=advance,
            )
        if factory is None:
            averaged = average(interactions, primitives, categorise, model.action_symbols)
            write_json(folder / PRIMITIVES, averaged)
            return
        with progress_bar("rehearsing") as advance:
            rehearsals = rehearse(
                factory, primitives, categorise, objects=objects, seed=seed, workers=workers, progress=advance
            )
        write_json(folder / PRIMITIVES, tabulate(rehearsals, factory().feature_names))

    options = {"objects": objects, "seed": seed, "choice": choice}
    return Stage("distill", (WORLD, MODEL, DIRECT_MODEL, INTERACTIONS), (PRIMITIVES,), work, options)


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
