"""What other people's planners make of the printed files: `python -m tools.benchmarks.foreign`.

Ten planners from the package index are called as a researcher would who has never heard of neurosym, on
copies of a printed domain and problem. The table says what each solves, in how much CPU, and whether its
plans are valid: unified-planning's validator judges them by the printed files. Each planner
gets an environment of its own, below `--venvs`. What was measured stays in foreign.json, beside which
foreign.md is written, and is not measured again while neither files nor call change. What small tasks with
one thing of PDDL each told of the planners was measured once, and stays there.
"""

import hashlib
import json
import os
import signal
import statistics
import subprocess
import tempfile
import time
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import tyro
from unified_planning.io import PDDLReader
from unified_planning.shortcuts import PlanValidator

from neurosym.errors import listed_briefly
from neurosym.files import write_atomically
from neurosym.pddl.compiler import Action, excerpt_for
from neurosym.planners.unified_planning import validate_pddl
from neurosym.stages.console import say
from tools.benchmarks.foreign_calls import planners as theirs
from tools.benchmarks.foreign_calls.planners import PLANNERS, Planner, error_in, steps_in
from tools.benchmarks.jobs import Found, as_text, children_cpu, machine
from tools.benchmarks.options import RESULTS, ROOT
from tools.benchmarks.tables import document, number, table

CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "neurosym-foreign"
LIMIT, OUTPUT = 60, RESULTS / "foreign.json"
MEMORY = 8 << 30  # how much a planner may address [bytes]
PROBLEMS = {
    "tabletop": "task-01 task-07 task-13 task-15 task-17 task-19",
    "tabletop-paper": "task-01 task-13 task-15 task-17 task-19",
    "places": "anywhere-1-01 anywhere-3-08 anywhere-4-13 row-4-12 anywhere-6-18 anywhere-8-19",
    "towers": "tower-2-01 tower-4-03 anywhere-4-19 unstack-5-14 boxes-6-12 anywhere-8-20",
}  # of each domain some problems with few objects, and some with many
FILES = (("domain.pddl", ".pddl", False), ("domain-plain.pddl", ".plain.pddl", True))
"""Files that are looked for: the domain's, what follows a problem's name, and whether they tell no costs."""


@dataclass(frozen=True, slots=True)
class Task:
    """What a planner is given: name, texts of a domain and a problem, and whether they tell no costs."""

    name: str
    domain: str
    problem: str
    plain: bool = False

    def digest(self, planner: Planner, limit: int) -> str:
        """Return what stands for the task and a call of so long at most [CPU s] while neither changes."""
        all_of_it = "\0".join([self.domain, self.problem, planner.call_text(), str(limit)])
        return hashlib.sha256(all_of_it.encode()).hexdigest()[:16]


def main(
    domains: Annotated[Path, tyro.conf.arg(help="Folder of the domains.")] = ROOT / "domains",
    planners: Annotated[str, tyro.conf.arg(help="Names of planners, with commas; all if empty.")] = "",
    problems: Annotated[str, tyro.conf.arg(help="Problems as domain/name, with commas; some if empty.")] = "",
    limit: Annotated[int, tyro.conf.arg(help="CPU that a call may take [s].")] = LIMIT,
    venvs: Annotated[Path, tyro.conf.arg(help="Folder for the planners' environments.")] = CACHE / "venvs",
    output: Annotated[Path, tyro.conf.arg(help="File for figures, the table beside it.")] = OUTPUT,
) -> None:
    """Install planners, call them, judge their plans, and write the table and the figures."""
    named = [name for name in planners.split(",") if name] or list(PLANNERS)
    if unknown := [name for name in named if name not in PLANNERS]:
        raise SystemExit(f"There is no planner {unknown[0]}; there are {', '.join(PLANNERS)}.")
    chosen = [one for one in problems.split(",") if one] or [
        f"{domain}/{name}" for domain, names in PROBLEMS.items() for name in names.split()
    ]
    found: dict[str, Any] = json.loads(output.read_text())["planners"] if output.exists() else {}
    for name in named:
        planner = PLANNERS[name]
        refused = theirs.install(planner, venvs)
        about = {"version": planner.version, "call": planner.told, "not_installed": refused}
        one = found[name] = {"problems": {}} | found.get(name, {}) | about
        if refused:
            say(f"{name} cannot be installed: {refused}")
        for task in () if refused else (task_of(domains, problem, planner.costs) for problem in chosen):
            known = one["problems"].get(task.name)
            one["problems"][task.name] = measured(planner, task, planner.words(venvs, limit), limit, known)
            one["totals"] = totals(one["problems"].values())
            write_results(found, limit, output)
    write_results(found, limit, output)
    say(f"wrote {output}")


