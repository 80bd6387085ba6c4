"""What came of learning relations over seeds, as plain values."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from statistics import mean
from typing import Any, NamedTuple

from neurosym.data.origin import StrategyName
from tools.benchmarks.jobs import Found
from tools.benchmarks.relations.tasks import Cell, slug
from tools.benchmarks.tables import mean_of


class Way(NamedTuple):
    """How interactions are chosen that relations are learned from, and what folders and jobs are called."""

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
SINGLY = "singly"  # what names of jobs begin with that try symbols of single objects
RIGHT = 0.85  # an operator has been found if it is right so often where it is promised
PUTS = "on", "in"
KEYS = {"boxes": "three into three", "sort": "unstack and sort", "swap": "swap"}
AT_PLACE = "tower of 3 at a place"


def summarise(
    hand: Mapping[str, Any], found: Found, cells: Sequence[Cell], *, seeds: int, steps: int
) -> dict[str, Any]:
    """Gather what was found, for each seed and in the mean over those that are done."""
    every, names = range(1, seeds + 1), [name for name, *_ in cells]
    each, at_random = (
        {str(seed): found[job] for seed in every if (job := f"learn-{way.label(seed)}") in found}
        for way in (CURIOUS, RANDOM)
    )
    table = {name: _cell(found, name, CURIOUS, every) for name in names}
    singly = {name: [_blocks(found, f"{SINGLY}-{seed}-{slug(name)}-") for seed in every] for name in names}
    return {
        **hand,
        "seeds": len(each),
        "steps": steps,
        **{
            f"{put}_operator_seeds": sum(
                (one["operators"][put] or {"right": 0})["right"] >= RIGHT for one in each.values()
            )
            for put in PUTS
        },
        "towers": {height: mean_of(table[f"tower of {height}"]["replanned"]) for height in ("3", "4")},
        **{key: mean_of(table[name]["replanned"]) for key, name in KEYS.items()},
        "tower_at_place": mean_of(table[AT_PLACE]["replanned"]),
        "static_bits": mean_of(one["static_bits"]["balanced"] for one in each.values()),
        "state_bits": mean_of(one["state_bits"]["balanced"] for one in each.values()),
        "recall_on": mean_of([one["recall_on"]["recall"] for one in each.values()]),
        "effect_errors": _errors([one["effect_errors"] for one in each.values()]),
        "learned": each,
        "at_random": at_random,
        "table": table,
        "table_at_random": {name: _cell(found, name, RANDOM, every) for name in names},
        "singly": {name: [mean(one) for one in of_seeds if one] for name, of_seeds in singly.items()},
    }


def _blocks(found: Found, begin: str) -> list[Any]:
    """Return what came of all tasks of a cell: they are tried some at a time, and jobs end with the first."""
    names = (name for name in found if name.startswith(begin) and name.removeprefix(begin).isdigit())
    return [one for name in names for one in found[name]]


def _cell(found: Found, name: str, way: Way, seeds: Iterable[int]) -> dict[str, Any]:
    """Gather the trials of a cell, with the shares of each seed that has some."""
    of_seeds = [_blocks(found, f"try-{way.label(seed)}-{slug(name)}-") for seed in seeds]
    known = [trials for trials in of_seeds if trials]
    every = [trial for trials in known for trial in trials]
    wrongly = [trial.get("believed", False) > trial.get("reached", False) for trial in every]
    shares = {
        what: [sum(trial.get(what, False) for trial in trials) / len(trials) for trials in known]
        for what in ("reached", "blind")
    }
    return {
        "tasks": len(every),
        "planned": sum(trial["status"] == "solved" for trial in every),
        "replanned": shares["reached"],
        "blind": shares["blind"],
        "believed_wrongly": sum(wrongly),
    }


def _errors(of_seeds: Sequence[Mapping[str, Mapping[str, float]]]) -> dict[str, dict[str, float]]:
    """Average what was measured of predicted ends over seeds, for each number of objects."""
    sizes = of_seeds[0] if of_seeds else {}
    return {size: {name: mean(one[size][name] for one in of_seeds) for name in sizes[size]} for size in sizes}
