"""Running a planner as a process that leaves nothing behind.

Planners start processes of their own, some in sessions of their own, and write files wherever they stand, or
where temporary files go. Callers give each call a folder of its own for both. When it ends or its time is up,
all its descendants are killed; those that have cut their ties are known by a mark in their environment.
"""

import os
import resource
import signal
import subprocess
import tempfile
import textwrap
import uuid
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

MEMORY = 4 * 1024**3
"""How much memory a planner may take [bytes]."""
FILE_SIZE = 1024**3
"""How large a file a planner may write, its output included [bytes]."""
_TOLD = 1024**2  # how much of its output is kept, from the end [bytes]
_MARK = "NEUROSYM_PLANNER_CALL"


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
) -> Finished:
    """Run a command in a session of its own, and kill all that is left of it when it ends or its time is up.

    Args:
        command: The command.
        folder: Its working directory, and where its temporary files go.
        time_limit: When to kill it [s].
        stdin: What it reads from its standard input.
        environment: Variables added to the environment.
    """
    mark = f"{_MARK}={uuid.uuid4().hex}"
    added = {"TMPDIR": str(folder), **(environment or {}), **dict([mark.split("=")])}
    with (stdin or Path(os.devnull)).open("rb") as source, tempfile.TemporaryFile() as sink:
        process = subprocess.Popen(
            command,
            cwd=folder,
            stdin=source,
            stdout=sink,
            stderr=subprocess.STDOUT,
            env={**os.environ, **added},
            start_new_session=True,
        )
        code: int | None = None
        try:
            with suppress(ProcessLookupError):
                resource.prlimit(process.pid, resource.RLIMIT_AS, (MEMORY, MEMORY))
                resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (FILE_SIZE, FILE_SIZE))
            code = process.wait(timeout=max(time_limit, 0.0))
        except subprocess.TimeoutExpired:
            pass
        finally:
            # While it has not been waited for, its number is still its own.
            kill_all(mark, None if process.returncode is not None else process.pid)
            process.wait()
        sink.seek(max(0, sink.seek(0, os.SEEK_END) - _TOLD))
        return Finished(code, sink.read().decode(errors="replace"))


def read_text(path: Path) -> str:
    """Read what a planner wrote, whatever it is; nothing if there is no such file, or it is too large."""
    try:
        if path.stat().st_size > _TOLD:
            return ""
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""


def kill_all(mark: str, root: int | None) -> None:
    """Kill a process of ours with all its descendants, and whatever else bears its mark.

    They are stopped first, so that none can start another while they are being listed.

    Args:
        mark: NAME=VALUE in the environment that the process was started with.
        root: The process, if it has not been waited for.
    """
    stopped: set[int] = set()
    while new := (_marked(mark) | (_descendants(root) if root else set())) - stopped:
        for process in new:
            _signal(process, signal.SIGSTOP)
        stopped |= new
    for process in stopped:
        _signal(process, signal.SIGKILL)


def _marked(mark: str) -> set[int]:
    return {number for number in _processes() if mark.encode() in _about(number, "environ")}


def _descendants(root: int) -> set[int]:
    children: dict[int, list[int]] = {}
    for number in _processes():
        # The command's name, in brackets, may hold anything; the parent is the second field after it.
        if fields := _about(number, "stat").rpartition(b")")[2].split():
            children.setdefault(int(fields[1]), []).append(number)
    found: set[int] = set()
    waiting = [root]
    while waiting:
        process = waiting.pop()
        found.add(process)
        waiting += children.get(process, [])
    return found


def _processes() -> list[int]:
    return [int(entry.name) for entry in Path("/proc").iterdir() if entry.name.isdigit()]


def _about(process: int, what: str) -> bytes:
    """Read what the system tells about a process; nothing if it has ended or is not ours."""
    with suppress(OSError):
        return (Path("/proc") / str(process) / what).read_bytes()
    return b""


def _signal(process: int, number: signal.Signals) -> None:
    with suppress(ProcessLookupError, PermissionError):
        os.kill(process, number)
