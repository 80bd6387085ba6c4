"""The command `neurosym show`: what was explored, learned or asked for, in pictures or live."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Optional

from tyro.conf import arg

from neurosym.commands.options import Folder, opened
from neurosym.console import say, say_next
from neurosym.errors import InvalidValue
from neurosym.files import check_writable, make_folder
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, INTERACTIONS, MODEL, PICTURES, WORLD
from neurosym.wording import quoted

if TYPE_CHECKING:
    from neurosym.pictures.motions import Motion
    from neurosym.world import Outcome, World


def show(
    folder: Folder,
    interaction: Annotated[
        Optional[int], arg(metavar="I", help="Make row I of interactions.npz (0, 1, ...) happen again.")
    ] = None,
    primitive: Annotated[
        Optional[str],
        arg(
            metavar="CODE",
            help="Perform a primitive, like 101 or 101b, on an object of each category it is for.",
        ),
    ] = None,
    operator: Annotated[
        Optional[str],
        arg(metavar="NAME", help="Perform an operator of the domain, like carry-to-010-hollow-narrow-01."),
    ] = None,
    problem: Annotated[
        Optional[str], arg(metavar="NAME", help="Show a problem's start, with its goals transparently.")
    ] = None,
    output: Annotated[
        Optional[Path],
        arg(help="Write a PNG, or an animated GIF, here and not in DIR/pictures; its ending decides."),
    ] = None,
    gui: Annotated[bool, arg(help="Show the motion live in a window instead.")] = False,
) -> int:
    """Show an interaction, a primitive, an operator or a problem, in pictures or live.

    The dots mark the action's waypoints, as in the paper: blue the first, green the second, red the third.
    """
    from neurosym.pictures.images import check_picture_path
    from neurosym.worlds.world_file import read_world

    domain = opened(folder)
    if sum(chosen is not None for chosen in (interaction, primitive, operator, problem)) != 1:
        raise InvalidValue(
            "Name one thing to show: --interaction I, --primitive CODE, --operator NAME or --problem NAME."
        )
    if gui and (output or problem is not None):
        raise InvalidValue("--gui shows a motion live and writes no file; leave out --output and --problem.")
    if output:
        check_picture_path(output)
    world = read_world(domain.require(WORLD))()
    if problem is not None:
        _show_problem(domain, world, domain.problem(problem), output)
    elif interaction is not None:
        _show_interaction(domain, world, interaction, output, gui)
    else:
        name = f"operator-{operator}" if operator is not None else f"primitive-{primitive}"
        _show_motions(domain, world, _learned(domain, world, primitive, operator), name, output, gui)
    return 0


def _show_problem(domain: DomainFolder, world: "World", name: str, output: Path | None) -> None:
    from neurosym.pictures.show import picture_problem
    from neurosym.stages.planning import load_problem

    problem = load_problem(domain, name, world)
    path = _picture_path(domain, f"problem-{problem.name}", output)
    picture_problem(world, problem, path)
    say(f"wrote {path}")
    say_next(f"neurosym plan {quoted(domain.path)} {problem.name}")


def _show_interaction(
    domain: DomainFolder, world: "World", number: int, output: Path | None, gui: bool
) -> None:
    from neurosym.data.interactions import Interactions
    from neurosym.pictures.motions import judge, recall_interaction

    interactions = Interactions.load(domain.require(INTERACTIONS))
    motion, is_same_scene = recall_interaction(world, interactions, number)
    (outcome,) = _show_motions(domain, world, [motion], f"interaction-{number}", output, gui)
    say(judge(interactions, number, outcome, is_same_scene))
    say_next(f"neurosym show {quoted(domain.path)} --interaction {number} --output interaction-{number}.gif")


def _learned(
    domain: DomainFolder, world: "World", primitive: str | None, operator: str | None
) -> "Sequence[Motion]":
    """Return the motions of a primitive or an operator, on objects drawn as when it was rehearsed."""
    from neurosym.grounding import Grounding
    from neurosym.learning.effect_model import EffectModel
    from neurosym.pictures.motions import operator_motions, operators_of, pair_motion
    from neurosym.related import relating
    from neurosym.stages.manifest import rehearsal_options
    from neurosym.stages.task_drawing import sight_of_pairs

    grounding = Grounding.load(domain.require(GROUNDING))
    if operator is not None and (on_pair := relating(operator, grounding)):
        return [pair_motion(world, grounding, on_pair, sight=sight_of_pairs(domain))]
    by_name = (grounding.operator_named(operator),) if operator is not None else ()
    asked = by_name if primitive is None else operators_of(grounding, primitive)
    categorise = EffectModel.load(domain.require(MODEL)).object_symbols
    objects, seed = rehearsal_options(domain.manifest())
    drawn: dict[str, Any] = {"categorise": categorise, "objects": objects, "seed": seed}
    return operator_motions(world, grounding, asked, **drawn)


def _show_motions(
    domain: DomainFolder,
    world: "World",
    motions: "Sequence[Motion]",
    name: str,
    output: Path | None,
    gui: bool,
) -> "tuple[Outcome, ...]":
    from neurosym.pictures.show import picture_motions, show_live, tell

    if not motions:
        raise InvalidValue("Rehearsal sampled no object that this is for, so there is nothing to show.")
    path = None if gui else _picture_path(domain, name, output)
    outcomes = picture_motions(world, motions, path) if path else show_live(world, motions)
    for motion, outcome in zip(motions, outcomes, strict=True):
        say(f"{motion.title}: {tell(outcome)}")
    if path:
        say(f"wrote {path}")
    return outcomes


def _picture_path(domain: DomainFolder, name: str, output: Path | None) -> Path:
    if output:
        return output
    path = domain / f"{PICTURES}/{name}.png"
    make_folder(path.parent)
    check_writable(path)
    return path