def write_results(found: Mapping[str, Any], limit: int, output: Path) -> None:
    """Write the figures and the table."""
    planners = {name: found[name] for name in PLANNERS if name in found}
    figures = {"machine": machine(), "limit_cpu_s": limit, "planners": planners}
    write_atomically(output, as_text(figures))
    write_atomically(output.with_suffix(".md"), page(figures))


def task_of(domains: Path, problem: str, costs: bool) -> Task:
    """Read a printed problem; for a planner without costs, plain files are preferred."""
    domain, _, name = problem.partition("/")
    for printed, ending, plain in sorted(FILES, key=lambda each: each[2] == costs):
        files = domains / domain / printed, domains / domain / "problems" / f"{name}{ending}"
        if all(path.exists() for path in files):
            return Task(problem, *(path.read_text() for path in files), plain)
    raise SystemExit(f"There is no printed problem {problem} below {domains}.")


def measured(
    planner: Planner, task: Task, words: Sequence[str], limit: int, known: Found | None = None
) -> Found:
    """Call a planner on a task by a command line, and judge its plan, unless that is known."""
    digest = task.digest(planner, limit)
    if known and known["digest"] == digest:
        return known
    with tempfile.TemporaryDirectory(prefix="neurosym-foreign-") as scratch:
        folder = Path(scratch)
        (folder / "domain.pddl").write_text(task.domain)
        (folder / "problem.pddl").write_text(task.problem)
        cpu, clock, code = called(words, folder, limit)
        plan = plan_in(folder, planner)
        said = (_text(folder / each) for each in (theirs.COMPLAINED, theirs.PRINTED))
        why = f"exit code {code}, and no plan" if code else "no plan, and no word why"
        error = error_in(*said) or why
    spent = {"cpu_s": round(cpu, 2), "wall_s": round(clock, 2)}
    found = {"status": "solved", **spent, "digest": digest, **judged(task, plan)}
    if cpu > limit or (plan is None and code is None):
        found |= {"status": "limit"}
    elif plan is None:
        found |= {"status": "failed", "error": error}
    elif found["valid"] is False:
        found |= {"status": "wrong", "error": found["judge"]}
    say(f"{planner.packages[0]}, {task.name}: {found['status']}, {found['cpu_s']} s {found['error']}")
    return found


def called(words: Sequence[str], folder: Path, limit: int) -> tuple[float, float, int | None]:
    """Call a planner in a folder; return the CPU of its processes [s], the time [s], and its exit code.

    It is ended, with all that it started, after so much CPU in a process, or twice as long by the clock; its
    exit code is None then, and the CPU that of the processes that had ended.
    """
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "VIRTUAL_ENV"))}
    clean |= {"OMP_NUM_THREADS": "1", "HOME": str(folder)}
    begin, before, code = time.monotonic(), children_cpu(), None
    limits = f'ulimit -c 0; ulimit -t {limit + 1}; ulimit -v {MEMORY // 1024}; exec "$@"'
    command = ["bash", "-c", limits, "bash", *words]
    with (folder / theirs.PRINTED).open("w") as printed, (folder / theirs.COMPLAINED).open("w") as complained:
        streams = {"stdin": subprocess.DEVNULL, "stdout": printed, "stderr": complained}
        process = subprocess.Popen(command, cwd=folder, env=clean, start_new_session=True, **streams)
        try:
            with suppress(subprocess.TimeoutExpired):
                code = process.wait(2 * limit)
        finally:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    ended = code in (-signal.SIGKILL, -signal.SIGXCPU)
    return children_cpu() - before, time.monotonic() - begin, None if ended else code


def _text(path: Path) -> str:
    return path.read_text(errors="replace") if path.exists() else ""


def plan_in(folder: Path, planner: Planner) -> list[Action] | None:
    """Read the plan that a planner left; None if it left none."""
    files = [path for path in sorted(folder.glob(planner.plans)) if path.is_file()]
    return (steps_in(_text(files[-1])) or None) if files else None


def judged(task: Task, plan: list[Action] | None) -> dict[str, Any]:
    """Say whether a plan is valid by the printed files, and what it costs."""
    told = {"plan_length": plan and len(plan), "cost": None, "valid": None, "judge": "", "error": ""}
    if plan is None:
        return told
    try:
        verdict = validate_pddl(task.domain, task.problem, plan)
    except Exception as error:  # it is not ours, and trips over what it does not know
        return told | {"judge": str(error)[:300]}
    cost = cost_of(task, plan) if verdict.valid else None
    return told | {"cost": cost, "valid": verdict.valid, "judge": verdict.reason}


