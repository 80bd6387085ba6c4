"""The command `neurosym check`: what a data set holds, or all that is wrong with it."""

from neurosym.commands.answers import Json, answer_in
from neurosym.commands.options import DataPath, opened
from neurosym.console import say, say_next
from neurosym.errors import InvalidData, InvalidFile
from neurosym.stages.layout import INTERACTIONS
from neurosym.wording import quoted


def check(data: DataPath, json: Json = False) -> int:
    """Check a data set, of your own or explored, before it is trained on.

    docs/data.md says what it must hold; every problem is told in a line of its own, with exit code 2.
    """
    from neurosym.commands.tables import show_data
    from neurosym.data.check import training_problems, warnings_about
    from neurosym.data.interactions import examine

    path = opened(data).require(INTERACTIONS) if data.is_dir() else data
    if not path.is_file():
        raise InvalidFile(path, "there is no such file or folder")
    answer, found = answer_in(json), examine(path)
    if problems := [*found.problems, *training_problems(found.columns, found.origin)]:
        answer({"path": str(path), "problems": problems})
        raise InvalidData(path, problems)
    interactions = found.interactions
    assert interactions is not None, "without problems there are interactions"
    show_data(interactions, path)
    warnings = warnings_about(interactions.columns, interactions.origin, found.given)
    for warning in warnings:
        say(f"note: {warning}")
    is_in_place = path.name == INTERACTIONS
    copying = "" if is_in_place else f"mkdir -p my-domain && cp {quoted(path)} my-domain/{INTERACTIONS} && "
    say_next(f"{copying}neurosym train {quoted(path.parent) if is_in_place else 'my-domain'}")
    widths = {name: getattr(interactions, name).shape[1] for name in ("features", "actions", "effects")}
    rows = len(interactions)
    answer({"path": str(path), "interactions": rows, **widths, "problems": [], "notes": [*warnings]})
    return 0
