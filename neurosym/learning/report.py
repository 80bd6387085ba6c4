"""The report of a training as it is read, and its table of errors."""

import msgspec

from neurosym.naming import name_axes


class TrainingSummary(msgspec.Struct, frozen=True):
    """What is shown of a training report; see `neurosym.learning.training.assess`."""

    held_out: int
    r2_through_codes: float
    r2_direct: float
    share: float | None
    mae: dict[str, list[float]]
    object_symbols: dict[str, float]
    action_symbols: dict[str, float]


def error_table(report: TrainingSummary) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of the errors of each predictor, in mm if the axes are x, y and z."""
    names = name_axes(max(map(len, report.mae.values()), default=3))
    is_in_space = len(names) == 3
    rows = [
        [name, *(f"{1000 * error:.1f}" if is_in_space else f"{error:.3g}" for error in errors)]
        for name, errors in report.mae.items()
    ]
    return ["predictor", *(f"{axis} [mm]" if is_in_space else axis for axis in names)], rows