def cost_of(task: Task, plan: Sequence[Action]) -> float | None:
    """Add up what the steps of a valid plan cost by the printed files; None where these tell no costs."""
    reader = PDDLReader()
    known = reader.parse_problem_string(*excerpt_for(task.domain, task.problem, plan))
    steps = reader.parse_plan_string(known, "\n".join(f"({' '.join(step)})" for step in plan))
    with PlanValidator(problem_kind=known.kind, plan_kind=steps.kind) as validator:
        told = validator.validate(known, steps).metric_evaluations
    return float(next(iter(told.values()))) if told else None


def totals(found: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """Add up what a planner made of the problems."""
    rows = list(found)
    solved = [row for row in rows if row["status"] == "solved"]
    return {
        "problems": len(rows),
        "solved": len(solved),
        "valid": sum(row["valid"] is True for row in rows),
        "wrong": sum(row["valid"] is False for row in rows),
        "median_cpu_s": statistics.median(row["cpu_s"] for row in solved) if solved else None,
        "cpu_s": round(sum(row["cpu_s"] for row in rows), 1),
    }


def page(figures: Mapping[str, Any]) -> str:
    """Write the tables."""
    found: Mapping[str, Any] = figures["planners"]
    rows = [[name, one["version"], one["call"], *_summary(one)] for name, one in found.items()]
    parts = [
        "# What other people's planners make of the printed files",
        f"`python -m tools.benchmarks.foreign` wrote this page and `foreign.json`. Each call may take "
        f"{figures['limit_cpu_s']} s of CPU. Plans are judged by unified-planning's validator.",
        table("Planner | Version | Call | Solved | Valid | CPU, median of solved [s]", rows),
    ]
    called_on, tried = (
        {name: one[about] for name, one in found.items() if one.get(about)}
        for about in ("problems", "features")
    )
    if called_on:
        names = list(dict.fromkeys(name for one in called_on.values() for name in one))
        cells = [[name, *(_cell(one.get(name)) for one in called_on.values())] for name in names]
        parts += ["CPU [s] and cost (or else length) of each plan:", table(["Problem", *called_on], cells)]
    if tried:
        titles = next(iter(tried.values()))
        cells = [[name, *(_taken(one.get(name)) for one in tried.values())] for name in titles]
        parts += [
            "What of PDDL they take; a cross tells that a small task with it was not solved, brackets "
            "that unified-planning does not read the task, so that nobody judged the plan:",
            table(["In the task", *tried], cells),
        ]
    return document(*(part.strip() for part in (*parts, *_refusals(found))))


def _summary(one: Mapping[str, Any]) -> list[str]:
    if one["not_installed"]:
        return ["not installed", "", ""]
    sums = one["totals"]
    cpu = "" if sums["median_cpu_s"] is None else number(sums["median_cpu_s"])
    return [f"{sums['solved']} of {sums['problems']}", str(sums["valid"]), cpu]


def _cell(row: Mapping[str, Any] | None) -> str:
    if row is None:
        return ""
    if row["plan_length"] is None or row["status"] == "limit":
        return str(row["status"])
    told = f"{row['cost']:.0f}" if row["cost"] is not None else f"{row['plan_length']} steps"
    judged = {True: "", False: ", not valid", None: ", not judged"}[row["valid"]]
    return f"{row['cpu_s']:.2f}, {told}{judged}"


def _taken(row: Mapping[str, Any] | None) -> str:
    if row is None:
        return ""
    return "✗" if row["status"] != "solved" else "✓" if row["valid"] else "(✓)"


def _refusals(found: Mapping[str, Any]) -> Iterable[str]:
    """Say what each planner complained of, once for each complaint."""
    for name, one in found.items():
        told: dict[str, list[str]] = {}
        for about in ("problems", "features"):
            for title, row in one.get(about, {}).items():
                if row["error"]:
                    told.setdefault(row["error"].replace("|", "\\|"), []).append(title)
        if one["not_installed"]:
            told = {one["not_installed"]: ["installing it"]}
        if told:
            lines = [f"- {listed_briefly(titles, 3)}: `{error}`" for error, titles in told.items()]
            yield f"{name} said:\n\n" + "\n".join(lines)


if __name__ == "__main__":
    tyro.cli(main)
