"""How well a training went, as it is written and read: its figures, and their table of errors.

It is read by what tells of a domain, without the networks.
"""

from collections.abc import Sequence

import msgspec

from neurosym.errors import listed_briefly
from neurosym.operators import name_axes


class TrainingReport(msgspec.Struct, frozen=True, omit_defaults=True):
    """How well a model fits, on interactions held out from training."""

    held_out: int  # how many interactions it was measured on
    r2_through_codes: float  # R2 of the effect through the binary codes, mean over the axes that vary
    r2_through_codes_by_axis: tuple[float, ...]  # the same on each axis
    r2: float  # R2 without cutting the embeddings to bits
    r2_by_axis: tuple[float, ...]  # the same on each axis
    r2_direct: float  # R2 of the network without a bottleneck, mean over these axes
    r2_direct_by_axis: tuple[float, ...]  # the same on each axis
    share: float | None  # R2 through the codes divided by R2 of that network; see `share_of`
    # mean absolute error on each axis [m], of the model through its codes and of trivial predictors
    mae: dict[str, list[float]]
    object_symbols: dict[str, float]  # share of each object symbol
    action_symbols: dict[str, float]  # share of each action symbol
    # R2 through the codes of each fit that was made; of the one that is made today
    restarts: tuple[float, ...] = ()
    # codes that no object of the data has, neither of those learned from nor held out
    empty_object_codes: tuple[str, ...] = ()
    empty_action_codes: tuple[str, ...] = ()  # the same of actions


def empty_codes(report: TrainingReport) -> str:
    """Say in a sentence which codes no row of the data has; empty if there are none.

    Args:
        report: What was measured after training.
    """
    kinds = {"objects": report.empty_object_codes, "actions": report.empty_action_codes}
    listed = [f"{len(codes)} for {kind} ({listed_briefly(codes)})" for kind, codes in kinds.items() if codes]
    return f"codes that stay empty, since no row of the data has them: {', '.join(listed)}" if listed else ""


def error_table(report: TrainingReport, named: Sequence[str] = ()) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of the errors of each predictor, in mm if the axes are x, y and z of ours."""
    names = named or name_axes(max(map(len, report.mae.values()), default=3))
    scale, form, unit = (1000, ".1f", " [mm]") if len(names) == 3 and not named else (1, ".3g", "")
    rows = [[name, *(format(scale * error, form) for error in errors)] for name, errors in report.mae.items()]
    return ["predictor", *(f"{axis}{unit}" for axis in names)], rows
