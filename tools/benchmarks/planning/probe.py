"""Try domain folders on a few tasks while something is being developed, with seeds that no evaluation uses.

`python -m tools.benchmarks.planning.probe DOMAIN_FOLDER...` draws tasks as the paper does, and others with
goals anywhere. Fast Downward plans, and each plan is followed blindly and with replanning. What was tried is
kept until the domain, or the source of `neurosym`, changes; so an interrupted run goes on where it was.
"""

import hashlib
import os
import statistics
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

import neurosym
from neurosym.console import say, show_table
from neurosym.grounding import Grounding
from neurosym.stages.layout import GROUNDING
from neurosym.stages.verdict import wilson
from tools.benchmarks.jobs import Job, load_jobs, perform
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.jobs import FAR_OBJECTS, SIZES, stamp
from tools.benchmarks.planning.measures import TIME_LIMIT, bench_of
from tools.benchmarks.planning.reach import FAR, primitives_needed
from tools.benchmarks.planning.trials import Trial, from_json, to_json, try_task

WORK = Path("evaluation/probe")
FAR_TOLERANCE = 0.05  # [m]
Row = list[str]


def try_one(folder: Path, objects: int, seed: int, tolerance: float, *, far: bool) -> list[Any]:
    """Draw a task, and try it.

    Args:
        folder: The domain folder.
        objects: How many objects.
        seed: Same seed, same task.
        tolerance: How near each object must come to its goal [m].
        far: Whether the goal is anywhere on the table; such a plan is not followed blindly.
    """
    bench = bench_of(folder)
    task = bench.draw(objects, seed, tolerance, "anywhere" if far else None)
    limit = None if far else TIME_LIMIT
    return to_json([try_task(bench.setting, task, blind=not far, time_limit=limit)])


def main(
    folders: Annotated[tuple[Path, ...], tyro.conf.Positional],
    singles: Annotated[int, tyro.conf.arg(help="Drawn tasks with one object.")] = 40,
    doubles: Annotated[int, tyro.conf.arg(help="Drawn tasks with two objects.")] = 40,
    far: Annotated[str, tyro.conf.arg(help="Tasks anywhere, with 1, 2 and 4 objects.")] = "40,20,10",
    tolerances: Annotated[str, tyro.conf.arg(help="Tolerances of drawn tasks [mm].")] = "50,20",
    seed_from: Annotated[int, tyro.conf.arg(help="First seed of the tasks.")] = 100_000,
    workers: Annotated[int, tyro.conf.arg(help="Tasks at once.")] = 1,
    work: Annotated[Path, tyro.conf.arg(help="Folder for what was tried.")] = WORK,
    label: Annotated[str | None, tyro.conf.arg(help="Stands for the source, if given.")] = None,
) -> None:
    """Try tasks in each domain folder, and print a table for each.

    Args:
        folders: Domain folders.
        singles: Drawn tasks with one object.
        doubles: Drawn tasks with two objects.
        far: How many tasks with goals anywhere, by the number of objects.
        tolerances: Tolerances of drawn tasks [mm].
        seed_from: First seed of the tasks.
        workers: Tasks at once.
        work: Folder for what was tried.
        label: Stands for the source in the names of what was tried; its hash if not given.
    """
    millimetres = [int(part) for part in tolerances.split(",")]
    counts = dict(zip(FAR_OBJECTS, map(int, far.split(",")), strict=False))
    (work / "jobs").mkdir(parents=True, exist_ok=True)
    for folder in folders:
        prefix = f"{stamp(folder)}-{label or source_stamp()}"
        drawn = {
            (kind, mm): drawn_jobs(folder, prefix, SIZES[kind], mm, range(seed_from, seed_from + count))
            for mm in millimetres
            for kind, count in (("single", singles), ("double", doubles))
        }
        anywhere = {
            objects: far_jobs(folder, prefix, objects, range(seed_from, seed_from + count))
            for objects, count in counts.items()
        }
        every = {name: job for jobs in (*drawn.values(), *anywhere.values()) for name, job in jobs.items()}
        perform(work / "jobs", every, workers, lambda: None, label=folder.name)
        found = load_jobs(work / "jobs")
        rows = table(
            {key: _trials(found, jobs) for key, jobs in drawn.items()},
            {objects: _trials(found, jobs) for objects, jobs in anywhere.items()},
        )
        show_table(str(folder), ["what", "figure"], [*rows, *reach_rows(folder)])
    say(f"what was tried is in {work / 'jobs'}")


