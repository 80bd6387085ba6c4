"""Where things lie in a checkout, and the options that the benchmarks' commands share."""

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import tyro
from tyro.conf import arg

ROOT = Path(__file__).parent.parent.parent
RESULTS = Path("docs/results")
CORES = os.cpu_count() or 1  # how many jobs run at once by default

Seeds = Annotated[int, arg(help="Seeds of everything.")]
Steps = Annotated[int, arg(help="Interactions of each exploration.")]
Scale = Annotated[float, arg(help="How much is measured, as a share of the full number.")]
Work = Annotated[Path, arg(help="Folder for what was learned and measured.")]
Results = Annotated[Path, arg(help="Folder for the tables.")]
Workers = Annotated[int, arg(help="Jobs at once.")]


def scaled(scale: float, number: int) -> int:
    """Return how many that is of a usual number, some at least."""
    return max(4, round(number * scale))


def check_positive(**values: int) -> None:
    """End with a sentence unless all options are at least 1."""
    for name, value in values.items():
        if value < 1:
            sys.exit(f"--{name} {value} must be at least 1.")


def begin(main: Callable[..., None]) -> None:
    """Read what was typed, and begin; each job computes in one thread, as there are several at once."""
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    tyro.cli(main)
