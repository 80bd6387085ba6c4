"""Modes: outcomes that differ in kind are kept apart, and only those of one kind are averaged.

The mean of "on the table" and "in the air" is a place where no object ever is.
"""

from collections.abc import Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.operators import TOLERANCE, Mode
from neurosym.world import OutcomeKind


def sort_into_modes(
    kinds: Sequence[OutcomeKind],
    effects: Float[np.ndarray, "N E"],
    resting_effects: Float[np.ndarray, "N E"],
    peak_heights: Float[np.ndarray, "N"],
) -> tuple[Mode, ...]:
    """Sort outcomes into modes, most frequent first.

    Args:
        kinds: How each outcome ended.
        effects: Displacements at the end of the rise [m].
        resting_effects: Displacements once everything is put down [m].
        peak_heights: Greatest heights on the way [m].
    """
    ended, modes = np.array(kinds), []
    for kind in dict.fromkeys(kinds):
        rows = ended == kind
        judged = (effects if kind == "held" else resting_effects)[rows]
        distances = np.linalg.norm(judged - judged.mean(0), axis=1)
        mode = Mode(
            kind=kind,
            count=int(rows.sum()),
            share=int(rows.sum()) / len(kinds),
            effect=tuple(effects[rows].mean(0).tolist()),
            spread=tuple(effects[rows].std(0).tolist()),
            resting_effect=tuple(resting_effects[rows].mean(0).tolist()),
            resting_spread=tuple(resting_effects[rows].std(0).tolist()),
            peak_height=float(peak_heights[rows].mean()),
            near_mean=int(np.sum(distances <= TOLERANCE)),
        )
        modes.append(mode)
    return tuple(sorted(modes, key=lambda mode: (-mode.count, mode.kind)))
