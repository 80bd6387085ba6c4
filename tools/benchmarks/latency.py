"""How long commands take: `python -m tools.benchmarks.latency`.

The CPU of each command with all the processes it starts is measured, beside a bound that it cannot go below,
in the same run. Each works in a copy of its domain. It runs once before, so that Python has compiled what it
imports; the median of the runs after that counts. What must and shall be was set down where importing numpy
took 0.14 s, so what is measured is told as it would be there, too.
"""

import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.choices import DOMAINS
from neurosym.evaluation.summary import markdown_table
from neurosym.files import write_atomically
from neurosym.stages.console import say
from tools.benchmarks.jobs import as_text, machine
from tools.benchmarks.places import ROOT

RESULTS = Path("docs/results")
REFERENCE = 0.14
"""What importing numpy took where it was set down what commands must take [CPU s]."""
NUMPY = "numpy"
STARTED = {"python": "pass", NUMPY: "import numpy"}
"""Bounds that are a program of Python, by what the page calls them."""
COUNTED = {"planner": "", "simulation": "from neurosym.sim.tabletop import Tabletop as world"}
"""Bounds that are a part of the command: what the planners it starts take, or what its world does."""
_COUNT = """
import resource, sys, time
{world}
spent = 0.0
if "world" in globals():
    interact = world.interact
    def counted(*arguments, **options):
        global spent
        begin = time.process_time()
        try:
            return interact(*arguments, **options)
        finally:
            spent += time.process_time() - begin
    world.interact = counted
from neurosym.commands.cli import main
try:
    main()
except SystemExit:
    pass
children = resource.getrusage(resource.RUSAGE_CHILDREN)
print(spent + children.ru_utime + children.ru_stime)
"""
"""Does a command in this process, and prints last what the part of it took that is its bound [CPU s]."""


@dataclass(frozen=True, slots=True)
class Row:
    """A command that is measured.

    Attributes:
        command: What is typed after `neurosym`; shipped domains that it names are copied beforehand.
        bound: One of `STARTED` or `COUNTED`.
        must: The most that it may take [CPU s, where numpy takes `REFERENCE`]; None if nothing was set down.
        goal: What it should take [the same].
        before: What is typed beforehand, and not measured.
        once: Whether it is measured once, as the first of its kind: what it leaves makes the next one quick.
    """

    command: str
    bound: str
    must: float | None = None
    goal: float | None = None
    before: tuple[str, ...] = ()
    once: bool = False


SCENES = ROOT / "tools/benchmarks/scenes"
ROWS = (
    Row("--version", "python", 0.10, 0.05),
    Row("--help", "python", 0.20, 0.15),
    Row("plan tabletop task-01", "planner", 0.5, 0.3),
    Row("plan places row-4-12", "planner", 0.9, 0.6),
    Row("plan towers tower-6-05", "planner", 0.9, 0.6),
    Row("plan places anywhere-8-20", "planner", 3.5, 2.5),
    Row(
        "execute places anywhere-1-01 places/plans/anywhere-1-01.fast-downward.plan",
        "simulation",
        0.9,
        0.6,
        ("plan places anywhere-1-01",),
    ),
    Row("explain places", NUMPY, 0.5, 0.3),
    Row("check places", NUMPY, 0.35, 0.2),
    Row("plan tabletop far-80", "planner", 2.0, 1.0, (f"new-problem tabletop --scene {SCENES}/far-80.json",)),
    Row("report tabletop", NUMPY, 30.0, 15.0, ("report --help",), once=True),
    Row("demo", NUMPY, 40.0, 25.0, ("demo --help",), once=True),
    Row(
        "execute places four-anywhere places/plans/four-anywhere.fast-downward.plan",
        NUMPY,
        60.0,
        20.0,
        (f"new-problem places --scene {SCENES}/four-anywhere.json", "plan places four-anywhere"),
        once=True,
    ),
)
"""What is measured; a command more is a row more."""


def main(
    runs: Annotated[int, tyro.conf.arg(help="How often each command is measured.")] = 3,
    only: Annotated[
        str, tyro.conf.arg(help="Measure commands that hold this text only; writes nothing.")
    ] = "",
    results: Annotated[Path, tyro.conf.arg(help="Folder for the table.")] = RESULTS,
) -> None:
    """Measure commands beside their bounds, and write the page and the figures."""
    found = {}
    for row in ROWS:
        if only in row.command:
            found[row.command] = measured(row, runs)
            say(f"{row.command}: {found[row.command]}")
    if not only:
        figures = {name: {key: one[key] for key in ("cpu_s", "bound_cpu_s")} for name, one in found.items()}
        write_atomically(results / "latency.json", as_text(figures))
        write_atomically(results / "latency.md", page(found))
        say(f"wrote {results / 'latency.md'}")


