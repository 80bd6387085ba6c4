"""What is kept of a trial: a line of JSON, so that a campaign that was interrupted goes on where it was."""

import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import msgspec

from tools.faults.subjects import Subject


class Trial(msgspec.Struct, frozen=True):
    """What came of one trial.

    Attributes:
        part: kills, disk, pairs, limits or clock.
        name: What it is called within the campaign.
        subject: The command.
        world: Its world.
        told: How it was disturbed.
        outcome: How it ended, in a few words.
        found: What is not as promised; nothing if all is well.
        kills: How many kills it contains.
        seconds: How long it took [s].
    """

    part: str
    name: str
    subject: str
    world: str
    told: str
    outcome: str
    found: tuple[str, ...] = ()
    kills: int = 0
    seconds: float = 0.0


def trial_of(
    name: str,
    subject: Subject,
    told: str,
    outcome: str,
    found: Sequence[str],
    begin: float,
    *,
    kills: int = 0,
) -> Trial:
    """Write down what came of a trial that began at a time of the steady clock [s]."""
    part, seconds = name.partition("-")[0], round(time.monotonic() - begin, 1)
    return Trial(part, name, subject.name, subject.world, told, outcome, tuple(found), kills, seconds)


Job = tuple[str, Callable[[], Trial]]
"""The name of a trial, and what performs it."""
Jobs = Iterator[Job]


class Journal:
    """The trials that were made, in a file with a line for each.

    Args:
        path: The file.
    """

    def __init__(self, path: Path):
        self.path = path
        lines = path.read_bytes().splitlines() if path.exists() else []
        self.trials: dict[str, Trial] = {}
        for line in lines:
            try:
                trial = msgspec.json.decode(line, type=Trial)
            except msgspec.DecodeError:  # the last one, if a kill came while it was written
                continue
            self.trials[trial.name] = trial

    def add(self, trial: Trial) -> None:
        """Write down a trial."""
        self.trials[trial.name] = trial
        with self.path.open("ab") as file:
            file.write(msgspec.json.encode(trial) + b"\n")
