"""The report of a training as it is read, and its table of errors."""

import msgspec

from neurosym.naming import name_axes
from neurosym.wording import listed_briefly


class TrainingReport(msgspec.Struct, frozen=True, omit_defaults=True):
    """How well a model fits, on interactions held out from training.

    Attributes:
        held_out: How many interactions it was measured on.
        r2_through_codes: R2 of the effect through the binary codes, mean over the axes that vary.
        r2_direct: The same of the network without a bottleneck.
        share: The one divided by the other; see `share_of`.
        mae: Mean absolute error on each axis [m], of the model through its codes and of trivial predictors.
        object_symbols: Share of each object symbol.
        action_symbols: Share of each action symbol.
        r2_through_codes_by_axis: R2 through the codes on each axis.
        r2: R2 without cutting the embeddings to bits.
        r2_by_axis: The same on each axis.
        r2_direct_by_axis: R2 of the network without a bottleneck on each axis.
        restarts: R2 through the codes of each fit that was made.
        empty_object_codes: Codes that no object of the data has, neither of those learned from nor held out.
        empty_action_codes: The same of actions.
    """

    held_out: int
    r2_through_codes: float
    r2_through_codes_by_axis: tuple[float, ...]
    r2: float
    r2_by_axis: tuple[float, ...]
    r2_direct: float
    r2_direct_by_axis: tuple[float, ...]
    share: float | None
    mae: dict[str, list[float]]
    object_symbols: dict[str, float]
    action_symbols: dict[str, float]
    restarts: tuple[float, ...] = ()
    empty_object_codes: tuple[str, ...] = ()
    empty_action_codes: tuple[str, ...] = ()


def empty_codes(report: TrainingReport) -> str:
    """Say in a sentence which codes no row of the data has; empty if there are none.

    Args:
        report: What was measured after training.
    """
    kinds = {"objects": report.empty_object_codes, "actions": report.empty_action_codes}
    listed = [f"{len(codes)} for {kind} ({listed_briefly(codes)})" for kind, codes in kinds.items() if codes]
    return f"codes that stay empty, since no row of the data has them: {', '.join(listed)}" if listed else ""


def error_table(report: TrainingReport) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of the errors of each predictor, in mm if the axes are x, y and z."""
    names = name_axes(max(map(len, report.mae.values()), default=3))
    is_in_space = len(names) == 3
    rows = [
        [name, *(f"{1000 * error:.1f}" if is_in_space else f"{error:.3g}" for error in errors)]
        for name, errors in report.mae.items()
    ]
    return ["predictor", *(f"{axis} [mm]" if is_in_space else axis for axis in names)], rows
