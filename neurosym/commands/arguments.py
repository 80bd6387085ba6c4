"""Reading what was typed on the command line: tyro does it, and what it refuses is said in one sentence."""

import io
import os
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import redirect_stderr
from functools import partial, wraps

from neurosym.errors import InvalidValue, UnknownChoice

Command = Callable[..., int]
HELP = frozenset({"-h", "--help"})
_WIDE = "100000"
"""Columns in which nothing is wrapped."""
_STYLE = re.compile(r"\x1b\[[0-9;]*m")
_RULE = re.compile(r"[╭╰].*|[\s│─-]*[─-]{3,}[\s│─-]*")
_HELP_TEXT = " " * 8
"""What the rows that explain an option begin with."""
_FRAME = 2
"""Columns of the frame on each side of a row."""


def read_arguments(
    commands: Mapping[str, Command], about: str, arguments: Sequence[str]
) -> Callable[[], int]:
    """Return the command that was typed, ready to be called.

    Args:
        commands: The commands, by name.
        about: What `--help` says first.
        arguments: What was typed after `neurosym`.

    Raises:
        UnknownChoice: If there is no such command.
        InvalidValue: If its arguments cannot be read.
        SystemExit: If help was asked for, once it is printed.
    """
    import tyro

    name = arguments[0] if arguments and not arguments[0].startswith("-") else ""
    if name and name not in commands:
        raise UnknownChoice("command", name, commands)
    columns = os.environ.get("COLUMNS")
    said = io.StringIO()
    try:
        if not HELP.intersection(arguments):
            os.environ["COLUMNS"] = _WIDE
        with redirect_stderr(said):
            chosen: Callable[[], int] = tyro.extras.subcommand_cli_from_dict(
                {known: _later(command) for known, command in commands.items()},
                prog="neurosym",
                description=about,
                args=arguments,
                config=(tyro.conf.FlagCreatePairsOff,),
            )
    except SystemExit as ended:
        if ended.code and (problem := _problem(said.getvalue(), name)):
            raise InvalidValue(problem + _hint(name, arguments)) from None
        sys.stderr.write(said.getvalue())
        raise
    finally:
        os.environ.pop("COLUMNS", None)
        if columns is not None:
            os.environ["COLUMNS"] = columns
    sys.stderr.write(said.getvalue())
    return chosen


def _later(command: Command) -> Callable[..., Callable[[], int]]:
    """Return a function with the same signature that only remembers what the command is called with."""

    @wraps(command)
    def later(*arguments: object, **options: object) -> Callable[[], int]:
        return partial(command, *arguments, **options)

    return later


def _problem(box: str, name: str) -> str:
    """Take the first paragraph out of tyro's box: title, rule, what is wrong, and after a rule the help."""
    rows = [_STYLE.sub("", row) for row in box.splitlines()]
    rules = [number for number, row in enumerate(rows) if _RULE.fullmatch(row)]
    if len(rules) < 2:
        return ""
    inside = [row.rstrip("│ ")[_FRAME:] for row in rows[rules[0] + 1 : rules[1]]]
    if "" in inside:
        inside = inside[: inside.index("")]
    said = " ".join(row.strip() for row in inside if not row.startswith(_HELP_TEXT))
    said = re.sub(r" \(applied to neurosym[^)]*\)|\. Expected 1 values\.", "", said)
    said = said.replace(f" from neurosym {name}:", ":")
    return f"neurosym{' ' if name else ''}{name}: {said[:1].lower()}{said[1:].rstrip('.')}" if said else ""


def _hint(name: str, arguments: Sequence[str]) -> str:
    goals = [word for word in arguments if re.fullmatch(r"[^-=]\S*=\S+", word)]
    repeat = "; --goal is given once for each object" if "--goal" in arguments and len(goals) > 1 else ""
    return f"{repeat}; `neurosym {name}{' ' if name else ''}--help` says what there is."
