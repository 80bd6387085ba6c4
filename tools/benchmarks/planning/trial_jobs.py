"""Jobs of `evaluate.py` that try tasks, and what they come to in `planning.json`."""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from neurosym.evaluation.paper_tables import KINDS, LEAST_OBJECTS, LEAST_SHARE, kind_of
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from tools.benchmarks.jobs import Job
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.jobs import (
    FAR_OBJECTS,
    SHIPPED,
    SIZES,
    TOLERANCES,
    Size,
    Turn,
    block_name,
    blocks,
    domain_name,
    folder_of,
    known_stamp,
    on_drawn,
    stamp,
)
from tools.benchmarks.planning.measures import TIME_LIMIT, bench_of, read_tasks
from tools.benchmarks.planning.trials import Trial, from_json, to_json, try_task

FAR_BLOCK = 5
"""Tasks with goals anywhere in one job."""
KINDS_OF = "curiosity"
"""In whose domains the kinds of primitive are counted."""


def trial_turns(work: Path, size: Size) -> list[Turn]:
    """List the jobs that try tasks in the shipped domain, what is most asked for first."""
    turns: list[Turn] = [
        (f"precision, {1000 * tolerance:g} mm", precision_jobs(work, size, tolerance))
        for tolerance in TOLERANCES
    ]
    return [turns[0], ("far goals", far_jobs(size)), *turns[1:]]


def precision_jobs(work: Path, size: Size, tolerance: float) -> dict[str, Job]:
    """List the jobs that try tasks drawn as the paper draws them."""
    prefix = f"precision-{stamp(SHIPPED)}-{1000 * tolerance:g}mm"
    return on_drawn(work, prefix, size.precise, partial(precise, SHIPPED, tolerance=tolerance))


def far_jobs(size: Size) -> dict[str, Job]:
    """List the jobs that try tasks with goals anywhere, each a few."""
    return {
        _far_name(objects, block): partial(far, SHIPPED, objects, block)
        for objects, count in zip(FAR_OBJECTS, size.far, strict=True)
        for block in blocks(count, FAR_BLOCK)
    }


def kinds_jobs(work: Path, size: Size) -> dict[str, Job]:
    """List the jobs that say which kinds of primitive there are in the domain of each seed."""
    names = [domain_name(KINDS_OF, seed) for seed in range(1, size.seeds + 1)]
    return {_kinds_name(work, name): partial(kinds, folder_of(work, name)) for name in names}


def precise(folder: Path, drawn: Path, *, tolerance: float) -> list[Any]:
    """Try tasks that were drawn, blindly and with replanning."""
    bench = bench_of(folder)
    tasks = read_tasks(bench, drawn, tolerance)
    return to_json([try_task(bench.setting, task, blind=True, time_limit=TIME_LIMIT) for task in tasks])


def far(folder: Path, objects: int, seeds: Sequence[int]) -> list[Any]:
    """Try tasks with goals anywhere, with replanning."""
    bench = bench_of(folder)
    tasks = [bench.draw(objects, seed, TOLERANCE, "anywhere") for seed in seeds]
    return to_json([try_task(bench.setting, task, blind=False) for task in tasks])


def kinds(folder: Path) -> list[str] | None:
    """Say which of the six kinds of primitive the operators of a domain are, by their rehearsals.

    Returns:
        The kinds that were found; None if the rehearsals are not kept.
    """
    grounding = bench_of(folder).setting.grounding
    return kinds_of(grounding)


def kinds_of(grounding: Grounding) -> list[str] | None:
    """Say which of the six kinds of primitive there are, by the rule of `primitive_kinds`.

    Returns:
        The kinds that were found; None if the rehearsals are not kept.
    """
    telling = {one.symbol for one in grounding.operators.categories if one.share >= LEAST_OBJECTS}
    rehearsed = [op for op in grounding.operators.operators if op.category in telling and op.rehearsals]
    if not rehearsed:
        return None
    found = set()
    for operator in rehearsed:
        told = [kind_of(one, grounding.lift_height) for one in operator.rehearsals[: operator.trials]]
        found |= {kind for kind in KINDS if told.count(kind) >= LEAST_SHARE * len(told)}
    return [kind for kind in KINDS if kind in found]


def summarise_trials(found: Mapping[str, Any], work: Path, size: Size) -> dict[str, Any]:
    """Gather trials into figures; what is not done yet is missing."""
    drawn = {
        f"{1000 * tolerance:g}": {kind: _drawn(found, work, size, tolerance, kind) for kind in SIZES}
        for tolerance in TOLERANCES
    }
    anywhere = {
        str(objects): [
            trial
            for block in blocks(count, FAR_BLOCK)
            for trial in from_json(found.get(_far_name(objects, block), []))
        ]
        for objects, count in zip(FAR_OBJECTS, size.far, strict=True)
    }
    usual = drawn["50"]
    every = [trial for trials in usual.values() for trial in trials]
    far_trials = [trial for trials in anywhere.values() for trial in trials]
    errors = figures.promise_errors(figures.steps_of(every))
    return {
        "precision": {
            mm: {kind: _precision(trials) for kind, trials in sizes.items()} for mm, sizes in drawn.items()
        },
        "far_goals": {objects: figures.share(trials) for objects, trials in anywhere.items()},
        "promise_rms_mm": {name: errors[name] for name in ("all", "worst")},
        "kinds_by_seed": {
            str(seed): found[job]
            for seed, job in enumerate(kinds_jobs(work, size), 1)
            if found.get(job) is not None
        },
        "motions": {kind: figures.motions(trials) for kind, trials in usual.items()},
        "promises": {
            "drawn, replanned": _promises(every, "replanned"),
            "drawn, blind": _promises(every, "blind"),
            "anywhere, replanned": _promises(far_trials, "replanned"),
        },
        "far_details": {objects: _far_details(trials) for objects, trials in anywhere.items()},
        "calibration": figures.calibration(every),
        "calibration_replanned": figures.calibration_replanned(every),
    }


def _precision(trials: Sequence[Trial]) -> dict[str, Any]:
    shares = {way: figures.share(trials, way) for way in ("blind", "replanned")}
    return {**shares, "tasks": len(trials)}


def _far_details(trials: Sequence[Trial]) -> dict[str, Any]:
    plans = [trial.primitives for trial in trials if trial.replanned]
    return {
        "tasks": len(trials),
        "without_plan": len(trials) - len(plans),
        "primitives": sum(plans) / len(plans) if plans else None,
        "motions": figures.motions(trials),
        "missed": figures.ended_by(trials),
    }


def _promises(trials: Sequence[Trial], way: str) -> dict[str, Any]:
    steps = figures.steps_of(trials, way)
    return {
        **figures.promise_errors(steps),
        "interval": figures.rms_interval(trials, way),
        "first": figures.first_rms(trials, way),
        "kinds_kept": figures.kinds_kept(steps),
    }


def _drawn(found: Mapping[str, Any], work: Path, size: Size, tolerance: float, kind: str) -> list[Trial]:
    names = precision_jobs(work, size, tolerance)
    chosen = [name for name in names if name.split("-")[-3] == str(SIZES[kind])]
    return [trial for name in chosen for trial in from_json(found.get(name, []))]


def _far_name(objects: int, block: Sequence[int]) -> str:
    return f"far-{stamp(SHIPPED)}-{objects}-{block_name(block)}"


def _kinds_name(work: Path, name: str) -> str:
    return f"kinds-{name}-{known_stamp(work, name)}-found"
