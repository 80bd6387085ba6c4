"""Options that the benchmarks' commands share."""

import os
from pathlib import Path
from typing import Annotated

from tyro.conf import arg

Seeds = Annotated[int, arg(help="Seeds of everything.")]
Steps = Annotated[int, arg(help="Interactions of each exploration.")]
Work = Annotated[Path, arg(help="Folder for what was measured.")]
Results = Annotated[Path, arg(help="Folder for the tables.")]
Workers = Annotated[int, arg(help="Jobs at once.")]
OnlyReport = Annotated[bool, arg(help="Write the tables from what is there.")]
Output = Annotated[Path | None, arg(help="Write the JSON here instead of printing it.")]

CORES = os.cpu_count() or 1
"""How many jobs run at once by default."""
