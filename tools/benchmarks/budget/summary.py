"""What came of budgets, as plain values and as a page of Markdown tables."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from tools.benchmarks.jobs import Found, machine
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.trials import trials_of
from tools.benchmarks.tables import document, mean_of, table, with_interval


class Cell(NamedTuple):
    """What is tried: tasks of a size, within a tolerance [m]."""

    name: str
    objects: int
    tolerance: float
    count: int
    is_far: bool = False


TOTALS = (1000, 2000, 4000, 5000, 6000, 8000, 10_000, 16_000)
STAGES = "stages"
_DRAWN = Cell("single", 1, 0.05, 100), Cell("double", 2, 0.05, 100)
_PRECISE = Cell("single-20", 1, 0.02, 50), Cell("double-20", 2, 0.02, 50)
_FAR = tuple(Cell(f"far-{n}", n, 0.05, 25, True) for n in (1, 2, 4))
_CURVE = {
    total: _DRAWN + (_PRECISE if total in (2000, 8000) else ()) for total in (1000, 2000, 4000, 8000, 16_000)
}
WAYS: Mapping[str, Mapping[int, tuple[Cell, ...]]] = {
    "one-budget": _CURVE | {6000: _DRAWN + _PRECISE},
    "random": _CURVE,
    "entropy": _CURVE,
    STAGES: {total: _CURVE[total] for total in (2000, 4000, 8000)},
    "with-places": {5000: _FAR, 10_000: _FAR + _DRAWN},
}
"""Ways to spend a budget, after how many interactions each is tried, and on what."""
MUST = {"drawn": {"single": 0.95, "double": 0.85}, "places": {"far-1": 1.0, "far-2": 0.96, "far-4": 0.96}}
_HOW = {"drawn": "blind", "places": "replanned"}


def domain_name(way: str, seed: int, total: int) -> str:
    """Name what was learned in a way from so many interactions."""
    return f"{way}-{seed}-{total}"


def summarise(found: Found) -> dict[str, Any]:
    """Gather the shares of reached goals, for each seed and in the mean."""
    learned = [name.removeprefix("learn-").rsplit("-", 2) for name in found if name.startswith("learn-")]
    shares: dict[str, dict[str, Any]] = {}
    for way in WAYS:
        for total, cells in WAYS[way].items():
            seeds = sorted(int(seed) for of, seed, at in learned if (of, int(at)) == (way, total))
            for cell in cells if seeds else ():
                begin = [f"try-{domain_name(way, seed, total)}-{cell.name}-" for seed in seeds]
                trials = [trials_of(found, [n for n in found if n.startswith(one)]) for one in begin]
                told = {how: [figures.share(of_one, how) for of_one in trials] for how in figures.WAYS}
                shares.setdefault(way, {}).setdefault(str(total), {})[cell.name] = {
                    **told,
                    "tasks": sum(map(len, trials)),
                }
    taken = {name.removeprefix("learn-"): found[name] for name in found if name.startswith("learn-")}
    return {
        "command": "make evaluate-budget",
        "versions": machine("numpy", "pybullet", "torch", "up-fast-downward"),
        "interactions_for": {
            "drawn": _first(shares.get("one-budget", {}), "drawn"),
            "places": _first(shares.get("with-places", {}), "places"),
        },
        "blind_at_2000": {way: _mean(shares, way, "2000", "single", "blind") for way in WAYS},
        "seeds": len({seed for _, seed, _ in learned}),
        "learned": taken,
        "shares": shares,
    }


def _mean(shares: Mapping[str, Any], way: str, total: str, cell: str, how: str) -> float | None:
    return mean_of(shares.get(way, {}).get(total, {}).get(cell, {}).get(how, ()))


def _first(by_total: Mapping[str, Any], what: str) -> int | None:
    """Return the fewest interactions that are enough in the mean of the seeds; None if none of them are."""
    for total in sorted(map(int, by_total)):
        cells = by_total[str(total)]
        means = [mean_of(cells[name][_HOW[what]]) if name in cells else None for name in MUST[what]]
        if all(one is not None and one >= must for one, must in zip(means, MUST[what].values(), strict=True)):
            return total
    return None


def page(summary: Mapping[str, Any]) -> str:
    """Write the page."""
    rows = []
    for way, by_total in summary["shares"].items():
        for total, cells in by_total.items():
            for name, told in cells.items():
                figures_of = [with_interval(mean_of(told[how]), told["tasks"]) for how in figures.WAYS]
                rows.append([way, f"{int(total):,}", name, str(len(told["blind"])), *figures_of])
    taken = [
        [name, f"{one['interactions']:,}", f"{one['cpu'] / 60:.1f}"]
        for name, one in summary["learned"].items()
    ]
    return document(
        "# Budgets, measured",
        "By `make evaluate-budget`, which wrote this page and `budget.json`. Interactions are all that were "
        "performed, whatever for. Goals within 50 mm, or 20 mm where it is said; in *far* tasks they lie "
        "anywhere on the table, for objects that can be grasped. Shares of tasks, with the interval at 95 %.",
        table("way | interactions | tasks | seeds | followed blindly | replanned", rows),
        "## What it took",
        table("way, seed, at most | interactions | CPU minutes since the point before", taken),
    )
