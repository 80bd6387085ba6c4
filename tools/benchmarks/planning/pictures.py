"""The pictures of `evaluate.py`: Table III as bars, and time and steps against objects."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

BARS = (
    ("bfs", "reached", "BFS over the network, followed blindly", "#f2c46d"),
    ("bfs", "reached_with_replanning", "BFS, with replanning", "#e69f00"),
    ("fast-downward", "reached", "Fast Downward, followed blindly", "#80b8b5"),
    ("fast-downward", "reached_with_replanning", "Fast Downward, with replanning", "#00726e"),
)


def draw_table3(results: Mapping[str, Any], path: Path) -> None:
    """Draw the shares of goals reached, for one and two objects, beside the paper's figures."""
    table, paper = results["table3"], results["paper"]
    figure, axes = plt.subplots(1, 2, figsize=(13, 4.6), layout="constrained", sharey=True)
    for axis, kind in zip(axes, ("single", "double"), strict=True):
        places = np.arange(len(table))
        for number, (planner, measure, words, colour) in enumerate(BARS):
            cells = [kinds[kind].get(planner) for kinds in table.values()]
            heights = [100 * cell[measure] if cell else 0.0 for cell in cells]
            spreads = [100 * cell["spread"][measure] if cell else 0.0 for cell in cells]
            offsets = places + 0.2 * (number - 1.5)
            axis.bar(offsets, heights, 0.19, yerr=spreads, color=colour, label=words, capsize=2)
        known = [(place, paper[kind][name]) for place, name in enumerate(table) if name in paper[kind]]
        for place, share in known:
            axis.hlines(100 * share, place - 0.45, place + 0.45, colors="#b03060", linestyles="dashed")
        axis.plot([], [], color="#b03060", linestyle="dashed", label="the paper's figure")
        axis.set(title=f"{kind}-object tasks, within 50 mm", ylim=(0, 105))
        axis.set_xticks(places, list(table))
        axis.grid(axis="y", alpha=0.3)
    axes[0].set_ylabel("goals reached [%]")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=9)
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)


def draw_scaling(scaling: Mapping[str, Any], path: Path) -> None:
    """Draw time and plan length against objects, for easy and for hard goals."""
    figure, axes = plt.subplots(2, 3, figsize=(14, 7), layout="constrained")
    panels = (
        ("seconds", "median time [s]", "log"),
        ("over_fewest", "primitives over the fewest", "linear"),
        ("megabytes", "memory [MB]", "log"),
    )
    for row, difficulty in zip(axes, ("easy", "hard"), strict=True):
        for axis, (measure, title, scale) in zip(row, panels, strict=True):
            axis.set_prop_cycle(color=plt.get_cmap("tab20").colors)
            for contender, cells in scaling["contenders"].items():
                points = {
                    int(size.split()[0]): cell[measure]
                    for size, cell in cells.items()
                    if size.split()[1] == difficulty and cell["solved"] and cell[measure] is not None
                }
                axis.plot(list(points), list(points.values()), marker="o", markersize=4, label=contender)
            axis.set(title=f"{difficulty} goals: {title}", xlabel="objects")
            if not any(len(line.get_xdata()) for line in axis.lines):
                continue  # nothing to lay a logarithmic scale over
            axis.set_yscale(scale)
            axis.set_xscale("log", base=2)
            axis.set_xticks([1, 2, 4, 8, 16], ["1", "2", "4", "8", "16"])
            axis.grid(alpha=0.3)
    if scaling["contenders"]:
        figure.legend(
            *axes[0][0].get_legend_handles_labels(), loc="outside lower center", ncols=3, fontsize=9
        )
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)
