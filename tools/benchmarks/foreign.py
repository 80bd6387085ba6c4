"""What other people's planners make of the printed files: `python -m tools.benchmarks.foreign`.

Ten planners from the package index are called as a researcher would who has never heard of neurosym, on
copies of a printed domain and problem. The table says what each solves, in how much CPU, and whether its
plans are valid: unified-planning's validator judges them by the printed files. `--features` tries small tasks
beside, each with one thing of PDDL. Each planner gets an environment of its own, below `--venvs`. What was
measured is kept below `--work`, and not measured again while neither files nor call change. Writes
foreign.json and foreign.md.
"""

import contextlib
import hashlib
import json
import os
import resource
import signal
import statistics
import subprocess
import tempfile
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.errors import listed_briefly
from neurosym.evaluation.summary import markdown_table
from neurosym.files import write_atomically
from neurosym.pddl.compiler import Action, Tree, tree_of
from neurosym.planners.unified_planning import validate_pddl
from neurosym.stages.console import say
from tools.benchmarks.foreign_calls.features import FEATURES
from tools.benchmarks.foreign_calls.planners import (
    COMPLAINED,
    PLANNERS,
    PRINTED,
    Planner,
    error_in,
    install,
    steps_in,
)
from tools.benchmarks.jobs import as_text, machine
from tools.benchmarks.places import ROOT

CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "neurosym-foreign"
LIMIT = 60
MEMORY = 8 << 30
"""How much a planner may address [bytes]."""
DOMAINS = ("tabletop", "tabletop-paper", "places", "towers")
EACH = 5
"""How many problems of each domain are tried."""
NAMED = ("towers/tower-4-03", "places/row-4-12", "tabletop/task-07")
"""Problems that are tried besides."""
OBJECTS = range(1, 9)
"""With how many objects."""


@dataclass(frozen=True, slots=True)
class Printed:
    """What a printed domain and its problems are called.

    Attributes:
        domain: Name of the domain's file.
        problem: What follows a problem's name.
        plain: Whether they tell no costs.
    """

    domain: str
    problem: str
    plain: bool = False


FILES = (Printed("domain.pddl", ".pddl"), Printed("domain-plain.pddl", ".plain.pddl", plain=True))
"""The files that are looked for, in this order; planners that take no costs look for plain ones first."""


@dataclass(frozen=True, slots=True)
class Task:
    """What a planner is given: the texts of a domain and of a problem.

    Attributes:
        name: What the table calls it.
        plain: Whether it tells no costs.
    """

    name: str
    domain: str
    problem: str
    plain: bool = False

    def digest(self, planner: Planner, limit: int) -> str:
        """Return what stands for the task and a call, as long as neither changes.

        Args:
            planner: What is called.
            limit: CPU that it may take [s].
        """
        all_of_it = "\0".join([self.domain, self.problem, planner.call_text(), str(limit)])
        return hashlib.sha256(all_of_it.encode()).hexdigest()[:16]


