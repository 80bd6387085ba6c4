"""What the command line shows: progress bars, tables, and where things lie.

Lines are printed here; what rich draws is in `terminal`, which is imported when something is drawn.
"""

import os
import re
import shutil
import sys
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, suppress
from pathlib import Path

from neurosym.errors import PIPE_WIDTH, Advance, CannotWrite, Doing, harmless, quoted

NAME = "neurosym"  # of the program
_PROGRAM = re.compile(rf"(?:^|(?<=, then )|(?<= && )){NAME}(?= )")


class OutputClosed(BaseException):
    """Nobody reads any longer what is printed; nothing that is in the way of an end catches this."""


class _Output:
    """Whether commands print what they have to say."""

    quiet = False


def shown_doing() -> AbstractContextManager[Doing]:
    """Show in a terminal what goes on, one thing in the place of the one before; it is gone in the end."""
    from neurosym.stages.terminal import shown_doing as drawn

    return drawn(is_quiet)


def progress_bar(label: str) -> AbstractContextManager[Advance]:
    """Show a bar with rate and remaining time while some long work goes on, once it has begun.

    Where the output is no terminal, a line now and then says as much.
    """
    from neurosym.stages.terminal import progress_bar as drawn

    return drawn(label, is_quiet)


@contextmanager
def naming_output() -> Iterator[None]:
    """Have errors of the system while something is printed name standard output, and print no more.

    Raises:
        OutputClosed: If nobody reads it.
        CannotWrite: If it cannot be written, because the disk is full for instance.
    """
    try:
        yield
    except BrokenPipeError as error:
        _say_no_more()
        raise OutputClosed from error
    except OSError as error:
        _say_no_more()
        raise CannotWrite(Path("standard output"), error) from error


def _say_no_more() -> None:
    """Let what is printed from now on, and what waits to be, go nowhere."""
    _Output.quiet = True
    with suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)


def say(text: str) -> None:
    """Print a line for the user."""
    if _Output.quiet:
        return
    with naming_output():
        sys.stdout.write(f"{harmless(text)}\n")
        sys.stdout.flush()


def print_raw(text: str) -> None:
    """Print a text as it is, for programs to read."""
    say(text.rstrip("\n"))


def complain(sentence: str, style: str = "") -> None:
    """Print on standard error, also when commands are quiet.

    Args:
        sentence: What went wrong, for instance.
        style: How it looks in a terminal, as rich says it.
    """
    from neurosym.stages.terminal import error_console

    error_console.print(sentence, markup=False, style=style or None)


def be_quiet(quiet: bool) -> None:
    """Print nothing but what goes wrong, or everything again."""
    _Output.quiet = quiet


def is_quiet() -> bool:
    """Say whether nothing is printed but what goes wrong."""
    return _Output.quiet


def width() -> int:
    """Return how many columns there are to print in."""
    return shutil.get_terminal_size().columns if sys.stdout.isatty() else PIPE_WIDTH


def say_next(command: str) -> None:
    """Print what to type next, where `neurosym` is not found by its name as it was called this time."""
    say(f"next: {_PROGRAM.sub(lambda _: _program(), command)}")


def _program() -> str:
    """Return how the user can call this program: by its name, or else by the path that was typed now."""
    typed, found = sys.argv[0], shutil.which(NAME)
    if Path(typed).name != NAME or (found and Path(found).resolve() == Path(typed).resolve()):
        return NAME
    return quoted(typed)


def show_table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table.

    Args:
        title: What it shows.
        columns: Headings.
        rows: One text for each heading.
    """
    if _Output.quiet:
        return
    from neurosym.stages.terminal import print_table

    with naming_output():
        print_table(title, columns, rows)
