"""Plans that come from standard input, and plans that go to standard output or to another file."""

import sys
from pathlib import Path

from neurosym.commands.options import check_file
from neurosym.console import be_quiet, print_raw, say
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import make_folder, write_atomically
from neurosym.reading import read_text
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, PLANS, WORLD
from neurosym.wording import quoted

STANDARD = Path("-")
"""What names standard input or output in place of a plan file."""
_INPUT = Path("standard input")


def given_plan(
    folder: DomainFolder, typed: Path, name: str, plan_file: Path, *, must_fit: bool = True
) -> Path:
    """Return the file of a plan that was given; what standard input holds is written into the folder first.

    Args:
        folder: The domain folder.
        typed: The same as it was typed.
        name: Name of the problem.
        plan_file: The plan's file, or `STANDARD`.
        must_fit: Whether what standard input holds must be a plan for the problem.

    Raises:
        InvalidFile: If it is no file, or holds no plan for the problem.
        InvalidValue: If there is nothing.
    """
    if plan_file == STANDARD:
        return _saved_plan(folder, name, must_fit)
    if plan_file.exists() and not plan_file.is_file():
        raise InvalidFile(plan_file, "it is no file; name one that holds a plan")
    if not plan_file.is_file():
        raise InvalidValue(
            f"There is no plan file {plan_file}; `neurosym plan {quoted(typed)} {name}` writes one."
        )
    return plan_file


def _saved_plan(folder: DomainFolder, name: str, must_fit: bool) -> Path:
    from neurosym.grounding import Grounding
    from neurosym.pddl.plan_reading import parse_plan
    from neurosym.reading import MOST_TEXT
    from neurosym.stages.planning import load_problem
    from neurosym.worlds.world_file import read_world

    data = sys.stdin.buffer.read(MOST_TEXT + 1) if hasattr(sys.stdin, "buffer") else sys.stdin.read().encode()
    if len(data) > MOST_TEXT:
        raise InvalidFile(_INPUT, f"it holds more than {MOST_TEXT} bytes")
    try:
        text = data.decode()
    except UnicodeDecodeError as error:
        raise InvalidFile(_INPUT, "it is no text") from error
    if must_fit:
        problem = load_problem(folder, name, read_world(folder.require(WORLD))())
        parse_plan(text, _INPUT, Grounding.load(folder.require(GROUNDING)), problem)
    make_folder(folder / PLANS)
    file = folder / PLANS / f"{name}.stdin.plan"
    write_atomically(file, text)
    say(f"wrote {file}")
    return file


def check_output(output: Path | None, json: bool) -> None:
    """Raise `InvalidValue` unless a plan can go there.

    Args:
        output: Where to, if anywhere.
        json: Whether the answer is printed as JSON.
    """
    if output == STANDARD and json:
        raise InvalidValue("Both --output - and --json ask for standard output; leave one of them out.")
    check_file(None if output == STANDARD else output, "plan")


def hand_over(plan_file: Path, output: Path) -> None:
    """Copy a plan to where it was asked for.

    Args:
        plan_file: The plan.
        output: Where to.
    """
    text = read_text(plan_file)
    if output == STANDARD:
        be_quiet(False)
        print_raw(text)
    else:
        write_atomically(output, text)
        say(f"wrote {output}")
