"""The table of `tables` with rehearsals: what an operator does to an object depends on how wide that is."""

import msgspec
import numpy as np
import tables

from neurosym.grounding import Grounding
from neurosym.operators import Category, Operator, Rehearsal
from neurosym.problems import Problem, SceneObject

NARROW, WIDE = 0.035, 0.065
"""Edges of the narrowest and the widest block [m]; trays are 7 cm wider."""
MEAN = (NARROW + WIDE) / 2
_ROWS = 20


def grounding(cell: float = 0.005) -> Grounding:
    """Have wider blocks pushed farther and lifted less high, and the widest not be pushed away at all."""
    learned = tables.grounding(cell)
    table = learned.objects
    categories, operators = map(_with_objects, table.categories), map(_with_rows, table.operators)
    table = msgspec.structs.replace(table, categories=tuple(categories), operators=tuple(operators))
    return msgspec.structs.replace(learned, objects=table)


def item(name: str, x: float, y: float, size: float, *, category: str = "00") -> SceneObject:
    """Return an object of a size beside that of the average block, whatever its category [m]."""
    width = size + (0.07 if category == "11" else 0.0)
    return SceneObject(name, category, (width, width, 0.05, 0.0), (x, y, 0.025))


def problem(*sizes: float) -> Problem:
    """Two blocks and a tray of these sizes; the first block is to be lifted in the end."""
    first, second, third = sizes or (0.04, 0.055, 0.05)
    objects = (
        item("item-01", 0.4512, 0.0133, first),
        item("item-02", 0.4512, -0.2, second),
        item("item-03", 0.7, -0.1, third, category="11"),
    )
    spots = (0.52, 0.05, 0.28), (0.53, -0.12, 0.025), (0.64, -0.15, 0.025)
    goals = {one.name: spot for one, spot in zip(objects, spots, strict=True)}
    return Problem("sizes", objects, goals, tolerance=0.03, provenance="by hand")


def _sizes() -> list[float]:
    return [float(value) for value in np.linspace(NARROW, WIDE, _ROWS)]


def _with_objects(category: Category) -> Category:
    wider = 0.07 if category.symbol == "11" else 0.0
    rows = tuple((size + wider, size + wider, 0.05, 0.0) for size in _sizes())
    return msgspec.structs.replace(category, objects=rows)


def _with_rows(operator: Operator) -> Operator:
    promise = operator.promise
    if promise is None or operator.trials < _ROWS // 2:
        return operator
    rows = tuple(_row(operator, size) for size in _sizes())
    return msgspec.structs.replace(operator, rehearsals=rows)


def _row(operator: Operator, size: float) -> Rehearsal:
    """Scale what the operator promises on average by the object's size."""
    promise = operator.promise
    assert promise is not None
    times = size / MEAN
    stays = operator.name == "push-away-001-block" and size > 0.06
    x, y, z = promise.effect
    effect = (0.0, 0.0, 0.0) if stays else (x * times, y * times, z / times if z > 0.1 else 0.0)
    resting = tuple(part * times for part in promise.resting_effect[:2])
    settled = (0.0, 0.0, 0.0) if stays else (resting[0], resting[1], 0.0)
    turn = 0.5 if size < 0.04 else 0.0
    return Rehearsal(promise.kind, effect, settled, max(effect[2], 0.0), turn)
