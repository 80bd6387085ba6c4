"""How a command ends: its exit code, and the one sentence if it could not be done."""

import io
import os
import signal
import sys
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType

from neurosym.choices import compute_in_one_thread
from neurosym.commands.catalogue import overview
from neurosym.errors import NAME, InvalidValue, NeurosymError, refuse_other_library, version_of
from neurosym.stages.console import NARROW, OutputClosed, be_quiet, complain, naming_output, say, width

_DONE, _BAD_INPUT, NO_RESULT, _NOBODY_READS = 0, 2, 3, 141
"""Exit codes; `cli` says what each means."""


# What ends a command from outside: Ctrl-C, a closed terminal, `timeout`, a batch system.
#
# The first signal is raised as an exception, so that what is being done is left in order: planners are
# killed, temporary folders removed, workers ended. What comes after it is ignored, since closed terminals
# and batch systems send several, but for a second Ctrl-C, which ends at once; the keeper of `planners/`
# clears away then.

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""What a command is ended with in order."""
_PATIENCE = 10.0  # until a command that does not end in order is ended at once [s]
_IMPATIENT = 0.5  # Ctrl-C within this time after the first signal is the same one [s]


class _Ended(KeyboardInterrupt):
    """A signal ended the command; like Ctrl-C, it is no `Exception`."""

    def __init__(self, number: signal.Signals):
        super().__init__(number)
        self.number = number


def say_interrupted(error: KeyboardInterrupt) -> int:
    """Say that the command was interrupted, and return its exit code."""
    number = error.number if isinstance(error, _Ended) else signal.SIGINT
    how = "interrupted" if number == signal.SIGINT else f"ended by {number.name}"
    complain(f"{how}; the same command goes on from what is written, or begins again")
    return 128 + number


@contextmanager
def raised_signals() -> Iterator[None]:
    """Raise `_Ended` where a signal is heard, unless it is ignored already (as by `nohup`).

    Once a signal was heard, this process is to end, and remains deaf to others until then.
    """
    if threading.current_thread() is not threading.main_thread():
        yield  # only the main thread may say what becomes of signals
        return
    heard: list[int] = []

    def hear(number: int, _: FrameType | None) -> None:
        if not heard:
            heard.append(number)
            signal.setitimer(signal.ITIMER_REAL, _PATIENCE)
            raise _Ended(signal.Signals(number))
        is_same = signal.getitimer(signal.ITIMER_REAL)[0] > _PATIENCE - _IMPATIENT
        if number == signal.SIGALRM or (number == signal.SIGINT and not is_same):
            os._exit(128 + heard[0])

    before = {number: signal.getsignal(number) for number in _SIGNALS}
    ours = [number for number, handler in before.items() if handler is not signal.SIG_IGN]
    alarm = signal.signal(signal.SIGALRM, hear)
    for number in ours:
        signal.signal(number, hear)
    try:
        yield
    finally:
        if not heard:
            signal.signal(signal.SIGALRM, alarm)
            for number in ours:
                signal.signal(number, before[number])


def make_usable() -> None:
    """Make standard streams such that anything can be printed.

    Where one is closed (`>&-`), what is printed goes nowhere; without this the next file that is opened would
    be taken for it.
    """
    for descriptor in (0, 1, 2):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # the lowest number that is free
    for name in ("stdin", "stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, io.TextIOWrapper(io.FileIO(os.devnull, "r+"), encoding="utf-8"))
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # names that the encoding does not have


_QUIET = "--quiet"
"""What any command may be given to print nothing but what goes wrong."""
_NO_MEMORY = "There is not enough memory; ask for less (workers, objects, rows), or end other programs."
_WANTS_MEMORY = (  # how torch says it, and what loads libraries
    "allocate memory",
    "not enough memory",
    "bad allocation",
    "std::bad_alloc",
    "failed to map segment",
)


def perform(typed: Sequence[str]) -> int:
    """Perform what was typed, say what went wrong if anything did, and return the exit code.

    Args:
        typed: What was typed after `neurosym`.
    """
    try:
        with raised_signals():
            try:
                refuse_other_library()
                return _perform(typed)
            finally:
                with naming_output():
                    sys.stdout.flush()
    except (OutputClosed, BrokenPipeError):
        return _NOBODY_READS
    except KeyboardInterrupt as error:
        return say_interrupted(error)
    except NeurosymError as error:
        complain(str(error))
    except OSError as error:
        complain(_told(error))
    except (MemoryError, RuntimeError, ImportError) as error:
        if not isinstance(error, MemoryError) and not any(words in str(error) for words in _WANTS_MEMORY):
            raise
        complain(_NO_MEMORY)
    return _BAD_INPUT


def _perform(typed: Sequence[str]) -> int:
    """Perform what was typed; to say only which this is, or what there is, next to nothing is imported."""
    be_quiet(False)
    for word in typed:  # each is to be written down, in a record for instance
        if word != word.encode(errors="replace").decode():
            encoding = sys.getfilesystemencoding()
            raise InvalidValue(f"{word!r} is no text in {encoding}; rename the file such that its name is.")
    if [*typed] == ["--version"]:
        say(f"{NAME} {version_of('neurosym')} (Python {sys.version.split()[0]})")
        return _DONE
    words = [word for word in typed if word != _QUIET]
    if words and words[0].startswith("-") and {"-h", "--help"} & {*words}:
        say(overview(min(width(), NARROW)))
        return _DONE
    be_quiet(_QUIET in typed)
    # torch would leave a folder among temporary ones as soon as it is imported
    os.environ.setdefault("TORCHINDUCTOR_CACHE_DIR", tempfile.gettempdir())
    compute_in_one_thread()
    from neurosym.commands.arguments import read_arguments

    return read_arguments(words)()


def _told(error: OSError) -> str:
    """Say what the system did not do, by the name of the file if it tells it."""
    try:
        Path.cwd()
    except OSError:
        return "The current folder is no longer there; go to another one."
    reason = error.strerror or str(error) or type(error).__name__
    if error.filename is None:
        return f"Something could not be read or written: {reason}."
    with suppress(ValueError):
        return f"{os.fsdecode(error.filename)}: {reason}"
    return reason
