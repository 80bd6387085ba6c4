"""Running a planner as a process that leaves nothing behind.

Planners start processes of their own, some in sessions of their own, and write files wherever they stand.
Callers give each call a working directory of its own; when its time is up, all its descendants are killed.
"""

import os
import resource
import signal
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

MEMORY = 4 * 1024**3
"""How much memory a planner may take [bytes]."""


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
        """The last line that it wrote."""
        lines = [line.strip() for line in self.output.splitlines() if line.strip()]
        return lines[-1] if lines else "it said nothing"


def run_limited(
    command: Sequence[str],
    folder: Path,
    time_limit: float,
    *,
    stdin: Path | None = None,
    environment: Mapping[str, str] | None = None,
) -> Finished:
    """Run a command in a session of its own, and kill it with all its descendants when the time is up.

    Args:
        command: The command.
        folder: Its working directory.
        time_limit: When to kill it [s].
        stdin: What it reads from its standard input.
        environment: Variables added to the environment.
    """
    with (stdin or Path(os.devnull)).open("rb") as source, tempfile.TemporaryFile() as sink:
        process = subprocess.Popen(
            command,
            cwd=folder,
            stdin=source,
            stdout=sink,
            stderr=subprocess.STDOUT,
            env={**os.environ, **(environment or {})},
            start_new_session=True,
        )
        code: int | None = None
        try:
            with suppress(ProcessLookupError):
                resource.prlimit(process.pid, resource.RLIMIT_AS, (MEMORY, MEMORY))
            code = process.wait(timeout=max(time_limit, 0.0))
        except subprocess.TimeoutExpired:
            pass
        finally:
            if process.returncode is None:  # not waited for yet, so its number is still its own
                kill_tree(process.pid)
                process.wait()
        sink.seek(0)
        return Finished(code, sink.read().decode(errors="replace"))


def kill_tree(root: int) -> None:
    """Kill a process of ours and all its descendants, in whatever sessions they are.

    They are stopped first, so that none can start another while they are being listed.

    Args:
        root: A process that has not been waited for.
    """
    stopped: set[int] = set()
    while new := _descendants(root) - stopped:
        for process in new:
            _signal(process, signal.SIGSTOP)
        stopped |= new
    for process in stopped:
        _signal(process, signal.SIGKILL)


def _descendants(root: int) -> set[int]:
    children: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        with suppress(OSError):
            # The command's name, in brackets, may hold anything; the parent is the second field after it.
            parent = int((entry / "stat").read_text(errors="replace").rpartition(")")[2].split()[1])
            children.setdefault(parent, []).append(int(entry.name))
    found: set[int] = set()
    waiting = [root]
    while waiting:
        process = waiting.pop()
        found.add(process)
        waiting += children.get(process, [])
    return found


def _signal(process: int, number: signal.Signals) -> None:
    with suppress(ProcessLookupError, PermissionError):
        os.kill(process, number)
