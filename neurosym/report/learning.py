"""How well the model predicts, for the page: errors beside trivial predictors, and the learning curve."""

from dataclasses import dataclass

import numpy as np

from neurosym.learning.learning_curve import LearningCurve
from neurosym.learning.report import TrainingReport, error_table
from neurosym.naming import name_axes
from neurosym.reading import read_json
from neurosym.report.charts import Axis, Chart, lines
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import CURVE, TRAINING


@dataclass(frozen=True, slots=True)
class Learned:
    """How well the model predicts.

    Attributes:
        report: What was measured after training.
        columns: Headings of the table of errors.
        rows: A predictor and its error on each axis.
    """

    report: TrainingReport
    columns: list[str]
    rows: list[list[str]]


def learned(folder: DomainFolder) -> Learned | None:
    """Read how well the model of a folder predicts, if it was trained.

    Raises:
        InvalidFile: If the training report is damaged.
    """
    path = folder / TRAINING
    if not path.is_file():
        return None
    report = read_json(path, TrainingReport)
    return Learned(report, *error_table(report))


def curve_charts(folder: DomainFolder) -> tuple[Chart, ...]:
    """Draw the learning curve of a folder, if it was made.

    Raises:
        InvalidFile: If its file is damaged.
    """
    path = folder / CURVE
    if not path.is_file():
        return ()
    curve = read_json(path, LearningCurve)
    points = curve.points
    if len(points) < 2:
        return ()
    at = [point.interactions for point in points]
    across = Axis("interactions learned from", 0.0, float(max(at)))
    coded, direct = [p.r2_through_codes for p in points], [p.r2_direct for p in points]
    low, high = min(0.0, *coded, *direct), max(0.1, *coded, *direct)
    told = f"from {coded[0]:.2f} after {at[0]} interactions to {coded[-1]:.2f} after {at[-1]}"
    explained = lines(
        "How much of the effect is explained",
        f"R2 through the bits on {curve.held_out} held-out interactions: {told}; "
        f"without a bottleneck from {direct[0]:.2f} to {direct[-1]:.2f}.",
        across,
        Axis("R2", low, 1.05 * high),
        {"through the bits": np.column_stack([at, coded]), "no bottleneck": np.column_stack([at, direct])},
    )
    return (explained, _error_chart(curve, at, across))


def _error_chart(curve: LearningCurve, at: list[int], across: Axis) -> Chart:
    names = name_axes(len(curve.points[0].mae))
    unit, factor = (" [mm]", 1000.0) if len(names) == 3 else ("", 1.0)
    errors = factor * np.array([point.mae for point in curve.points])
    told = ", ".join(
        f"{name} from {column[0]:.3g} to {column[-1]:.3g}"
        for name, column in zip(names, errors.T, strict=True)
    )
    return lines(
        "Mean absolute error through the bits",
        f"Error{unit} on held-out interactions: {told}.",
        across,
        Axis(f"error{unit}", 0.0, 1.05 * float(errors.max()) or 1.0),
        {name: np.column_stack([at, column]) for name, column in zip(names, errors.T, strict=True)},
    )
