"""Reading what was typed on the command line: tyro does it, and what it refuses is said in one sentence.

tyro tells what it is about to refuse as an event. Events are no stable part of it, so the version is pinned.
"""

import inspect
import math
import re
from collections.abc import Callable, Sequence
from functools import partial, wraps
from itertools import pairwise
from pathlib import Path
from typing import Any

from neurosym.commands.catalogue import ABOUT, SUMMARIES, Command, command_named, nearest
from neurosym.errors import InvalidValue, UnknownChoice, shortened
from neurosym.reading import LARGEST_WHOLE

LONGEST = 4096
"""Characters of one argument, as of a path."""
MOST = {
    "steps": 10_000_000,  # more rows than this are not read again either
    "rehearsals": 1_000_000,
    "objects": 1_000_000,
    "actions": 10_000,
    "problems": 10_000,
    "tasks": 1_000_000,
    "replans": 1_000_000,
    "time-limit": 10_000_000,  # seconds, nearly four months
}
"""What is the most that makes sense of some options; of any other number, the greatest whole one."""
_IN_WORDS = (
    (r"^- <class '\w+'>: ", ""),
    (r"invalid literal for int\(\) with base 10: (.*)$", r"\1 is no whole number"),
    (r"could not convert string to float: (.*)$", r"\1 is no number"),
)
"""What Python says of what cannot be read, and what we say."""


def read_arguments(arguments: Sequence[str]) -> Callable[[], int]:
    """Return the command that was typed, ready to be called.

    Args:
        arguments: What was typed after `neurosym`.

    Raises:
        UnknownChoice: If there is no such command, or an option has no such choice.
        InvalidValue: If its arguments cannot be read.
        SystemExit: If help was asked for, once it is printed.
    """
    name = arguments[0] if arguments and not arguments[0].startswith("-") else ""
    command = command_named(name) if name else None
    _check_words(arguments)
    import tyro
    from tyro._errors import on_parse_error

    config = (tyro.conf.FlagCreatePairsOff,)
    with on_parse_error(partial(_refuse, command, arguments)):
        if command:  # as the others would be, which are not imported for it
            chosen: partial[int] = tyro.cli(
                _later(command), prog=f"neurosym {name}", args=arguments[1:], config=config
            )
        else:
            commands = {known: _later(command_named(known)) for known in SUMMARIES}
            chosen = tyro.extras.subcommand_cli_from_dict(
                commands, prog="neurosym", description=ABOUT, args=arguments, config=config
            )
    given = inspect.signature(chosen.func).bind(*chosen.args, **chosen.keywords).arguments
    for option, value in given.items():
        for number in value if isinstance(value, tuple) else (value,):
            _check_number(option.replace("_", "-"), number)
    return chosen


def _check_words(arguments: Sequence[str]) -> None:
    """Refuse what cannot be meant, however it is read: nothing at all, which as a path is this folder."""
    for before, word in pairwise(["", *arguments]):
        if word.startswith("--") and word.endswith("="):
            raise InvalidValue(f"{word.rstrip('=')} is given nothing; leave it out, or say what is meant.")
        if not word.strip():
            place = f"{before} is given nothing" if before.startswith("--") else "An argument is empty"
            raise InvalidValue(f"{place}; leave it out, or say what is meant.")
        if len(word) > LONGEST:
            raise InvalidValue(f"{shortened(word)} has {len(word)} characters; valid: at most {LONGEST}.")
        if "\0" in word:
            raise InvalidValue(f"{shortened(word)} holds a zero byte, which no argument can.")


def _check_number(option: str, value: object) -> None:
    """Refuse numbers that no option can take, so that they go no further."""
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidValue(f"{option} = {value} must be a finite number.")
    if isinstance(value, int | float) and abs(value) > (most := MOST.get(option, LARGEST_WHOLE)):
        given = shortened(f"{value}", 40)
        raise InvalidValue(f"{option} = {given} is too great; valid: at most {most:,}.")


def _later(command: Command) -> Callable[..., "partial[int]"]:
    """Return a function with the same signature that only remembers what the command is called with."""

    @wraps(command)
    def later(*arguments: object, **options: object) -> "partial[int]":
        return partial(command, *arguments, **options)

    return later


def _refuse(command: Command | None, typed: Sequence[str], event: Any) -> None:
    """Say in a sentence what tyro is about to refuse; events that are new to us it says itself."""
    from tyro import _errors as events

    name, said = typed[0] if command else "", ""
    if isinstance(event, events.InvalidChoice):
        choices = [choice for choice in event.choices if choice != "None"]  # which is no word of ours
        option = _called(event.argument).removeprefix("--")
        if option == "encoding":
            from neurosym.pddl.encodings import check_former

            check_former(event.value)
        raise UnknownChoice(option, event.value, choices)
    if isinstance(event, events.MissingArgs):
        said = f"missing: {', '.join(_called(missing.arg) for missing in event.missing_arguments)}"
        said += _unrecognized(command, event.unrecognized_tokens, "; ")
        said += _problems_of(typed[1]) if name and len(typed) == 2 else ""
    elif isinstance(event, events.MissingSubcommand):
        said = f"expected one of {{{', '.join(SUMMARIES)}}}"
    elif isinstance(event, events.BadValue):
        said = f"missing value for argument '{_called(event.argument)}'"
    elif isinstance(event, events.UnrecognizedArgs):
        said = _unrecognized(command, event.tokens)
    elif isinstance(event, events.InstantiationFailure):
        option = _called(event.argument) if event.argument else "what was typed"
        reason = event.message.splitlines()[-1].rstrip(".")  # of several, the last kind
        for pattern, ours in _IN_WORDS:
            reason = re.sub(pattern, ours, reason)
        said = f"error parsing {option}: {shortened(reason, 300)}"
    if said:
        whole = f"neurosym {name}".rstrip()
        raise InvalidValue(f"{whole}: {said}; `{whole} --help` says what there is.")


def _called(argument: Any) -> str:
    """Say what an argument is called: `--option`, or PLACE."""
    if argument.is_positional():
        return str(argument.lowered.metavar)
    return str(argument.lowered.name_or_flags[-1])


def _unrecognized(command: Command | None, tokens: Sequence[str], before: str = "") -> str:
    """List what is no option; of the first, say which is nearest."""
    if not tokens:
        return ""
    said = shortened(", ".join(shortened(token, 300) for token in tokens), 600)
    options = inspect.signature(command).parameters if command else ()
    known = [f"--{option.replace('_', '-')}" for option in options]
    near = nearest(tokens[0].partition("=")[0], known) if tokens[0].startswith("--") else ""
    return f"{before}unrecognized options: {said}" + (f"; the nearest is {near}" if near else "")


def _problems_of(typed: str) -> str:
    """List the problems of a domain folder or shipped domain, if one was typed; else nothing."""
    from neurosym.shipped import shipped_domain
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import PROBLEMS

    folder = Path(typed) if Path(typed).is_dir() else shipped_domain(typed)
    names = DomainFolder(folder).problem_names() if folder and (folder / PROBLEMS).is_dir() else ()
    return f"; problems of {typed}: {', '.join(names)}" if names else ""
