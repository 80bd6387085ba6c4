"""What the command line shows: lines, tables, how far long work has come, and what goes wrong."""

import os
import re
import shutil
import sys
import textwrap
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from time import monotonic

from neurosym.errors import PIPE_WIDTH, Advance, CannotWrite, Doing, harmless, quoted, shortened

NAME = "neurosym"  # of the program
_PROGRAM = re.compile(rf"(?:^|(?<=, then )|(?<= && )){NAME}(?= )")
_LONG = re.compile(r"\S{1000,}")
_LEAST_PAUSE = 5.0  # between lines that say how far some work has come [s]
_BAR, _REDRAW = 30, 0.1  # columns of a bar; how often it is drawn [s]
_NARROWEST = 8  # columns of a cell, if a table is too wide


class OutputClosed(BaseException):
    """Nobody reads any longer what is printed; nothing that is in the way of an end catches this."""


class _Output:
    """Whether commands print what they have to say."""

    quiet = False


def be_quiet(quiet: bool) -> None:
    """Print nothing but what goes wrong, or everything again."""
    _Output.quiet = quiet


def is_quiet() -> bool:
    """Say whether nothing is printed but what goes wrong."""
    return _Output.quiet


def width() -> int:
    """Return how many columns there are to print in."""
    return shutil.get_terminal_size().columns if sys.stdout.isatty() else PIPE_WIDTH


@contextmanager
def naming_output() -> Iterator[None]:
    """Have errors of the system while something is printed name standard output, and print no more.

    Raises:
        OutputClosed: If nobody reads it.
        CannotWrite: If it cannot be written, because the disk is full for instance.
    """
    try:
        yield
    except OSError as error:
        _Output.quiet = True
        with suppress(OSError, ValueError):  # what waits to be printed goes nowhere
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, sys.stdout.fileno())
            os.close(nowhere)
        if isinstance(error, BrokenPipeError):
            raise OutputClosed from error
        raise CannotWrite(Path("standard output"), error) from error


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


def say_next(command: str) -> None:
    """Print what to type next, where `neurosym` is not found by its name as it was called this time."""
    typed, found = sys.argv[0], shutil.which(NAME)
    is_found = found and Path(found).resolve() == Path(typed).resolve()
    program = NAME if is_found or Path(typed).name != NAME else quoted(typed)
    say(f"next: {_PROGRAM.sub(lambda _: program, command)}")


def show_table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table, whose widest columns are folded where the terminal is too narrow.

    Args:
        title: What it shows.
        columns: Headings.
        rows: One text for each heading.
    """
    lines = [[harmless(cell) for cell in line] for line in (columns, *rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    while sum(widths) + 2 * len(widths) > width() and max(widths) > _NARROWEST:
        widths[widths.index(max(widths))] -= 1
    say(title)
    for number, line in enumerate(lines):
        folded = [textwrap.wrap(cell, max(wide, 1)) or [""] for cell, wide in zip(line, widths, strict=True)]
        for part in range(max(map(len, folded))):
            cells = (cell[part] if part < len(cell) else "" for cell in folded)
            say("  ".join(f"{cell:<{wide}}" for cell, wide in zip(cells, widths, strict=True)).rstrip())
        if number == 0:
            say("  ".join("-" * wide for wide in widths))


def complain(sentence: str) -> None:
    """Print on standard error, also when commands are quiet; what cannot be written there is lost.

    Words that are far too long, which may come from files of strangers, lose their ends.
    """
    told = _LONG.sub(lambda word: shortened(word[0], 300), harmless(sentence))
    _write_error(f"\x1b[31m{told}\x1b[0m\n" if _is_seen() and "NO_COLOR" not in os.environ else f"{told}\n")


def _is_seen() -> bool:
    """Whether standard error is a terminal, on which a line can be written anew."""
    return sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


def _write_error(text: str) -> None:
    with suppress(OSError):
        sys.stderr.write(text)
        sys.stderr.flush()


def _draw(text: str) -> None:
    """Write a text in the place of the one before, as far as it fits into a line of the terminal."""
    _write_error(f"\r\x1b[2K{harmless(text)[: shutil.get_terminal_size().columns - 1]}")


@contextmanager
def shown_doing() -> Iterator[Doing]:
    """Show in a terminal what goes on, one thing in the place of the one before; it is gone in the end."""
    is_shown = _is_seen() and not _Output.quiet
    try:
        yield lambda text: _draw(text) if is_shown else None
    finally:
        if is_shown:
            _draw("")


@contextmanager
def progress_bar(label: str) -> Iterator[Advance]:
    """Show a bar with elapsed and remaining time while some long work goes on, once it has begun.

    Where there is no terminal, a line says as much for each tenth that is done, but not soon after another.
    """
    bar = _Bar(label)
    try:
        yield bar.advance
    finally:
        if bar.is_drawn:
            _write_error("\n")


class _Bar:
    def __init__(self, label: str):
        self.is_drawn = False
        self._restart(label)

    def _restart(self, label: str) -> None:
        self._label, self._tenths = label, 0
        self._begin = self._last = monotonic()

    def advance(self, done: int, total: int, label: str | None = None) -> None:
        """Say how much is done, if it is time to."""
        if _Output.quiet:
            return
        if label is not None and label != self._label:
            self._restart(label)
        now, tenths = monotonic(), 10 * done // total if total else 0
        is_seen, taken = _is_seen(), now - self._begin
        pause = _REDRAW if is_seen else _LEAST_PAUSE
        if now - self._last < pause and not (is_seen and done >= total):
            return
        if not is_seen and tenths <= self._tenths:
            return
        self._tenths, self._last = tenths, now
        left = "" if done >= total or not done else f", about {_minutes(taken * (total - done) / done)} left"
        text = f"{self._label}: {done} of {total} after {_minutes(taken)}{left}"
        if is_seen:
            self.is_drawn = True
            _draw(f"{'█' * (_BAR * done // max(total, 1)):<{_BAR}} {text}")
        else:
            _write_error(f"{harmless(text)}\n")


def _minutes(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d} min"
