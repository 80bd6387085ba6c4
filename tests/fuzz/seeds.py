"""The domain folder that cases begin with: learned once, on a toy world with relations, by every command."""

import subprocess
import sys
from pathlib import Path

LEARN = (
    "run {0} --world toy-relations --steps 1024 --seed 3 --strategy random --regime quick --workers 1 "
    "--rehearsals 40 --problems 2 --places 512 --relations 1024"
)
MORE = (
    "plan {0} task-01 --planner bfs",
    "new-problem {0} --name far --seed 3 --goal item-01=0.98,0.29",
    "new-problem {0} --name long --seed 5 --objects 3 --actions 4",
    "plan {0} long",
    "compare {0} --tasks 2 --workers 1 --planners counting fast-downward",
    "evaluate {0} --workers 1",
    "practise {0} --interactions 60 --workers 1",
)
"""What is added to a learned folder, so that every format that is read has a seed."""
RELATED = (
    "new-problem {0} --name tower --task tower --objects 4 --seed 3",
    "plan {0} tower",
    "execute {0} tower {0}/plans/tower.fast-downward.plan",
)
"""What is added to one that learned relations."""


def build(folder: Path) -> None:
    """Learn the domain folder, unless it is there."""
    if not folder.is_dir():
        unfinished = folder.with_name(f"{folder.name}-unfinished")
        _perform(LEARN, unfinished)
        complete(unfinished)
        for line in RELATED:
            _perform(line, unfinished)
        unfinished.rename(folder)


def complete(folder: Path) -> None:
    """Add to a learned folder what other commands write."""
    for line in MORE:
        _perform(line, folder)


def _perform(line: str, folder: Path) -> None:
    arguments = [part.format(folder) for part in line.split()]
    subprocess.run(
        [sys.executable, "-m", "neurosym", *arguments],
        check=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
