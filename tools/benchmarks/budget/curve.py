"""The share of goals that plans reach by all interactions they cost, in one picture."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

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
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)
