"""What came of carrying to places, as plain values and as a page of Markdown tables."""

from collections.abc import Mapping, Sequence
from statistics import median
from typing import Any

from neurosym.errors import counted
from tools.benchmarks.carrying import tasks
from tools.benchmarks.jobs import Found, machine
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.trials import Trial
from tools.benchmarks.tables import document, mean_of, percent, spread_of, table, with_interval

BASELINES = ("by hand", "without places")
RIGHT = 0.9  # a domain can carry if some action symbol ends graspable objects so often where it should


def slug(name: str) -> str:
    """Return what files of a cell are called."""
    return name.replace(", ", "-").replace(" ", "-")


def summarise(
    found: Found, trials: Mapping[str, Sequence[Sequence[Trial]]], *, seeds: int, steps: int, places: int
) -> dict[str, Any]:
    """Gather the shares of reached goals, for each seed and in the mean."""
    table: dict[str, dict[str, Any]] = {
        name: {way: [figures.share(of_one, way) for of_one in of] for way in figures.WAYS}
        | {"motions": _motions(of), "tasks": sum(map(len, of))}
        for name, of in trials.items()
    }

    def whole(name: str) -> float | None:
        return mean_of(table[name]["replanned"])

    can, at_random = (
        [found.get(f"{how}-{seed}") for seed in range(1, seeds + 1)] for how in ("learn", "random")
    )
    return {
        "command": "make evaluate-places",
        "versions": machine("numpy", "pybullet", "torch", "up-fast-downward"),
        "seeds": seeds,
        "steps": steps,
        "places": places,
        "far_goals": {str(n): whole(f"graspable {n}") for n in tasks.FAR},
        "far_goals_20mm": {str(n): whole(f"graspable {n}, 20 mm") for n in tasks.FAR},
        "far_goals_all": {str(n): whole(f"all {n}") for n in tasks.FAR},
        **{name: whole(name) for name in ("swap", "row", "crowded")},
        "carry_seeds": sum(one is not None and one["right"] >= RIGHT for one in can),
        "carries": can,
        "carries_at_random": at_random,
        "baselines": {
            baseline: {
                name: sum(reached) / len(reached)
                for name in table
                if (reached := found.get(slug(f"{baseline} {name}")))
            }
            for baseline in BASELINES
        },
        "table": table,
    }


def _motions(of_seeds: Sequence[Sequence[Trial]]) -> dict[str, float] | None:
    counts = [len(one.replanned.steps) for of_one in of_seeds for one in of_one if one.replanned]
    return {"median": median(counts), "most": max(counts)} if counts else None


def page(summary: Mapping[str, Any]) -> str:
    """Write the tables."""
    rows = [
        [
            name,
            str(cell["tasks"]),
            *(_over_seeds(cell[way], cell["tasks"]) for way in figures.WAYS),
            f"{cell['motions']['median']:g}, {cell['motions']['most']:g}" if cell["motions"] else "-",
            *(percent(of.get(name)) for of in summary["baselines"].values()),
        ]
        for name, cell in summary["table"].items()
    ]
    pairs = zip(summary["carries"], summary["carries_at_random"], strict=True)
    can = [
        [str(seed), *(cell for one in pair for cell in _carrier(one))] for seed, pair in enumerate(pairs, 1)
    ]
    columns = ["tasks", "number", "followed blindly", "with replanning", "motions: median, most"]
    return document(
        "# Carried to places",
        f"`{summary['command']}` wrote this page. {counted(summary['seeds'], 'seed')}, each with "
        f"{summary['steps']} interactions and {summary['places']} more that were aimed at places; Fast "
        "Downward. Shares are means over the seeds, with their standard deviation; in brackets stands "
        "the Wilson interval of all tasks at 95 %. Goals lie anywhere on the table, at least 15 cm away."
        " *Graspable* are objects that an action written by hand can grasp. Within 50 mm where nothing "
        "else is said. In a *crowd*, objects stand within 5 cm of the next. *Motions* are primitives "
        "that were performed. A cell without figures was not tried yet. Baselines: *by hand*, each "
        "object is carried by an action that a person wrote, three motions an object at most; *without "
        "places*, the same domain leads objects over cells. Both are tried on the tasks of seed 1.",
        table([*columns, *summary["baselines"]], rows),
        "## What was discovered",
        "The action symbol that carries graspable objects most surely: the share of its rehearsals that end "
        "within 15 mm of what its operator does on average, and the median distance from that. Beside it "
        "stands what is learned from as many actions at places that were drawn at random.",
        table("seed | symbol | right | median [mm] | at random: symbol | right | median [mm]", can),
    )


def _carrier(one: Mapping[str, Any] | None) -> tuple[str, str, str]:
    if one is None:
        return ("-", "-", "-")
    return (one["symbol"] or "none", f"{one['right']:.1%}", f"{one['median_mm']:.1f}")


def _over_seeds(shares: Sequence[float | None], of: int) -> str:
    known = [100 * share for share in shares if share is not None]
    return with_interval(mean_of(shares), of, spread_of(known, 0))
