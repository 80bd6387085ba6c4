"""How long commands take: `python -m tools.benchmarks.latency`.

The CPU of each command with all the processes it starts is measured, beside a bound that it cannot go below,
in the same run. Each works in a copy of its domain. It runs once before, so that Python has compiled what it
imports; the median of the runs after that counts. What must and shall be was set down where importing numpy
took 0.14 s, so what is measured is told as it would be there, too.
"""

import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, NamedTuple

import tyro

from neurosym.choices import DOMAINS
from neurosym.files import write_atomically
from neurosym.stages.console import say
from tools.benchmarks.jobs import as_text, children_cpu, machine
from tools.benchmarks.options import RESULTS, ROOT, Results
from tools.benchmarks.tables import document, listed, number, table

REFERENCE = 0.14  # what importing numpy took where it was set down what commands must take [CPU s]
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


class Row(NamedTuple):
    """A command that is measured."""

    command: str  # what is typed after `neurosym`; shipped domains that it names are copied beforehand
    bound: str  # one of `STARTED` or `COUNTED`
    must: float | None = None  # the most that it may take [CPU s, where numpy takes `REFERENCE`], if set down
    goal: float | None = None  # what it should take [the same]
    before: tuple[str, ...] = ()  # what is typed beforehand, and not measured
    once: bool = False  # measured once, as the first of its kind: what it leaves makes the next one quick


SCENES = ROOT / "tools/benchmarks/scenes"
_ONE, _FOUR = (
    f"{name} places/plans/{name}.fast-downward.{kind}"
    for name, kind in (("anywhere-1-01", "plan"), ("four-anywhere", "steps"))
)
_DRAWN = f"new-problem places --scene {SCENES}/four-anywhere.json"
ROWS = (
    Row("--version", "python", 0.10, 0.05),
    Row("--help", "python", 0.20, 0.15),
    Row("plan tabletop task-01", "planner", 0.5, 0.3),
    Row("plan places row-4-12", "planner", 0.9, 0.6),
    Row("plan towers tower-6-05", "planner", 0.9, 0.6),
    Row("plan places anywhere-8-20", "planner", 3.5, 2.5),
    Row(f"execute places {_ONE}", "simulation", 0.9, 0.6, ("plan places anywhere-1-01",)),
    Row("explain places", NUMPY, 0.5, 0.3),
    Row("check places", NUMPY, 0.35, 0.2),
    Row("plan tabletop far-80", "planner", 2.0, 1.0, (f"new-problem tabletop --scene {SCENES}/far-80.json",)),
    Row("report tabletop", NUMPY, 30.0, 15.0, ("report --help",), once=True),
    Row("demo", NUMPY, 40.0, 25.0, ("demo --help",), once=True),
    Row(f"execute places {_FOUR}", NUMPY, 60.0, 20.0, (_DRAWN, "plan places four-anywhere"), once=True),
)  # what is measured; a command more is a row more


def main(
    runs: Annotated[int, tyro.conf.arg(help="How often each command is measured.")] = 3,
    only: Annotated[str, tyro.conf.arg(help="Only commands that hold this text; writes nothing.")] = "",
    results: Results = RESULTS,
) -> None:
    """Measure commands beside their bounds, and write the page and the figures."""
    found = {}
    for row in (row for row in ROWS if only in row.command):
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
            left_out = shutil.ignore_patterns("plans", "runs")
            shutil.copytree(ROOT / "domains" / name, folder / name, ignore=left_out)
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
    before = children_cpu()
    _run(command, folder)
    return children_cpu() - before


def _neurosym(words: str) -> tuple[str, ...]:
    return (sys.executable, "-m", "neurosym", *words.split())


def _run(command: Sequence[str], folder: Path) -> str:
    """Run a command as users do: Python keeps what it compiles, and nobody says how many threads run."""
    left_out = ("PYTHONDONTWRITEBYTECODE", *(name for name in os.environ if name.endswith("_NUM_THREADS")))
    kept = {name: value for name, value in os.environ.items() if name not in left_out}
    kept |= {"PYTHONPATH": str(ROOT), "PYTHONPYCACHEPREFIX": str(folder / "compiled")}
    done = subprocess.run(command, cwd=folder, env=kept, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        raise RuntimeError(f"{' '.join(command[1:])} ended with {done.returncode}: {done.stderr[-500:]}")
    return done.stdout


def page(found: dict[str, dict[str, float]]) -> str:
    """Return the page."""
    rows = {row.command: row for row in ROWS}
    columns = "command | CPU [s] | bound | CPU of that [s] | numpy [s] | as set down [s] | must | goal"
    return document(
        "# Latency, measured",
        "`python -m tools.benchmarks.latency` wrote this page and `latency.json`. "
        f"Machine: {listed(machine('numpy', 'up-fast-downward'))}. CPU seconds are those of a command with "
        "all the processes it starts. The bound was measured in the same run: starting Python, importing "
        "numpy, what the planners that the command starts take by themselves, or what its world simulates. "
        "Importing numpy was measured beside each command, too. It took "
        f"{REFERENCE} s where the last two columns were set down, so the column before them tells "
        "what the command would take there.",
        table(columns, [_cells(rows[command], one) for command, one in found.items()]),
    )


def _cells(row: Row, one: dict[str, float]) -> list[str]:
    there = REFERENCE * one["cpu_s"] / one[NUMPY]
    spent = [number(value) for value in (one["cpu_s"], one["bound_cpu_s"], one[NUMPY], there)]
    limits = ["-" if limit is None else f"{limit:g}" for limit in (row.must, row.goal)]
    return [f"`neurosym {row.command}`", spent[0], row.bound, *spent[1:], *limits]


if __name__ == "__main__":
    tyro.cli(main)
