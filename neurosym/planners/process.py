"""Running a planner as a process that leaves nothing behind.

Planners start processes of their own, some in sessions of their own, and write files wherever they stand, or
where temporary files go. Each call gets a folder of its own for both. When it ends or its time is up, all its
descendants are killed; those that have cut their ties are known by a mark in their environment. When we are
killed ourselves, the keeper does that (`keeper.py`).
"""

import atexit
import math
import os
import resource
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import uuid
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from neurosym.errors import CannotStart, InvalidFile
from neurosym.files import read_bytes
from neurosym.planners import keeper
from neurosym.planners.keeper import FOLDER_PREFIX, MARK, end_processes, marked, state_of, this_process

MEMORY = 4 * 1024**3
"""How much memory a planner may take, unless this process may take less [bytes]."""
FILE_SIZE = 1024**3
"""How large a file a planner may write, its output included, unless this process may write less [bytes]."""
_TOLD = 1024**2  # how much of its output is kept, from the end [bytes]
_PATIENCE = 2.0  # for the keeper to end [s]
_running: dict[int, "subprocess.Popen[bytes]"] = {}  # by the thread that waits for it
_keepers: dict[int, "subprocess.Popen[bytes]"] = {}
"""The keeper by the process that it was started for; a forked process has none yet."""
_open: set[object] = set()
"""What is being done, or was broken off by an error."""
_starting = threading.Lock()


@dataclass(frozen=True, slots=True)
class Finished:
    """How a process ended.

    Attributes:
        code: Its exit code; None if it was killed because the time was up.
        output: What it wrote, errors included.
    """

    code: int | None
    output: str

    @property
    def last_words(self) -> str:
        """The last line that it wrote, shortened, without control characters."""
        plain = "".join(sign if sign.isprintable() or sign == "\n" else " " for sign in self.output)
        lines = [line.strip() for line in plain.splitlines() if line.strip()]
        return textwrap.shorten(lines[-1], 200) if lines else "it said nothing"


def run_limited(
    command: Sequence[str],
    folder: Path,
    time_limit: float,
    *,
    stdin: Path | None = None,
    environment: Mapping[str, str] | None = None,
    memory: int = MEMORY,
) -> Finished:
    """Run a command in a session of its own, and kill all that is left of it when it ends or its time is up.

    Args:
        command: The command.
        folder: Its working directory, and where its temporary files go.
        time_limit: When to kill it [s]; infinite: never.
        stdin: What it reads from its standard input.
        environment: Variables added to the environment.
        memory: How much memory it may take [bytes].

    Raises:
        CannotStart: If the system lets no process be started.
    """
    mark = f"{this_process()}.{uuid.uuid4().hex}"
    added = {"TMPDIR": str(folder), **(environment or {}), MARK: mark}
    source_file = stdin or Path(os.devnull)
    with kept(), source_file.open("rb") as source, tempfile.TemporaryFile() as sink:
        try:
            process = subprocess.Popen(
                _limited(command, memory),
                cwd=folder,
                stdin=source,
                stdout=sink,
                stderr=subprocess.STDOUT,
                env={**os.environ, **added},
                start_new_session=True,
            )
        except OSError as error:
            raise CannotStart("planner", str(error.strerror)) from error
        code: int | None = None
        try:
            _running[threading.get_ident()] = process
            code = process.wait(timeout=None if math.isinf(time_limit) else max(time_limit, 0.0))
        except subprocess.TimeoutExpired:
            pass
        finally:
            _running.pop(threading.get_ident(), None)
            # While it has not been waited for, its number is still its own.
            _kill_all(f"{MARK}={mark}", None if process.returncode is not None else process.pid)
            process.wait()
        sink.seek(max(0, sink.seek(0, os.SEEK_END) - _TOLD))
        return Finished(code, sink.read().decode(errors="replace"))


def end_calls(threads: Collection[int]) -> None:
    """Kill what threads are waiting for; they then see to what it started.

    Args:
        threads: Their identifiers.
    """
    for thread in threads:
        if process := _running.get(thread):
            process.kill()


def read_text(path: Path) -> str:
    """Read what a planner wrote, whatever it is; nothing if there is no such file, or it is too large."""
    with suppress(InvalidFile):
        return read_bytes(path, _TOLD).decode(errors="replace")
    return ""


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """Make an empty folder, and remove it with all that is in it; also when this process is killed."""
    prefix = f"{FOLDER_PREFIX}{os.getpid()}-"
    with kept(), tempfile.TemporaryDirectory(prefix=prefix, ignore_cleanup_errors=True) as name:
        yield Path(name)


@contextmanager
def kept() -> Iterator[None]:
    """Have the keeper look after what is made and started inside, in case that it is not left in order."""
    _start_keeper()
    task = object()
    _open.add(task)
    yield
    _open.discard(task)


def _start_keeper() -> None:
    """Start the process that clears away what this one leaves when it is killed; once for each process."""
    with _starting:
        if os.getpid() in _keepers:
            return
        program = [sys.executable, "-I", "-S", keeper.__file__, tempfile.gettempdir(), this_process()]
        with suppress(OSError):
            _keepers[os.getpid()] = subprocess.Popen(
                program,
                cwd="/",
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                env={name: value for name, value in os.environ.items() if name != MARK},
                start_new_session=True,
            )


@atexit.register
def _dismiss() -> None:
    """Clear away what was broken off, tell the keeper that nothing is left, and wait for its end."""
    found = _keepers.pop(os.getpid(), None)
    if found:
        if _open:
            keeper.clear(Path(tempfile.gettempdir()), this_process())
        with suppress(OSError, subprocess.TimeoutExpired):
            found.communicate(b".", timeout=_PATIENCE)


def _kill_all(mark: str, root: int | None) -> None:
    """Kill a process that was not waited for yet, its descendants, and whatever else bears its mark."""
    if root and not keeper.processes():  # a system that does not tell
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(root, signal.SIGKILL)
    end_processes(lambda: marked(mark) | (_descendants(root) if root else set()))


def _limited(command: Sequence[str], memory: int) -> list[str]:
    """Have a shell limit itself and then become the command, so that no moment is without the limits."""
    kibibytes = _at_most(resource.RLIMIT_AS, memory) // 1024
    blocks = _at_most(resource.RLIMIT_FSIZE, FILE_SIZE) // 512
    limits = f"{{ ulimit -v {kibibytes}; ulimit -f {blocks}; }} 2>/dev/null"  # not every system has both
    return ["/bin/sh", "-c", f'{limits}; exec "$@"', "sh", *command]


def _at_most(kind: int, most: int) -> int:
    """Return what a planner may have, which is never more than this process may have."""
    return min(limit for limit in (most, *resource.getrlimit(kind)) if limit != resource.RLIM_INFINITY)


def _descendants(root: int) -> set[int]:
    parents = {number: int(fields[1]) for number in keeper.processes() if (fields := state_of(number))}
    found, new = set[int](), {root}
    while new:
        found |= new
        new = {number for number, parent in parents.items() if parent in new} - found
    return found
