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

Draw = Callable[[Bench, int], Problem]  # draws the task of a seed
Cell = tuple[str, Draw, int]
"""What a cell of the table is called, what draws its tasks, and how many there are for each seed."""
NEAR = 0.02  # the smaller tolerance [m]
BLOCK = 5  # tasks that are tried together
FAR = {1: 40, 2: 20, 4: 20, 8: 10}
"""How many tasks there are with goals anywhere, by how many objects they have."""


def is_graspable(features: Float[np.ndarray, " F"]) -> bool:
    """Say whether a person who writes actions by hand finds a grasp for an object."""
    return carry_to(features) is not None


def far(bench: Bench, objects: int, seed: int, *, graspable: bool, tolerance: float = TOLERANCE) -> Problem:
    """Draw goals anywhere on the table, at least 15 cm away."""
    return bench.draw(objects, seed, tolerance, "anywhere", is_graspable if graspable else None)


def graspable(task: TaskKind, objects: int, bench: Bench, seed: int) -> Problem:
    """Draw a task of some kind with graspable objects."""
    return bench.draw(objects, seed, TOLERANCE, task, is_graspable)


def cells(scale: float) -> tuple[Cell, ...]:
    """List what is tried, so many times the usual number."""

    def draw(objects: int, **options: bool | float) -> Draw:
        return partial(_far, objects, options)

    found: list[Cell] = [
        *((f"graspable {n}", draw(n, graspable=True), count) for n, count in FAR.items()),
        *((f"graspable {n}, 20 mm", draw(n, graspable=True, tolerance=NEAR), k) for n, k in FAR.items()),
        *((f"all {n}", draw(n, graspable=False), count) for n, count in FAR.items()),
        ("swap", partial(graspable, "swap", 2), 20),
        ("row", partial(graspable, "row", 4), 20),
        ("crowded", partial(graspable, "crowded", 4), 20),
    ]
    return tuple((name, task, BLOCK * math.ceil(count * scale / BLOCK)) for name, task, count in found)


def _far(objects: int, options: dict[str, bool | float], bench: Bench, seed: int) -> Problem:
    return far(bench, objects, seed, **options)  # type: ignore[arg-type]
