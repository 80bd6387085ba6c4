"""The same command twice at once in one folder: one is refused in a sentence, or both end as if in turn."""

import random
import time
from functools import partial
from pathlib import Path

from tools.faults.commands import Ending, Running, content, differences, left_by, start
from tools.faults.subjects import Bench, Subject, WorldName, subjects
from tools.faults.trials import Jobs, Trial, trial_of

PART = "pairs"
_REFUSED = 2


def pairs(bench: Bench, world: WorldName, *, wanted: int, seed: int) -> Jobs:
    """Run commands twice at once."""
    for subject in subjects(world):
        for number in range(wanted):
            name = f"{PART}-{subject.title}-{number}"
            yield name, partial(_trial, bench, subject, name, seed)
    for number in range(wanted):
        name = f"{PART}-new-problem-{world}-{number}"
        yield name, partial(_four_problems, bench, world, name)


def _trial(bench: Bench, subject: Subject, name: str, seed: int) -> Trial:
    goal, begin = bench.undisturbed(subject), time.monotonic()
    later = random.Random(f"{seed} {name}").choice((0.0, 0.0, 0.2, 0.5)) * goal.ending.seconds
    place = bench.place / "trial"
    folder = bench.fresh(subject, place / "domain")
    running = []
    for number, wait in enumerate((0.0, later)):
        time.sleep(wait)
        running.append(start(subject.arguments(folder), place / f"scratch-{number}"))
    done = goal.ending.code or 0
    endings, found = _ended(running, place, done)
    if done not in [ending.code for ending in endings]:
        found.append("neither did its work")
    found += differences(content(folder), goal.content)
    return trial_of(name, subject, f"the second {later:.1f} s later", _outcome(endings), found, begin)


def _ended(running: list[Running], place: Path, done: int) -> tuple[list[Ending], list[str]]:
    """Wait for commands; say how they ended, and what is wrong with that or was left."""
    endings = [one.ending() for one in running]
    found = [complaint for ending in endings for complaint in ending.complaints((done, _REFUSED))]
    for number, one in enumerate(running):
        found += left_by(one, place / f"scratch-{number}")
    return endings, found


def _outcome(endings: list[Ending]) -> str:
    refused = [ending.errors for ending in endings if ending.code == _REFUSED]
    return f"one is refused: {refused[0]}" if refused else "both end, with the same bytes as one"


def _four_problems(bench: Bench, world: WorldName, name: str) -> Trial:
    """Draw four problems at once, each of which needs a free name."""
    subject = Subject("new-problem", world, lambda folder: ("new-problem", str(folder), "--seed", "1"))
    begin, place = time.monotonic(), bench.place / "trial"
    folder = bench.fresh(subject, place / "domain")
    before = content(folder)
    running = [start(subject.arguments(folder), place / f"scratch-{number}") for number in range(4)]
    endings, found = _ended(running, place, 0)
    made = {path.name for path in (folder / "problems").glob("*.scene.json")} - {
        path.rpartition("/")[2] for path in before
    }
    done = sum(ending.code == 0 for ending in endings)
    if len(made) != done or not done:
        found.append(f"{done} say that they wrote a problem, {len(made)} are there")
    outcome = f"{len(made)} problems of {done} commands"
    return trial_of(name, subject, "four at once", outcome, found, begin)
