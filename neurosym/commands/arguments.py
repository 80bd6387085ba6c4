"""Options that several commands share, and how what was typed is read."""

import inspect
import io
import math
import os
import re
import shutil
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stdout
from difflib import get_close_matches
from functools import partial, wraps
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Optional

import msgspec
from tyro.conf import Positional, arg

from neurosym.choices import DOMAINS, DrawnTask, EngineName, copy_shipped, shipped_domain
from neurosym.commands.catalogue import ABOUT, SUMMARIES, Command, command_named, nearest
from neurosym.errors import InvalidValue, UnknownChoice, quoted, shortened
from neurosym.files import LARGEST_WHOLE, check_writable
from neurosym.stages.console import NARROW, be_quiet, folded, is_quiet, print_raw, say
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PROBLEMS

Folder = Annotated[Positional[Path], arg(metavar="DIR", help="The domain folder.")]
ProblemName = Annotated[
    Positional[str], arg(metavar="PROBLEM", help="A problem in DIR/problems: its name or its file.")
]
Tolerance = Annotated[
    Optional[float],
    arg(
        metavar="METRES",
        help="How near objects must come to their goals, instead of the problem's own tolerance.",
    ),
]
Seed = Annotated[int, arg(help="Where all random draws start: same seed, same bytes.")]
Workers = Annotated[int, arg(help="Processes that simulate; their number does not change the result.")]
TimeLimit = Annotated[
    Optional[float],
    arg(
        metavar="SECONDS",
        help="Your own ceiling: when planning ends without a plan. Ours and Fast Downward need none: their "
        "budgets count work, so that plans are the same on a busy machine. Others give up after 60 s.",
    ),
]
Task = Annotated[
    Optional[DrawnTask],
    arg(
        help="What tasks ask for: goals anywhere, a swap, a row, or to clear a crowd; in a domain with "
        "relations also a tower, boxes, unstack or exchange; else as in the paper."
    ),
]
Engine = Annotated[
    Optional[EngineName],
    arg(help="What simulates a new tabletop or camera: pybullet (default), or mujoco (docs/world.md)."),
]
Json = Annotated[bool, arg(help="Print the answer as JSON and nothing else, for programs.")]
CPUS = os.cpu_count() or 1


def check_file(path: Path | None, what: str, *endings: str) -> None:
    """Raise unless a file of one of some endings can be written, if one is asked for.

    `what` is written there, as a sentence has it; without endings, any will do.

    Raises:
        InvalidValue: If it has another ending, or stands in no folder.
        CannotWrite: If the system does not let it be written.
    """
    if path is None:
        return
    is_named = not endings or path.suffix.lower() in endings
    if not is_named or path.is_dir() or not path.absolute().parent.is_dir():
        ending = f" that ends in {' or '.join(endings)}," if endings else ""
        raise InvalidValue(f"No {what} can be written to {path}; name a file{ending} in an existing folder.")
    check_writable(path)


def opened(folder: Path) -> DomainFolder:
    """Return a domain folder that prints its notes; a shipped domain that is named is copied there first.

    Raises:
        FolderNotFound: If there is none.
        CannotWrite: If a shipped domain cannot be copied.
    """
    if len(folder.parts) == 1 and not folder.exists() and copy_shipped(folder.name, folder):
        say(f"copied the shipped domain {folder.name} to the folder {folder}; all results go there")
    if not folder.exists() and (meant := get_close_matches(str(folder), DOMAINS, n=1)):
        raise InvalidValue(
            f"There is no folder {folder}; the shipped domain is called {meant[0]}, and `neurosym init "
            f"{quoted(folder)}` makes a new one."
        )
    return DomainFolder(folder, notify=lambda remark: say(f"note: {remark}"))


def refuse_options(**options: object) -> None:
    """Refuse options that data of a user's own do not have, as far as they are given."""
    if given := [
        f"--{name}" for name, value in options.items() if not (value is None or value is False or value == ())
    ]:
        raise InvalidValue(f"With data of your own there is no {' or '.join(given)}.")


def answer_in(json: bool) -> Callable[..., None]:
    """Return how a command gives its answer to programs; from now on nothing else is printed to them.

    What is returned prints a struct or dictionary as JSON, if that was asked for, and before it what else is
    given by name.
    """
    was_quiet = is_quiet()
    be_quiet(was_quiet or json)

    def answer(value: Any, **besides: Any) -> None:
        if json:
            be_quiet(was_quiet)
            found = msgspec.to_builtins(value)
            text = msgspec.json.encode({**besides, **found} if besides else found)
            print_raw(msgspec.json.format(text, indent=2).decode())

    return answer


# Reading what was typed: tyro does it, and what it refuses is said in one sentence.
#
# tyro tells what it is about to refuse as an event. Events are no stable part of it, so the version is
# pinned.

