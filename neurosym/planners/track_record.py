"""What each planner solved of shipped problems, by encoding: measured, and kept in the package.

`make evaluate-planners` writes `track_record.json` from the same run as `docs/results/planners.md`. Each
planner was given whole problems as they are printed.
"""

from functools import cache
from pathlib import Path

import msgspec

from neurosym.pddl.encoding_names import FORMER
from neurosym.reading import read_json

FILE = Path(__file__).with_suffix(".json")


class TrackRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What planners solved.

    Attributes:
        problems: Names of the problems of the shipped domain `tabletop`.
        time_limit: How long a planner had for each [s].
        solved: How many of them each planner solved, by its name and by encoding.
    """

    problems: tuple[str, ...]
    time_limit: float
    solved: dict[str, dict[str, int]]

    def of(self, planner: str) -> str:
        """Say what a planner solved in each encoding, in short; nothing if it was not measured."""
        given = len(self.problems)
        return ", ".join(f"{name} {count}/{given}" for name, count in self.solved.get(planner, {}).items())


@cache
def track_record() -> TrackRecord:
    """Read what planners solved, in the encodings that there are: earlier versions measured others, too."""
    read = read_json(FILE, TrackRecord)
    solved = {
        planner: {encoding: count for encoding, count in counts.items() if encoding not in FORMER}
        for planner, counts in read.solved.items()
    }
    return msgspec.structs.replace(read, solved=solved)
