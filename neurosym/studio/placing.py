"""What cannot be, said while something is dragged: off the table, in another object, or beyond reach."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Bool, Float

from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE
from neurosym.pddl.place_domain import carriers_for
from neurosym.problems import Problem, SceneObject
from neurosym.promises import usable
from neurosym.table import Table

REACH_CELL = 0.01
"""Edge of the cells that the reach of an object is drawn with [m]."""
REACH_STEPS = 3
"""How many primitives with an object its reach is drawn for."""
Kind = Literal["object", "goal"]


@dataclass(frozen=True, slots=True, eq=False)
class Reach:
    """Where the operators of the domain bring an object within some steps, as they promise for it.

    Attributes:
        steps: How many primitives at most.
        corner: Least x and y of the table [m].
        cells: Which cells are reached, of `REACH_CELL` each, x first; the object's own is one.
        is_everywhere: Whether it can be carried anywhere on the table.
    """

    steps: int
    corner: tuple[float, float]
    cells: Bool[np.ndarray, "X Y"]
    is_everywhere: bool

    def centres(self) -> Float[np.ndarray, "N 2"]:
        """Return the centres of the cells that are reached [m]."""
        return np.asarray(np.argwhere(self.cells) * REACH_CELL + np.array(self.corner) + REACH_CELL / 2)

    def distance(self, x: float, y: float) -> float:
        """Return how far a point is from what is reached, about [m]."""
        if self.is_everywhere:
            return 0.0
        apart = np.linalg.norm(self.centres() - np.array([x, y]), axis=1)
        return max(0.0, float(apart.min(initial=np.inf)) - REACH_CELL)


def reach_of(item: SceneObject, grounding: Grounding, steps: int = REACH_STEPS) -> Reach:
    """Work out where an object can be brought to, on the table.

    Args:
        item: The object.
        grounding: The learned domain.
        steps: How many primitives at most.
    """
    table = grounding.table
    shape = tuple(max(1, round((high - low) / REACH_CELL)) for low, high in (table.x, table.y))
    corner = (table.x[0], table.y[0])
    cells = np.zeros(shape, dtype=bool)
    here = np.floor((np.array(item.position[:2]) - corner) / REACH_CELL).astype(int)
    cells[tuple(np.clip(here, 0, np.array(shape) - 1))] = True
    everywhere = bool(carriers_for(item, grounding, TOLERANCE))
    if everywhere:
        return Reach(steps, corner, np.ones(shape, dtype=bool), is_everywhere=True)
    shifts = {
        tuple(np.rint(np.array(operator.promise.resting_effect[:2]) / REACH_CELL).astype(int).tolist())
        for operator in usable(grounding, item)
        if operator.promise is not None
        and not (is_lift(operator) and not any(operator.promise.resting_effect))
    }
    for _ in range(steps):
        cells = np.logical_or.reduce([cells, *(_shifted(cells, x, y) for x, y in shifts)])
    return Reach(steps, corner, cells, is_everywhere=False)


def _shifted(cells: Bool[np.ndarray, "X Y"], x: int, y: int) -> Bool[np.ndarray, "X Y"]:
    """Move what is reached by some cells; what leaves the table is gone."""
    width, depth = cells.shape
    found = np.zeros_like(cells)
    if abs(x) < width and abs(y) < depth:
        found[max(0, x) : width + min(0, x), max(0, y) : depth + min(0, y)] = cells[
            max(0, -x) : width + min(0, -x), max(0, -y) : depth + min(0, -y)
        ]
    return found


def why_not_there(problem: Problem, name: str, kind: Kind, table: Table) -> str:
    """Say why an object or its goal cannot be where it is, or nothing.

    Two goals may not be in one place, nor a goal in an object that is to stay. A goal above the table is only
    asked to be over it.

    Args:
        problem: The problem.
        name: Name of the object.
        kind: Whether it is about where the object starts, or about its goal.
        table: Where objects may stand.
    """
    item = problem.object_named(name)
    x, y, z = item.position if kind == "object" else problem.goals[name]
    called = name if kind == "object" else f"the goal of {name}"
    if not table.contains(np.array([x, y, z])):
        return f"{called} is off the table"
    for other in problem.objects:
        if other.name == name:
            continue
        there = other.position if kind == "object" else problem.goals.get(other.name, other.position)
        apart = (np.array(item.features[:2]) + np.array(other.features[:2])) / 2
        is_over = np.all(np.abs(np.array([x, y]) - np.array(there[:2])) < apart)
        if is_over and abs(z - there[2]) < (item.features[2] + other.features[2]) / 2 - 1e-6:
            has_goal = kind == "goal" and other.name in problem.goals
            return f"{called} is in {f'the goal of {other.name}' if has_goal else other.name}"
    return ""


def why_beyond(problem: Problem, name: str, reach: Reach) -> str:
    """Say that a goal is farther than some primitives bring its object, or nothing.

    It is a warning: a longer plan may come there, and a goal in the air is not asked about.

    Args:
        problem: The problem.
        name: Name of an object with a goal.
        reach: Where the object can be brought to.
    """
    x, y, z = problem.goals[name]
    if abs(z - problem.object_named(name).position[2]) > problem.tolerance:
        return ""
    beyond = reach.distance(x, y) - problem.tolerance
    if beyond <= 0:
        return ""
    return f"the goal of {name} is {1000 * beyond:.0f} mm beyond what {reach.steps} steps reach"


def relation_of_drop(problem: Problem, name: str) -> str | None:
    """Name the object that a goal was dropped on, whose goal or place it shares, if there is one.

    This is where a ghost dropped on another becomes a goal `a on b`, once a domain knows relations. Until
    then a page says that both cannot be there (`why_not_there`).

    Args:
        problem: The problem.
        name: Name of the object whose goal was dropped.
    """
    goal = problem.goals.get(name)
    for other in problem.objects:
        if goal is None or other.name == name:
            continue
        x, y, _ = problem.goals.get(other.name, other.position)
        half = np.array(other.features[:2]) / 2
        if np.all(np.abs(np.array(goal[:2]) - (x, y)) < half):
            return other.name
    return None
