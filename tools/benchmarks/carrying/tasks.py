"""The tasks that carrying is measured by, beside those that `neurosym compare` draws."""

import math
from collections.abc import Callable
from functools import partial

import numpy as np
from jaxtyping import Float

from neurosym.choices import TaskKind
from neurosym.evaluation.comparison import Bench
from neurosym.operators import TOLERANCE
from neurosym.problems import Problem
from tools.benchmarks.world.hand_written import carry_to

Draw = Callable[[Bench, int], Problem]
"""Draws the task of a seed."""
NEAR = 0.02
"""The smaller tolerance [m]."""
BLOCK = 5
"""Tasks that are tried together."""


def is_graspable(features: Float[np.ndarray, " F"]) -> bool:
    """Say whether a person who writes actions by hand finds a grasp for an object."""
    return carry_to(features) is not None


def far(bench: Bench, objects: int, seed: int, *, graspable: bool, tolerance: float = TOLERANCE) -> Problem:
    """Draw goals anywhere on the table, at least 15 cm away."""
    return bench.draw(objects, seed, tolerance, "anywhere", is_graspable if graspable else None)


def _graspable(task: TaskKind, objects: int, bench: Bench, seed: int) -> Problem:
    return bench.draw(objects, seed, TOLERANCE, task, is_graspable)


swap: Draw = partial(_graspable, "swap", 2)
"""Draws two objects that shall change places."""
row: Draw = partial(_graspable, "row", 4)
"""Draws four objects that shall stand in a row."""
crowded: Draw = partial(_graspable, "crowded", 4)
"""Draws a crowd of four objects that is to be cleared."""

Cell = tuple[str, Draw, int]
"""What a cell of the table is called, what draws its tasks, and how many there are for each seed."""


def cells(scale: float) -> tuple[Cell, ...]:
    """List what is tried."""

    def some(count: int) -> int:
        return BLOCK * math.ceil(count * scale / BLOCK)

    of_size = {1: some(40), 2: some(20), 4: some(20), 8: some(10)}
    return (
        *((f"graspable {n}", partial(_far, n, True, None), count) for n, count in of_size.items()),
        *((f"graspable {n}, 20 mm", partial(_far, n, True, NEAR), count) for n, count in of_size.items()),
        *((f"all {n}", partial(_far, n, False, None), count) for n, count in of_size.items()),
        ("swap", swap, some(20)),
        ("row", row, some(20)),
        ("crowded", crowded, some(20)),
    )


def _far(objects: int, graspable: bool, tolerance: float | None, bench: Bench, seed: int) -> Problem:
    within = {} if tolerance is None else {"tolerance": tolerance}
    return far(bench, objects, seed, graspable=graspable, **within)
