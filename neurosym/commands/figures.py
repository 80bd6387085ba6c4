"""The command `neurosym figures`: the paper's Figures 3 and 4 from a domain folder, by the simulator."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import arg

from neurosym.commands.options import Folder, opened
from neurosym.console import say, say_next
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, MODEL, PICTURES, WORLD
from neurosym.wording import quoted

if TYPE_CHECKING:
    from neurosym.grounding import Grounding
    from neurosym.pictures.images import Row
    from neurosym.report.examples import Example
    from neurosym.world import World

PRIMITIVES_FIGURE, PLANS_FIGURE = "figure-3-primitives.png", "figure-4-plans.png"
PLANS_SHOWN = 4


def figures(
    folder: Folder,
    output: Annotated[
        Optional[Path], arg(metavar="FOLDER", help="Write them here and not in DIR/pictures.")
    ] = None,
) -> int:
    """Draw the paper's Figure 3 (each primitive) and Figure 4 (example plans) from the simulator.

    A row of Figure 3 is a primitive: how it starts and how each phase of the motion ends, with the waypoints
    as blue, green and red dots. The last rows carry an object of each category to a place, if that was
    learned. A row of Figure 4 is a run of DIR/runs: in its first picture the goals are
    transparent, in its last the start is.
    """
    from neurosym.files import check_writable, make_folder
    from neurosym.grounding import Grounding
    from neurosym.pictures.images import save_sheet
    from neurosym.report.examples import problem_reader, runs_of
    from neurosym.worlds.world_file import read_world

    domain = opened(folder)
    target = _output_folder(domain, output)
    world = read_world(domain.require(WORLD))()
    grounding = Grounding.load(domain.require(GROUNDING))
    domain.require(MODEL)
    make_folder(target)
    check_writable(target / PRIMITIVES_FIGURE)
    runs = runs_of(domain, problem_reader(domain))
    save_sheet(target / PRIMITIVES_FIGURE, _primitive_rows(domain, world, grounding))
    say(f"wrote {target / PRIMITIVES_FIGURE}")
    if rows := _plan_rows(world, grounding, runs):
        save_sheet(target / PLANS_FIGURE, rows)
        say(f"wrote {target / PLANS_FIGURE}")
        say_next(f"neurosym report {quoted(folder)}")
    else:
        say(f"no Figure 4: {domain / 'runs'} holds no run with steps that goes the same way again")
        say_next(f"neurosym plan {quoted(folder)} NAME, then neurosym execute {quoted(folder)} NAME PLAN")
    return 0


def _output_folder(domain: DomainFolder, output: Path | None) -> Path:
    target = output or domain / PICTURES
    if (target.exists() and not target.is_dir()) or not target.absolute().parent.is_dir():
        raise InvalidValue(f"No figures can be written to {target}; name a folder, in an existing one.")
    return target


def _primitive_rows(domain: DomainFolder, world: "World", grounding: "Grounding") -> "list[Row]":
    from neurosym.learning.effect_model import EffectModel
    from neurosym.pictures.images import Row
    from neurosym.pictures.motions import surest_carriers
    from neurosym.pictures.stills import operator_stills, primitive_stills
    from neurosym.stages.manifest import rehearsal_options

    categorise = EffectModel.load(domain / MODEL).object_symbols
    objects, seed = rehearsal_options(domain.manifest())
    found = [
        primitive_stills(world, grounding, symbol, categorise, objects=objects, seed=seed)
        for symbol in grounding.operators.symbols
    ]
    found += [
        operator_stills(world, grounding, one.name, categorise, objects=objects, seed=seed)
        for one in surest_carriers(grounding)
    ]
    return [Row(stills.title, stills.frames, stills.captions) for stills in found]


def _plan_rows(world: "World", grounding: "Grounding", runs: "tuple[Example, ...]") -> "list[Row]":
    from neurosym.pictures.images import Row
    from neurosym.pictures.stills import run_stills
    from neurosym.report.examples import telling_examples

    rows: list[Row] = []
    for example in telling_examples(runs):
        if len(rows) < PLANS_SHOWN:
            try:
                stills = run_stills(world, example.problem, grounding, example.run)
            except (InvalidValue, UnknownChoice) as error:
                say(f"passed over {example.name}: {error}")
            else:
                rows.append(Row(example.name, stills.frames, stills.captions))
    return rows