def main(
    domains: Annotated[Path, tyro.conf.arg(help="Folder of the domains.")] = ROOT / "domains",
    planners: Annotated[str, tyro.conf.arg(help="Names of planners, with commas; all if empty.")] = "",
    problems: Annotated[
        str,
        tyro.conf.arg(help="Problems as domain/name, with commas; some of each domain if empty, none if -."),
    ] = "",
    features: Annotated[bool, tyro.conf.arg(help="Try the small tasks, too.")] = False,
    limit: Annotated[int, tyro.conf.arg(help="CPU that a call may take [s].")] = LIMIT,
    venvs: Annotated[Path, tyro.conf.arg(help="Folder for the planners' environments.")] = CACHE / "venvs",
    work: Annotated[Path, tyro.conf.arg(help="Folder for what was measured.")] = CACHE / "work",
    output: Annotated[Path, tyro.conf.arg(help="File for the figures; the table is beside it.")] = Path(
        "docs/results/foreign.json"
    ),
) -> None:
    """Install planners, call them, judge their plans, and write the table and the figures."""
    named = [name for name in planners.split(",") if name] or list(PLANNERS)
    if unknown := [name for name in named if name not in PLANNERS]:
        raise SystemExit(f"There is no planner {unknown[0]}; there are {', '.join(PLANNERS)}.")
    chosen = [one for one in problems.split(",") if one] or shipped(domains)
    chosen = [] if problems == "-" else chosen
    kept = json.loads(output.read_text()) if output.exists() else {}
    found: dict[str, Any] = kept.get("planners", {})
    for name in named:
        planner = PLANNERS[name]
        refused = install(planner, venvs)
        one = found.get(name, {}) | {
            "version": planner.version,
            "call": planner.told,
            "not_installed": refused,
        }
        found[name] = one
        if refused:
            say(f"{name} cannot be installed: {refused}")
            continue
        words = planner.words(venvs, limit)
        one["problems"] = still_true(one.get("problems", {}), domains, planner, limit)
        for task in (task_of(domains, problem, planner.costs) for problem in chosen):
            one["problems"][task.name] = measured(name, task, words, work, limit)
        if features:
            tasks = [Task(title, *each.task()) for title, each in FEATURES.items()]
            one["features"] = {task.name: measured(name, task, words, work, limit) for task in tasks}
        one["totals"] = totals(one["problems"].values())
    found = {name: found[name] for name in PLANNERS if name in found}
    figures = {"machine": machine(), "limit_cpu_s": limit, "planners": found}
    write_atomically(output, as_text(figures))
    write_atomically(output.with_suffix(".md"), page(figures))
    say(f"wrote {output}")


def shipped(domains: Path) -> list[str]:
    """Choose problems of each domain, evenly over how many objects they have.

    Only those with a shipped plan count, where there are any. Of those with as many objects, the first by
    name counts that was not chosen yet.
    """
    chosen = []
    for domain in DOMAINS:
        scenes = sorted((domains / domain / "problems").glob("*.scene.json"))
        left = {path.name.partition(".")[0]: len(json.loads(path.read_text())["objects"]) for path in scenes}
        left = {
            name: count for name, count in left.items() if count in OBJECTS and _files(domains / domain, name)
        }
        planned = {path.name.partition(".")[0] for path in (domains / domain / "plans").glob("*.plan")}
        left = {name: count for name, count in left.items() if name in planned or not planned}
        low, high = min(left.values(), default=0), max(left.values(), default=0)
        for number in range(min(EACH, len(left))):
            wanted = low + (high - low) * number / (EACH - 1)
            name = min(left, key=lambda each: (abs(left[each] - wanted), each))
            del left[name]
            chosen.append(f"{domain}/{name}")
    besides = (
        one for one in NAMED if one not in chosen and _files(domains / Path(one).parent, Path(one).name)
    )
    return [*chosen, *besides]


def _files(folder: Path, name: str, costs: bool = True) -> tuple[Path, Path, bool] | None:
    """Return the printed domain and problem that there are, and whether they tell no costs."""
    for printed in sorted(FILES, key=lambda each: each.plain == costs):
        domain, problem = folder / printed.domain, folder / "problems" / f"{name}{printed.problem}"
        if domain.exists() and problem.exists():
            return domain, problem, printed.plain
    return None


def task_of(domains: Path, problem: str, costs: bool) -> Task:
    """Read a printed problem."""
    domain, _, name = problem.partition("/")
    files = _files(domains / domain, name, costs)
    if files is None:
        raise SystemExit(f"There is no printed problem {problem} below {domains}.")
    return Task(problem, files[0].read_text(), files[1].read_text(), files[2])


