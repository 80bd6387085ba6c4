"""Pictures: goals that plans reach by all interactions they cost, and when curiosity pays."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from tools.benchmarks.budget import heights
from tools.benchmarks.budget.ways import STAGES

LINES = {
    "one-budget": "one budget, curious by disagreement",
    "entropy": "one budget, curious by entropy",
    "random": "one budget, random exploring",
    STAGES: "stages in a row",
}
PANELS = {"single": "one object, within 50 mm", "double": "two objects, within 50 mm"}


def draw(summary: Mapping[str, Any], path: Path) -> None:
    """Draw what is reached blindly against interactions, mean and standard deviation over seeds."""
    figure, axes = plt.subplots(1, len(PANELS), figsize=(9, 3.4), layout="constrained", sharey=True)
    for axis, (cell, title) in zip(axes, PANELS.items(), strict=True):
        for way, label in LINES.items():
            by_total = summary["shares"].get(way, {})
            found = {
                int(total): 100 * np.array(by_total[total][cell]["blind"])
                for total in by_total
                if cell in by_total[total]
            }
            totals = sorted(found)
            means = np.array([found[total].mean() for total in totals])
            spreads = np.array([found[total].std() for total in totals])
            axis.plot(totals, means, marker="o", markersize=3, label=label)
            axis.fill_between(totals, means - spreads, means + spreads, alpha=0.15)
        axis.set(title=title, xlabel="all interactions", xscale="log", ylim=(0, 100))
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("goals reached blindly [%]")
    axes[-1].legend(loc="lower right")
    _save(figure, path)


def draw_curiosity(found: Mapping[str, Any], path: Path) -> None:
    """Draw what is explained of actions that move something, by how many do; see `heights.summarise`."""
    figure, axis = plt.subplots(figsize=(9, 3.2), layout="constrained")
    for name, way in heights.STRATEGIES.items():
        known = [told for told in found.values() if name in told]
        shares = [100 * told["moved"] for told in known]
        explained = [np.array(told[name]["r2"]) for told in known]
        means = np.array([one.mean() for one in explained])
        spreads = np.array([one.std() for one in explained])
        axis.plot(shares, means, marker="o", markersize=3, label=f"{way.steps:,}: {way.about}")
        axis.fill_between(shares, means - spreads, means + spreads, alpha=0.15)
    axis.set(xlabel="random actions that move their target [%]", ylabel="R2 of what these do")
    axis.grid(alpha=0.3)
    figure.legend(title="explored: by", loc="outside right upper")
    _save(figure, path)


def _save(figure: Figure, path: Path) -> None:
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)
