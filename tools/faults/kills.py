"""Commands are killed at a drawn moment by a drawn signal, and started again, until they end."""

import random
import signal
import time
from functools import partial
from pathlib import Path

from tools.faults.commands import SIGNALS, content, left_by, start
from tools.faults.subjects import Bench, Subject
from tools.faults.trials import Jobs, Journal, Trial, trial_of

PART = "kills"
_TRIES = 5  # to hit a command before it ends


def kills(bench: Bench, subject: Subject, journal: Journal, *, wanted: int, seed: int) -> Jobs:
    """Kill a command until that was done often enough."""
    done = number = 0
    while done < wanted and number < 2 * wanted:
        name = f"{PART}-{subject.title}-{number:03d}"
        most = min(subject.chain, wanted - done)
        yield name, partial(_trial, bench, subject, name, most, seed)
        done += journal.trials[name].kills
        number += 1


def _trial(bench: Bench, subject: Subject, name: str, most: int, seed: int) -> Trial:
    """Kill a command once or several times in a folder, let it end, and look at what it has made."""
    goal, rng, begin = bench.undisturbed(subject), random.Random(f"{seed} {name}"), time.monotonic()
    place = bench.place / "trial"
    told: list[str] = []
    found: list[str] = []
    for _ in range(_TRIES):
        folder = bench.fresh(subject, place / "domain")
        before = content(folder) if folder.exists() else {}
        for _ in range(most):
            at, number = rng.uniform(0.0, goal.ending.seconds), rng.choice(SIGNALS)
            kill = _kill(subject, folder, place / "scratch", at, number, before)
            if kill is None:
                break
            told.append(f"{number.name} at {at:.2f} s")
            found += [f"after {told[-1]}: {complaint}" for complaint in kill]
        if told:
            break
    found += bench.finished(subject, folder, place / "scratch")
    outcome = "the same bytes" if not found else "a finding"
    return trial_of(name, subject, ", ".join(told), outcome, found, begin, kills=len(told))


def _kill(
    subject: Subject, folder: Path, scratch: Path, at: float, number: signal.Signals, before: dict[str, str]
) -> list[str] | None:
    """Start a command and kill it; say what is wrong then, or nothing at all if it had ended before."""
    running = start(subject.arguments(folder), scratch)
    if running.ends_within(at - (time.monotonic() - running.begin)):
        running.ending()
        left_by(running, scratch)
        return None
    running.process.send_signal(number)
    ending = running.ending()
    ended = (0, 3)  # if the signal came after the work
    found = [] if ending.is_before_ours else ending.complaints((-number, 128 + number, *ended))
    found += left_by(running, scratch)
    now = content(folder) if folder.exists() else {}
    found += [f"damaged: {name}" for name, digest in now.items() if digest == "damaged"]
    found += [f"lost: {name}" for name in before if name not in now]
    if number != signal.SIGKILL:  # what that leaves, the next call clears away
        found += [f"half a file left: {name}" for name in now if Path(name).name.startswith(".")]
    return found
