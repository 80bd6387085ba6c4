"""Give every planner every encoding, and readers of PDDL too: what each parses, solves and refuses.

Each planner gets the whole problem at once, as it is printed, and its plan is replayed with exact
displacements. This shows what planners do with the text, not what `neurosym plan` makes of it, which solves
object by object and tries again. Every cell of the matrix writes a file of its own into a working folder, so
that the run can be interrupted and goes on where it was.
"""

import hashlib
import json
import os
import sys
import tempfile
from collections.abc import Mapping, Sequence
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from statistics import median_high
from typing import Annotated, Any

import msgspec
import tyro

from neurosym.errors import InvalidPlan
from neurosym.grounding import Grounding
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.sas import sas_text
from neurosym.pddl.strips_problem import printed_cell
from neurosym.pddl.syntax import SAS, STRIPS, EncodingName
from neurosym.planners import PLANNERS, PlanStatus, plan
from neurosym.planners.external import SAS_SUFFIX, run_limited
from neurosym.planners.planner import PddlProgram
from neurosym.planners.registry import PROGRAMS
from neurosym.problems import Problem
from neurosym.stages.console import say
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING
from neurosym.stages.planning import load_problem
from neurosym.tasks.task import understand
from neurosym.tasks.transition import validate
from tools.benchmarks.jobs import Evaluation, Found, machine
from tools.benchmarks.options import RESULTS, ROOT, Results, Work
from tools.benchmarks.tables import listed

TIME_LIMIT = 30.0
"""How long each planner may take [s]."""
Tasks = Mapping[str, tuple[Problem, Grounding]]
"""Problems by name, with what was learned of their domain."""
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
COLUMNS: tuple[tuple[str, EncodingName, tuple[str, ...]], ...] = (
    ("strips", STRIPS, ("toy-", "task-")),
    ("strips, places", STRIPS, ("places-",)),
    ("strips, relations", STRIPS, ("relations-",)),
    ("numeric", "numeric", ("toy-", "task-")),
    ("sas", SAS, ("toy-", "task-")),
)
"""The columns: the title, the encoding, and what the names of its problems begin with."""
PACKAGES = (
    "unified-planning", "up-fast-downward", "kairos-planner", "up-enhsp", "up-lpg", "up-symk",
    "pddl", "tarski",
)  # fmt: skip


def main(
    time_limit: Annotated[float, tyro.conf.arg(help="How long each planner may take [s].")] = TIME_LIMIT,
    work: Work = Path("evaluation/planners"),
    results: Results = RESULTS,
    workers: Annotated[int, tyro.conf.arg(help="Cells at once.")] = 1,
) -> None:
    """Fill what is not filled of the matrix, and write the tables."""
    tasks = _problems()
    evaluation = Evaluation("planners", work / _digest(tasks, time_limit), results, workers)
    names, asked = [planner.name for planner in PROGRAMS], _asked(tasks)
    cells = [
        (name, encoding, task)
        for encoding, task in asked
        for name in names
        if encoding != SAS or encoding in _taken(name)
    ]
    cells.sort(key=lambda cell: cell[1] not in _taken(cell[0])[:1])  # what each does best with comes first
    jobs = {
        ".".join(cell): partial(measure, *cell[:2], *tasks[cell[2]], time_limit=time_limit) for cell in cells
    }
    jobs |= {
        f"{reader}.{encoding}.{task}": partial(measure_reader, reader, encoding, *tasks[task])
        for reader in READERS
        for encoding, task in asked
        if encoding != SAS
    }

    def report() -> None:
        write_results(evaluation, [*tasks], time_limit, len(jobs))

    evaluation.perform(jobs, "planners", report)
    report()
    say(f"wrote {results / 'planners.md'} and {results / 'planners.json'}")