def source_stamp() -> str:
    """Tell this source of `neurosym` from others."""
    root = Path(neurosym.__file__).parent
    content = b"".join(path.read_bytes() for path in sorted(root.rglob("*.py")))
    return hashlib.sha256(content).hexdigest()[:8]


def drawn_jobs(folder: Path, prefix: str, objects: int, mm: int, seeds: Sequence[int]) -> dict[str, Job]:
    """List the jobs that try tasks drawn as the paper draws them, one each."""
    return {
        f"drawn-{prefix}-{objects}-{mm}mm-{seed}": partial(
            try_one, folder, objects, seed, mm / 1000, far=False
        )
        for seed in seeds
    }


def far_jobs(folder: Path, prefix: str, objects: int, seeds: Sequence[int]) -> dict[str, Job]:
    """List the jobs that try tasks with goals anywhere, one each."""
    return {
        f"far-{prefix}-{objects}-{seed}": partial(try_one, folder, objects, seed, FAR_TOLERANCE, far=True)
        for seed in seeds
    }


def table(drawn: dict[tuple[str, int], list[Trial]], far: dict[int, list[Trial]]) -> list[Row]:
    """Say what became of the tasks in one domain.

    Args:
        drawn: Trials of drawn tasks, by `single` or `double` and the tolerance [mm].
        far: Trials of tasks with goals anywhere, by the number of objects.
    """
    rows = []
    for (kind, mm), trials in drawn.items():
        rows.append([f"{kind}, {mm} mm, blind", _reached(trials, "blind")])
        rows.append([f"{kind}, {mm} mm, replanned", _reached(trials)])
    rows += [[f"anywhere, {objects} objects", _reached(trials)] for objects, trials in far.items()]
    groups = {f"{kind}, {mm} mm": trials for (kind, mm), trials in drawn.items()}
    groups |= {f"anywhere, {objects} objects": trials for objects, trials in far.items()}
    for name, trials in groups.items():
        plans = [trial.primitives for trial in trials if trial.replanned]
        length = sum(plans) / len(plans) if plans else None
        rows.append([f"motions, {name}", f"{_number(figures.motions(trials))} (plans: {_number(length)})"])
    both = [trial for trials in drawn.values() for trial in trials]
    everything = [trial for trials in groups.values() for trial in trials]
    for name, steps in (
        ("drawn, blind", figures.steps_of(both, "blind")),
        ("drawn, replanned", figures.steps_of(both)),
        ("anywhere", figures.steps_of(trial for trials in far.values() for trial in trials)),
    ):
        errors, kept = figures.promise_errors(steps), figures.kinds_kept(steps)
        told = f"RMS {_number(errors['all'])}, median {_number(errors['median'])}"
        worst = f"{_number(errors['worst'])}, {_number(errors['worst_median'])} ({errors['worst_category']})"
        rows.append([f"promise error [mm], {name}", f"{told}; worst {worst}; {errors['steps']} steps"])
        rows.append([f"kinds kept, {name}", "-" if kept is None else f"{100 * kept:.0f} %"])
    for name, trials in groups.items():
        ended = ", ".join(f"{how} ({count})" for how, count in figures.ended_by(trials).items())
        rows.append([f"missed, {name}", ended or "-"])
    cpu = [trial.cpu for trial in everything]
    rows.append(["CPU seconds a task", _number(sum(cpu) / len(cpu) if cpu else None)])
    return rows


def reach_rows(folder: Path) -> list[Row]:
    """Say for each category how many primitives move an object far, in the median and the worst direction.

    Args:
        folder: The domain folder.
    """
    rows = []
    for category, needed in primitives_needed(Grounding.load(folder / GROUNDING)).items():
        worst = max(needed, key=lambda name: needed[name])
        told = f"median {statistics.median(needed.values()):.1f}, {worst} {needed[worst]:.1f}"
        rows.append([f"primitives for {1000 * FAR:.0f} mm, {category}", told])
    return rows


def _trials(found: dict[str, Any], jobs: dict[str, Job]) -> list[Trial]:
    return [trial for name in jobs if name in found for trial in from_json(found[name])]


def _reached(trials: Sequence[Trial], way: str = "replanned") -> str:
    if not trials:
        return "-"
    count = figures.reached(trials, way)
    low, high = wilson(count, len(trials))
    return f"{count} of {len(trials)}: {count / len(trials):.0%} ({low:.0%} to {high:.0%})"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.1f}"


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # for the jobs, of which there may be several at once
    tyro.cli(main)
