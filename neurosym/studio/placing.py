"""What cannot be, said while something is dragged; and where an object can be brought to."""

from collections.abc import Collection, Iterator, Mapping
from typing import Literal

import numpy as np

from neurosym.arrays import Float, Int
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE, Vector
from neurosym.problems import Problem, SceneObject
from neurosym.promises import usable
from neurosym.related import Borne, carried_along, chain_below
from neurosym.studio.relating import (
    ghost_spots,
    relation_of_drop,
    stacks_of,
    supports_of,
    under,
    why_not_related,
)
from neurosym.table import Table
from neurosym.tasks.carriers import carriers_for
from neurosym.tasks.task import Task

REACH_CELL = 0.01
"""Edge of the cells that the reach of an object is drawn with [m]."""
REACH_STEPS = 3
"""How many primitives with an object its reach is drawn for."""
_SPOTS = 0.02  # how far apart the places are where an object is tried to be added [m]
Kind = Literal["object", "goal"]


def reach_of(item: SceneObject, grounding: Grounding, steps: int = REACH_STEPS) -> Float[np.ndarray, "N 2"]:
    """Work out where operators bring an object within some steps: centres of cells of the table [m].

    It can be everywhere, if something carries it; the cell of its own is always one.

    Args:
        item: The object.
        grounding: The learned domain.
        steps: How many primitives at most.
    """
    low, high = np.array([grounding.table.x, grounding.table.y]).T
    shape = np.maximum(1, np.rint((high - low) / REACH_CELL).astype(int))
    cells = np.clip(((np.array([item.position[:2]]) - low) // REACH_CELL).astype(int), 0, shape - 1)
    if carriers_for(item, grounding, TOLERANCE):
        cells, steps = np.argwhere(np.ones(shape)), 0
    shifts = np.array([(0, 0), *_shifts(item, grounding)])
    for _ in range(steps):
        cells = np.unique((cells[:, None] + shifts).reshape(-1, 2), axis=0)
        cells = cells[np.all((cells >= 0) & (cells < shape), axis=1)]
    return np.asarray(cells * REACH_CELL + low + REACH_CELL / 2)


def _shifts(item: SceneObject, grounding: Grounding) -> Iterator[Int[np.ndarray, "2"]]:
    """Yield by how many cells each operator brings an object elsewhere."""
    for operator in usable(grounding, item):
        if operator.promise and (any(operator.promise.resting_effect) or not is_lift(operator)):
            yield np.rint(np.array(operator.promise.resting_effect[:2]) / REACH_CELL).astype(int)


def why_not_there(
    problem: Problem,
    name: str,
    kind: Kind,
    table: Table,
    *,
    ghosts: Mapping[str, Vector] | None = None,
    may_be_in: Collection[str] = (),
) -> str:
    """Say why an object or its goal cannot be where it is, or nothing.

    Two goals may not be in one place, nor a goal in an object that is to stay. A goal above the table is only
    asked to be over it.

    Args:
        problem: The problem.
        name: Name of the object.
        kind: Whether it is about where the object starts, or about its goal.
        table: Where objects may stand.
        ghosts: Where the ghosts of objects with goals stand [m]; the goals on the table, if not given.
        may_be_in: Names of the objects that it may stand on or in, or that may stand on or in it.
    """
    ghosts = {} if kind == "object" else problem.goals if ghosts is None else ghosts
    item = problem.object_named(name)
    at = np.array(item.position if kind == "object" else problem.goals[name])
    called = name if kind == "object" else f"the goal of {name}"
    if not table.contains(at):
        return f"{called} is off the table"
    for other in problem.objects:
        if other.name == name or other.name in may_be_in:
            continue
        away = np.abs(at - ghosts.get(other.name, other.position))
        room = (np.array(item.features[:3]) + other.features[:3]) / 2 - (0.0, 0.0, 1e-6)
        if np.all(away < room):
            return f"{called} is in {f'the goal of {other.name}' if other.name in ghosts else other.name}"
    return ""


def complaints_about(task: Task) -> dict[str, str]:
    """Say of each object or goal that cannot be where it is why not, by `object NAME` and `goal NAME`."""
    problem, table, ghosts, found = task.problem, task.grounding.table, ghost_spots(task), dict[str, str]()
    stacks = stacks_of(task)
    supports = supports_of(task, stacks)
    for name in problem.object_names:
        if why := why_not_there(problem, name, "object", table, may_be_in=_pile(name, stacks)):
            found[f"object {name}"] = why
        if name in problem.goals:
            upon = carried_along(name, supports)
            why = why_not_there(problem, name, "goal", table, ghosts=ghosts, may_be_in=upon)
            if why := _unless_dropped(why, task, name):
                found[f"goal {name}"] = why
    return found | {f"goal {name}": why for name, why in why_not_related(task).items()}


def _pile(name: str, stacks: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name all that stands in one pile with an object, itself included."""
    lowest = chain_below(name, stacks)[-1]
    return lowest, *carried_along(lowest, stacks)


def _unless_dropped(why: str, task: Task, name: str) -> str:
    """Return why a goal cannot be on the table there, or nothing if it may be dropped on what is there."""
    goals, grounding = task.problem.goals, task.grounding
    if not why or not grounding.table.contains(np.array(goals[name])):
        return why
    if grounding.relations is None:
        on = under(task, name, goals)
        return f"{why}; this domain knows no goals like {name} on {on[0]}" if on else why
    return "" if relation_of_drop(task, name) else why


def free_spot(
    problem: Problem | None, features: tuple[float, ...], table: Table, middle: tuple[float, float]
) -> tuple[float, float]:
    """Find room for an object on the table, nearest to its middle [m].

    Args:
        problem: The problem; None if nothing is on the table.
        features: What the object is.
        table: Where objects may stand.
        middle: The middle of the table [m].

    Raises:
        InvalidValue: If there is none.
    """
    if problem is None:
        return middle
    axes = [np.arange(low + _SPOTS, high - _SPOTS / 2, _SPOTS) for low, high in (table.x, table.y)]
    spots = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 2)
    sizes = np.array([item.features[:2] for item in problem.objects]) + features[:2]
    away = np.abs(spots[:, None] - problem.scene().positions[:, :2])  # (spots, M, 2)
    free = spots[np.all(np.any(away >= sizes / 2, axis=2), axis=1)]
    if not len(free):
        raise InvalidValue("There is no room for another object; take one away, or make one smaller.")
    x, y = free[np.argmin(np.linalg.norm(free - middle, axis=1))].tolist()
    return x, y
