"""The results of `evaluate.py` as a page of Markdown tables."""

from collections.abc import Mapping, Sequence
from statistics import mean, stdev
from typing import Any

from neurosym.errors import counted
from neurosym.evaluation.summary import markdown_table
from neurosym.stages.verdicts import wilson


def page(summary: Mapping[str, Any]) -> str:
    """Write the tables."""
    rows = [
        [
            name,
            str(cell["tasks"]),
            _over_seeds(cell["blind"], cell["tasks"]),
            _over_seeds(cell["replanned"], cell["tasks"]),
            _said(cell["motions"]),
            *(_percent(of.get(name)) for of in summary["baselines"].values()),
        ]
        for name, cell in summary["table"].items()
    ]
    can = [
        [str(seed), *_carrier(one), *_carrier(at_random)]
        for seed, (one, at_random) in enumerate(
            zip(summary["carries"], summary["carries_at_random"], strict=True), start=1
        )
    ]
    sections = [
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
        "within 15 mm of what its operator does on average, and the median distance from that. Beside it "
        "stands what is learned from as many actions at places that were drawn at random.",
        markdown_table(
            ["seed", "symbol", "right", "median [mm]", "at random: symbol", "right", "median [mm]"], can
        ),
    ]
    return "\n\n".join(sections) + "\n"


def _said(motions: Mapping[str, float] | None) -> str:
    return "-" if motions is None else f"{motions['median']:g}, {motions['most']:g}"


def _carrier(one: Mapping[str, Any] | None) -> tuple[str, str, str]:
    if one is None:
        return ("-", "-", "-")
    return (one["symbol"] or "none", f"{one['right']:.1%}", f"{one['median_mm']:.1f}")


def _over_seeds(shares: Sequence[float | None], tasks: int) -> str:
    known = [share for share in shares if share is not None]
    if not known:
        return "-"
    low, high = wilson(round(mean(known) * tasks), tasks)
    spread = f" ± {100 * stdev(known):.0f}" if len(known) > 1 else ""
    return f"{100 * mean(known):.0f} %{spread} ({100 * low:.0f} to {100 * high:.0f})"


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100 * share:.0f} %"
