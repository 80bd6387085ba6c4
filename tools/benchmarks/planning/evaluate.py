"""Measure what docs/planning.md claims: Table III, plans that are valid and come true, scale, and failures.

Every job writes a file of its own into a working folder, so that the run can be interrupted and goes on where
it was; what was measured with another domain is measured again. The results go to docs/results/ (planning and
scaling, each as .json, .md and .png), as far as they are known.
"""

import json
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.evaluation.comparison import TaskRecord
from neurosym.files import write_atomically
from tools.benchmarks.jobs import Evaluation, as_text, machine
from tools.benchmarks.options import CORES, OnlyReport, Results, Steps, Workers, begin, check_positive
from tools.benchmarks.planning import jobs, measures, tally, trial_jobs
from tools.benchmarks.planning.jobs import COMPARED, SIZES, Size
from tools.benchmarks.planning.pictures import draw_scaling, draw_table3
from tools.benchmarks.planning.scaling_tables import scaling_page
from tools.benchmarks.planning.tables import page
from tools.benchmarks.planning.tasks import DIFFICULTIES
from tools.benchmarks.planning.trial_tables import trial_sections

RESULTS, WORK = Path("docs/results"), Path("evaluation/planning")
REPORT_EVERY = 60.0
"""Seconds between two reports while jobs are being done."""
PAPER = {"single": {"curiosity": 0.82, "active": 0.56, "random": 0.13}}
PAPER["double"] = {"curiosity": 0.59, "active": 0.38, "random": 0.09}
"""Table III of the paper: BFS in its own simulator, with its own boxes."""


def main(
    seeds: Annotated[int, tyro.conf.arg(help="Seeds of Table III; 1 is the short form.")] = 5,
    steps: Steps = 2560,
    tasks: Annotated[
        int | None, tyro.conf.arg(help="Drawn tasks of each size; 100, or 30 in the short form.")
    ] = None,
    precise: Annotated[
        int | None, tyro.conf.arg(help="Tasks of each size tried in the shipped domain; 400, or 30 in short.")
    ] = None,
    far: Annotated[
        tuple[int, int, int] | None,
        tyro.conf.arg(help="Tasks with goals anywhere, with 1, 2 and 4 objects; 200 100 100, or 10 5 5."),
    ] = None,
    strategies: Annotated[
        tuple[jobs.Strategy, ...], tyro.conf.arg(help="Strategies of exploration that Table III compares.")
    ] = jobs.USUAL,
    learn: Annotated[bool, tyro.conf.arg(help="Learn domains; else take those that are there.")] = True,
    work: Annotated[Path, tyro.conf.arg(help="Folder for what was learned and measured.")] = WORK,
    results: Results = RESULTS,
    workers: Workers = CORES,
    only_report: OnlyReport = False,
) -> None:
    """Learn, do every job that was not done, and write the results."""
    size = jobs.size_of(seeds, steps, tasks, precise=precise, far=far, strategies=strategies)
    counts = {"seeds": seeds, "steps": steps, "workers": workers}
    check_positive(**counts, tasks=size.tasks, precise=size.precise, far=1 + min(size.far))
    evaluation = Evaluation("planning", work, results, workers)
    report = partial(write_results, evaluation, size)
    report()
    now_and_then = sparing(report, REPORT_EVERY)
    if not only_report:
        prepare_domains(work, size)
        for label, turn in turns(work, size, learn=learn):
            if label.startswith("seed"):
                prepare_domains(work, size)
            wanted = {name: job for name, job in turn.items() if "-none-" not in name}
            evaluation.perform(wanted, label, now_and_then, fresh=label == "scaling")
    report()


def turns(work: Path, size: Size, *, learn: bool) -> Iterator[jobs.Turn]:
    """List all jobs; trials come when the tasks are drawn and Table III of the shipped domain is done."""
    for label, turn in jobs.jobs_in_turn(work, size, learn=learn):
        yield label, turn
        if label == "shipped domain":
            yield from trial_jobs.trial_turns(work, size)
    yield "kinds of primitive", trial_jobs.kinds_jobs(work, size)


def sparing(report: Callable[[], None], seconds: float) -> Callable[[], None]:
    """Return a function that reports, but not if it did so a moment ago."""
    last = time.monotonic()

    def maybe() -> None:
        nonlocal last
        if time.monotonic() - last >= seconds:
            report()
            last = time.monotonic()

    return maybe


def prepare_domains(work: Path, size: Size) -> None:
    """Compile the domains of Table III that are there."""
    for strategy in size.strategies:
        for seed in range(1, size.seeds + 1):
            measures.prepare(jobs.folder_of(work, jobs.domain_name(strategy, seed)))


