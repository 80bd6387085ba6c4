"""The grid that positions are written on in PDDL, and the cells that count as a goal.

Each axis has cells of its own: x and y cover the table, z counts upwards from where an object rests. The grid
is anchored at each object: the cell an object starts in stands for exactly where it starts, so the start is
not rounded. Steps are, because their displacement is a whole number of cells. A plan's promise is therefore
off by at most the sum of its steps' remainders, and the goal's ball is shrunk by that much: a plan into the
shrunken ball of no more steps than were reckoned with ends within the tolerance.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from neurosym.data.axes import Axis
from neurosym.data.cells import Cells
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Vector
from neurosym.problems import SceneObject, check_on_table
from neurosym.tasks.promises import usable

AXES = ("x", "y", "z")


def axes_of(grounding: Grounding) -> tuple[Axis, Axis, Axis]:
    """Return what objects on a table move along: over it, and up to where the highest lift leads [all m]."""
    table, cell = grounding.table, grounding.cell
    highest = max((grounding.highest(operator) for operator in grounding.live), default=0)
    bounds = table.x, table.y, (0.0, highest * cell if highest > 0 else None)
    x, y, z = (
        Axis(name, unit="m", cell=cell, low=low, high=high)
        for name, (low, high) in zip(AXES, bounds, strict=True)
    )
    return x, y, z


@lru_cache(maxsize=8)
def grid_of(grounding: Grounding) -> tuple[Cells, Cells, Cells]:
    """Lay the grid over the table: the cells of x, y and z, all with names of as many digits."""
    axes = axes_of(grounding)
    digits = max(len(str(Cells(axis).count - 1)) for axis in axes)
    x, y, z = (Cells(axis, digits) for axis in axes)
    return x, y, z


def anchor(grid: Sequence[Cells], position: Vector) -> tuple[int, int, int]:
    """Return the cell that an object at rest starts in, whose centre [m] is over the table."""
    x, y, _ = grid
    return (x.clipped(position[0]), y.clipped(position[1]), 0)


@dataclass(frozen=True, slots=True)
class GoalRegion:
    """The cells that count as an object's goal: the nearer they are, the more heights meet it there.

    Attributes:
        heights: Cells along z, the nearest to the goal first.
        zone: For each cell of x and y in the goal, over how many of the heights it is met, nearest first.
    """

    heights: tuple[int, ...] = ()
    zone: Mapping[tuple[int, int], int] = field(default_factory=dict)

    def zones_at(self, height: int) -> list[int]:
        """List the zones over whose cells a height meets the goal."""
        if height not in self.heights:
            return []
        return [zone for zone in sorted(set(self.zone.values())) if zone > self.heights.index(height)]


def goal_region(
    item: SceneObject, goal: Vector, tolerance: float, grounding: Grounding, *, steps: int
) -> GoalRegion:
    """Find the cells from which the goal is met whatever the grid rounded on the way.

    Along z there are only the levels that objects of this category can be at: the table, and where lifts end.
    Each leaves a disc of the ball to x and y, the smaller the farther it is from the goal. If not a single
    cell is left, the goal's own is taken at the nearest level, and a replay must tell. The rounding of so
    many steps is reckoned with; goal and tolerance are in metres.
    """
    check_on_table(item, grounding.table)
    grid, (error_x, error_y, error_z) = grid_of(grounding), rounding(item, grounding)
    dx, dy, height = (end - start for end, start in zip(goal, item.position, strict=True))
    cell = grounding.cell
    ends = (z for z in levels(item, grounding) if z < grid[2].count)  # by its past it may end above all cells
    misses = {z: abs(z * cell - height) + (error_z if z else 0.0) for z in ends}
    heights = within(misses, tolerance)
    radii = [math.sqrt(tolerance**2 - misses[z] ** 2) for z in heights]
    (start_x, start_y, _), reach = anchor(grid, item.position), math.ceil(max(radii, default=0) / cell)
    middle = math.floor(dx / cell + 0.5), math.floor(dy / cell + 0.5)

    def zone(x: int, y: int) -> int:
        """Return over how many heights a cell, counted from the start, is near enough whatever errs."""
        off_x = abs(x - dx / cell) * cell + steps * error_x
        off_y = abs(y - dy / cell) * cell + steps * error_y
        if not (0 <= start_x + x < grid[0].count and 0 <= start_y + y < grid[1].count):
            return 0
        return max(sum(math.hypot(off_x, off_y) <= radius for radius in radii), (x, y) == middle)

    rows, columns = (range(cell - reach, cell + reach + 1) for cell in middle)
    found = {(start_x + x, start_y + y): zone(x, y) for x in rows for y in columns if heights}
    return GoalRegion(heights, {cell: number for cell, number in found.items() if number})


def levels(item: SceneObject, grounding: Grounding) -> tuple[int, ...]:
    """List the heights that an object of this category can have, in cells above where it rests."""
    lifts = (grounding.cells(operator)[2] for operator in usable(grounding, item) if is_lift(operator))
    return (0, *sorted(set(lifts)))


def rounding(item: SceneObject, grounding: Grounding) -> Vector:
    """Return how far one step of a plan with an object can err on each axis because of the grid [m].

    On x and y the errors of several steps add up. On z they do not: whatever rests is at its own height
    exactly, so only an object that ends held errs.
    """
    steps = usable(grounding, item) if grounding.is_refined else grounding.live
    errors = [(0.0, 0.0, 0.0), *map(grounding.rounding, steps)]
    x, y, z = (max(axis) for axis in zip(*errors, strict=True))
    return (x, y, z)


def within(misses: Mapping[int, float], tolerance: float) -> tuple[int, ...]:
    """List the levels that miss a goal by less than the tolerance, nearest first."""
    return tuple(sorted((z for z in misses if misses[z] < tolerance), key=lambda z: (misses[z], z)))
