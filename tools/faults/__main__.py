"""Make the campaign: `python -m tools.faults` (or `make faults`), into docs/results/faults.md and .json.

Finished trials are kept in a folder and not made again, so that the campaign can be interrupted.
"""

import json
import os
import platform
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.commands.ending import raised_signals, say_interrupted
from neurosym.files import write_atomically
from neurosym.stages.console import progress_bar, say
from tools.benchmarks.jobs import pack, unpack
from tools.faults.journal import Jobs, Journal, page, summarise
from tools.faults.subjects import WORLDS, Bench, WorldName, subjects
from tools.faults.trials import cannot_limit_processes, cannot_mount, clocks, disks, kills, limits, pairs

RESULTS = Path("docs/results")
TRIALS = "faults-trials.zip"
"""The journal of the trials, with the results, so that another machine can go on."""
PARTS = ("clock", "pairs", "limits", "disk", "kills")
SLOW = ("run-tabletop",)
"""Killed last, since each takes the longest."""


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
    left_out = _left_out(bench)
    for what in left_out:
        say(f"left out: {what}")
    for title, jobs, total in _plan(bench, journal, worlds, kill, kill_slow, pair, seed):
        part, _, subject = title.partition(" ")
        if part in parts and (not commands or subject.partition("-")[0] in (*commands, "all")):
            if part == "disk" and cannot_mount(bench):
                continue
            _perform(title, jobs, journal, total)
            _write(results, journal, seed, left_out)
    shutil.rmtree(folder / "trial", ignore_errors=True)
    pack(folder, results / TRIALS, "trials.jsonl")
    say(f"wrote {results / 'faults.json'} and {results / 'faults.md'}")


def _left_out(bench: Bench) -> list[str]:
    reasons = {"full disks": cannot_mount(bench), "few processes": cannot_limit_processes()}
    return [f"{what}: {reason}" for what, reason in reasons.items() if reason]


def _plan(
    bench: Bench,
    journal: Journal,
    worlds: tuple[WorldName, ...],
    kill: int,
    kill_slow: int,
    pair: int,
    seed: int,
) -> Iterator[tuple[str, Jobs, int]]:
    """List all jobs by a title of their part and command, with how many they are."""
    every = [subject for world in worlds for subject in subjects(world)]
    quick, slow = ([one for one in every if (one.title in SLOW) == is_slow] for is_slow in (False, True))
    yield from ((f"clock {one.title}", clocks(bench, one), 2) for one in quick)
    for world in worlds[:1]:
        yield f"pairs all-{world}", pairs(bench, world, wanted=pair, seed=seed), 5 * pair
    yield from ((f"limits {one.title}", limits(bench, one), 14) for one in quick if one.world == "toy")
    yield "disk all", disks(bench), 33
    for one in (*quick, *slow):
        wanted = kill_slow if one in slow else kill
        yield f"kills {one.title}", kills(bench, one, journal, wanted=wanted, seed=seed), wanted


def _perform(title: str, jobs: Jobs, journal: Journal, total: int) -> None:
    """Make the trials that were not made, and write each down."""
    done = 0
    with progress_bar(title) as advance:
        for name, job in jobs:
            if name not in journal.trials:
                trial = job()
                journal.add(trial)
                for found in trial.found:
                    say(f"{name}: {found}")
            done += max(1, journal.trials[name].kills)
            advance(min(done, total), total)


def _write(results: Path, journal: Journal, seed: int, left_out: list[str]) -> None:
    minutes = sum(trial.seconds for trial in journal.trials.values()) / 60
    about: dict[str, Any] = {
        "command": "make faults",
        "seed": seed,
        "minutes": round(minutes, 1),
        "machine": {
            "cores": os.cpu_count(),
            "system": platform.system(),
            "python": platform.python_version(),
        },
        "left_out": left_out,
    }
    summary = summarise(journal.trials.values(), about)
    write_atomically(results / "faults.json", json.dumps(summary, indent=1) + "\n")
    write_atomically(results / "faults.md", page(summary))


if __name__ == "__main__":
    try:
        with raised_signals():
            tyro.cli(main)
    except KeyboardInterrupt as error:
        sys.exit(say_interrupted(error))
