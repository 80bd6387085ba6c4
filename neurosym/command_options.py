"""Options that several commands of the command line share."""

import os
from pathlib import Path
from typing import Annotated

from tyro.conf import Positional, arg

Folder = Annotated[Positional[Path], arg(metavar="DIR", help="The domain folder.")]
DataPath = Annotated[
    Positional[Path],
    arg(metavar="DATA", help="A data set: an .npz file, or a folder that holds interactions.npz."),
]
ProblemName = Annotated[
    Positional[str],
    arg(metavar="PROBLEM", help="A problem in DIR/problems: its name or its file."),
]
Seed = Annotated[int, arg(help="Where all random draws start: same seed, same bytes.")]
Workers = Annotated[int, arg(help="Processes that simulate; their number does not change the result.")]
Strategy = Annotated[str, arg(help="How actions are chosen: curiosity, random or active.")]
RegimeName = Annotated[
    str, arg(help="Network and training: default, quick (a first look), paper (as printed).")
]

NO_RESULT = 3
"""Exit code when the work was done and the answer is no: no plan, or the goal was not reached."""
CPUS = os.cpu_count() or 1
