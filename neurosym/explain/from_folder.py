"""Explaining the symbols of a domain folder, from whatever of it is there."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.explain.explained import Explanation
from neurosym.explain.explanation import explain, explain_carrying, summary_of
from neurosym.explain.relating_words import summary_of_relations, with_relations
from neurosym.grounding import FORMAT, Grounding
from neurosym.operators import OperatorTable
from neurosym.pddl.compiler import CELL, with_every_outcome
from neurosym.place_operators import PlaceOperators
from neurosym.relation_operators import RelationOperators
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
from neurosym.stages.practised import operator_table
from neurosym.world import World
from neurosym.worlds.world_file import read_world

_NO_WORLD = f"There is no {WORLD} here to say what the parameters of actions are: they are plain numbers."
_ASSUMED = f"What is in the domain is said for cells of 5 mm; there is no {GROUNDING} yet."
_OTHER_TABLE = f"{GROUNDING} was compiled from another {PRIMITIVES}; compile-domain makes it fit."


def explain_folder(domain: DomainFolder) -> Explanation:
    """Explain the symbols of a domain folder, from whatever of it is there beside the table of operators.

    Args:
        domain: The folder.

    Raises:
        StageMissing: If there is no `primitives.json`.
        InvalidFile: If a file cannot be used.
    """
    path, table = domain.require(PRIMITIVES), operator_table(domain)
    world = read_world(domain / WORLD)() if (domain / WORLD).exists() else None
    gripper = world.action_box.gripper.tolist() if world else ()
    names = world.feature_names if world else _names_in_data(domain)
    grounding, remark = _grounding(domain, table, world)
    left_out = grounding.why_left_out if grounding else None
    with _fitting(path):
        told = explain(table, feature_names=names, gripper=gripper, why_left_out=left_out)
    remarks = []
    if (path := domain / PLACE_OPERATORS).is_file():
        with _fitting(path):
            told = replace(told, carrying=explain_carrying(PlaceOperators.load(path), gripper))
        remarks.append(summary_of(told.carrying))
    if (path := domain / RELATION_OPERATORS).is_file():
        relations = RelationOperators.load(path)
        told = with_relations(told, relations, names, gripper)
        remarks.append(summary_of_relations(relations))
    remarks += [_NO_WORLD] * (world is None) + [remark] * bool(remark)
    remarks += [f"{line}." for line in domain.outdated(TABLE_FILES)]
    return replace(told, summary=(*told.summary, *remarks))


@contextmanager
def _fitting(path: Path) -> Iterator[None]:
    """Name the file whose table does not fit together."""
    try:
        yield
    except InvalidValue as error:
        raise InvalidFile(path, str(error)) from error


def _names_in_data(domain: DomainFolder) -> tuple[str, ...]:
    """Return the names that data of a user's own give to features."""
    path = domain / INTERACTIONS
    return tuple(Interactions.load(path).origin.get("feature_names", ())) if path.is_file() else ()


def _grounding(
    domain: DomainFolder, table: OperatorTable, world: World | None
) -> tuple[Grounding | None, str]:
    """Return what knows which operators are in the domain, and a remark on how it knows."""
    if (domain / GROUNDING).exists():
        grounding = Grounding.load(domain / GROUNDING)
        fits = grounding.operators in (table, with_every_outcome(table))
        return (grounding, "") if fits else (None, _OTHER_TABLE)
    axes = {len(mode.effect) for operator in table.operators for mode in operator.modes}
    if world is None or axes != {3}:
        return None, ""
    return Grounding(FORMAT, world.name, CELL, world.table, world.lift_height, table), _ASSUMED
