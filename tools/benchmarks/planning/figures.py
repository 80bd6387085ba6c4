"""Figures of trials: shares, Brier scores, and errors of promises."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from neurosym.stages.plan_records import MORE_MOTIONS
from tools.benchmarks.planning.trials import Followed, Step, Trial

BIN = 50
"""Least number of plans in a bin of the calibration."""
TELLING = 20
"""Least number of steps of a category that can be the worst."""
_RESAMPLES = 2000


def reached(trials: Sequence[Trial], way: str = "replanned") -> int:
    """Count the trials that ended at their goal; one without a plan did not."""
    runs: Iterable[Followed | None] = (getattr(trial, way) for trial in trials)
    return sum(run is not None and run.reached for run in runs)


def share(trials: Sequence[Trial], way: str = "replanned") -> float | None:
    """Return the share of trials that ended at their goal; None if there are none."""
    return reached(trials, way) / len(trials) if trials else None


def steps_of(trials: Iterable[Trial], way: str = "replanned") -> list[Step]:
    """List the steps that were executed, of all trials."""
    runs: Iterable[Followed | None] = (getattr(trial, way) for trial in trials)
    return [step for run in runs if run for step in run.steps]


def motions(trials: Sequence[Trial], way: str = "replanned") -> float | None:
    """Return the mean number of primitives performed for a task with a plan; None if there is none."""
    counts = [len(run.steps) for trial in trials if (run := getattr(trial, way))]
    return float(np.mean(counts)) if counts else None


def promise_errors(steps: Sequence[Step]) -> dict[str, Any]:
    """Say how far steps ended from their promise [mm]: RMS and median, of all and of the worst category."""
    by_category: dict[str, list[float]] = defaultdict(list)
    for step in steps:
        if step.error is not None:
            by_category[step.category].append(step.error)
    every = [error for errors in by_category.values() for error in errors]
    telling = {name: _rms(errors) for name, errors in by_category.items() if len(errors) >= TELLING}
    worst = max(telling, key=lambda name: telling[name], default=None)
    return {
        "steps": len(every),
        "all": _rms(every),
        "median": float(np.median(every)) if every else None,
        "worst": telling[worst] if worst else None,
        "worst_median": float(np.median(by_category[worst])) if worst else None,
        "worst_category": worst,
    }


def rms_interval(trials: Sequence[Trial], way: str = "replanned") -> tuple[float, float] | None:
    """Return the bootstrap interval of the RMS of promises over runs, at 95 % [mm]; None without a step.

    A few steps that went wrong decide an RMS, so it says little without this (Efron, 1979).
    """
    runs = [[step.error for step in steps_of([trial], way) if step.error is not None] for trial in trials]
    squares = np.array([np.sum(np.square(errors)) for errors in runs])
    counts = np.array([len(errors) for errors in runs])
    if not counts.sum():
        return None
    drawn = np.random.default_rng(0).integers(len(runs), size=(_RESAMPLES, len(runs)))
    means = squares[drawn].sum(1) / np.maximum(counts[drawn].sum(1), 1)
    low, high = np.quantile(np.sqrt(means), (0.025, 0.975))
    return float(low), float(high)


def first_rms(trials: Sequence[Trial], way: str = "replanned") -> float | None:
    """Return the RMS of promises of the first step of each run [mm]; None if there is no such step."""
    firsts = [steps_of([trial], way)[:1] for trial in trials]
    return _rms([step.error for steps in firsts for step in steps if step.error is not None])


def kinds_kept(steps: Sequence[Step]) -> float | None:
    """Return the share of steps that ended in the way they promised; None if none did promise."""
    told = [step for step in steps if step.kind_promised is not None]
    return sum(step.kind_seen == step.kind_promised for step in told) / len(told) if told else None


def ended_by(trials: Iterable[Trial]) -> dict[str, int]:
    """Count what ended the trials that missed: how the run ended, and the worst that happened in it."""
    counted: Counter[str] = Counter()
    for trial in trials:
        run = trial.replanned
        if run is None:
            counted[f"no plan at the start ({trial.status})"] += 1
        elif not run.reached:
            counted[f"{run.ended}: {run.kind}"] += 1
    return dict(sorted(counted.items(), key=lambda item: (-item[1], item[0])))


def calibration(trials: Iterable[Trial]) -> dict[str, Any]:
    """Compare the printed chances of plans with how often they came true, followed blindly."""
    known = [trial for trial in trials if trial.blind and trial.chance is not None]
    return _calibrated(
        np.array([trial.chance for trial in known], dtype=float),
        np.array([trial.blind.reached for trial in known if trial.blind], dtype=float),
    )


def calibration_replanned(trials: Iterable[Trial]) -> dict[str, Any]:
    """Compare the printed chances to be there in so many motions with how often plans were, planned anew."""
    known = [trial for trial in trials if trial.replanned and trial.chance_replanned is not None]
    came = [
        trial.replanned.reached and len(trial.replanned.steps) <= trial.primitives + MORE_MOTIONS
        for trial in known
        if trial.replanned
    ]
    return _calibrated(
        np.array([trial.chance_replanned for trial in known], dtype=float), np.array(came, dtype=float)
    )


def _calibrated(chances: np.ndarray, came: np.ndarray) -> dict[str, Any]:
    return {
        "plans": len(chances),
        "brier": brier(chances, came) if len(came) else None,
        "base_rate": float(came.mean()) if len(came) else None,
        "brier_of_base_rate": brier(np.full(len(came), came.mean()), came) if len(came) else None,
        "bins": bins(chances, came),
    }


def brier(chances: np.ndarray, came: np.ndarray) -> float:
    """Return the mean squared distance between chances and what came, 1 for true and 0 for false."""
    return float(np.mean((chances - came) ** 2))


def bins(chances: np.ndarray, came: np.ndarray, least: int = BIN) -> list[dict[str, float]]:
    """Cut plans by their chance into bins of nearly the same number, each of a least number of plans."""
    order = np.argsort(chances, kind="stable")
    parts = np.array_split(order, max(1, len(order) // least)) if len(order) else []
    return [
        {"plans": len(part), "chance": float(chances[part].mean()), "reached": float(came[part].mean())}
        for part in parts
    ]


def _rms(errors: Sequence[float]) -> float | None:
    return float(np.sqrt(np.mean(np.square(errors)))) if errors else None
