"""Running the command line as a user would, and finding what it leaves behind."""

import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tools.benchmarks.options import ROOT

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL)  # what commands are killed by
MARK = "NEUROSYM_FAULTS"  # a variable in the environment of all that a trial starts
PATIENCE = 1200.0
"""How long a command may take before it counts as hanging, on a machine that is busy with much else [s]."""
SETTLE = 5.0  # how long what a command leaves may take to end after it, on a busy machine [s]


@dataclass(frozen=True)
class Ending:
    """How a command ended."""

    code: int | None  # minus the signal if one ended it; None if it had to be killed because it hung
    errors: str  # what it wrote to standard error, without progress bars
    seconds: float  # how long it took [s]

    @property
    def is_before_ours(self) -> bool:
        """Whether Ctrl-C came while Python itself was starting, and nothing of ours was there to hear it."""
        return self.errors.endswith("KeyboardInterrupt") and str(ROOT) not in self.errors

    def complaints(self, codes: Sequence[int]) -> list[str]:
        """Say what is wrong with it."""
        if self.code is None:
            return ["hangs"]
        found = [] if self.code in codes else [f"exit code {self.code}: {self.errors[-300:]}"]
        if "Traceback" in self.errors:
            found.append(f"traceback: {self.errors[-300:]}")
        elif self.code == 2 and len(self.errors.splitlines()) != 1:
            found.append(f"not one sentence: {self.errors[-300:]}")
        return found


@dataclass
class Running:
    """A command that runs."""

    process: "subprocess.Popen[bytes]"
    mark: str  # what its environment, and that of all it starts, names it by
    log: Path  # what it writes to standard error goes here
    begin: float = field(default_factory=time.monotonic)  # when it started [s]

    def ends_within(self, seconds: float) -> bool:
        """Wait, and say whether it has ended."""
        try:
            self.process.wait(max(0.0, seconds))
        except subprocess.TimeoutExpired:
            return False
        except KeyboardInterrupt:
            self.process.kill()
            raise
        return True

    def ending(self) -> Ending:
        """Wait for its end; kill it if that does not come."""
        hangs = not self.ends_within(PATIENCE)
        if hangs:
            self.process.kill()
            self.process.wait()
        lines = [line for line in self.log.read_text(errors="replace").splitlines() if "█" not in line]
        self.log.unlink()
        code, seconds = self.process.returncode, time.monotonic() - self.begin
        return Ending(None if hangs else code, "\n".join(filter(str.strip, lines)), seconds)


def start(
    arguments: Sequence[str],
    scratch: Path,
    *,
    environment: Mapping[str, str] = {},
    before: Sequence[str] = (),
    logs: Path | None = None,
) -> Running:
    """Start `neurosym` with arguments."""
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    mark, nothing = f"{os.getpid()}-{time.monotonic_ns()}", subprocess.DEVNULL
    log = (logs or scratch.parent) / f"{mark}.log"
    command = [*before, sys.executable, "-m", "neurosym", *arguments]
    added = {MARK: mark, "TMPDIR": str(scratch), "OMP_NUM_THREADS": "1", "PYTHONPATH": str(ROOT)}
    with log.open("wb") as sink, _heard():
        where = {"cwd": scratch.parent, "env": {**os.environ, **added, **environment}}
        process = subprocess.Popen(command, stdin=nothing, stdout=nothing, stderr=sink, **where)
    return Running(process, mark, log)


@contextmanager
def _heard() -> Iterator[None]:
    """Let what is started hear signals that we ignore, as under nohup; what is handled is not passed on."""
    ignored = [number for number in SIGNALS if signal.getsignal(number) is signal.SIG_IGN]
    for number in ignored:
        signal.signal(number, lambda *_: None)
    try:
        yield
    finally:
        for number in ignored:
            signal.signal(number, signal.SIG_IGN)


def run(arguments: Sequence[str], scratch: Path, **options: Any) -> tuple[Ending, list[str]]:
    """Run `neurosym` to its end; also return what it leaves behind. See `start`."""
    running = start(arguments, scratch, **options)
    return running.ending(), left_by(running, scratch)


def left_by(running: Running, scratch: Path) -> list[str]:
    """Name the processes and temporary files that a command has left, and kill those processes."""
    end = time.monotonic() + SETTLE
    while True:
        processes, files = marked(running.mark), [path.name for path in scratch.iterdir()]
        if not (processes or files) or time.monotonic() > end:
            break
        time.sleep(0.02)
    found = [f"process left: {_read(n, 'cmdline')[:120].decode('latin-1')}" for n in processes]
    for number in processes:
        os.kill(number, signal.SIGKILL)
    return found + [f"temporary file left: {name}" for name in files]


def marked(mark: str) -> list[int]:
    """List the processes that a command has started, without those that only wait to be buried."""
    wanted = f"{MARK}={mark}".encode()
    numbers = [int(path.name) for path in Path("/proc").glob("[0-9]*")]
    return [number for number in numbers if wanted in _read(number, "environ")]


def _read(process: int, what: str) -> bytes:
    try:
        return Path(f"/proc/{process}/{what}").read_bytes().replace(b"\0", b" ")
    except OSError:
        return b""


def content(folder: Path) -> dict[str, str]:
    """Return a digest of each file of a domain folder, without what a clock decides."""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): _digest(path) for path in files}


def stages_done(folder: Path) -> dict[str, Any]:
    """Return what the manifest of a domain folder says of each stage."""
    try:
        found: dict[str, Any] = _timeless(json.loads((folder / "manifest.json").read_bytes())["stages"])
    except (OSError, ValueError, KeyError):
        return {}
    return found


def _digest(path: Path) -> str:
    data = path.read_bytes()
    if path.suffix == ".json":
        try:
            data = json.dumps(_timeless(json.loads(data))).encode()
        except ValueError:
            return "damaged"
    if path.suffix == ".npz" and not zipfile.is_zipfile(path):
        return "damaged"
    return hashlib.sha256(data).hexdigest()[:16]


def _timeless(value: Any) -> Any:
    """Leave out seconds, and digests of files that hold them."""
    if isinstance(value, list):
        return [_timeless(entry) for entry in value]
    if not isinstance(value, dict):
        return value
    told = {key: entry for key, entry in value.items() if key != "seconds"}
    digests = {key for key, entry in told.items() if key.endswith(".json") and isinstance(entry, str)}
    return {key: _timeless(entry) for key, entry in told.items() if key not in digests}


def differences(found: Mapping[str, str], wanted: Mapping[str, str]) -> list[str]:
    """Say which files are missing, too many, damaged, or have other bytes."""
    said = [f"missing: {name}" for name in wanted if name not in found]
    said += [f"too many: {name}" for name in found if name not in wanted]
    return said + [f"other bytes: {name}" for name in wanted if found.get(name, wanted[name]) != wanted[name]]
