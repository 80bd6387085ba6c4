"""The command `neurosym explain`: what the symbols mean, in words."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import arg

from neurosym.command_options import Folder
from neurosym.console import say, say_next
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import read_json, write_atomically
from neurosym.folder import GROUNDING, INTERACTIONS, PRIMITIVES, WORLD, DomainFolder
from neurosym.operators import OperatorTable
from neurosym.quoting import quoted

if TYPE_CHECKING:
    from neurosym.explain.explanation import Explanation
    from neurosym.pddl.grounding import Grounding
    from neurosym.world import World

_NO_WORLD = f"There is no {WORLD} here to say what the parameters of actions are: they are plain numbers."
_ASSUMED = f"What is in the domain is said for cells of 5 mm; there is no {GROUNDING} yet."
_OTHER_TABLE = f"{GROUNDING} was compiled from another {PRIMITIVES}; compile-domain makes it fit."


def explain(
    folder: Folder,
    output: Annotated[
        Path | None, arg(metavar="FILE.md", help="Write it as Markdown here instead of printing it.")
    ] = None,
) -> int:
    """Say in words what each symbol means: what the hand does and brings about, which objects are alike."""
    from neurosym.explain.text import explanation_page, show_explanation

    domain = DomainFolder(folder)
    if output:
        _check_page_path(output)
    explanation = explain_folder(domain)
    if output:
        write_atomically(output, explanation_page(explanation, domain.path.resolve().name))
        say(explanation.summary[0])
        say(f"wrote {output}")
    else:
        show_explanation(explanation)
    if (domain / GROUNDING).is_file() and (domain / WORLD).is_file():
        say_next(f"neurosym show {quoted(folder)} --primitive {explanation.actions[0].symbol}")
    elif (domain / WORLD).is_file():
        say_next(f"neurosym compile-domain {quoted(folder)}")
    return 0


def explain_folder(domain: DomainFolder) -> "Explanation":
    """Explain the symbols of a domain folder, from whatever of it is there beside the table of operators.

    Args:
        domain: The folder.

    Raises:
        StageMissing: If there is no `primitives.json`.
        InvalidFile: If a file cannot be used.
    """
    from neurosym.explain.explanation import explain as explain_table

    path = domain.require(PRIMITIVES)
    table = read_json(path, OperatorTable)
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
    outdated = [f"{line}." for line in domain.outdated((PRIMITIVES,))]
    remarks = [_NO_WORLD] * (world is None) + [remark] * bool(remark) + outdated
    return replace(explanation, summary=(*explanation.summary, *remarks))


def _world(domain: DomainFolder) -> "World | None":
    from neurosym.world_file import read_world

    return read_world(domain / WORLD)() if (domain / WORLD).exists() else None


def _names_in_data(domain: DomainFolder) -> tuple[str, ...]:
    """Return the names that data of a user's own give to features."""
    from neurosym.interactions import Interactions

    path = domain / INTERACTIONS
    return tuple(Interactions.load(path).origin.get("feature_names", ())) if path.is_file() else ()


def _grounding(
    domain: DomainFolder, table: OperatorTable, world: "World | None"
) -> "tuple[Grounding | None, str]":
    """Return what knows which operators are in the domain, and a remark on how it knows."""
    from neurosym.outcomes import with_every_outcome
    from neurosym.pddl.compiler import CELL
    from neurosym.pddl.grounding import FORMAT, Grounding

    if (domain / GROUNDING).exists():
        grounding = Grounding.load(domain / GROUNDING)
        fits = grounding.operators in (table, with_every_outcome(table))
        return (grounding, "") if fits else (None, _OTHER_TABLE)
    axes = {len(mode.effect) for operator in table.operators for mode in operator.modes}
    if world is None or axes != {3}:
        return None, ""
    return Grounding(FORMAT, world.name, CELL, world.table, world.lift_height, table), _ASSUMED


def _check_page_path(path: Path) -> None:
    if path.suffix.lower() != ".md" or path.is_dir() or not path.absolute().parent.is_dir():
        raise InvalidValue(
            f"No explanation can be written to {path}; name a file that ends in .md, in an existing folder."
        )
