"""Each stage is performed on a disk that is full, or nearly so, and again when there is room."""

import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path

from neurosym.stages.layout import MANIFEST
from tools.faults.commands import content, run, stages_done
from tools.faults.subjects import Bench, Subject, stages
from tools.faults.trials import Jobs, Trial, trial_of

PART = "disk"
SIZE = "64m"
SHARES = (0.0, 0.3, 0.7)
"""How much of what a stage writes there is room for."""
_REFUSED = 2
_FILLER = "filler"


def cannot_mount(bench: Bench) -> str:
    """Say why there can be no small disk here, or nothing if there can."""
    try:
        with _small_disk(bench.place / "trial"):
            return ""
    except (OSError, subprocess.CalledProcessError):
        return "a small disk is a mounted tmpfs, which takes root"


def disks(bench: Bench) -> Jobs:
    """Fill the disk at each stage."""
    for subject in stages("toy"):
        for share in SHARES:
            for scratch_too in (False, True) if subject.name in ("plan", "compare") else (False,):
                name = f"{PART}-{subject.title}-{share:.0%}{'-scratch' if scratch_too else ''}"
                yield name, partial(_trial, bench, subject, share, scratch_too, name)


@contextmanager
def _small_disk(place: Path) -> Iterator[Path]:
    place.mkdir(parents=True, exist_ok=True)
    command = ("mount", "-t", "tmpfs", "-o", f"size={SIZE}", "tmpfs", str(place))
    subprocess.run(command, check=True, capture_output=True)
    try:
        yield place
    finally:
        subprocess.run(("umount", "--lazy", str(place)), check=True)


def _fill(disk: Path, room: int) -> None:
    """Fill a disk but for so many bytes."""
    with suppress(OSError), (disk / _FILLER).open("wb", buffering=0) as filler:
        while True:
            filler.write(bytes(4096))
    with (disk / _FILLER).open("r+b") as filler:
        filler.truncate(max(0, filler.seek(0, 2) - room))


def _trial(bench: Bench, subject: Subject, share: float, scratch_too: bool, name: str) -> Trial:
    goal, begin = bench.undisturbed(subject), time.monotonic()
    found: list[str] = []
    with _small_disk(bench.place / "trial") as disk:  # as when undisturbed: some write where
        folder = bench.fresh(subject, disk / "domain")
        scratch = (disk if scratch_too else bench.place) / "scratch"
        scratch.mkdir(parents=True, exist_ok=True)
        before, stages_before = content(folder), stages_done(folder)
        _fill(disk, round(share * goal.written))
        ending, left = run(subject.arguments(folder), scratch, logs=bench.place)
        found += left
        if ending.code != goal.ending.code:
            found += ending.complaints((_REFUSED,))
            now = content(folder)
            if stages_before.items() <= stages_done(folder).items():  # those that were done stay, as promised
                before.pop(MANIFEST, None)
            found += [f"lost or changed: {name}" for name in before if now.get(name) != before[name]]
            found += [f"half a file left: {name}" for name in now if Path(name).name.startswith(".")]
        outcome = "refused" if ending.code == _REFUSED else f"exit code {ending.code}"
        (disk / _FILLER).unlink()
        found += bench.finished(subject, folder, scratch, logs=bench.place)
    told = f"room for {share:.0%} of what it writes" + ", temporary files on the same disk" * scratch_too
    outcome += ", then the same bytes" if not found else ", a finding"
    return trial_of(name, subject, told, outcome, found, begin)
