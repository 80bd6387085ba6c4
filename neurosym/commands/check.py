"""The command `neurosym check`: what a data set holds, or all that is wrong with it."""

from neurosym.commands.options import (
    DataPath,
    opened,
)
from neurosym.console import say, say_next
from neurosym.errors import InvalidData, InvalidFile
from neurosym.stages.layout import INTERACTIONS
from neurosym.wording import quoted


def check(data: DataPath) -> int:
    """Check a data set, of your own or explored, before it is trained on.

    docs/data.md says what it must hold; every problem is told in a line of its own, with exit code 2.
    """
    from neurosym.commands.tables import show_data
    from neurosym.data.check import training_problems, warnings_about
    from neurosym.data.interactions import examine

    path = opened(data).require(INTERACTIONS) if data.is_dir() else data
    if not path.is_file():
        raise InvalidFile(path, "there is no such file or folder")
    found = examine(path)
    if problems := [*found.problems, *training_problems(found.columns, found.origin)]:
        raise InvalidData(path, problems)
    interactions = found.interactions
    assert interactions is not None, "without problems there are interactions"
    show_data(interactions, path)
    for warning in warnings_about(interactions.columns, interactions.origin, found.given):
        say(f"note: {warning}")
    is_in_place = path.name == INTERACTIONS
    copying = "" if is_in_place else f"mkdir -p my-domain && cp {quoted(path)} my-domain/{INTERACTIONS} && "
    say_next(f"{copying}neurosym train {quoted(path.parent) if is_in_place else 'my-domain'}")
    return 0
