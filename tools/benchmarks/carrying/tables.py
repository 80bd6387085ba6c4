"""The results of `evaluate.py` as a page of Markdown tables."""

from collections.abc import Mapping, Sequence
from statistics import mean, stdev
from typing import Any

from neurosym.markdown import markdown_table
from neurosym.wording import counted


def page(summary: Mapping[str, Any]) -> str:
    """Write the tables.

    Args:
        summary: What `summarise` returned.
    """
    rows = [
        [
            name,
            str(cell["tasks"]),
            _percent(cell["blind"]),
            _percent(cell["replanned"]),
            _said(cell["motions"]),
            *(_percent([of.get(name)]) for of in summary["baselines"].values()),
        ]
        for name, cell in summary["table"].items()
    ]
    can = [
        [str(seed), one["symbol"], f"{one['right']:.0%}", f"{one['median_mm']:.1f}"]
        for seed, one in enumerate(summary["carries"], start=1)
        if one
    ]
    sections = [
        "# Carried to places",
        f"`{summary['command']}` wrote this page. {counted(summary['seeds'], 'seed')}, each with "
        f"{summary['steps']} interactions and {summary['places']} more that were aimed at places; Fast "
        "Downward; means and "
        "standard deviations of the seeds. Goals lie anywhere on the table, at least 15 cm away. *Graspable* "
        "are objects that an action written by hand can grasp. Within 50 mm where nothing else is said. In a "
        "*crowd*, objects stand within 5 cm of the next. *Motions* are primitives that were performed. "
        "A cell without figures was not tried yet. Baselines: *by hand*, each object is carried by an action "
        "that a person wrote, three motions an object at most; *without places*, the same domain leads "
        "objects over cells. Both are tried on the tasks of seed 1.",
        markdown_table(
            [
                "tasks",
                "number",
                "followed blindly",
                "with replanning",
                "motions: median, most",
                *summary["baselines"],
            ],
            rows,
        ),
        "## What was discovered",
        "The action symbol that carries graspable objects most surely: the share of its rehearsals that end "
        "within 15 mm of what its operator does on average, and the median distance from that.",
        markdown_table(["seed", "symbol", "right", "median [mm]"], can),
    ]
    return "\n\n".join(sections) + "\n"


def _said(motions: Mapping[str, float] | None) -> str:
    return "-" if motions is None else f"{motions['median']:g}, {motions['most']:g}"


def _percent(values: Sequence[float | None]) -> str:
    known = [100 * share for share in values if share is not None]
    if not known:
        return "-"
    return f"{mean(known):.1f} %" + (f" ± {stdev(known):.1f}" if len(known) > 1 else "")