def measure(
    planner: str, encoding: str, problem: Problem, grounding: Grounding, *, time_limit: float
) -> dict[str, Any]:
    """Give a planner a problem in an encoding; what came of it."""
    if remedy := PLANNERS[planner].missing():
        return {"status": "not installed", "words": remedy}
    fitted = _on_grid(planner, problem, grounding)
    with tempfile.TemporaryDirectory(prefix="neurosym-matrix-") as name:
        files = _written(Path(name), problem, fitted, encoding)
        answer = _program(planner).call(*files, time_limit=time_limit)
    found: dict[str, Any] = {
        "status": answer.status.value,
        "cell_mm": _cell_in_mm(encoding, problem, fitted),
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


def _cell_in_mm(encoding: str, problem: Problem, fitted: Grounding) -> float | None:
    """Return how long the cells are that objects are led over; None if none is."""
    task = understand(problem, fitted)
    if encoding == STRIPS:
        return printed_cell(task) * 1000 if task.led else None
    return fitted.cell * 1000 if encoding == SAS else None


def measure_reader(reader: str, encoding: str, problem: Problem, grounding: Grounding) -> dict[str, Any]:
    """Let a reader read a problem in an encoding; whether it did."""
    fitted = _on_grid("symk", problem, grounding)
    with tempfile.TemporaryDirectory(prefix="neurosym-matrix-") as name:
        files = _written(Path(name), problem, fitted, encoding)
        command = [sys.executable, "-c", f"import sys; {READERS[reader]}", *map(str, files)]
        finished = run_limited(command, Path(name), TIME_LIMIT * 2)
    status = {0: "parsed", None: "timeout"}.get(finished.code, "failed")
    return {"status": status, "words": "" if finished.code == 0 else finished.last_words}


def _problems() -> Tasks:
    """Take problems of the toy world, of single objects, places and relations, and shipped ones."""
    sys.path.insert(0, str(ROOT / "tests"))
    import toy_domain
    import toy_places
    import toy_relations

    plain = {name: (toy_domain.problem(goals), toy_domain.grounding()) for name, goals in TOY_GOALS.items()}
    carried, put = (toy_places.swap(), toy_places.mixed()), (toy_relations.tower(), toy_relations.sorting())
    return {
        **plain,
        **_shipped(),
        **{f"places-{task.name}": (task, toy_places.grounding()) for task in carried},
        **{f"relations-{task.name}": (task, toy_relations.grounding()) for task in put},
    }


def _shipped() -> Tasks:
    """Take the first problem of one and of two objects that is not met at the start, and has a plan."""
    folder, found, sizes = DomainFolder(ROOT / "domains/tabletop"), {}, [1, 2]
    grounding = Grounding.load(folder.require(GROUNDING))
    for name in folder.problem_names():
        problem = load_problem(folder, name)
        if len(problem.objects) in sizes and plan(problem, grounding, "counting").steps:
            sizes.remove(len(problem.objects))
            found[name] = (problem, grounding)
    return found


def _asked(tasks: Sequence[str] | Tasks) -> list[tuple[EncodingName, str]]:
    """List which problem is given in which encoding: places and relations only stand on the page."""
    return [(encoding, name) for _, encoding, kinds in COLUMNS for name in tasks if name.startswith(kinds)]


def _digest(tasks: Tasks, time_limit: float) -> str:
    """Name what is measured with, so that what was measured with something else is measured again."""
    texts = [_texts(*tasks[name], encoding) for encoding, name in _asked(tasks)]
    return hashlib.sha256(msgspec.json.encode([texts, time_limit])).hexdigest()[:12]


def _taken(planner: str) -> tuple[str, ...]:
    return _program(planner).encodings


def _program(planner: str) -> PddlProgram:
    """Return what takes the files."""
    program = PLANNERS[planner].program
    assert program is not None, f"{planner} reads no files"
    return program


def _on_grid(planner: str, problem: Problem, grounding: Grounding) -> Grounding:
    """Lay the grid that a planner is given: coarser if fine ones are too much for it."""
    cell = max(grounding.cell, _program(planner).cell)
    categories, table = {item.category for item in problem.objects}, grounding.operators
    kept = tuple(one for one in table.operators if one.category in categories)
    narrowed = msgspec.structs.replace(table, operators=kept)
    return msgspec.structs.replace(grounding, operators=narrowed, cell=cell)


def _written(folder: Path, problem: Problem, grounding: Grounding, encoding: str) -> tuple[Path, Path]:
    """Write the files of domain and problem, which are one if in SAS+."""
    names = (f"problem{SAS_SUFFIX}",) * 2 if encoding == SAS else ("domain.pddl", "problem.pddl")
    domain, task = (folder / name for name in names)
    for file, text in zip((domain, task), _texts(problem, grounding, encoding), strict=True):
        file.write_text(text)
    return domain, task


def _texts(problem: Problem, grounding: Grounding, encoding: str) -> tuple[str, str]:
    if encoding == SAS:
        return (sas_text(problem, grounding),) * 2
    return domain_text(grounding, encoding), problem_text(problem, grounding, encoding)


def write_results(evaluation: Evaluation, tasks: Sequence[str], time_limit: float, cells: int) -> None:
    """Write the figures and the page, and keep what `one_page` measured."""
    path, found = evaluation.results / "planners.json", evaluation.found()
    page = json.loads(path.read_text()).get("one_page") if path.exists() else None
    values = {
        **({"one_page": page} if page else {}),
        "command": "make evaluate-planners",
        "time_limit": time_limit,
        "problems": list(tasks),
        "missing": cells - len(found),
        "machine": machine() | {"load": f"{os.getloadavg()[0]:.0f}"} | {n: _version(n) for n in PACKAGES},
        "cells": {name: found[name] for name in sorted(found)},
    }
    evaluation.write(values, _page(values), records=False)


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
        "on a finer grid in the end, which is not done here. What is carried to places has problems of its",
        "own: two that change places, and one that is carried to where another must be pushed away. So have",
        "relations: a tower of three, and a stack to be sorted into two trays. Only Fast Downward is given",
        "`sas`, which no file of a domain says.",
        "",
        f"| planner | usual | {' | '.join(title for title, *_ in COLUMNS)} |",
        "|---|---|" + "---|" * len(COLUMNS),
    ]
    for name in [*(planner.name for planner in PROGRAMS), *READERS]:
        row = [_cell(values["cells"], name, encoding, kinds) for _, encoding, kinds in COLUMNS]
        usual, *_ = ("reads only",) if name in READERS else _taken(name)
        lines.append(f"| {name} | {usual} | {' | '.join(row)} |")
    return "\n".join([*lines, "", f"Measured with {listed(values['machine'])}.", ""])


def _cell(cells: Found, name: str, encoding: str, kinds: Sequence[str]) -> str:
    begin = tuple(f"{name}.{encoding}.{kind}" for kind in kinds)
    found = [cell for key, cell in cells.items() if key.startswith(begin)]
    if not found:
        return "-" if encoding == SAS else "not done"
    said = sorted({cell["words"] for cell in found if cell["status"] not in ("solved", "parsed")})
    words = "; ".join(text.replace("|", "/")[:160] for text in said[:2])
    if parsed := sum(cell["status"] == "parsed" for cell in found):
        return f"{parsed}/{len(found)} parsed" + (f"; {words}" if words else "")
    solved = [cell for cell in found if cell["status"] == "solved"]
    if not solved:
        return f"0/{len(found)}: {words}"
    valid = sum(cell["valid"] for cell in solved)
    seconds, steps = (median_high([c[name] for c in solved]) for name in ("seconds", "steps"))
    grid = f", {solved[0]['cell_mm']:g} mm" if solved[0]["cell_mm"] else ""
    text = f"**{len(solved)}/{len(found)}**, {valid} valid, {seconds:g} s, {steps:g} steps{grid}"
    return text + (f"; {words}" if words else "")


if __name__ == "__main__":
    tyro.cli(main)
