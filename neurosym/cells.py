"""Displacements in space, and in whole cells of a grid."""

import math

from neurosym.operators import Effect, Mode, Vector

Cells = tuple[int, int, int]
"""A displacement along x, y and z in whole cells."""


def in_space(effect: Effect) -> Vector:
    """Return an effect along x, y and z as a vector [m]."""
    x, y, z = effect
    return (x, y, z)


def at_rest(promise: Mode) -> Vector:
    """Return where a promise to end upright brings the object: it keeps its height [m]."""
    x, y, _ = promise.resting_effect
    return (x, y, 0.0)


def in_cells(displacement: Vector, cell: float) -> Cells:
    """Round a displacement to whole cells, halves away from zero.

    Args:
        displacement: The displacement [m].
        cell: Edge of a cell [m].
    """
    x, y, z = (int(math.copysign(math.floor(abs(part) / cell + 0.5), part)) for part in displacement)
    return (x, y, z)


def remainder(displacement: Vector, cells: Cells, cell: float) -> Vector:
    """Return by how much a displacement in whole cells is off, on each axis [m].

    Args:
        displacement: The displacement [m].
        cells: The same in cells.
        cell: Edge of a cell [m].
    """
    x, y, z = (abs(part - cell * whole) for part, whole in zip(displacement, cells, strict=True))
    return (x, y, z)
