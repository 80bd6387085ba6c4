"""The command `neurosym demo`: a shipped domain compiled, planned with and executed, with pictures."""

from pathlib import Path
from typing import Annotated

from tyro.conf import arg

from neurosym.console import say, say_next
from neurosym.errors import InvalidValue
from neurosym.files import make_folder
from neurosym.shipped import copy_shipped
from neurosym.wording import quoted

DOMAIN, PROBLEM = "places", "swap-2-07"
"""Two objects stand where the other is to stand: one steps aside, so the plan has three steps."""


def demo(
    output: Annotated[
        Path, arg(metavar="FOLDER", help="Where the copy of the domain and the pictures go.")
    ] = Path("demo"),
) -> int:
    """Compile a shipped domain, plan how two objects change places, execute, film.

    It prints each command that it performs, so that any of them can be tried again with changes.
    """
    from neurosym.commands.compile_domain import compile_domain
    from neurosym.commands.execute import execute
    from neurosym.commands.plan import plan
    from neurosym.stages.layout import plan_files

    folder = _copied(output)
    plan_file = folder / plan_files(PROBLEM, "fast-downward")[0]
    gif, strip = (output / f"{PROBLEM}{ending}" for ending in (".gif", ".png"))
    _say_command("compile-domain", folder)
    compile_domain(folder)
    say(f"{PROBLEM} came with the domain: two objects are to change places")
    _say_command("plan", folder, PROBLEM)
    if code := plan(folder, PROBLEM):
        return code
    _say_command("execute", folder, PROBLEM, plan_file, "--gif", gif, "--strip", strip)
    code = execute(folder, PROBLEM, plan_file, gif=gif, strip=strip)
    say(f"look at {gif} and {strip}, and read {folder / 'domain.pddl'}")
    say_next(f"neurosym report {quoted(folder)}")
    return code


def _copied(output: Path) -> Path:
    """Copy the domain; what an earlier demonstration left is used again, and nothing is removed."""
    target = output / DOMAIN
    make_folder(output)
    if not target.exists() and not copy_shipped(DOMAIN, target):
        raise InvalidValue("No domain came with this installation; install neurosym-pddl again.")
    return target


def _say_command(*words: str | Path) -> None:
    say(f"\n$ neurosym {' '.join(quoted(word) for word in words)}")
