"""Give every planner every encoding, and readers of PDDL too: what each parses, solves and refuses.

Each planner gets the whole problem at once, as it is printed, and its plan is replayed with exact
displacements. This shows what planners do with the text, not what `neurosym plan` makes of it, which solves
object by object and tries again. Every cell of the matrix writes a file of its own into a working folder, so
that the run can be interrupted and goes on where it was.
"""

import hashlib
import os
import sys
import tempfile
from collections.abc import Mapping, Sequence
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Annotated, Any

import msgspec
import tyro

from neurosym.console import say
from neurosym.errors import InvalidPlan
from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.moves import BY_RELATIONS, ENCODINGS, PLACES, RELATIONAL, Encoding
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.validation import validate
from neurosym.planners import PLANNERS, PlanStatus, plan
from neurosym.planners.catalogue import COARSE, PROGRAMS
from neurosym.planners.planner import PddlProgram
from neurosym.planners.process import run_limited
from neurosym.planners.track_record import FILE, TrackRecord
from neurosym.planners.unified_planning import plan_unified_planning
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING
from neurosym.stages.planning import load_problem
from tools.benchmarks.jobs import as_text, load_jobs, machine, perform
from tools.benchmarks.options import Results, Work
from tools.benchmarks.places import ROOT

RESULTS, WORK, SHIPPED = Path("docs/results"), Path("evaluation/planners"), Path("domains/tabletop")
TIME_LIMIT = 30.0
"""How long each planner may take [s]."""
PROBLEMS = {1: 1, 2: 1}
"""How many problems of the shipped domain are taken, by how many objects they have."""
TOY_GOALS = {
    "toy-1": {"item-01": (0.68, 0.16, 0.025)},
    "toy-2": {"item-01": (0.68, 0.08, 0.025), "item-02": (0.8, 0.1, 0.225)},
}
READERS = {
    "unified-planning": "from unified_planning.io import PDDLReader; "
    "PDDLReader().parse_problem(*sys.argv[1:])",
    "pddl": "import pddl; pddl.parse_domain(sys.argv[1]); pddl.parse_problem(sys.argv[2])",
    "tarski": "from tarski.io import PDDLReader; r = PDDLReader(raise_on_error=True); "
    "r.parse_domain(sys.argv[1]); r.parse_instance(sys.argv[2])",
}
"""Programs that read PDDL and do not plan."""
REFUSING = {"tamer": partial(plan_unified_planning, engine="tamer")}
"""Planners that refuse all of it, for the record."""
COLUMNS = (*ENCODINGS, PLACES, *BY_RELATIONS)
PACKAGES = (
    "unified-planning", "up-fast-downward", "kairos-planner", "up-enhsp", "up-lpg", "up-symk",
    "kstar-planner", "forbiditerative", "up-pyperplan", "up-aries", "up-tamer", "pddl", "tarski",
)  # fmt: skip


def main(
    time_limit: Annotated[float, tyro.conf.arg(help="How long each planner may take [s].")] = TIME_LIMIT,
    work: Work = WORK,
    results: Results = RESULTS,
    workers: Annotated[int, tyro.conf.arg(help="Cells at once.")] = 1,
) -> None:
    """Fill what is not filled of the matrix, and write the tables."""
    tasks = {**_toy(), **_shipped(), **_with_places(), **_with_relations()}
    folder = work / _digest(tasks, time_limit)
    folder.mkdir(parents=True, exist_ok=True)
    results.mkdir(parents=True, exist_ok=True)
    names = [*(planner.name for planner in PROGRAMS), *REFUSING]
    cells = [(name, encoding, task) for encoding, task in _asked(tasks) for name in names]
    cells.sort(key=lambda cell: cell[1] not in _taken(cell[0])[:1])  # what each does best with comes first
    jobs = {
        ".".join(cell): partial(measure, *cell[:2], *tasks[cell[2]], time_limit=time_limit) for cell in cells
    }
    read = {
        f"{reader}.{encoding}.{task}": partial(measure_reader, reader, encoding, *tasks[task])
        for reader in READERS
        for encoding, task in _asked(tasks)
    }
    jobs |= read

    def report() -> None:
        _write(load_jobs(folder), results, tasks, time_limit, len(jobs))

    perform(folder, jobs, workers, report, label="planners")
    report()
    say(f"wrote {results / 'planners.md'} and {results / 'planners.json'}")


