"""The stage that distils: networks, data and world -> the table of operators."""

from neurosym.actions import EFFECT_AXES, ActionBox
from neurosym.checks import check_count
from neurosym.console import progress_bar
from neurosym.data.check import model_misfit, world_misfit
from neurosym.data.interactions import Interactions
from neurosym.data.origin import box_of
from neurosym.errors import InvalidFile, UnknownChoice
from neurosym.files import write_json
from neurosym.primitives.audition import CHOICES
from neurosym.stages.aims import OBJECTS, Aim
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DIRECT_MODEL, INTERACTIONS, MODEL, WORLD
from neurosym.stages.manifest import Claim, Stage
from neurosym.worlds.workers import check_workers
from neurosym.worlds.world_file import read_world


def distill_stage(
    folder: DomainFolder,
    aim: Aim = OBJECTS,
    *,
    objects: int,
    seed: int,
    workers: int,
    choice: str = "own",
) -> Stage:
    """Distil primitives and rehearse them: model, data and world -> `primitives.json`.

    Without a `world.toml`, nothing is rehearsed: effects are averaged from the data, whose origin, or else
    least and greatest values, are the action box.
    """
    check_count("objects", objects)
    check_workers(workers)
    if choice not in CHOICES:
        raise UnknownChoice("choice", choice, CHOICES)
    of_model, of_network, data, *besides = map(aim.file, (MODEL, aim.network, INTERACTIONS, *aim.besides))

    def work() -> None:
        from neurosym.learning.direct_model import DirectModel
        from neurosym.learning.effect_model import EffectModel
        from neurosym.primitives.table import NothingDistilled, average_operators, find_operators

        model = EffectModel.load(folder.require(of_model))
        network = DirectModel.load(folder.require(of_network))
        interactions = Interactions.load(folder.require(data))
        for name, one in ((of_model, model), (of_network, network)):
            problem = model_misfit(one.dimensions, interactions.columns, interactions.origin)
            if problem and name.endswith((MODEL, DIRECT_MODEL)):
                raise InvalidFile(folder / name, problem)
        known = model, network.predict_outcomes, interactions
        try:
            if aim is OBJECTS and not (folder / WORLD).exists():
                box = ActionBox(*box_of(interactions.actions, interactions.origin))
                found = average_operators(*known, box, choice, seed=seed, open_bar=progress_bar)
            else:
                method, factory = aim.method(folder, choice), read_world(folder.require(WORLD))
                world = method.adapt(factory)()
                widths = len(world.feature_names), len(world.action_box.low)
                axes = getattr(world, "effect_axes", EFFECT_AXES)
                if problem := world_misfit(world.name, (*widths, axes), interactions.columns):
                    raise InvalidFile(folder / data, problem)
                found = find_operators(
                    *known,
                    world.action_box,
                    method,
                    categorise=EffectModel.load(folder.require(aim.categories)).object_symbols,
                    world_factory=factory,
                    objects=objects,
                    seed=seed,
                    workers=workers,
                    open_bar=progress_bar,
                )
        except NothingDistilled as error:
            raise InvalidFile(folder / of_model, "no action encodes to its symbol; train again") from error
        write_json(folder / aim.table, found)

    options = {"objects": objects, "seed": seed, **({} if aim.folder else {"choice": choice})}
    inputs = tuple(dict.fromkeys((WORLD, aim.categories, of_model, of_network, data, *besides)))
    return Stage(aim.stage("distill"), inputs, (aim.table,), work, options, Claim.ALONE)
