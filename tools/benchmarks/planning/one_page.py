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
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import tyro

from neurosym.choices import DOMAINS
from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.stages.console import say
from neurosym.tasks.task import understand
from tools.benchmarks.jobs import Evaluation, Found, Job, as_text
from tools.benchmarks.options import RESULTS, ROOT, Results, Work

FIRST, OPTIMAL = "first", "optimal"
RUNS = 3
"""How often the first plan is looked for."""
LIMITS = ("--overall-time-limit", "60s", "--overall-memory-limit", "2G")
RELATIONS, CELLS, PLACES = "relations", "cells", "places"
Figures = dict[str, Any]


def main(work: Work = Path("build/one-page"), results: Results = RESULTS) -> None:
    """Measure the printed files, and keep what else the file of results holds."""
    evaluation = Evaluation("one-page", work, results)
    evaluation.perform(jobs(), "planning")
    path = results / "planners.json"
    kept = json.loads(path.read_text())
    before = kept.get("one_page", {}).get("before", {})
    found = figures(evaluation.found())
    costs = found.pop("optimal")
    was = {name: cost for name, cost in before.get("optimal", {}).items() if isinstance(cost, int)}
    dearer = {
        name: [was[name], cost]
        for name, cost in costs.items()
        if name in was and isinstance(cost, int) and cost > was[name]
    }
    kept["one_page"] = found | {"optimal": costs, "dearer_than_before": dearer, "before": before}
    write_atomically(path, as_text(kept))
    say(json.dumps(found, indent=1))
    say(f"{len(costs)} cheapest plans, {len(dearer)} dearer than before; wrote {path}")


def jobs() -> dict[str, Job]:
    """List the calls: first plans several times, cheapest ones once."""
    found: dict[str, Job] = {}
    for name, _, problem in shipped():
        files = (str(problem.parent.parent / "domain.pddl"), str(problem))
        for run in range(RUNS):
            found[f"{FIRST}.{name}.{run}"] = partial(called, "--alias", "lama-first", *files)
        found[f"{OPTIMAL}.{name}"] = partial(called, *files, "--search", "astar(lmcut())")
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


def called(*words: str) -> Figures:
    """Call Fast Downward in a folder of its own, and return how that went."""
    spec = find_spec("up_fast_downward")
    assert spec is not None and spec.origin is not None, "`pip install up-fast-downward` brings it"  # noqa: PT018
    driver = Path(spec.origin).parent / "downward" / "fast-downward.py"
    alone = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    with tempfile.TemporaryDirectory() as place:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [sys.executable, str(driver), *LIMITS, *words]
        done = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False, env=alone)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cost = re.search(r"Plan cost: (\d+)", done.stdout)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"code": done.returncode, "cpu": round(cpu, 3), "cost": int(cost[1]) if cost else None}


def figures(records: Found) -> Figures:
    """Sum up what calls came to: of the longest domain and problems, and of medians the worst domain's."""
    pages = [(ROOT / "domains" / domain / "domain.pddl").read_text() for domain in DOMAINS]
    rows = shipped()
    found: Figures = {
        "lines": max(len(text.splitlines()) for text in pages),
        "bytes": max(len(text.encode()) for text in pages),
        "actions": max(text.count("(:action ") for text in pages),
        "problem_bytes_8": {
            kind: max(file.stat().st_size for _, about, file in rows if about == (kind, 8))
            for kind in (RELATIONS, CELLS)
        },
    }
    for kind, objects in ((RELATIONS, 8), (CELLS, 2), (CELLS, 8)):
        calls: dict[str, list[float]] = {}
        for name, about, _ in rows:
            if about == (kind, objects):
                spent = [records[f"{FIRST}.{name}.{run}"]["cpu"] for run in range(RUNS)]
                calls.setdefault(name.partition(".")[0], []).extend(spent)
        found[f"cpu_{kind}_{objects}"] = max(map(statistics.median, calls.values()))
    found["optimal"] = {
        name: record["cost"] if record["cost"] is not None else f"code {record['code']}"
        for name, *_ in rows
        if (record := records.get(f"{OPTIMAL}.{name}"))
    }
    return found


if __name__ == "__main__":
    tyro.cli(main)
