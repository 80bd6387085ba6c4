"""What rich draws for the command line: tables, bars that say how far some work has come, sentences in red.

It is imported when something of it is to be shown, since rich takes longer to import than most commands to
begin; `console` is what is called.
"""

import re
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from time import monotonic
from typing import IO, Any, cast

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    Task,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.status import Status
from rich.table import Table
from rich.text import Text

from neurosym.errors import PIPE_WIDTH, Advance, Doing, harmless, shortened

_LONG = re.compile(r"\S{1000,}")
_LEAST_PAUSE = 5.0  # between lines that say how far some work has come [s]


class _OutputConsole(Console):
    def on_broken_pipe(self) -> None:
        """Leave it to who prints; rich would end the program."""
        raise


class ErrorConsole(Console):
    """A console for sentences about what was given, which may come from files of strangers."""

    def print(self, *objects: Any, **options: Any) -> None:
        """Print without what a terminal would act on, and without the end of words that are far too long."""
        shown = (_LONG.sub(_cut, harmless(text)) if isinstance(text, str) else text for text in objects)
        super().print(*shown, **options)


def _cut(word: re.Match[str]) -> str:
    return shortened(word[0], 300)


class _Forgiving:
    """Standard error, which a command can do without: what cannot be written there is lost."""

    def __getattr__(self, name: str) -> Any:
        return getattr(sys.stderr, name)

    def write(self, text: str) -> int:
        with suppress(OSError):
            sys.stderr.write(text)
        return len(text)

    def flush(self) -> None:
        with suppress(OSError):
            sys.stderr.flush()


console = _OutputConsole(
    highlight=False, emoji=False, soft_wrap=True, width=None if sys.stdout.isatty() else PIPE_WIDTH
)
error_console = ErrorConsole(
    file=cast(IO[str], _Forgiving()), stderr=True, highlight=False, emoji=False, soft_wrap=True
)


class _Rate(ProgressColumn):
    def render(self, task: Task) -> Text:
        return Text(f"{task.speed:.1f}/s" if task.speed else "-/s", style="progress.data.speed")


class _Lines:
    """Says how far some work has come in a line now and then, where there is no terminal to show a bar on."""

    def __init__(self, label: str):
        self._restart(label)

    def _restart(self, label: str) -> None:
        self._label, self._tenths = label, 0
        self._begin = self._last = monotonic()

    def advance(self, done: int, total: int, label: str | None = None) -> None:
        """Say how much is done, if that is a tenth more, and not long after the last line."""
        if label is not None and label != self._label:
            self._restart(label)
        now, tenths = monotonic(), 10 * done // total if total else 0
        if tenths <= self._tenths or now - self._last < _LEAST_PAUSE:
            return
        self._tenths, self._last = tenths, now
        taken = now - self._begin
        left = "" if done >= total else f", about {_minutes(taken * (total - done) / done)} left"
        error_console.print(f"{self._label}: {done} of {total} after {_minutes(taken)}{left}", markup=False)


def _minutes(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d} min"


@contextmanager
def shown_doing(is_quiet: Callable[[], bool]) -> Iterator[Doing]:
    """Show what goes on, one thing in the place of the one before; see `console.shown_doing`."""
    status = Status("", console=error_console)

    def tell(text: str) -> None:
        if not is_quiet():
            status.update(Text(harmless(text)))
            status.start()

    try:
        yield tell
    finally:
        status.stop()


@contextmanager
def progress_bar(label: str, is_quiet: Callable[[], bool]) -> Iterator[Advance]:
    """Show a bar, or say a line now and then; see `console.progress_bar`."""
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        _Rate(),
        TextColumn("left"),
        TimeRemainingColumn(),
        TextColumn("elapsed"),
        TimeElapsedColumn(),
    )
    progress, lines = Progress(*columns, console=error_console), _Lines(label)
    task = progress.add_task(label, total=None)

    def advance(done: int, total: int, label: str | None = None) -> None:
        if is_quiet():
            return
        if not error_console.is_terminal:
            lines.advance(done, total, label)
            return
        progress.start()
        if label is not None and label != progress.tasks[0].description:
            progress.reset(task, description=label, total=total)
        progress.update(task, completed=done, total=total)

    try:
        yield advance
    finally:
        if progress.live.is_started:
            progress.stop()


def print_table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table; see `console.show_table`."""
    table = Table(title=Text(harmless(title), style="table.title"), title_justify="left")
    for column in columns:
        table.add_column(Text(harmless(column)), overflow="fold")
    for row in rows:
        table.add_row(*(Text(harmless(cell)) for cell in row))
    console.print(table)
