"""What came of learning relations over seeds, as plain values."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean
from typing import Any

from neurosym.data.origin import StrategyName
from tools.benchmarks.relations.tasks import Cell, slug


@dataclass(frozen=True, slots=True)
class Way:
    """How interactions are chosen that relations are learned from.

    Attributes:
        strategy: Its name.
        prefix: What the names of folders begin with.
        mark: What comes before the seed in names of jobs.
    """

    strategy: StrategyName
    prefix: str
    mark: str = ""

    def folder(self, work: Path, seed: int) -> Path:
        """Return where the domain of a seed lies."""
        return work / f"{self.prefix}-{seed}"

    def label(self, seed: int) -> str:
        """Name a seed in names of jobs."""
        return f"{self.mark}{seed}"


CURIOUS, RANDOM = Way("disagreement", "seed"), Way("random", "random", "random-")
SINGLY, FIRST = "singly", "begun"
"""What the names of jobs begin with that try symbols of single objects, and that learn from few
interactions."""
RIGHT = 0.85
"""An operator has been found if it is right so often where it is promised."""
PUTS = "on", "in"
KEYS = {"boxes": "three into three", "sort": "unstack and sort", "swap": "swap"}
AT_PLACE = "tower of 3 at a place"


def summarise(
    hand: Mapping[str, Any], found: Mapping[str, Any], cells: Sequence[Cell], *, seeds: int, steps: int
) -> dict[str, Any]:
    """Gather what was found, for each seed and in the mean over those that are done."""
    every = range(1, seeds + 1)
    each, at_random = (_learned(found, way, every) for way in (CURIOUS, RANDOM))
    table = {name: _cell(found, name, CURIOUS, every) for name, *_ in cells}

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
        "at_random": {str(seed): one for seed, one in at_random.items()},
        "table": table,
        "table_at_random": {name: _cell(found, name, RANDOM, every) for name, *_ in cells},
        "singly": {name: _singly(found, name, every) for name, *_ in cells},
        "first": {way.strategy: _after_first(found, way, every) for way in (CURIOUS, RANDOM)},
    }


def _after_first(found: Mapping[str, Any], way: Way, seeds: Sequence[int]) -> dict[str, Any]:
    """Gather what could be done after the first interactions.

    Returns:
        For each number of interactions the mean share in which what puts on and what puts in is right, 0
        where there is none; and for each seed the first number after which both are.
    """
    of_seeds = [one for seed in seeds if (one := found.get(f"{FIRST}-{way.label(seed)}"))]
    rows = [
        {
            "interactions": after[0]["interactions"],
            **{name: mean(_right(one[name]) for one in after) for name in PUTS},
            "borne": mean(one["borne"] / one["interactions"] for one in after),
        }
        for after in zip(*of_seeds, strict=True)
    ]
    both = [
        next((row["interactions"] for row in one if min(_right(row[put]) for put in PUTS) >= RIGHT), None)
        for one in of_seeds
    ]
    return {"after": rows, "until_both": both}


def _right(found: Mapping[str, float] | None) -> float:
    return found["right"] if found else 0.0


def _learned(found: Mapping[str, Any], way: Way, seeds: Sequence[int]) -> dict[int, Any]:
    names = {seed: f"learn-{way.label(seed)}" for seed in seeds}
    return {seed: found[name] for seed, name in names.items() if name in found}


def _singly(found: Mapping[str, Any], name: str, seeds: Sequence[int]) -> list[float]:
    """Return the share that symbols of single objects reached of a cell, for each seed that was tried."""
    of_seeds = (_blocks(found, f"{SINGLY}-{seed}-{slug(name)}-") for seed in seeds)
    return [mean(reached) for reached in of_seeds if reached]


def _blocks(found: Mapping[str, Any], begin: str) -> list[Any]:
    """Return what came of all tasks of a cell: they are tried some at a time, and jobs end with the first."""
    return [
        one
        for job, tried in found.items()
        if job.startswith(begin) and job.removeprefix(begin).isdigit()
        for one in tried
    ]


def _cell(found: Mapping[str, Any], name: str, way: Way, seeds: Sequence[int]) -> dict[str, Any]:
    """Gather the trials of a cell, with the shares of each seed that has some."""
    of_seeds = [_blocks(found, f"try-{way.label(seed)}-{slug(name)}-") for seed in seeds]
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
