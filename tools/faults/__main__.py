"""Make the campaign: `python -m tools.faults` (or `make faults`), into docs/results/faults.md and .json.

Finished trials are kept in a folder and not made again, so that the campaign can be interrupted.
"""

import os
import platform
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import tyro

from neurosym.commands.ending import raised_signals, say_interrupted
from neurosym.files import write_atomically
from neurosym.stages.console import progress_bar, say
from tools.benchmarks.jobs import as_text, pack, unpack
from tools.benchmarks.options import RESULTS
from tools.faults.journal import Jobs, Journal, page, summarise
from tools.faults.subjects import WORLDS, Bench, Subject, WorldName, subjects
from tools.faults.trials import cannot_limit_processes, cannot_mount, clocks, disks, kills, limits, pairs

TRIALS = "faults-trials.zip"  # the journal of the trials, with the results, so that another machine can go on
PARTS = ("clock", "pairs", "limits", "disk", "kills")
SLOW = ("run-tabletop",)  # killed last, since each takes the longest


def main(
    folder: Annotated[Path, tyro.conf.arg(help="Where trials take place and are kept.")] = Path("faults"),
    results: Annotated[Path, tyro.conf.arg(help="Folder for faults.json and faults.md.")] = RESULTS,
    kill: Annotated[int, tyro.conf.arg(help="Kills of each command in each world.")] = 50,
    kill_slow: Annotated[int, tyro.conf.arg(help="Kills of `run` on the tabletop.")] = 50,
    pair: Annotated[int, tyro.conf.arg(help="How often each command is run twice at once.")] = 3,
    seed: Annotated[int, tyro.conf.arg(help="What is drawn is drawn from it.")] = 0,
    worlds: Annotated[tuple[WorldName, ...], tyro.conf.arg(help="Worlds to try.")] = WORLDS,
    parts: Annotated[tuple[str, ...], tyro.conf.arg(help="Parts to try.")] = PARTS,
    commands: Annotated[tuple[str, ...], tyro.conf.arg(help="Commands to try; all if not given.")] = (),
) -> None:
    """Try what can go wrong around a command, and write a table of what came of it."""
    results.mkdir(parents=True, exist_ok=True)
    folder.mkdir(parents=True, exist_ok=True)
    unpack(results / TRIALS, folder)
    bench, journal = Bench(folder), Journal(folder / "trials.jsonl")
    reasons = {"full disks": cannot_mount(bench), "few processes": cannot_limit_processes()}
    left_out = [f"{what}: {reason}" for what, reason in reasons.items() if reason]
    for what in left_out:
        say(f"left out: {what}")
    every = [subject for world in worlds for subject in subjects(world)]
    for part, name, jobs, total in _plan(bench, journal, every, {False: kill, True: kill_slow}, pair, seed):
        asked = part in parts and (not commands or name.partition("-")[0] in (*commands, "all"))
        if asked and not (part == "disk" and reasons["full disks"]):
            _perform(f"{part} {name}", jobs, journal, total)
            _write(results, journal, seed, left_out)
    shutil.rmtree(folder / "trial", ignore_errors=True)
    pack(folder, results / TRIALS, "trials.jsonl")
    say(f"wrote {results / 'faults.json'} and {results / 'faults.md'}")


def _plan(
    bench: Bench, journal: Journal, every: list[Subject], kill: dict[bool, int], pair: int, seed: int
) -> Iterator[tuple[str, str, Jobs, int]]:
    """List all jobs by their part and command, with how many they are; kills of slow commands come last."""
    quick = [one for one in every if one.title not in SLOW]
    yield from (("clock", one.title, clocks(bench, one), 2) for one in quick)
    world = every[0].world
    yield "pairs", f"all-{world}", pairs(bench, world, wanted=pair, seed=seed), 5 * pair
    yield from (("limits", one.title, limits(bench, one), 14) for one in quick if one.world == "toy")
    yield "disk", "all", disks(bench), 33
    for one in sorted(every, key=lambda one: one.title in SLOW):
        wanted = kill[one.title in SLOW]
        yield "kills", one.title, kills(bench, one, journal, wanted=wanted, seed=seed), wanted


def _perform(title: str, jobs: Jobs, journal: Journal, total: int) -> None:
    """Make the trials that were not made, and write each down."""
    done = 0
    with progress_bar(title) as advance:
        for name, job in jobs:
            if name not in journal.trials:
                journal.add(job())
                for found in journal.trials[name].found:
                    say(f"{name}: {found}")
            done += max(1, journal.trials[name].kills)
            advance(min(done, total), total)


def _write(results: Path, journal: Journal, seed: int, left_out: list[str]) -> None:
    minutes = sum(trial.seconds for trial in journal.trials.values()) / 60
    about = {"cores": os.cpu_count(), "system": platform.system(), "python": platform.python_version()}
    told = {"command": "make faults", "seed": seed, "minutes": round(minutes, 1), "machine": about}
    summary = summarise(journal.trials.values(), {**told, "left_out": left_out})
    write_atomically(results / "faults.json", as_text(summary))
    write_atomically(results / "faults.md", page(summary))


if __name__ == "__main__":
    try:
        with raised_signals():
            tyro.cli(main)
    except KeyboardInterrupt as error:
        sys.exit(say_interrupted(error))