def measure(
    planner: str, encoding: str, problem: Problem, grounding: Grounding, *, time_limit: float
) -> dict[str, Any]:
    """Give a planner a problem in an encoding; what came of it."""
    if remedy := PLANNERS[planner].missing() if planner in PLANNERS else "":
        return {"status": "not installed", "words": remedy}
    fitted = _on_grid(planner, encoding, problem, grounding)
    with tempfile.TemporaryDirectory(prefix="neurosym-matrix-") as name:
        answer = _program(planner).call(
            *_written(Path(name), problem, fitted, encoding), time_limit=time_limit
        )
    found: dict[str, Any] = {
        "status": answer.status.value,
        "cell_mm": None if encoding in ("numeric", *BY_RELATIONS) else fitted.cell * 1000,
        "seconds": round(answer.seconds, 2),
        "words": answer.reason,
    }
    if answer.status is PlanStatus.SOLVED:
        try:
            steps = parse_plan(answer.text, Path("its plan"), fitted, problem)
        except InvalidPlan as error:
            return {**found, "status": "failed", "words": str(error)}
        checked = validate(steps, problem, grounding)
        found |= {"valid": checked.valid, "steps": len(steps), "words": checked.reason}
    return found


def measure_reader(reader: str, encoding: str, problem: Problem, grounding: Grounding) -> dict[str, Any]:
    """Let a reader read a problem in an encoding; whether it did."""
    fitted = _on_grid("up-fast-downward", encoding, problem, grounding)
    with tempfile.TemporaryDirectory(prefix="neurosym-matrix-") as name:
        files = _written(Path(name), problem, fitted, encoding)
        command = [sys.executable, "-c", f"import sys; {READERS[reader]}", *map(str, files)]
        finished = run_limited(command, Path(name), TIME_LIMIT * 2)
    status = {0: "parsed", None: "timeout"}.get(finished.code, "failed")
    return {"status": status, "words": "" if finished.code == 0 else finished.last_words}


def _toy() -> dict[str, tuple[Problem, Grounding]]:
    sys.path.insert(0, str(ROOT / "tests"))
    import toy_domain

    return {name: (toy_domain.problem(goals), toy_domain.grounding()) for name, goals in TOY_GOALS.items()}


def _shipped() -> dict[str, tuple[Problem, Grounding]]:
    """Take the first problems of each size that are not met at the start and that there is a plan for."""
    folder = DomainFolder(ROOT / SHIPPED)
    grounding = Grounding.load(folder.require(GROUNDING))
    found: dict[str, tuple[Problem, Grounding]] = {}
    left = dict(PROBLEMS)
    for name in folder.problem_names():
        problem = load_problem(folder, name)
        if left.get(len(problem.objects)) and plan(problem, grounding, "counting").steps:
            left[len(problem.objects)] -= 1
            found[name] = (problem, grounding)
    return found


def _with_places() -> dict[str, tuple[Problem, Grounding]]:
    """Take two problems of the toy world in which objects are carried to places."""
    import toy_places

    return {
        f"{PLACES}-{task.name}": (task, toy_places.grounding())
        for task in (toy_places.swap(), toy_places.mixed())
    }


def _with_relations() -> dict[str, tuple[Problem, Grounding]]:
    """Take two problems of the toy world in which objects are put on and into one another."""
    import toy_relations

    return {
        f"{RELATIONAL}-{task.name}": (task, toy_relations.grounding())
        for task in (toy_relations.tower(), toy_relations.sorting())
    }


def _asked(tasks: Mapping[str, tuple[Problem, Grounding]]) -> list[tuple[str, str]]:
    """List which problem is given in which encoding."""
    return [
        (encoding, name)
        for encoding in COLUMNS
        for name, (_, grounding) in tasks.items()
        if encoding in _fitting(grounding)
    ]


def _fitting(grounding: Grounding) -> tuple[Encoding, ...]:
    """Name the encodings that the problems of a domain are given in: relations and places have their own."""
    if grounding.relations is not None:
        return BY_RELATIONS
    return ENCODINGS if grounding.places is None else (PLACES,)


def _digest(tasks: Mapping[str, tuple[Problem, Grounding]], time_limit: float) -> str:
    """Name what is measured with, so that what was measured with something else is measured again."""
    return hashlib.sha256(msgspec.json.encode([tasks, time_limit])).hexdigest()[:12]


def _taken(planner: str) -> tuple[str, ...]:
    return _program(planner).encodings


def _program(planner: str) -> PddlProgram:
    """Return what takes the files; what refuses them all takes no encoding."""
    program = PLANNERS[planner].program if planner in PLANNERS else None
    return program or PddlProgram(REFUSING[planner], encodings=(), cell=COARSE)


def _on_grid(planner: str, encoding: str, problem: Problem, grounding: Grounding) -> Grounding:
    """Lay the grid that a planner is given: coarser if fine ones are too much for it, or the encoding."""
    coarsest = COARSE if encoding == "operators" else 0.0
    cell = max(grounding.cell, coarsest, _program(planner).cell)
    narrowed = grounding.narrowed({item.category for item in problem.objects})
    return msgspec.structs.replace(narrowed, cell=cell)


