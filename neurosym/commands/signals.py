"""What ends a command from outside: Ctrl-C, a closed terminal, `timeout`, a batch system.

The first signal is raised as an exception, so that what is being done is left in order: planners are killed,
temporary folders removed, workers ended. What comes after it is ignored, since closed terminals and batch
systems send several, but for a second Ctrl-C, which ends at once; the keeper of `planners/` clears away then.
"""

import os
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import FrameType

from neurosym.commands.exit_codes import INTERRUPTED
from neurosym.console import complain

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""What a command is ended with in order."""
_PATIENCE = 10.0  # until a command that does not end in order is ended at once [s]
_IMPATIENT = 0.5  # Ctrl-C within this time after the first signal is the same one [s]


class Ended(KeyboardInterrupt):
    """A signal ended the command; like Ctrl-C, it is no `Exception`.

    Attributes:
        code: The exit code that says so.
        name: What the signal is called.
    """

    def __init__(self, number: signal.Signals):
        super().__init__(number)
        self.code = _exit_code(number)
        self.name = number.name


def say_interrupted(error: KeyboardInterrupt) -> int:
    """Say that the command was interrupted, if there is still somebody to say it to; return its exit code.

    Args:
        error: What was raised.
    """
    how = (
        f"ended by {error.name}" if isinstance(error, Ended) and error.code != INTERRUPTED else "interrupted"
    )
    with suppress(OSError):
        complain(f"{how}; the same command goes on from what is written, or begins again")
    return error.code if isinstance(error, Ended) else INTERRUPTED


def _exit_code(number: int) -> int:
    return 128 + number


@contextmanager
def raised_signals() -> Iterator[None]:
    """Raise `Ended` where a signal is heard, unless it is ignored already (as by `nohup`).

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
            raise Ended(signal.Signals(number))
        is_same = signal.getitimer(signal.ITIMER_REAL)[0] > _PATIENCE - _IMPATIENT
        if number == signal.SIGALRM or (number == signal.SIGINT and not is_same):
            os._exit(_exit_code(heard[0]))

    before = {number: signal.getsignal(number) for number in SIGNALS}
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
