"""What came of learning relations over seeds, as plain values."""

from collections.abc import Mapping, Sequence
from statistics import mean
from typing import Any

from tools.benchmarks.relations.tasks import Cell, slug

RIGHT = 0.85
"""An operator has been found if it is right so often where it is promised."""
KEYS = {"boxes": "three into three", "sort": "unstack and sort", "swap": "swap"}
AT_PLACE = "tower of 3 at a place"


def summarise(
    hand: Mapping[str, Any],
    found: Mapping[str, Any],
    cells: Sequence[Cell],
    *,
    seeds: int,
    steps: int,
) -> dict[str, Any]:
    """Gather what was found, for each seed and in the mean over those that are done.

    Args:
        hand: What was measured without learning.
        found: What the jobs found, by name.
        cells: What is tried.
        seeds: How many seeds.
        steps: Interactions that are aimed at other objects.
    """
    each = {seed: found[name] for seed in range(1, seeds + 1) if (name := f"learn-{seed}") in found}
    table = {name: _cell(found, name, range(1, seeds + 1)) for name, *_ in cells}

    def reached(name: str) -> float | None:
        return _mean(table[name]["replanned"])

    return {
        **hand,
        "seeds": len(each),
        "steps": steps,
        "on_operator_seeds": _seeds_with(each, "on"),
        "in_operator_seeds": _seeds_with(each, "in"),
        "towers": {height: reached(f"tower of {height}") for height in ("3", "4")},
        **{key: reached(name) for key, name in KEYS.items()},
        "tower_at_place": reached(AT_PLACE),
        "static_bits": _mean([one["static_bits"]["balanced"] for one in each.values()]),
        "state_bits": _mean([one["state_bits"]["balanced"] for one in each.values()]),
        "recall_on": _mean([one["recall_on"]["recall"] for one in each.values()]),
        "effect_errors": _errors([one["effect_errors"] for one in each.values()]),
        "learned": {str(seed): one for seed, one in each.items()},
        "at_random": {
            name.removeprefix("random-"): one for name, one in found.items() if name.startswith("random-")
        },
        "table": table,
    }


def _cell(found: Mapping[str, Any], name: str, seeds: Sequence[int]) -> dict[str, Any]:
    """Gather the trials of a cell, with the shares of each seed that has some."""
    of_seeds = [
        [
            trial
            for job, trials in found.items()
            if job.startswith(f"try-{seed}-{slug(name)}-")
            and job.removeprefix(f"try-{seed}-{slug(name)}-").isdigit()
            for trial in trials
        ]
        for seed in seeds
    ]
    known = [trials for trials in of_seeds if trials]
    every = [trial for trials in known for trial in trials]
    return {
        "tasks": len(every),
        "planned": sum(trial["status"] == "solved" for trial in every),
        "replanned": [_share(trials, "reached") for trials in known],
        "blind": [_share(trials, "blind") for trials in known],
        "believed_wrongly": sum(
            trial.get("believed", False) > trial.get("reached", False) for trial in every
        ),
    }


def _share(trials: Sequence[Mapping[str, Any]], what: str) -> float:
    return sum(trial.get(what, False) for trial in trials) / len(trials)


def _seeds_with(each: Mapping[int, Any], name: str) -> int:
    best = [one["operators"][name] for one in each.values()]
    return sum(one is not None and one["right"] >= RIGHT for one in best)


def _errors(of_seeds: Sequence[Mapping[str, Mapping[str, float]]]) -> dict[str, dict[str, float]]:
    """Average what was measured of predicted ends over seeds, for each number of objects."""
    sizes = of_seeds[0] if of_seeds else {}
    return {size: {name: mean(one[size][name] for one in of_seeds) for name in sizes[size]} for size in sizes}


def _mean(values: Sequence[float]) -> float | None:
    return mean(values) if values else None
