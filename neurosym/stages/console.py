"""What the command line shows: lines, tables, how far long work has come, and what goes wrong."""

import os
import re
import shutil
import sys
import textwrap
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from itertools import chain, zip_longest
from pathlib import Path
from time import monotonic

from neurosym.errors import PIPE_WIDTH, Advance, CannotWrite, Doing, harmless, quoted, shortened

NAME = "neurosym"  # of the program
_PROGRAM = re.compile(rf"(?:^|(?<=, then )|(?<= && )){NAME}(?= )")
_LONG = re.compile(r"\S{1000,}")
_LEAST_PAUSE = 5.0  # between lines that say how far some work has come [s]
_BAR, _REDRAW = 30, 0.1  # columns of a bar; how often it is drawn [s]
_AT_ONCE = 1.0  # what is done so soon may have been done before, and tells nothing of what is left [s]
NARROW = 80  # columns of help, and of what is to be read in one screen
_VECTOR = re.compile(r"\([-\d., ]{,60}\)")


class OutputClosed(BaseException):
    """Nobody reads any longer what is printed; nothing that is in the way of an end catches this."""


class _Output:
    """Whether commands print what they have to say, and who shows how far work has come, if others do."""

    quiet = False
    take: Callable[[str], None] | None = None


def be_quiet(quiet: bool) -> None:
    """Print nothing but what goes wrong, or everything again."""
    _Output.quiet = quiet


def show_elsewhere(take: Callable[[str], None]) -> None:
    """Print nothing but what goes wrong, and hand lines that say how far work has come to who shows them."""
    _Output.quiet, _Output.take = True, take


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


def folded(text: str, columns: int) -> list[str]:
    """Fold a text between its words, since names are to be copied and numbers in brackets belong together.

    Args:
        text: A line, or several; what is folded keeps its indentation.
        columns: How wide it may become, unless a word is longer.
    """
    lines = list[str]()
    for line in text.split("\n"):
        whole = _VECTOR.sub(lambda vector: vector[0].replace(" ", "\xa0"), line)
        margin = " " * (len(line) - len(line.lstrip()))
        parts = textwrap.wrap(
            whole, max(columns, 1), subsequent_indent=margin, break_long_words=False, break_on_hyphens=False
        )
        lines += [part.replace("\xa0", " ") for part in parts] or [""]
    return lines


def say(text: str) -> None:
    """Print a line for the user, which a terminal that is too narrow gets in several."""
    print_raw("\n".join(folded(harmless(text), width())) if sys.stdout.isatty() else text)


def print_raw(text: str) -> None:
    """Print a text as it is, for programs to read or to be copied."""
    if _Output.quiet:
        return
    with naming_output():
        sys.stdout.write(f"{harmless(text).rstrip(chr(10))}\n")
        sys.stdout.flush()


def say_next(command: str) -> None:
    """Print what to type next, where `neurosym` is not found by its name as it was called this time."""
    typed, found = sys.argv[0], shutil.which(NAME)
    is_found = found and Path(found).resolve() == Path(typed).resolve()
    program = NAME if is_found or Path(typed).name != NAME else quoted(typed)
    print_raw(f"next: {_PROGRAM.sub(lambda _: program, command)}")


def show_table(
    title: str, columns: Sequence[str], rows: Sequence[Sequence[str]], *, most: int | None = None
) -> None:
    """Print a table, whose widest columns are folded where the terminal is too narrow; names never are.

    Where even that is too wide, each row becomes a line of its own, with the headings in it.

    Args:
        title: What it shows.
        columns: Headings.
        rows: One text for each heading.
        most: How many columns of the terminal it may take; all of them if not given.
    """
    there, words = min(width(), most or width()), partial(folded, columns=1)
    lines = [[harmless(cell) for cell in line] for line in (columns, *rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    least = [max(map(len, chain(*map(words, column)))) for column in zip(*lines, strict=True)]
    say(title)
    while sum(widths) + 2 * (len(widths) - 1) > there:
        able = [n for n, wide in enumerate(widths) if wide > least[n]]
        if not able:
            _stack(lines, there)
            return
        widths[max(able, key=widths.__getitem__)] -= 1
    for number, line in enumerate(lines):
        cells = [folded(cell, wide) for cell, wide in zip(line, widths, strict=True)]
        for parts in zip_longest(*cells, fillvalue=""):
            print_raw("  ".join(f"{part:<{wide}}" for part, wide in zip(parts, widths, strict=True)).rstrip())
        if number == 0:
            print_raw("  ".join("-" * wide for wide in widths))


def _stack(lines: Sequence[Sequence[str]], columns: int) -> None:
    """Print the rows of a table below each other: what each is of, then what is in its other columns."""
    headings, *rows = lines
    first = 1 if headings[0] else 2  # a column without a heading counts the rows
    for row in rows:
        told = [f"{name}: {cell}" for name, cell in zip(headings[first:], row[first:], strict=True) if cell]
        for line in (*folded("  ".join(row[:first]), columns), *folded(f"    {'; '.join(told)}", columns)):
            print_raw(line)


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
def shown_doing(*, always: bool = False) -> Iterator[Doing]:
    """Show in a terminal what goes on, one thing in the place of the one before; it is gone in the end.

    Where there is no terminal, each is a line if it is to be shown `always`.
    """
    is_shown = not _Output.quiet
    try:
        if is_shown and _is_seen():
            yield _draw
        else:
            yield lambda text: _write_error(f"{harmless(text)}\n") if is_shown and always else None
    finally:
        if is_shown and _is_seen():
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
        self.is_drawn, self._last = False, monotonic()
        self._restart(label)

    def _restart(self, label: str) -> None:
        self._label, self._tenths, self._begin = label, 0, monotonic()
        self._measured_from = self._begin, 0

    def advance(self, done: int, total: int, label: str | None = None) -> None:
        """Say how much is done, if it is time to."""
        if _Output.quiet and _Output.take is None:
            return
        if label is not None and label != self._label:
            self._restart(label)
        now, tenths = monotonic(), 10 * done // total if total else 0
        if now - self._begin <= _AT_ONCE:
            self._measured_from = now, done
        is_seen, taken = _is_seen() and _Output.take is None, now - self._begin
        pause = _REDRAW if is_seen else _LEAST_PAUSE
        if now - self._last < pause and not (is_seen and done >= total):
            return
        if not is_seen and tenths <= self._tenths:
            return
        self._tenths, self._last = tenths, now
        since, before = self._measured_from
        rate = (now - since) / (done - before) if done > before else 0.0
        left = f", about {_minutes(rate * (total - done))} left" if done < total and rate else ""
        text = f"{self._label}: {done} of {total} after {_minutes(taken)}{left}"
        if is_seen:
            self.is_drawn = True
            wide = max(0, min(_BAR, shutil.get_terminal_size().columns - len(text) - 2))
            _draw(f"{'█' * (wide * done // max(total, 1)):<{wide}} {text}")
        elif _Output.take:
            _Output.take(text)
        else:
            _write_error(f"{harmless(text)}\n")


def _minutes(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d} min"