def still_true(kept: Mapping[str, Any], domains: Path, planner: Planner, limit: int) -> dict[str, Any]:
    """Return what was found earlier of files and calls that have not changed.

    Args:
        kept: Figures by problem.
        domains: Folder of the domains.
        planner: Whose they are.
        limit: CPU that it may take [s].
    """
    true: dict[str, Any] = {}
    for problem, figures in kept.items():
        domain, _, name = problem.partition("/")
        if _files(domains / domain, name, planner.costs):
            digest = task_of(domains, problem, planner.costs).digest(planner, limit)
            true |= {problem: figures} if figures["digest"] == digest else {}
    return true


def measured(name: str, task: Task, words: Sequence[str], work: Path, limit: int) -> dict[str, Any]:
    """Call a planner on a task and judge its plan, or take what was found earlier.

    Args:
        name: The planner.
        task: The task.
        words: Its command line.
        work: Folder for what was measured.
        limit: CPU that it may take [s].
    """
    digest = task.digest(PLANNERS[name], limit)
    path = work / f"{digest}.json"
    if path.exists():
        found: dict[str, Any] = json.loads(path.read_text())
        return found
    with tempfile.TemporaryDirectory(prefix="neurosym-foreign-") as scratch:
        folder = Path(scratch)
        (folder / "domain.pddl").write_text(task.domain)
        (folder / "problem.pddl").write_text(task.problem)
        cpu, clock, code = called(words, folder, limit)
        plan = plan_in(folder, PLANNERS[name])
        error = error_in(*(_text(folder / each) for each in (COMPLAINED, PRINTED))) or (
            f"exit code {code}, and no plan" if code else "no plan, and no word why"
        )
    found = {
        "status": "solved",
        "cpu_s": round(cpu, 2),
        "wall_s": round(clock, 2),
        "digest": digest,
        **judged(task, plan),
    }
    if plan is None:
        found |= {"status": "limit" if cpu > limit or code is None else "failed", "error": error}
        found |= {"error": ""} if found["status"] == "limit" else {}
    elif cpu > limit:
        found |= {"status": "limit"}
    elif found["valid"] is False:
        found |= {"status": "wrong", "error": found["judge"]}
    work.mkdir(parents=True, exist_ok=True)
    write_atomically(path, as_text(found))
    say(f"{name}, {task.name}: {found['status']}, {found['cpu_s']} s {found['error']}")
    return found


def called(words: Sequence[str], folder: Path, limit: int) -> tuple[float, float, int | None]:
    """Call a planner in a folder; return the CPU of its processes [s], the time [s], and its exit code.

    It is ended, with all that it started, after so much CPU in a process, or twice as long by the clock; its
    exit code is None then, and the CPU that of the processes that had ended.

    Args:
        words: The command line.
        folder: Where it is called.
        limit: The CPU that it may take [s].
    """
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "VIRTUAL_ENV"))}
    clean |= {"OMP_NUM_THREADS": "1", "HOME": str(folder)}
    begin = time.monotonic()
    with (folder / PRINTED).open("w") as printed, (folder / COMPLAINED).open("w") as complained:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        limits = f'ulimit -c 0; ulimit -t {limit + 1}; ulimit -v {MEMORY // 1024}; exec "$@"'
        process = subprocess.Popen(
            ["bash", "-c", limits, "bash", *words],
            cwd=folder,
            env=clean,
            stdin=subprocess.DEVNULL,
            stdout=printed,
            stderr=complained,
            start_new_session=True,
        )
        code: int | None = None
        try:
            code = process.wait(2 * limit)
        except subprocess.TimeoutExpired:
            pass
        finally:
            _end(process)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    ended = code in (-signal.SIGKILL, -signal.SIGXCPU)
    return cpu, time.monotonic() - begin, None if ended else code


def _end(process: "subprocess.Popen[bytes]") -> None:
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def _text(path: Path) -> str:
    return path.read_text(errors="replace") if path.exists() else ""


def plan_in(folder: Path, planner: Planner) -> list[Action] | None:
    """Read the plan that a planner left; None if it left none."""
    files = [path for path in sorted(folder.glob(planner.plans)) if path.is_file()]
    return (steps_in(_text(files[-1])) or None) if files else None


