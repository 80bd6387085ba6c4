"""The command `neurosym distill`: symbols to parameters, and what these do."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import arg

from neurosym.commands.options import CPUS, Choice, Folder, Seed, Workers, opened
from neurosym.console import say, say_next
from neurosym.stages.layout import (
    PLACE_MODEL,
    PLACE_OPERATORS,
    PRIMITIVES,
    RELATION_MODEL,
    RELATION_OPERATORS,
)
from neurosym.wording import quoted

if TYPE_CHECKING:
    from neurosym.operators import OperatorTable


def distill(
    folder: Folder,
    objects: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    seed: Seed = 0,
    workers: Workers = CPUS,
    choice: Choice = "own",
) -> int:
    """Turn action symbols into parameters and rehearse each: -> `primitives.json`."""
    from neurosym.commands.tables import show_operators, show_relations, show_verdict
    from neurosym.operators import OperatorTable
    from neurosym.place_operators import PlaceOperators
    from neurosym.relation_operators import RelationOperators
    from neurosym.stages.aims import TO_OBJECTS, TO_PLACES
    from neurosym.stages.distilling import distill_stage
    from neurosym.stages.verdict import judge_operators, judge_relations

    domain = opened(folder)
    domain.perform(
        distill_stage(domain, objects=objects, seed=seed, workers=workers, choice=choice), again=True
    )
    table = OperatorTable.load(domain / PRIMITIVES)
    show_operators(table)
    is_rehearsed = table.measured == "rehearsal"
    after = f"neurosym compile-domain {quoted(folder)}" if is_rehearsed else _told_of_data(folder, table)
    show_verdict(judge_operators(table))
    if (domain / PLACE_MODEL).exists() and is_rehearsed:
        stage = distill_stage(domain, TO_PLACES, objects=objects, seed=seed, workers=workers)
        domain.perform(stage, again=True)
        places = PlaceOperators.load(domain / PLACE_OPERATORS).operators
        show_operators(places)
        show_verdict(judge_operators(places))
    if (domain / RELATION_MODEL).exists() and is_rehearsed:
        stage = distill_stage(domain, TO_OBJECTS, objects=objects, seed=seed, workers=workers)
        domain.perform(stage, again=True)
        relations = RelationOperators.load(domain / RELATION_OPERATORS)
        show_relations(relations)
        show_verdict(judge_relations(relations))
    say_next(after)
    return 0


def _told_of_data(folder: Path, table: "OperatorTable") -> str:
    """Say what a table lacks that was averaged from data; return what to type next."""
    from neurosym.naming import counted_axes

    say("there is no world.toml, so nothing was rehearsed: effects are averages over the rows of the data")
    if table.axes == 3:
        say("a PDDL domain needs a world besides, and distilled again, primitives are rehearsed in it")
        return f"neurosym init {quoted(folder)} --world module:factory"
    say(f"no PDDL domain can be made of {counted_axes(table.axes)}: it moves objects along x, y and z")
    return f"neurosym explain {quoted(folder)}"