def write_results(evaluation: Evaluation, size: Size) -> None:
    """Write JSON, Markdown and PNG from the jobs that are done."""
    results = evaluation.results
    matrix = results / "planners.json"
    planners = json.loads(matrix.read_text()) if matrix.exists() else None
    summary = summarise(evaluation.found(), evaluation.work, size, planners)
    evaluation.write(summary, page(summary, trial_sections(summary)))
    write_atomically(results / "scaling.json", as_text(summary["scaling"]))
    write_atomically(results / "scaling.md", scaling_page(summary))
    draw_table3(summary, results / "planning.png")
    draw_scaling(summary["scaling"], results / "scaling.png")


def summarise(found: Mapping[str, Any], work: Path, size: Size, planners: Any) -> dict[str, Any]:
    """Gather jobs into tables; what is not done yet is missing."""
    every = [name for _, turn in turns(work, size, learn=False) for name in turn]
    symbolic = {
        f"{objects} {difficulty}": tally.symbolic_cell(entries)
        for objects in jobs.SYMBOLIC_OBJECTS
        for difficulty in DIFFICULTIES
        if (entries := _gathered(found, jobs.symbolic_jobs(size), f"-{objects}-{difficulty}-"))
    }
    shipped = {kind: _drawn(found, work, size, "shipped", 0.05, kind) for kind in SIZES}
    costless = {kind: _of_size(found, jobs.costless_jobs(work, size), kind) for kind in SIZES}
    nudged = {kind: _of_size(found, jobs.disturbed_jobs(work, size), kind) for kind in SIZES}
    return {
        "command": f"make evaluate-planning SEEDS={size.seeds} STEPS={size.steps} "
        f"STRATEGIES='{' '.join(size.strategies)}'",
        "versions": machine("numpy", "pybullet", "torch", "up-fast-downward"),
        "missing": sum(name not in found for name in every),
        "size": size._asdict(),
        **tally.whole(symbolic.values()),
        "symbolic": symbolic,
        "table3": table3(found, work, size, 0.05),
        "table3_at_20_mm": table3(found, work, size, 0.02),
        "paper": PAPER,
        "reasons": {kind: tally.reasons(records, COMPARED) for kind, records in shipped.items()},
        "collisions": {kind: tally.collisions(records, COMPARED) for kind, records in shipped.items()},
        "costs": {kind: tally.costs(entries, shipped[kind]) for kind, entries in costless.items()},
        "disturbed": {kind: tally.disturbed(entries) for kind, entries in nudged.items()},
        "timings": next((found[name] for name in jobs.timing_jobs(work) if name in found), None),
        "planners": planners,
        "scaling": scaling(found, size),
        **trial_jobs.summarise_trials(found, work, size),
    }


def table3(found: Mapping[str, Any], work: Path, size: Size, tolerance: float) -> dict[str, Any]:
    """Gather Table III: strategy -> single or double -> planner -> shares."""
    table = {}
    for strategy in ("shipped", *size.strategies):
        seeds = ["1"] if strategy == "shipped" else [str(seed) for seed in range(1, size.seeds + 1)]
        table[strategy] = {
            kind: tally.table3_cell(
                {seed: _drawn(found, work, size, _domain(strategy, seed), tolerance, kind) for seed in seeds},
                COMPARED,
            )
            for kind in SIZES
        }
    return table


def scaling(found: Mapping[str, Any], size: Size) -> dict[str, Any]:
    """Gather the scaling table: contender -> objects and difficulty -> figures."""
    table: dict[str, Any] = {}
    for contender in jobs.CONTENDERS:
        for objects, difficulty in jobs.cells():
            name = jobs.contender_name(size, objects, difficulty, contender)
            if name in found:
                cell = tally.scaling_cell(found[name])
                table.setdefault(contender, {})[f"{objects} {difficulty}"] = cell
    return {"cap_seconds": measures.CAP, "tasks_in_a_cell": size.scaling, "contenders": table}


def _domain(strategy: str, seed: str) -> str:
    return "shipped" if strategy == "shipped" else jobs.domain_name(strategy, int(seed))


def _drawn(
    found: Mapping[str, Any], work: Path, size: Size, domain: str, tolerance: float, kind: str
) -> list[TaskRecord]:
    return tally.records_of(_of_size(found, jobs.table3_jobs(work, size, domain, tolerance), kind))


def _of_size(found: Mapping[str, Any], names: Iterable[str], kind: str) -> list[Any]:
    """Put the entries of jobs on single or on double tasks into one list."""
    chosen = [name for name in names if name.split("-")[-3] == str(SIZES[kind])]
    return [entry for name in chosen for entry in found.get(name, [])]


def _gathered(found: Mapping[str, Any], names: Sequence[str] | Iterable[str], part: str) -> list[Any]:
    return [entry for name in names if part in name for entry in found.get(name, [])]


if __name__ == "__main__":
    begin(main)