def measured(row: Row, runs: int) -> dict[str, float]:
    """Measure a command, its bound, and importing numpy, by turns; the median of each [CPU s]."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name in {*DOMAINS} & {*row.command.split()}:
            shutil.copytree(
                ROOT / "domains" / name, folder / name, ignore=shutil.ignore_patterns("plans", "runs")
            )
        for words in (*row.before, *(() if row.once else (row.command,))):
            cpu_of(_neurosym(words), folder)
        cpu_of((sys.executable, "-c", STARTED[NUMPY]), folder)
        found: dict[str, list[float]] = {"cpu_s": [], "bound_cpu_s": [], NUMPY: []}
        for _ in range(1 if row.once else runs):
            found[NUMPY].append(cpu_of((sys.executable, "-c", STARTED[NUMPY]), folder))
            found["cpu_s"].append(cpu_of(_neurosym(row.command), folder))
            found["bound_cpu_s"].append(bound_of(row, folder))
    return {name: round(statistics.median(values), 3) for name, values in found.items()}


def bound_of(row: Row, folder: Path) -> float:
    """Measure what a command cannot go below [CPU s]."""
    if row.bound in STARTED:
        return cpu_of((sys.executable, "-c", STARTED[row.bound]), folder)
    code = _COUNT.format(world=COUNTED[row.bound])
    return float(_run((sys.executable, "-c", code, *row.command.split()), folder).split()[-1])


def cpu_of(command: Sequence[str], folder: Path) -> float:
    """Run a command, and return what it and all the processes it started took [CPU s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    _run(command, folder)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def _neurosym(words: str) -> tuple[str, ...]:
    return (sys.executable, "-m", "neurosym", *words.split())


def _run(command: Sequence[str], folder: Path) -> str:
    """Run a command as users do: Python keeps what it compiles, and nobody says how many threads run."""
    kept = {
        name: value
        for name, value in os.environ.items()
        if name != "PYTHONDONTWRITEBYTECODE" and not name.endswith("_NUM_THREADS")
    }
    kept |= {"PYTHONPATH": str(ROOT), "PYTHONPYCACHEPREFIX": str(folder / "compiled")}
    done = subprocess.run(command, cwd=folder, env=kept, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        raise RuntimeError(f"{' '.join(command[1:])} ended with {done.returncode}: {done.stderr[-500:]}")
    return done.stdout


def page(found: dict[str, dict[str, float]]) -> str:
    """Return the page."""
    rows = {row.command: row for row in ROWS}
    told = ", ".join(f"{name} {value}" for name, value in machine("numpy", "up-fast-downward").items())
    cells = [_cells(rows[command], one) for command, one in found.items()]
    columns = [
        "command",
        "CPU [s]",
        "bound",
        "CPU of that [s]",
        "numpy [s]",
        "as set down [s]",
        "must",
        "goal",
    ]
    return (
        "\n\n".join(
            [
                "# Latency, measured",
                "`python -m tools.benchmarks.latency` wrote this page and `latency.json`. "
                f"Machine: {told}. CPU seconds are those of a command with all the processes it starts. "
                "The bound was measured in the same run: starting Python, importing numpy, what the "
                "planners that the command starts take by themselves, or what its world simulates. "
                "Importing numpy was measured beside each command, too. It took "
                f"{REFERENCE} s where the last two columns were set down, so the column before them tells "
                "what the command would take there.",
                markdown_table(columns, cells),
            ]
        )
        + "\n"
    )


def _cells(row: Row, one: dict[str, float]) -> list[str]:
    there = REFERENCE * one["cpu_s"] / one[NUMPY]
    limits: list[Any] = ["-" if limit is None else f"{limit:g}" for limit in (row.must, row.goal)]
    figures = (
        f"{one['cpu_s']:.2f}",
        row.bound,
        f"{one['bound_cpu_s']:.2f}",
        f"{one[NUMPY]:.2f}",
        f"{there:.2f}",
    )
    return [f"`neurosym {row.command}`", *figures, *limits]


if __name__ == "__main__":
    tyro.cli(main)