def _written(folder: Path, problem: Problem, grounding: Grounding, encoding: str) -> tuple[Path, Path]:
    domain, task = folder / "domain.pddl", folder / "problem.pddl"
    domain.write_text(domain_text(grounding, encoding))
    task.write_text(problem_text(problem, grounding, encoding))
    return domain, task


def _write(
    found: Mapping[str, Any], results: Path, tasks: Mapping[str, Any], time_limit: float, cells: int
) -> None:
    values = {
        "command": "make evaluate-planners",
        "time_limit": time_limit,
        "problems": list(tasks),
        "missing": cells - len(found),
        "machine": machine() | {"load": f"{os.getloadavg()[0]:.0f}"} | {n: _version(n) for n in PACKAGES},
        "cells": {name: found[name] for name in sorted(found)},
    }
    write_atomically(results / "planners.json", as_text(values))
    write_atomically(results / "planners.md", _page(values))
    if results == RESULTS:
        write_atomically(FILE, as_text(msgspec.to_builtins(record_of(values))))


def record_of(values: Mapping[str, Any]) -> TrackRecord:
    """Return what each planner solved of shipped problems, in the encodings that it takes.

    Args:
        values: What `planners.json` holds.
    """
    problems = tuple(name for name in values["problems"] if name.startswith("task-"))
    solved = {
        planner.name: {
            encoding: sum(
                values["cells"].get(f"{planner.name}.{encoding}.{name}", {}).get("status") == "solved"
                for name in problems
            )
            for encoding in planner.encodings
            if encoding in ENCODINGS
        }
        for planner in PROGRAMS
    }
    return TrackRecord(problems, values["time_limit"], solved)


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


def _page(values: Mapping[str, Any]) -> str:
    tasks = ", ".join(values["problems"])
    left = f" **Not finished**: {values['missing']} cells to do." if values["missing"] else ""
    lines = [
        "# Planners and encodings",
        "",
        f"By `{values['command']}`, which wrote this page and `planners.json`. Problems: {tasks};",
        f"each solved whole within {values['time_limit']:g} s. `toy-1` has one goal, `toy-2` two.{left}",
        "",
        "Each cell: plans found of problems given, how many of these are valid when replayed with exact",
        "displacements, median seconds and steps, the grid; and what the planner said where it found none.",
        "*Usual* is the encoding that `neurosym plan` gives it; that also tries again where a replay fails,",
        "on a finer grid in the end, which is not done here. The encoding `places` has problems of its own:",
        "two that change places, and one that is carried to where another must be pushed away. So have those",
        "of relations: a tower of three, and a stack to be sorted into two trays. These are without a grid.",
        "",
        f"| planner | usual | {' | '.join(COLUMNS)} |",
        "|---|---|" + "---|" * len(COLUMNS),
    ]
    for name in [*(planner.name for planner in PROGRAMS), *REFUSING, *READERS]:
        row = [_cell(values["cells"], name, encoding) for encoding in COLUMNS]
        usual, *_ = ("reads only",) if name in READERS else (_taken(name) or ("none",))
        lines.append(f"| {name} | {usual} | {' | '.join(row)} |")
    versions = ", ".join(f"{name} {value}" for name, value in values["machine"].items())
    return "\n".join([*lines, "", f"Measured with {versions}.", ""])


def _cell(cells: Mapping[str, Any], name: str, encoding: str) -> str:
    found = [cell for key, cell in cells.items() if key.startswith(f"{name}.{encoding}.")]
    if not found:
        return "not done"
    said = sorted({cell["words"] for cell in found if cell["status"] not in ("solved", "parsed")})
    words = "; ".join(text.replace("|", "/")[:160] for text in said[:2])
    if parsed := sum(cell["status"] == "parsed" for cell in found):
        return f"{parsed}/{len(found)} parsed" + (f"; {words}" if words else "")
    solved = [cell for cell in found if cell["status"] == "solved"]
    if not solved:
        return f"0/{len(found)}: {words}"
    valid = sum(cell["valid"] for cell in solved)
    seconds, steps = _median([c["seconds"] for c in solved]), _median([c["steps"] for c in solved])
    grid = f", {solved[0]['cell_mm']:g} mm" if solved[0]["cell_mm"] else ""
    text = f"**{len(solved)}/{len(found)}**, {valid} valid, {seconds:g} s, {steps:g} steps{grid}"
    return text + (f"; {words}" if words else "")


def _median(values: Sequence[float]) -> float:
    ordered = sorted(values)
    return ordered[len(ordered) // 2]


if __name__ == "__main__":
    tyro.cli(main)
