"""The stage that practises: what was learned, and `primitives.json` -> `practice.json`."""

from functools import partial
from typing import TYPE_CHECKING, Any

from neurosym.checks import check_count
from neurosym.console import progress_bar
from neurosym.drafts import at_once
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import write_json
from neurosym.guarded import made
from neurosym.operators import OperatorTable
from neurosym.pddl.compiler import compile_domain
from neurosym.practice.rounds import Practised
from neurosym.reading import digest
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.layout import (
    DIRECT_MODEL,
    INTERACTIONS,
    MODEL,
    PRACTICE,
    PRIMITIVES,
    PROBLEMS,
    SCENE,
    WORLD,
)
from neurosym.stages.manifest import Claim, Stage
from neurosym.stages.practised import FORMAT, PracticeFile, practice_of
from neurosym.wording import quoted
from neurosym.worlds.workers import check_workers
from neurosym.worlds.world_file import read_world

if TYPE_CHECKING:
    from neurosym.practice.improving import Workshop


def practise_stage(
    folder: DomainFolder, *, interactions: int, seed: int, workers: int, evenly: bool = False
) -> Stage:
    """Practise: networks, data, world and operators -> `practice.json`.

    What was practised before counts, so that an interrupted call goes on.

    Args:
        folder: The domain folder.
        interactions: How many in all.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        evenly: Rehearse all operators in turn instead.
    """
    check_count("interactions", interactions)
    check_workers(workers)

    def work() -> None:
        from neurosym.practice.loop import practise

        for scene in sorted((folder / PROBLEMS).glob(f"*{SCENE}")):
            load_scene(scene)  # it is printed anew afterwards: what cannot be used is refused now
        begun = _begun(folder, seed, evenly=evenly)
        shop = _workshop(folder, seed, workers)
        world, of = shop.world, digest(folder / PRIMITIVES)
        compiled = partial(
            compile_domain, name=world.name, table_bounds=world.table, lift_height=world.lift_height
        )

        def save(practised: Practised) -> None:
            write_json(folder / PRACTICE, PracticeFile(FORMAT, of, seed, evenly, practised))

        with progress_bar("practising") as advance:

            def on_round(practised: Practised) -> None:
                with at_once():  # a kill loses no more than the round that it comes in
                    save(practised)
                advance(min(practised.spent, interactions), interactions)

            advance(min(begun.spent, interactions), interactions)
            save(practise(shop, begun, compiled, interactions=interactions, evenly=evenly, on_round=on_round))

    options: dict[str, Any] = {"interactions": interactions, "seed": seed}
    if evenly:
        options["evenly"] = True
    inputs = (WORLD, INTERACTIONS, MODEL, DIRECT_MODEL, PRIMITIVES)
    return Stage("practise", inputs, (PRACTICE,), work, options, Claim.ALONE)


def _workshop(folder: DomainFolder, seed: int, workers: int) -> "Workshop":
    from neurosym.data.interactions import Interactions
    from neurosym.learning.direct_model import DirectModel
    from neurosym.learning.effect_model import EffectModel
    from neurosym.practice.improving import Workshop

    factory = read_world(folder.require(WORLD))
    return Workshop(
        factory,
        made(factory),
        EffectModel.load(folder.require(MODEL)),
        DirectModel.load(folder.require(DIRECT_MODEL)),
        Interactions.load(folder.require(INTERACTIONS)),
        seed,
        workers,
    )


def _begun(folder: DomainFolder, seed: int, *, evenly: bool) -> Practised:
    """Return what was practised so far, or the distilled operators without any practice."""
    distilled = OperatorTable.load(folder.require(PRIMITIVES))
    if not any(operator.rehearsals for operator in distilled.operators):
        raise InvalidFile(
            folder / PRIMITIVES,
            f"its rehearsals are not kept; `neurosym distill {quoted(folder.path)}` makes it anew",
        )
    found = practice_of(folder)
    if found is None:
        return Practised(distilled)
    if (found.seed, found.evenly) != (seed, evenly):
        how = "evenly, " if found.evenly else ""
        raise InvalidValue(
            f"{folder / PRACTICE} was practised {how}with seed = {found.seed}; go on so, or remove it to "
            "begin anew."
        )
    return found.practised
