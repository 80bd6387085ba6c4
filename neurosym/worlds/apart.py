"""A process apart that calls functions for us, so that whatever they do, ours can tell it.

It is no fork, and does not import the program that started it. A pipe that is closed then tells it so.
"""

import signal
import subprocess
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from neurosym.errors import CannotStart, InvalidWorld
from neurosym.world import FrameSink
from neurosym.worlds import host
from neurosym.worlds.children import GRACE, Child


class Process:
    """A process that calls functions for us.

    Args:
        name: What messages call the world that is made there.

    Raises:
        CannotStart: If the system does not let it be started; from `call` if it ends before it is up.
        InvalidWorld: From `call`, if the process ends, or does not answer in time.
    """

    def __init__(self, name: str):
        self._name, self.patience = name, host.PATIENCE
        self._child = Child(host.serve)
        self._lock = threading.Lock()

    @property
    def is_open(self) -> bool:
        """Whether it can be asked."""
        return self._child.is_open

    @property
    def number(self) -> int:
        """Its number in the system."""
        return self._child.process.pid

    def close(self, grace: float = GRACE) -> None:
        """Let it end by itself, or kill it.

        Args:
            grace: How long it has to end [s].
        """
        self._child.close(grace)

    def call(
        self, what: str, function: Callable[..., Any], *arguments: Any, on_frame: FrameSink | None = None
    ) -> Any:
        """Have a function called, and return what it returns.

        Args:
            what: What messages call it.
            function: A function of a module.
            arguments: Its arguments.
            on_frame: Takes the pictures that it sends on the way.
        """
        with self._lock:
            self._ask(what, lambda: self._child.send((self._name, function, arguments)))
            try:
                while True:
                    kind, answer = self._ask(what, self._receive, what)
                    if kind != host.FRAME:
                        break
                    assert on_frame is not None, "else none is sent"
                    on_frame(*answer)
            except BaseException:  # whatever it still sends belongs to no call any more
                self.close(grace=0.0)
                raise
        if kind == host.REFUSAL:
            raise answer
        return answer

    def _receive(self, what: str) -> Any:
        try:
            return self._child.receive(self.patience)
        except TimeoutError as error:
            self.close(grace=0.0)
            problem = f"has not come back from {what} for {self.patience:g} s"
            raise InvalidWorld(self._name, problem) from error

    def _ask(self, what: str, exchange: Callable[..., Any], *arguments: Any) -> Any:
        try:
            return exchange(*arguments)
        except (EOFError, OSError) as error:
            raise InvalidWorld(self._name, f"{self._how_it_ended()} in {what}") from error
        except (InvalidWorld, CannotStart):
            raise
        except Exception as error:
            raise InvalidWorld(self._name, f"gives what no other process can read from {what}") from error

    def _how_it_ended(self) -> str:
        with suppress(subprocess.TimeoutExpired):
            self._child.process.wait(GRACE)
        self.close(grace=0.0)
        code = self._child.process.returncode
        if code >= 0:
            return f"ends its process with exit code {code}"
        because = " (by somebody, or for want of memory)" if -code == signal.SIGKILL else ""
        return f"has its process killed by {signal.Signals(-code).name}{because}"
