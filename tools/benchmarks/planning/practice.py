"""Does practice help? `python -m tools.benchmarks.planning.practice`, into docs/results/practice.*.

A domain is practised with, and another copy of it is rehearsed evenly for as many interactions. Then the
domain and both copies are tried on the same tasks, which no practice has seen. Goes on where it was
interrupted.
"""

import shutil
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from statistics import mean
from typing import Annotated, Any

import tyro

from neurosym.evaluation.summary import markdown_table
from neurosym.pddl.compiler import CELL
from neurosym.stages.compilation import compile_stage, practice_of
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import MANIFEST, TABLE_FILES
from neurosym.stages.practice import practise_stage
from tools.benchmarks.jobs import Evaluation, machine
from tools.benchmarks.options import CORES, Results, Work, Workers, begin
from tools.benchmarks.planning.jobs import SHIPPED
from tools.benchmarks.planning.trying import Jobs, in_millimetres, in_percent, promise_rms, shares, trying

RESULTS, WORK = Path("docs/results"), Path("evaluation/practice")
HOW = ("before", "practised", "evenly")
FIRST_TASK = 200_000
"""Seed of the first task, far from those of other evaluations."""
LEFT_OUT = ("plans", "problems", "runs", *TABLE_FILES[1:])
_KEPT = ("before", "1")


def main(
    domain: Annotated[Path, tyro.conf.arg(help="The domain folder.")] = SHIPPED,
    interactions: Annotated[int, tyro.conf.arg(help="Interactions of practice.")] = 2000,
    seeds: Annotated[int, tyro.conf.arg(help="Seeds of practice.")] = 3,
    tasks: Annotated[int, tyro.conf.arg(help="Tasks with one object, and with two.")] = 100,
    work: Work = WORK,
    results: Results = RESULTS,
    workers: Workers = CORES,
) -> None:
    """Practise, try, and write what came of it."""
    evaluation = Evaluation("practice", work, results, workers)
    copies = [_KEPT, *((how, str(seed)) for how in HOW[1:] for seed in range(1, seeds + 1))]
    learning = {
        f"learn-{how}-{seed}": partial(learn, domain, work / f"{how}-{seed}", how, int(seed), interactions)
        for how, seed in copies
    }
    evaluation.perform(learning, "practising")
    tried = {
        (how, seed): trying(work / f"{how}-{seed}", f"{how}-{seed}", tasks, FIRST_TASK)
        for how, seed in copies
    }
    every = {name: job for cells in tried.values() for jobs in cells.values() for name, job in jobs.items()}
    evaluation.perform(every, "trying")
    summary = summarise(evaluation.found(), tried, interactions=interactions, tasks=tasks)
    evaluation.write(summary, page(summary))


def learn(domain: Path, folder: Path, how: str, seed: int, interactions: int) -> dict[str, Any]:
    """Copy a domain, and practise with it, or rehearse all its operators evenly.

    Returns:
        How many interactions there were, and the competence of what was practised, before and after.
    """
    if not (folder / MANIFEST).exists():
        shutil.copytree(domain, folder, ignore=shutil.ignore_patterns(*LEFT_OUT))
    copy = DomainFolder(folder)
    if how != HOW[0]:
        stage = practise_stage(copy, interactions=interactions, seed=seed, workers=1, evenly=how == "evenly")
        copy.perform(stage, again=False)
    copy.perform(compile_stage(copy, cell=CELL), again=False)
    practised = practice_of(copy)
    rounds = practised.practised.rounds if practised else ()
    lessons = [lesson for one in rounds for lesson in one.lessons]
    return {
        "spent": sum(one.spent for one in rounds),
        "rounds": len(rounds),
        "lessons": len(lessons),
        "replaced": sum(bool(lesson.replaced) for lesson in lessons),
        "before": mean(lesson.before for lesson in lessons) if lessons else None,
        "after": mean(lesson.after for lesson in lessons) if lessons else None,
    }


def summarise(
    found: Mapping[str, Any], tried: Mapping[tuple[str, str], Jobs], *, interactions: int, tasks: int
) -> dict[str, Any]:
    """Gather shares of reached goals, and what practice was."""
    of = {how: [jobs for (one, _), jobs in tried.items() if one == how] for how in HOW}
    command = f"python -m tools.benchmarks.planning.practice --interactions {interactions} --tasks {tasks}"
    return {
        "command": command,
        "versions": machine("numpy", "pybullet", "torch", "up-fast-downward"),
        "interactions": interactions,
        "tasks": tasks,
        "practice": {f"{how} {seed}": found.get(f"learn-{how}-{seed}") for how, seed in tried},
        "reached": {how: shares(found, jobs) for how, jobs in of.items()},
        "promise_rms_mm": {how: promise_rms(found, jobs) for how, jobs in of.items()},
    }


def page(summary: Mapping[str, Any]) -> str:
    """Write the tables."""
    reached = summary["reached"]
    rows = [[what, *(in_percent(reached[how][what]) for how in HOW)] for what in reached[HOW[0]]]
    missed = summary["promise_rms_mm"]
    rows += [
        [f"promises of tasks within {what} miss by [mm]", *(in_millimetres(missed[how][what]) for how in HOW)]
        for what in missed[HOW[0]]
    ]
    told = [
        [name, *(str(entry[key]) for key in ("spent", "lessons", "replaced")), *_competence(entry)]
        for name, entry in summary["practice"].items()
        if entry and entry["lessons"]
    ]
    sections = [
        "# Does practice help?",
        f"`{summary['command']}` wrote this page. {summary['interactions']} interactions of practice, or of "
        f"rehearsing all operators evenly; then {summary['tasks']} tasks of each size, drawn as the paper "
        "draws them and seen by neither. Share of goals that were reached, and root mean square of the "
        "distance between what steps promised and what came, with replanning: mean and standard deviation of "
        "the seeds.",
        markdown_table(["tasks", *HOW], rows),
        "## What was practised",
        markdown_table(
            ["copy and seed", "interactions", "lessons", "replaced", "competence before", "and after"], told
        ),
    ]
    return "\n\n".join(sections) + "\n"


def _competence(entry: Mapping[str, Any]) -> tuple[str, str]:
    return f"{entry['before']:.2f}", f"{entry['after']:.2f}"


if __name__ == "__main__":
    begin(main)
