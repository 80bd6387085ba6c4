"""The command `neurosym distill`: symbols to parameters, and what these do."""

from typing import Annotated

from tyro.conf import arg

from neurosym.commands.options import (
    CPUS,
    Choice,
    Folder,
    Seed,
    Workers,
    opened,
)
from neurosym.console import say, say_next
from neurosym.stages.layout import (
    PLACE_MODEL,
    PLACE_OPERATORS,
    PRIMITIVES,
    RELATION_MODEL,
    RELATION_OPERATORS,
)
from neurosym.wording import quoted


def distill(
    folder: Folder,
    objects: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    seed: Seed = 0,
    workers: Workers = CPUS,
    choice: Choice = "own",
) -> int:
    """Turn action symbols into parameters and rehearse each in the world: -> `primitives.json`."""
    from neurosym.commands.tables import show_operators, show_relations
    from neurosym.naming import counted_axes
    from neurosym.operators import OperatorTable
    from neurosym.place_operators import PlaceOperators
    from neurosym.relation_operators import RelationOperators
    from neurosym.stages.aiming import distill_places_stage
    from neurosym.stages.distilling import distill_stage
    from neurosym.stages.relating import distill_relations_stage

    domain = opened(folder)
    domain.perform(
        distill_stage(domain, objects=objects, seed=seed, workers=workers, choice=choice), again=True
    )
    table = OperatorTable.load(domain / PRIMITIVES)
    show_operators(table)
    if (domain / PLACE_MODEL).exists() and table.measured == "rehearsal":
        domain.perform(distill_places_stage(domain, objects=objects, seed=seed, workers=workers), again=True)
        show_operators(PlaceOperators.load(domain / PLACE_OPERATORS).operators)
    if (domain / RELATION_MODEL).exists() and table.measured == "rehearsal":
        stage = distill_relations_stage(domain, pairs=objects, seed=seed, workers=workers)
        domain.perform(stage, again=True)
        show_relations(RelationOperators.load(domain / RELATION_OPERATORS))
    if table.measured == "rehearsal":
        say_next(f"neurosym compile-domain {quoted(folder)}")
        return 0
    say("there is no world.toml, so nothing was rehearsed: effects are averages over the rows of the data")
    if table.axes == 3:
        say("a PDDL domain needs a world besides, and distilled again, primitives are rehearsed in it")
        say_next(f"neurosym init {quoted(folder)} --world module:factory")
    else:
        say(f"no PDDL domain can be made of {counted_axes(table.axes)}: it moves objects along x, y and z")
        say_next(f"neurosym explain {quoted(folder)}")
    return 0
