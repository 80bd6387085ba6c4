"""Explaining the symbols of a domain folder, from whatever of it is there."""

from dataclasses import replace
from typing import TYPE_CHECKING

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.operators import OperatorTable
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    GROUNDING,
    INTERACTIONS,
    PLACE_OPERATORS,
    PRIMITIVES,
    RELATION_OPERATORS,
    TABLE_FILES,
    WORLD,
)
from neurosym.stages.practising import operator_table

if TYPE_CHECKING:
    from neurosym.explain.explained import Explanation, SymbolExplanation
    from neurosym.grounding import Grounding
    from neurosym.world import World


_NO_WORLD = f"There is no {WORLD} here to say what the parameters of actions are: they are plain numbers."


_ASSUMED = f"What is in the domain is said for cells of 5 mm; there is no {GROUNDING} yet."


_OTHER_TABLE = f"{GROUNDING} was compiled from another {PRIMITIVES}; compile-domain makes it fit."


def explain_folder(domain: DomainFolder) -> "Explanation":
    """Explain the symbols of a domain folder, from whatever of it is there beside the table of operators.

    Args:
        domain: The folder.

    Raises:
        StageMissing: If there is no `primitives.json`.
        InvalidFile: If a file cannot be used.
    """
    from neurosym.explain.carrying_words import summary_of
    from neurosym.explain.explanation import explain as explain_table
    from neurosym.explain.relating_words import (
        explain_pairs,
        explain_relating,
        explain_states,
        summary_of_relations,
    )
    from neurosym.relation_operators import RelationOperators

    path, table = domain.require(PRIMITIVES), operator_table(domain)
    world = _world(domain)
    grounding, remark = _grounding(domain, table, world)
    try:
        explanation = explain_table(
            table,
            feature_names=world.feature_names if world else _names_in_data(domain),
            gripper=world.action_box.gripper.tolist() if world else (),
            why_left_out=grounding.why_left_out if grounding else None,
        )
    except InvalidValue as error:
        raise InvalidFile(path, str(error)) from error
    outdated = [f"{line}." for line in domain.outdated(TABLE_FILES)]
    carrying = _carrying(domain, world)
    remarks = [summary_of(carrying)] if carrying else []
    relations = RelationOperators.load(domain / RELATION_OPERATORS) if _has_relations(domain) else None
    remarks += [summary_of_relations(relations)] if relations else []
    remarks += [_NO_WORLD] * (world is None) + [remark] * bool(remark) + outdated
    explanation = replace(explanation, summary=(*explanation.summary, *remarks), carrying=carrying)
    if relations is None:
        return explanation
    names = world.feature_names if world else _names_in_data(domain)
    return replace(
        explanation,
        relating=explain_relating(relations, world.action_box.gripper.tolist() if world else ()),
        states=explain_states(relations),
        pairs=explain_pairs(relations, names),
    )


def _has_relations(domain: DomainFolder) -> bool:
    return (domain / RELATION_OPERATORS).is_file()


def _carrying(domain: DomainFolder, world: "World | None") -> "tuple[SymbolExplanation, ...]":
    from neurosym.explain.carrying_words import explain_carrying
    from neurosym.explain.explanation import check_table
    from neurosym.place_operators import PlaceOperators

    path = domain / PLACE_OPERATORS
    if not path.is_file():
        return ()
    places = PlaceOperators.load(path)
    try:
        check_table(places.operators)
    except InvalidValue as error:
        raise InvalidFile(path, str(error)) from error
    return explain_carrying(places, world.action_box.gripper.tolist() if world else ())


def _world(domain: DomainFolder) -> "World | None":
    from neurosym.worlds.world_file import read_world

    return read_world(domain / WORLD)() if (domain / WORLD).exists() else None


def _names_in_data(domain: DomainFolder) -> tuple[str, ...]:
    """Return the names that data of a user's own give to features."""
    from neurosym.data.interactions import Interactions

    path = domain / INTERACTIONS
    return tuple(Interactions.load(path).origin.get("feature_names", ())) if path.is_file() else ()


def _grounding(
    domain: DomainFolder, table: OperatorTable, world: "World | None"
) -> "tuple[Grounding | None, str]":
    """Return what knows which operators are in the domain, and a remark on how it knows."""
    from neurosym.grounding import FORMAT, Grounding
    from neurosym.pddl.compiler import CELL
    from neurosym.pddl.determinisation import with_every_outcome

    if (domain / GROUNDING).exists():
        grounding = Grounding.load(domain / GROUNDING)
        fits = grounding.operators in (table, with_every_outcome(table))
        return (grounding, "") if fits else (None, _OTHER_TABLE)
    axes = {len(mode.effect) for operator in table.operators for mode in operator.modes}
    if world is None or axes != {3}:
        return None, ""
    return Grounding(FORMAT, world.name, CELL, world.table, world.lift_height, table), _ASSUMED
