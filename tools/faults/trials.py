"""What disturbs a command: kills, full disks, the same command at the same time, low limits, other clocks.

Each part lists its trials by name. A command begins in a fresh folder, is disturbed, looked after, and let
end; then its folder must be as if nothing had happened.
"""

import os
import random
import shutil
import signal
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any

from neurosym.stages.layout import MANIFEST
from tools.benchmarks.options import ROOT
from tools.faults import commands
from tools.faults.commands import Ending, Running, content, differences, left_by
from tools.faults.journal import Jobs, Journal, Trial
from tools.faults.subjects import Bench, Subject, WorldName, stages, subjects

REFUSED = 2
SAME = "the same bytes"


class Attempt:
    """A command in a fresh folder, and what is found wrong with how it goes."""

    def __init__(self, bench: Bench, subject: Subject, name: str, disk: Path | None = None):
        self.bench, self.subject, self.name = bench, subject, name
        self.goal, self.begin = bench.undisturbed(subject), time.monotonic()
        self.place, self.found = disk or bench.place / "trial", list[str]()
        self.scratch = self.place / "scratch"
        self.begin_anew()

    def begin_anew(self) -> None:
        """Make the folder that the command begins with."""
        self.folder = self.bench.fresh(self.subject, self.place / "domain")
        self.before = content(self.folder)

    def start(self, scratch: str = "scratch") -> Running:
        """Start the command."""
        return commands.start(self.subject.arguments(self.folder), self.place / scratch)

    def damage(self, *, half_files: bool = True) -> list[str]:
        """Say what of the folder was lost or is half there."""
        now = content(self.folder)
        found = [f"lost: {name}" for name in self.before if name not in now]
        half = [name for name in now if Path(name).name.startswith(".")] if half_files else []
        return found + [f"half a file left: {name}" for name in half]

    def written_down(self, told: str, outcome: str, kills: int = 0) -> Trial:
        """Write down what came of it."""
        seconds, of = round(time.monotonic() - self.begin, 1), (self.subject.name, self.subject.world)
        part, found = self.name.partition("-")[0], tuple(self.found)
        return Trial(part, self.name, *of, told, outcome, found, kills, seconds)

    def let_end(self, **options: Any) -> str:
        """Let the command end; say in a few words whether all was as promised."""
        self.found += self.bench.finished(self.subject, self.folder, self.scratch, **options)
        return "a finding" if self.found else SAME


def kills(bench: Bench, subject: Subject, journal: Journal, *, wanted: int, seed: int) -> Jobs:
    """Kill a command at drawn moments by drawn signals, and start it again, often enough."""
    done = number = 0
    while done < wanted and number < 2 * wanted:
        name = f"kills-{subject.title}-{number:03d}"
        most = min(subject.chain, wanted - done)
        yield name, partial(_killed, bench, subject, name, most, seed)
        done += journal.trials[name].kills
        number += 1


def _killed(bench: Bench, subject: Subject, name: str, most: int, seed: int) -> Trial:
    attempt, rng, told = Attempt(bench, subject, name), random.Random(f"{seed} {name}"), list[str]()
    for _ in range(5):  # tries to hit the command before it ends
        for _ in range(most):
            at, number = rng.uniform(0.0, attempt.goal.ending.seconds), rng.choice(commands.SIGNALS)
            wrong = _kill(attempt, at, number)
            if wrong is None:
                break
            told.append(f"{number.name} at {at:.2f} s")
            attempt.found += [f"after {told[-1]}: {complaint}" for complaint in wrong]
        if told:
            break
        attempt.begin_anew()
    return attempt.written_down(", ".join(told), attempt.let_end(), len(told))


def _kill(attempt: Attempt, at: float, number: signal.Signals) -> list[str] | None:
    """Start a command and kill it; say what is wrong then, or nothing at all if it had ended before."""
    running = attempt.start()
    if running.ends_within(at - (time.monotonic() - running.begin)):
        running.ending()
        left_by(running, attempt.scratch)
        return None
    running.process.send_signal(number)
    ending = running.ending()
    codes = (-number, 128 + number, 0, 3)  # the last two if the signal came after the work
    found = [] if ending.is_before_ours else ending.complaints(codes)
    found += left_by(running, attempt.scratch)
    found += [f"damaged: {name}" for name, what in content(attempt.folder).items() if what == "damaged"]
    may_be_half = number == signal.SIGKILL  # what that leaves is cleared away later
    return found + attempt.damage(half_files=not may_be_half)


def disks(bench: Bench) -> Jobs:
    """Perform each stage on a disk that is full, or nearly so, and again when there is room."""
    for subject in stages("toy"):
        for share in (0.0, 0.3, 0.7):
            for scratch_too in (False, True) if subject.name in ("plan", "compare") else (False,):
                name = f"disk-{subject.title}-{share:.0%}{'-scratch' if scratch_too else ''}"
                yield name, partial(_on_full_disk, bench, subject, share, scratch_too, name)


