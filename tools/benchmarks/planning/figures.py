"""Figures of trials: shares, Brier scores, and errors of promises."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from neurosym.stages.plan_records import MORE_MOTIONS
from tools.benchmarks.planning.trials import Step, Trial
from tools.benchmarks.tables import mean_of, share_of, tally

BIN = 50  # least number of plans in a bin of the calibration
TELLING = 20  # least number of steps of a category that can be the worst
WAYS = ("blind", "replanned")
_RESAMPLES = 2000


def share(trials: Sequence[Trial], way: str = "replanned") -> float | None:
    """Return the share of trials that ended at their goal, which needs a plan; None if there are none."""
    runs = [getattr(trial, way) for trial in trials]
    return share_of(sum(run is not None and run.reached for run in runs), len(runs))


def steps_of(trials: Iterable[Trial], way: str = "replanned") -> list[Step]:
    """List the steps that were executed, of all trials."""
    return [step for trial in trials if (run := getattr(trial, way)) for step in run.steps]


def motions(trials: Sequence[Trial]) -> float | None:
    """Return the mean number of primitives performed for a task with a plan; None if there is none."""
    return mean_of(len(trial.replanned.steps) for trial in trials if trial.replanned)


def promise_errors(steps: Sequence[Step]) -> dict[str, Any]:
    """Say how far steps ended from their promise [mm]: RMS and median, of all and of the worst category."""
    by_category: dict[str, list[float]] = defaultdict(list)
    for step in steps:
        if step.error is not None:
            by_category[step.category].append(step.error)
    every = [error for errors in by_category.values() for error in errors]
    telling = {name: _rms(errors) for name, errors in by_category.items() if len(errors) >= TELLING}
    worst = max(telling, key=lambda name: telling[name] or 0.0, default="")
    return {
        "steps": len(every),
        "all": _rms(every),
        "median": float(np.median(every)) if every else None,
        "worst": telling.get(worst),
        "worst_median": float(np.median(by_category[worst])) if worst else None,
        "worst_category": worst or None,
    }


def promises(trials: Sequence[Trial], way: str) -> dict[str, Any]:
    """Say how far steps ended from their promise [mm], the first ones, too, and whether in its way."""
    steps = steps_of(trials, way)
    firsts = [step for trial in trials for step in steps_of([trial], way)[:1]]
    told = [step for step in steps if step.kind_promised is not None]
    kept = sum(step.kind_seen == step.kind_promised for step in told)
    return {
        **promise_errors(steps),
        "interval": rms_interval(trials, way),
        "first": _rms([step.error for step in firsts if step.error is not None]),
        "kinds_kept": kept / len(told) if told else None,
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


def ended_by(trials: Iterable[Trial]) -> dict[str, int]:
    """Count what ended the trials that missed: how the run ended, and the worst that happened in it."""
    return tally(
        f"{trial.replanned.ended}: {trial.replanned.kind}"
        if trial.replanned
        else f"no plan at the start ({trial.status})"
        for trial in trials
        if not (trial.replanned and trial.replanned.reached)
    )


def calibration(trials: Iterable[Trial]) -> dict[str, Any]:
    """Compare the printed chances of plans with how often they came true, followed blindly."""
    return _calibrated(
        [(trial.chance, trial.blind.reached) for trial in trials if trial.blind and trial.chance is not None]
    )


def calibration_replanned(trials: Iterable[Trial]) -> dict[str, Any]:
    """Compare the printed chances to be there in so many motions with how often plans were, planned anew."""
    return _calibrated(
        [
            (trial.chance_replanned, run.reached and len(run.steps) <= trial.primitives + MORE_MOTIONS)
            for trial in trials
            if (run := trial.replanned) and trial.chance_replanned is not None
        ]
    )


def _calibrated(pairs: Sequence[tuple[float, bool]]) -> dict[str, Any]:
    """Compare chances with what came: the Brier score is the mean squared distance between the two.

    Plans are cut by their chance into bins of nearly the same number, each of `BIN` plans at least.
    """
    chances, came = np.array(pairs, dtype=float).reshape(-1, 2).T
    order = np.argsort(chances, kind="stable")
    bins = np.array_split(order, max(1, len(order) // BIN)) if len(order) else []
    return {
        "plans": len(chances),
        "brier": mean_of(((chances - came) ** 2).tolist()),
        "base_rate": mean_of(came.tolist()),
        "brier_of_base_rate": mean_of(((came - (mean_of(came.tolist()) or 0.0)) ** 2).tolist()),
        "bins": [
            {"plans": len(part), "chance": float(chances[part].mean()), "reached": float(came[part].mean())}
            for part in bins
        ],
    }


def _rms(errors: Sequence[float]) -> float | None:
    return float(np.sqrt(np.mean(np.square(errors)))) if errors else None
