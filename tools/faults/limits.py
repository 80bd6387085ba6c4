"""Commands that may have little memory, few files, small files or few processes."""

import os
import shutil
import time
from functools import partial
from pathlib import Path

from tools.faults.commands import content, differences, run
from tools.faults.subjects import Bench, Subject
from tools.faults.trials import Jobs, Trial, trial_of

PART = "limits"
LIMITS = {
    "memory": ("ulimit -v {}", (300_000, 500_000, 1_000_000, 2_000_000, 3_000_000)),
    "files": ("ulimit -n {}", (16, 32, 64)),
    "file size": ("ulimit -f {}", (1, 8, 256)),
    "processes": ("ulimit -p {}", (1, 4, 16)),
}
"""What a shell is told before, and with what: KiB, files, blocks of 512 bytes, processes of the user."""
_REFUSALS = (2, 3)
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
    """Limit what a command may have."""
    for what, (limit, sizes) in LIMITS.items():
        if what == "processes" and cannot_limit_processes():
            continue
        for size in sizes:
            name, told = f"{PART}-{subject.title}-{what.replace(' ', '-')}-{size}", limit.format(size)
            yield name, partial(_trial, bench, subject, name, f"{what}: {told}", told, what == "processes")


def _trial(bench: Bench, subject: Subject, name: str, told: str, limit: str, needs_user: bool) -> Trial:
    goal, begin, place = bench.undisturbed(subject), time.monotonic(), bench.place / "trial"
    folder = bench.fresh(subject, place / "domain")
    before = content(folder) if folder.exists() else {}
    before_it = ("sh", "-c", f'{limit} && exec "$@"', "sh")
    if needs_user and os.geteuid() == 0:
        before_it = (*_ANOTHER_USER, *before_it)
    ending, found = run(subject.arguments(folder), place / "scratch", before=before_it)
    found += ending.complaints((goal.ending.code or 0, *_REFUSALS))
    now = content(folder) if folder.exists() else {}
    found += [f"lost: {name}" for name in before if name not in now]
    found += [f"half a file left: {name}" for name in now if Path(name).name.startswith(".")]
    if ending.code == goal.ending.code and ending.code == 0:
        found += differences(now, goal.content)
    outcome = "the same bytes" if ending.code == 0 else f"exit code {ending.code}: {ending.errors[-200:]}"
    found += bench.finished(subject, folder, place / "scratch")
    return trial_of(name, subject, told, outcome, found, begin)