def cannot_mount(bench: Bench) -> str:
    """Say why there can be no small disk here, or nothing if there can."""
    try:
        with _small_disk(bench.place / "trial"):
            return ""
    except (OSError, subprocess.CalledProcessError):
        return "a small disk is a mounted tmpfs, which takes root"


@contextmanager
def _small_disk(place: Path) -> Iterator[Path]:
    place.mkdir(parents=True, exist_ok=True)
    command = ("mount", "-t", "tmpfs", "-o", "size=64m", "tmpfs", str(place))
    subprocess.run(command, check=True, capture_output=True)
    try:
        yield place
    finally:
        subprocess.run(("umount", "--lazy", str(place)), check=True)


@contextmanager
def _filled(disk: Path, room: int) -> Iterator[None]:
    """Fill a disk but for so many bytes for a while."""
    path = disk / "filler"
    with suppress(OSError), path.open("wb", buffering=0) as filler:
        while True:
            filler.write(bytes(4096))
    with path.open("r+b") as filler:
        filler.truncate(max(0, filler.seek(0, 2) - room))
    yield
    path.unlink()


def _on_full_disk(bench: Bench, subject: Subject, share: float, scratch_too: bool, name: str) -> Trial:
    bench.undisturbed(subject)  # before there is a disk in the same place: some write where they are
    with _small_disk(bench.place / "trial") as disk:
        attempt = Attempt(bench, subject, name, disk)
        attempt.scratch = (disk if scratch_too else bench.place) / "scratch"
        attempt.scratch.mkdir(parents=True, exist_ok=True)
        done_before = commands.stages_done(attempt.folder)
        with _filled(disk, round(share * attempt.goal.written)):
            ending, left = commands.run(subject.arguments(attempt.folder), attempt.scratch, logs=bench.place)
            attempt.found += left
            if ending.code != attempt.goal.ending.code:
                attempt.found += ending.complaints((REFUSED,))
                if (
                    done_before.items() <= commands.stages_done(attempt.folder).items()
                ):  # they stay, as promised
                    attempt.before.pop(MANIFEST, None)
                now, before = content(attempt.folder), attempt.before
                changed = [name for name in before if now.get(name) != before[name]]
                attempt.found += [f"lost or changed: {name}" for name in changed]
                attempt.found += attempt.damage()
        outcome = "refused" if ending.code == REFUSED else f"exit code {ending.code}"
        attempt.let_end(logs=bench.place)
        outcome += ", a finding" if attempt.found else ", then the same bytes"
    told = f"room for {share:.0%} of what it writes" + ", temporary files on the same disk" * scratch_too
    return attempt.written_down(told, outcome)


def pairs(bench: Bench, world: WorldName, *, wanted: int, seed: int) -> Jobs:
    """Run commands twice at once: one is refused in a sentence, or both end as if in turn."""
    for subject in subjects(world):
        for number in range(wanted):
            name = f"pairs-{subject.title}-{number}"
            yield name, partial(_twice, bench, subject, name, seed)
    drawing = Subject("new-problem", world, "new-problem {} --seed 1")
    for number in range(wanted):
        name = f"pairs-{drawing.title}-{number}"
        yield name, partial(_four_problems, bench, drawing, name)


def _twice(bench: Bench, subject: Subject, name: str, seed: int) -> Trial:
    attempt = Attempt(bench, subject, name)
    done = attempt.goal.ending.code or 0
    later = random.Random(f"{seed} {name}").choice((0.0, 0.0, 0.2, 0.5)) * attempt.goal.ending.seconds
    endings = _together(attempt, (0.0, later), done)
    if done not in [ending.code for ending in endings]:
        attempt.found.append("neither did its work")
    attempt.found += differences(content(attempt.folder), attempt.goal.content)
    refused = [ending.errors for ending in endings if ending.code == REFUSED]
    outcome = f"one is refused: {refused[0]}" if refused else "both end, with the same bytes as one"
    return attempt.written_down(f"the second {later:.1f} s later", outcome)


def _four_problems(bench: Bench, subject: Subject, name: str) -> Trial:
    """Draw four problems at once, each of which needs a free name."""
    attempt = Attempt(bench, subject, name)
    scenes = {*attempt.folder.glob("problems/*.scene.json")}
    done = sum(ending.code == 0 for ending in _together(attempt, (0.0,) * 4, 0))
    made = len({*attempt.folder.glob("problems/*.scene.json")} - scenes)
    if made != done or not done:
        attempt.found.append(f"{done} say that they wrote a problem, {made} are there")
    return attempt.written_down("four at once", f"{made} problems of {done} commands")


