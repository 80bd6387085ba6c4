"""The learning curves of `evaluate.py`, in one picture."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

Figure = Callable[[Mapping[str, Any]], float]
PANELS: Mapping[str, tuple[str, Figure]] = {
    "R2 through the codes": ("learn", lambda cell: cell["r2_through_codes"]),
    "R2 without a bottleneck": ("learn", lambda cell: cell["r2_direct"]),
    "error, high effects [mm]": ("learn", lambda cell: 1000 * float(np.mean(cell["mae"]["model"]))),
    "kinds of primitive found": ("act", lambda cell: sum(bool(pairs) for pairs in cell["kinds"].values())),
}  # which job tells each measure, and how


def draw(results: Mapping[str, Any], path: Path) -> None:
    """Draw each measure against interactions, mean and standard deviation over seeds."""
    figure, axes = plt.subplots(1, len(PANELS), figsize=(4 * len(PANELS), 3.4), layout="constrained")
    for axis, (title, (job, figure_of)) in zip(axes, PANELS.items(), strict=True):
        for strategy, by_rows in results["curves"].items():
            points = {int(rows): [figure_of(c) for c in jobs[job].values()] for rows, jobs in by_rows.items()}
            points = {rows: points[rows] for rows in sorted(points) if points[rows]}
            means = np.array([np.mean(values) for values in points.values()])
            spreads = np.array([np.std(values) for values in points.values()])
            axis.plot(list(points), means, marker="o", markersize=3, label=strategy)
            axis.fill_between(list(points), means - spreads, means + spreads, alpha=0.15)
        axis.set(title=title, xlabel="interactions")
        axis.grid(alpha=0.3)
    axes[0].legend()
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)