_LONGEST = 4096
"""Characters of one argument, as of a path."""
_BOUNDS = {
    "steps": (1, 10_000_000),  # more rows than this are not read again either
    "rehearsals": (1, 1_000_000),
    "objects": (1, 1_000_000),
    "actions": (0, 10_000),
    "problems": (0, 10_000),
    "tasks": (1, 1_000_000),
    "replans": (0, 1_000_000),
    "tries": (0, 64),  # so many outcomes of an object are kept
    "disturb": (0, LARGEST_WHOLE),
    "seed": (0, LARGEST_WHOLE),
    "places": (0, LARGEST_WHOLE),
    "relations": (0, LARGEST_WHOLE),
    "time-limit": (0, 10_000_000),  # seconds, nearly four months
    "tolerance": (0, LARGEST_WHOLE),
    "workers": (1, 256),
    "port": (0, 65535),
}
"""The least and the most that makes sense of some options; of any other number, any 64-bit one."""
_IN_WORDS = (
    (r"^- <class '\w+'>: ", ""),
    (r"invalid literal for int\(\) with base 10: (.*)$", r"\1 is no whole number"),
    (r"could not convert string to float: (.*)$", r"\1 is no number"),
)
"""What Python says of what cannot be read, and what we say."""


def read_arguments(arguments: Sequence[str]) -> Callable[[], int]:
    """Return the command that was typed, ready to be called.

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
    is_help = bool({"-h", "--help"} & {*arguments})
    with _narrow(is_help), on_parse_error(partial(_refuse, command, arguments)):
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
        if isinstance(value, int | float):
            _check_number(option.replace("_", "-"), value)
    return chosen


_BROKEN = re.compile(r"(?<=\S)\n(?=[`(-])")  # where tyro leaves a line of a docstring as it was


@contextmanager
def _narrow(is_help: bool) -> Iterator[None]:
    """Fold what tyro prints, if it is help: tables it folds itself, and sentences it does not."""
    if not is_help:
        yield
        return
    columns, before = min(shutil.get_terminal_size().columns, NARROW), dict(os.environ)
    page = io.TextIOWrapper(io.BytesIO(), sys.stdout.encoding or "utf-8", "backslashreplace")
    os.environ["COLUMNS"] = str(columns)
    try:
        with redirect_stdout(page):
            yield
    finally:
        os.environ.pop("COLUMNS")
        os.environ.update(before)
        page.seek(0)
        text = re.sub(r"\n{3,}", "\n\n", _BROKEN.sub(" ", page.read().rstrip()))
        be_quiet(False)
        print_raw("\n".join(folded(text, columns)))


def _check_words(arguments: Sequence[str]) -> None:
    """Refuse what cannot be meant, however it is read: nothing at all, which as a path is this folder."""
    for before, word in pairwise(["", *arguments]):
        if word.startswith("--") and word.endswith("="):
            raise InvalidValue(f"{word.rstrip('=')} is given nothing; leave it out, or say what is meant.")
        if not word.strip():
            place = f"{before} is given nothing" if before.startswith("--") else "An argument is empty"
            raise InvalidValue(f"{place}; leave it out, or say what is meant.")
        if len(word) > _LONGEST:
            raise InvalidValue(f"{shortened(word)} has {len(word)} characters; valid: at most {_LONGEST}.")
        if "\0" in word:
            raise InvalidValue(f"{shortened(word)} holds a zero byte, which no argument can.")


def _check_number(option: str, value: float) -> None:
    """Refuse numbers that an option cannot take, so that they go no further."""
    least, most = _BOUNDS.get(option, (-LARGEST_WHOLE, LARGEST_WHOLE))
    given = f"{option} = {shortened(str(value), 40)}"
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidValue(f"{given} must be a finite number.")
    if value > most:
        raise InvalidValue(f"{given} is too great; valid: at most {most:,}.")
    if value < least:
        raise InvalidValue(f"{given} must be at least {least}.")
    if value == 0 and option in ("tolerance", "time-limit"):
        raise InvalidValue(f"{given} must be greater than 0.")


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
        choices = [one for one in event.choices if one != "None"]  # which is no word of ours
        raise UnknownChoice(_called(event.argument).removeprefix("--"), event.value, choices)
    if isinstance(event, events.MissingArgs):
        said = f"missing: {', '.join(_called(missing.arg) for missing in event.missing_arguments)}"
        if event.unrecognized_tokens:
            said += f"; {_unrecognized(command, event.unrecognized_tokens)}"
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
    lowered = argument.lowered
    return str(lowered.metavar if argument.is_positional() else lowered.name_or_flags[-1])


def _unrecognized(command: Command | None, tokens: Sequence[str]) -> str:
    """List what is no option; of the first, say which is nearest."""
    said = shortened(", ".join(shortened(token, 300) for token in tokens), 600)
    options = inspect.signature(command).parameters if command else ()
    known = [f"--{option.replace('_', '-')}" for option in options]
    near = nearest(tokens[0].partition("=")[0], known) if tokens[0].startswith("--") else ""
    return f"unrecognized options: {said}" + (f"; the nearest is {near}" if near else "")


def _problems_of(typed: str) -> str:
    """List the problems of a domain folder or shipped domain, if one was typed; else nothing."""
    folder = Path(typed) if Path(typed).is_dir() else shipped_domain(typed)
    names = DomainFolder(folder).problem_names() if folder and (folder / PROBLEMS).is_dir() else ()
    return f"; problems of {typed}: {', '.join(names)}" if names else ""
