"""What is kept of trials, so that an interrupted campaign goes on where it was; and the table of all."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from tools.benchmarks.tables import document

TITLES = {
    "kills": "Killed at a drawn moment, and started again",
    "disk": "On a full disk, and again with room",
    "pairs": "The same command twice at once in one folder",
    "limits": "With low limits",
    "clock": "With clocks that jump",
}


class Trial(msgspec.Struct, frozen=True):
    """What came of one trial."""

    part: str  # one of `TITLES`
    name: str  # what it is called within the campaign
    subject: str  # the command
    world: str
    told: str  # how it was disturbed
    outcome: str  # how it ended, in a few words
    found: tuple[str, ...] = ()  # what is not as promised; nothing if all is well
    kills: int = 0  # how many kills it contains
    seconds: float = 0.0  # how long it took [s]


Jobs = Iterator[tuple[str, Callable[[], Trial]]]  # the names of trials, and what performs each


class Journal:
    """The trials that were made, in a file with a line for each."""

    def __init__(self, path: Path):
        self.path = path
        self.trials: dict[str, Trial] = {}
        for line in path.read_bytes().splitlines() if path.exists() else ():
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


def summarise(trials: Iterable[Trial], about: Mapping[str, Any]) -> dict[str, Any]:
    """Count trials and findings."""
    groups: dict[str, dict[str, list[Trial]]] = {part: {} for part in TITLES}
    for trial in trials:
        groups[trial.part].setdefault(f"{trial.subject} {trial.world}", []).append(trial)
    parts = {part: [_row(group) for group in found.values()] for part, found in groups.items() if found}
    return {**about, "parts": parts}


def _row(group: Sequence[Trial]) -> dict[str, Any]:
    kinds = Counter(trial.outcome.partition(":")[0] for trial in group)  # without what differs each time
    return {
        "command": group[0].subject,
        "world": group[0].world,
        "trials": len(group),
        "kills": sum(trial.kills for trial in group),
        "as_promised": sum(not trial.found for trial in group),
        "outcomes": dict(kinds.most_common()),
        "findings": [f"{trial.told}: {found}" for trial in group for found in trial.found],
        "seconds": round(sum(trial.seconds for trial in group), 1),
    }


def page(summary: Mapping[str, Any]) -> str:
    """Print a summary as Markdown."""
    parts = [
        "# A campaign of faults",
        f"`{summary['command']}`, seed {summary['seed']}, {summary['minutes']:.0f} minutes. "
        f"What is promised stands in [reliability.md](../reliability.md)."
        + "".join(f"\nLeft out: {reason}." for reason in summary["left_out"]),
    ]
    for part, rows in summary["parts"].items():
        what = "kills" if part == "kills" else "trials"
        columns = f"| command | world | {what} | as promised | how they ended |"
        lines = [f"## {TITLES[part]}", "", columns, "| --- | --- | --- | --- | --- |"]
        for row in rows:
            ended = "; ".join(f"{count} {kind}" for kind, count in row["outcomes"].items())
            kept = f"{row['as_promised']} of {row['trials']}"
            lines.append(f"| {row['command']} | {row['world']} | {row[what]} | {kept} | {ended} |")
        found = [f"- {row['command']}, {row['world']}: {text}" for row in rows for text in row["findings"]]
        parts += ["\n".join(lines), *filter(None, ["\n".join(" ".join(one.split()) for one in found)])]
    return document(*parts)
