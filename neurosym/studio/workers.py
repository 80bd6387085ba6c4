"""The processes that work for pages: some plan, some run; whoever comes when all are busy waits in line."""

import threading
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from neurosym.errors import CannotStart
from neurosym.studio import children
from neurosym.studio.messages import Failed, Job
from neurosym.worlds.children import Child, ChildEnded

DIED = "The process that worked on it has ended; only this is lost, so try again."
STOPPED = "It was stopped."
Tell = Callable[[Any], None]
"""Takes what a process sends; the last is its answer."""


class Ticket:
    """A job that was handed in: it waits in line, is worked on, or is done.

    Args:
        job: The job.
        tell: Called in a thread of its own with what is sent, the answer last.
        queue: Where it was handed in.
    """

    def __init__(self, job: Job, tell: Tell, queue: "Workers"):
        self.job, self.tell = job, tell
        self._queue = queue
        self._child: Child | None = None
        self._is_stopped = False
        self._words: list[Any] = []
        self._lock = threading.Lock()

    @property
    def place(self) -> int:
        """How many jobs are before it in the line; 0 once it is worked on."""
        return self._queue.place_of(self)

    @property
    def process(self) -> int | None:
        """The number of the process that works on it, while one does."""
        child = self._child
        return child.process.pid if child is not None else None

    def say(self, word: Any) -> None:
        """Say something to the process that works on it, or will; nothing is said of what is done."""
        with self._lock, suppress(ChildEnded):
            if self._child is not None:
                self._child.say(word)
            else:
                self._words.append(word)

    def stop(self) -> None:
        """Give the job up: its process is ended, and `tell` hears that it was stopped."""
        with self._lock:
            self._is_stopped = True
            if self._child is not None:
                self._child.process.kill()
        self._queue.drop(self)

    def work(self, child: Child) -> bool:
        """Have a process do the job, tell what it sends, and say whether the process can do another one.

        Args:
            child: The process.
        """
        try:
            child.ask(children.do, self.job)
            with self._lock:
                self._child = child
                for word in self._words:
                    child.say(word)
                if self._is_stopped:
                    child.process.kill()
            answer, is_usable = child.answer(hear=self.tell), True
        except (ChildEnded, CannotStart) as error:
            why = str(error) if isinstance(error, CannotStart) else STOPPED if self._is_stopped else DIED
            answer, is_usable = Failed(why), False
        with self._lock:
            self._child = None
        self.tell(answer)
        return is_usable


class Workers:
    """Processes of one kind, started when they are first needed, and a line before them.

    Args:
        most: How many work at once.
    """

    def __init__(self, most: int):
        self._line: deque[Ticket] = deque()
        self._free: list[Child] = []
        self._busy, self._most = 0, most
        self._lock = threading.Lock()
        self._is_closed = False

    def warm(self) -> None:
        """Start a process before it is needed."""
        with suppress(CannotStart):
            child = Child(children.__name__)
            with self._lock:
                self._free.append(child)

    def submit(self, job: Job, tell: Tell) -> Ticket:
        """Hand in a job.

        Args:
            job: The job.
            tell: Called in a thread of its own with what is sent, the answer last.
        """
        ticket = Ticket(job, tell, self)
        with self._lock:
            self._line.append(ticket)
        self._begin()
        return ticket

    def place_of(self, ticket: Ticket) -> int:
        """Return how many jobs are before one, itself included; 0 if it does not wait."""
        with self._lock:
            return self._line.index(ticket) + 1 if ticket in self._line else 0

    def drop(self, ticket: Ticket) -> None:
        """Take a job out of the line, if it is there."""
        with self._lock:
            if ticket not in self._line:
                return
            self._line.remove(ticket)
        ticket.tell(Failed(STOPPED))

    def close(self) -> None:
        """End all processes, and whatever they work on."""
        with self._lock:
            self._is_closed = True
            self._line.clear()
            free, self._free = self._free, []
        for child in free:
            child.close(grace=0.0)

    def _begin(self) -> None:
        with self._lock:
            if self._is_closed or not self._line or self._busy >= self._most:
                return
            ticket, self._busy = self._line.popleft(), self._busy + 1
            child = self._free.pop() if self._free else None
        threading.Thread(target=self._work, args=(ticket, child), daemon=True).start()

    def _work(self, ticket: Ticket, child: Child | None) -> None:
        is_usable = False
        try:
            child = child or Child(children.__name__)
            is_usable = ticket.work(child)
        except CannotStart as error:
            ticket.tell(Failed(str(error)))
        finally:
            with self._lock:
                self._busy -= 1
                keeps = is_usable and child is not None and not self._is_closed
                if keeps and child is not None:
                    self._free.append(child)
            if child is not None and not keeps:
                child.close(grace=0.0)
            self._begin()
