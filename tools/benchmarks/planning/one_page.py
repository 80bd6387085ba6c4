"""How long the page is, and what Fast Downward makes of it: `python -m tools.benchmarks.planning.one_page`.

Measures the printed files of the shipped domains as anybody would: their size, the first plan by LAMA in CPU
seconds of the whole call, and what the cheapest plan costs. Writes `one_page` into
docs/results/planners.json, beside what was measured with the files that one page replaced.
"""

import json
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.choices import DOMAINS
from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.stages.console import say
from neurosym.tasks.task import understand
from tools.benchmarks.jobs import Job, as_text, load_jobs, perform
from tools.benchmarks.places import ROOT

FIRST, OPTIMAL = "first", "optimal"
SEARCHES = {FIRST: ("--alias", "lama-first"), OPTIMAL: ("--search", "astar(lmcut())")}
RUNS = 3
"""How often the first plan is looked for."""
LIMITS = ("--overall-time-limit", "60s", "--overall-memory-limit", "2G")
RELATIONS, CELLS, PLACES = "relations", "cells", "places"
_COST = re.compile(r"Plan cost: (\d+)")
Figures = dict[str, Any]


def main(
    work: Annotated[Path, tyro.conf.arg(help="Folder for finished calls.")] = Path("build/one-page"),
    results: Annotated[Path, tyro.conf.arg(help="Folder for the figures.")] = Path("docs/results"),
) -> None:
    """Measure the printed files, and keep what else the file of results holds."""
    work.mkdir(parents=True, exist_ok=True)
    perform(work, jobs(), 1, lambda: None, label="planning")
    path = results / "planners.json"
    kept = json.loads(path.read_text())
    before = kept.get("one_page", {}).get("before", {})
    found = figures(load_jobs(work))
    costs = found.pop("optimal")
    dearer = {
        name: [before["optimal"][name], cost]
        for name, cost in costs.items()
        if _is_dearer(name, cost, before)
    }
    kept["one_page"] = found | {"optimal": costs, "dearer_than_before": dearer, "before": before}
    write_atomically(path, as_text(kept))
    say(json.dumps({name: value for name, value in found.items() if name != "optimal"}, indent=1))
    say(f"{len(costs)} cheapest plans, {len(dearer)} dearer than before; wrote {path}")


def _is_dearer(name: str, cost: int | str, before: Mapping[str, Any]) -> bool:
    was = before.get("optimal", {}).get(name)
    return isinstance(was, int) and isinstance(cost, int) and cost > was


def jobs() -> dict[str, Job]:
    """List the calls: first plans several times, cheapest ones once."""
    found: dict[str, Job] = {}
    for name, _, problem in shipped():
        for run in range(RUNS):
            found[f"{FIRST}.{name}.{run}"] = partial(called, problem, FIRST)
        found[f"{OPTIMAL}.{name}"] = partial(called, problem, OPTIMAL)
    return found


def shipped() -> list[tuple[str, tuple[str, int], Path]]:
    """List the shipped problems: name, what they are about with how many objects, and the printed file."""
    found = []
    for domain in DOMAINS:
        folder = ROOT / "domains" / domain
        grounding = Grounding.load(folder / "grounding.json")
        for scene in sorted((folder / "problems").glob("*.scene.json")):
            task = understand(Problem.load(scene), grounding)
            kind = RELATIONS if task.relates else CELLS if task.led else PLACES
            name = scene.name.removesuffix(".scene.json")
            found.append((f"{domain}.{name}", (kind, len(task.names)), scene.with_name(f"{name}.pddl")))
    return found


def called(problem: Path, search: str) -> Figures:
    """Call Fast Downward in a folder of its own, and return how that went.

    Args:
        problem: The problem; the domain lies above it.
        search: One of `SEARCHES`.
    """
    spec = find_spec("up_fast_downward")
    assert spec is not None, "`pip install up-fast-downward` brings it"
    assert spec.origin is not None
    driver, files = (
        Path(spec.origin).parent / "downward" / "fast-downward.py",
        (problem.parent.parent / "domain.pddl", problem),
    )
    asked = (*SEARCHES[FIRST], *files) if search == FIRST else (*files, *SEARCHES[search])
    alone = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    with tempfile.TemporaryDirectory() as place:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [sys.executable, str(driver), *LIMITS, *map(str, asked)]
        done = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False, env=alone)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cost = _COST.search(done.stdout)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"code": done.returncode, "cpu": round(cpu, 3), "cost": int(cost[1]) if cost else None}


def figures(records: Mapping[str, Figures]) -> Figures:
    """Sum up: of the longest domain and the longest problems, and of medians the worst domain's.

    Args:
        records: What the calls came to, by name.
    """
    pages = [(ROOT / "domains" / domain / "domain.pddl").read_text() for domain in DOMAINS]
    found: Figures = {
        "lines": max(len(text.splitlines()) for text in pages),
        "bytes": max(len(text.encode()) for text in pages),
        "actions": max(text.count("(:action ") for text in pages),
    }
    rows = shipped()
    found["problem_bytes_8"] = {
        kind: max(file.stat().st_size for _, about, file in rows if about == (kind, 8))
        for kind in (RELATIONS, CELLS)
    }
    for kind, objects in ((RELATIONS, 8), (CELLS, 2), (CELLS, 8)):
        medians = [
            statistics.median(calls)
            for domain in DOMAINS
            if (
                calls := _calls(
                    [name for name, about, _ in rows if about == (kind, objects)], domain, records
                )
            )
        ]
        found[f"cpu_{kind}_{objects}"] = max(medians)
    found["optimal"] = {
        name: record["cost"] if record["cost"] is not None else f"code {record['code']}"
        for name, *_ in rows
        if (record := records.get(f"{OPTIMAL}.{name}"))
    }
    return found


def _calls(names: list[str], domain: str, records: Mapping[str, Figures]) -> list[float]:
    """List the CPU seconds of calls for first plans of a domain's problems."""
    ours = [name for name in names if name.startswith(f"{domain}.")]
    return [records[f"{FIRST}.{name}.{run}"]["cpu"] for name in ours for run in range(RUNS)]


if __name__ == "__main__":
    tyro.cli(main)
