"""Commands whose clocks jump, in a patched time source."""

import time
from functools import partial

from tools.benchmarks.places import ROOT
from tools.faults.subjects import Bench, Subject
from tools.faults.trials import Jobs, Trial, trial_of

PART = "clock"
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
    """Give a command clocks that jump."""
    for kind, told in CLOCKS.items():
        name = f"{PART}-{subject.title}-{kind}"
        yield name, partial(_trial, bench, subject, name, kind, told)


def _trial(bench: Bench, subject: Subject, name: str, kind: str, told: str) -> Trial:
    bench.undisturbed(subject)  # in the same place, before
    begin, place = time.monotonic(), bench.place / "trial"
    folder = bench.fresh(subject, place / "domain")
    hook = place / "clock" / "sitecustomize.py"
    hook.parent.mkdir(parents=True, exist_ok=True)
    hook.write_text(HOOK)
    added = {"PYTHONPATH": f"{hook.parent}:{ROOT}", "NEUROSYM_FAULTS_CLOCK": kind}
    found = bench.finished(subject, folder, place / "scratch", environment=added)
    return trial_of(name, subject, told, "the same bytes" if not found else "a finding", found, begin)