def judged(task: Task, plan: list[Action] | None) -> dict[str, Any]:
    """Say whether a plan is valid by the printed files, and what it costs."""
    if plan is None:
        return {"plan_length": None, "cost": None, "valid": None, "judge": "", "error": ""}
    told = {"plan_length": len(plan), "cost": cost_of(task, plan)}
    try:
        verdict = validate_pddl(task.domain, task.problem, plan)
    except Exception as error:  # it is not ours, and trips over what it does not know
        return {**told, "valid": None, "judge": str(error)[:300], "error": ""}
    return {**told, "valid": verdict.valid, "judge": verdict.reason, "error": ""}


def cost_of(task: Task, plan: Sequence[Action]) -> float | None:
    """Add up what the steps of a plan cost by the printed files; None where these tell no costs."""
    parts = tree_of(task.domain)
    actions = {str(part[1]): part for part in parts if part[0] == ":action" and isinstance(part, list)}
    start = next(part for part in tree_of(task.problem) if part[0] == ":init")
    values = {_words(fact[1]): float(str(fact[2])) for fact in start if fact[0] == "=" and len(fact) == 3}
    if "(increase" not in task.domain or any(step[0] not in actions for step in plan):
        return None
    total = 0.0
    for name, *arguments in plan:
        action = actions[name]
        parameters = [word for word in action[action.index(":parameters") + 1] if word.startswith("?")]  # type: ignore[union-attr]
        given = dict(zip(map(str, parameters), arguments, strict=False))
        for amount in _amounts(action):
            words = _words(amount)
            ground = tuple(given.get(word, word) for word in words)
            total += values.get(ground, 0.0) if isinstance(amount, list) else float(words[0])
    return total


def _amounts(tree: "Tree | str") -> "Iterable[Tree | str]":
    if isinstance(tree, list):
        if tree and tree[0] == "increase":
            yield tree[2]
        for each in tree:
            yield from _amounts(each)


def _words(tree: "Tree | str") -> tuple[str, ...]:
    return (tree,) if isinstance(tree, str) else tuple(map(str, tree))


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
        markdown_table(["Planner", "Version", "Call", "Solved", "Valid", "CPU, median of solved [s]"], rows),
    ]
    names = list(dict.fromkeys(name for one in found.values() for name in one.get("problems", {})))
    called_on = {name: one for name, one in found.items() if one.get("problems")}
    if names:
        cells = [[name, *(_cell(one["problems"].get(name)) for one in called_on.values())] for name in names]
        parts += ["CPU [s] and cost (or else length) of each plan:"]
        parts += [markdown_table(["Problem", *called_on], cells)]
    tried = {name: one["features"] for name, one in found.items() if one.get("features")}
    if tried:
        cells = [[name, *(_taken(one.get(name)) for one in tried.values())] for name in FEATURES]
        parts += [
            "What of PDDL they take; a cross tells that a small task with it was not solved, brackets "
            "that unified-planning does not read the task, so that nobody judged the plan:"
        ]
        parts += [markdown_table(["In the task", *tried], cells)]
    return "\n\n".join(part.strip() for part in (*parts, *_refusals(found))) + "\n"


def _summary(one: Mapping[str, Any]) -> list[str]:
    if one["not_installed"]:
        return ["not installed", "", ""]
    sums = one["totals"]
    cpu = "" if sums["median_cpu_s"] is None else f"{sums['median_cpu_s']:.2f}"
    return [f"{sums['solved']} of {sums['problems']}", str(sums["valid"]), cpu]


def _cell(row: Mapping[str, Any] | None) -> str:
    if row is None:
        return ""
    if row["plan_length"] is None or row["status"] == "limit":
        return str(row["status"])
    told = f"{row['cost']:.0f}" if row["cost"] is not None else f"{row['plan_length']} steps"
    return (
        f"{row['cpu_s']:.2f}, {told}" + {True: "", False: ", not valid", None: ", not judged"}[row["valid"]]
    )


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
