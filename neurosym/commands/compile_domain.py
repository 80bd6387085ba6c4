"""The command `neurosym compile-domain`: what was learned, as PDDL."""

from typing import Annotated

from tyro.conf import arg

from neurosym.choices import CELL
from neurosym.commands.options import Folder, opened
from neurosym.console import say, say_next
from neurosym.stages.layout import DURATIVE_DOMAIN, GROUNDING, durative_file
from neurosym.wording import counted, listed_briefly, quoted


def compile_domain(
    folder: Folder,
    cell: Annotated[float, arg(help="Edge of a grid cell [m].")] = CELL,
    name: Annotated[
        str | None, arg(help="Name of the PDDL domain; by default the one it has, or that of its world.")
    ] = None,
    durative: Annotated[
        bool, arg(help="Also what carries objects to places with durations, for PlanSys2.")
    ] = False,
    plain: Annotated[bool, arg(help="Also all of it without costs, for planners that take none.")] = False,
) -> int:
    """Compile the PDDL domain: `primitives.json` -> `domain.pddl` and `grounding.json`.

    `domain.pddl` is a page that holds all that was learned, and takes the problems NAME.pddl.
    `domain-numeric.pddl` has numbers instead of cells and places, and takes NAME.numeric.pddl.
    With `--plain` there are `domain-plain.pddl` and NAME.plain.pddl, the page without costs. With
    `--durative` there is `domain-durative.pddl`: it carries objects to places by an action that takes time,
    and takes NAME.durative.pddl. From then on they are kept up to date.
    """
    from neurosym.commands.tables import show_verdict
    from neurosym.grounding import Grounding
    from neurosym.stages.compiling import compile_stage
    from neurosym.stages.verdict import judge_domain

    domain = opened(folder)
    domain.perform(compile_stage(domain, cell=cell, name=name, durative=durative, plain=plain), again=True)
    grounding = Grounding.load(domain / GROUNDING)
    say(f"{len(grounding.live)} operators in {folder / 'domain.pddl'}; left out: {len(grounding.left_out)}")
    for name, reason in grounding.left_out.items():
        say(f"  {name}: {reason}")
    if durative:
        names = domain.problem_names()
        left = [name for name in names if not (domain / durative_file(name)).exists()]
        say(f"{folder / DURATIVE_DOMAIN} takes {len(names) - len(left)} of {counted(len(names), 'problem')}")
        if left:
            say("  left out, since not all can be carried to its goal, or something is to bear something, or")
            say(f"  does so at first: {listed_briefly(left)}")
    show_verdict(judge_domain(grounding))
    say_next(f"neurosym new-problem {quoted(folder)}")
    return 0