def _together(attempt: Attempt, waits: tuple[float, ...], done: int) -> list[Ending]:
    """Start a command several times in one folder; say how they end, and find what is wrong with that."""
    running = []
    for number, wait in enumerate(waits):
        time.sleep(wait)
        running.append(attempt.start(f"scratch-{number}"))
    endings = [one.ending() for one in running]
    attempt.found += [complaint for ending in endings for complaint in ending.complaints((done, REFUSED))]
    for number, one in enumerate(running):
        attempt.found += left_by(one, attempt.place / f"scratch-{number}")
    return endings


LIMITS = {
    "memory": ("ulimit -v {}", (300_000, 500_000, 1_000_000, 2_000_000, 3_000_000)),
    "files": ("ulimit -n {}", (16, 32, 64)),
    "file size": ("ulimit -f {}", (1, 8, 256)),
    "processes": ("ulimit -p {}", (1, 4, 16)),
}  # what a shell is told before, and with what: KiB, files, blocks of 512 bytes, processes of the user
_CAPABILITIES = "+dac_override,+dac_read_search"  # to read and write as root does, and to run its Python
_ANOTHER_USER = (
    *("setpriv", "--reuid", "65534", "--clear-groups"),
    *("--inh-caps", _CAPABILITIES, "--ambient-caps", _CAPABILITIES),
)


def cannot_limit_processes() -> str:
    """Say why processes cannot be limited here, or nothing if they can."""
    is_root = os.geteuid() == 0  # who may have as many as there can be
    return "root can be another user only with setpriv" if is_root and not shutil.which("setpriv") else ""


def limits(bench: Bench, subject: Subject) -> Jobs:
    """Limit what memory, files and processes a command may have."""
    for what, (limit, sizes) in LIMITS.items():
        if what == "processes" and cannot_limit_processes():
            continue
        user = _ANOTHER_USER if what == "processes" and os.geteuid() == 0 else ()
        for size in sizes:
            name, told = f"limits-{subject.title}-{what.replace(' ', '-')}-{size}", limit.format(size)
            before = (*user, "sh", "-c", f'{told} && exec "$@"', "sh")
            yield name, partial(_limited, bench, subject, name, f"{what}: {told}", before)


def _limited(bench: Bench, subject: Subject, name: str, told: str, before: tuple[str, ...]) -> Trial:
    attempt = Attempt(bench, subject, name)
    ending, attempt.found = commands.run(subject.arguments(attempt.folder), attempt.scratch, before=before)
    attempt.found += ending.complaints((attempt.goal.ending.code or 0, REFUSED, 3)) + attempt.damage()
    if ending.code == attempt.goal.ending.code == 0:
        attempt.found += differences(content(attempt.folder), attempt.goal.content)
    outcome = SAME if ending.code == 0 else f"exit code {ending.code}: {ending.errors[-200:]}"
    attempt.let_end()
    return attempt.written_down(told, outcome)


CLOCKS = {
    "wall": "time.time jumps by up to a day, to and fro",
    "steady": "time.perf_counter and time.monotonic jump on by 3 s, five times",
}
HOOK = '''"""Makes clocks jump in each Python process that finds this file first."""

import os
import random
import time

_KIND = os.environ["NEUROSYM_FAULTS_CLOCK"]
_rng = random.Random(7)


def _wall(real):
    return lambda: real() + _rng.uniform(-86_400.0, 86_400.0)


def _steady(real):
    calls = jumps = 0

    def read():
        nonlocal calls, jumps
        calls += 1
        if calls % 20 == 0 and jumps < 5:
            jumps += 1
        return real() + 3.0 * jumps

    return read


if _KIND == "wall":
    time.time = _wall(time.time)
else:
    time.perf_counter, time.monotonic = _steady(time.perf_counter), _steady(time.monotonic)
'''


def clocks(bench: Bench, subject: Subject) -> Jobs:
    """Give a command clocks that jump, in a patched time source."""
    for kind, told in CLOCKS.items():
        name = f"clock-{subject.title}-{kind}"
        yield name, partial(_with_clock, bench, subject, name, kind, told)


def _with_clock(bench: Bench, subject: Subject, name: str, kind: str, told: str) -> Trial:
    attempt = Attempt(bench, subject, name)
    hook = attempt.place / "clock" / "sitecustomize.py"
    hook.parent.mkdir(parents=True, exist_ok=True)
    hook.write_text(HOOK)
    added = {"PYTHONPATH": f"{hook.parent}:{ROOT}", "NEUROSYM_FAULTS_CLOCK": kind}
    return attempt.written_down(told, attempt.let_end(environment=added))
