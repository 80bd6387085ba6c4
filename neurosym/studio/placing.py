"""What cannot be, said while something is dragged: off the table, in another object, or beyond reach."""

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE, Vector
from neurosym.problems import Problem, SceneObject
from neurosym.promises import usable
from neurosym.studio import setting
from neurosym.studio.relating import (
    above,
    ghost_spots,
    relation_of_drop,
    stacks_of,
    supports_of,
    under,
    why_not_related,
)
from neurosym.table import Table
from neurosym.tasks.carriers import carriers_for

REACH_CELL = 0.01
"""Edge of the cells that the reach of an object is drawn with [m]."""
REACH_STEPS = 3
"""How many primitives with an object its reach is drawn for."""
_SPOTS = 0.02  # how far apart the places are where an object is tried to be added [m]
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
    ghosts = problem.goals if ghosts is None else ghosts
    item = problem.object_named(name)
    x, y, z = item.position if kind == "object" else problem.goals[name]
    called = name if kind == "object" else f"the goal of {name}"
    if not table.contains(np.array([x, y, z])):
        return f"{called} is off the table"
    for other in problem.objects:
        if other.name == name or other.name in may_be_in:
            continue
        there = other.position if kind == "object" else ghosts.get(other.name, other.position)
        apart = (np.array(item.features[:2]) + np.array(other.features[:2])) / 2
        is_over = np.all(np.abs(np.array([x, y]) - np.array(there[:2])) < apart)
        if is_over and abs(z - there[2]) < (item.features[2] + other.features[2]) / 2 - 1e-6:
            has_goal = kind == "goal" and other.name in ghosts
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


def complaints_about(
    problem: Problem, grounding: Grounding, find_reach: Callable[[str], Reach]
) -> dict[str, str]:
    """Say of each object or goal that cannot be where it is why not, by `object NAME` and `goal NAME`.

    Args:
        problem: The problem, which knows the kinds of its pairs if the domain has any.
        grounding: The learned domain.
        find_reach: Gives where an object can be brought to, by its name.
    """
    found, table, ghosts = dict[str, str](), grounding.table, ghost_spots(problem, grounding)
    stacks = {name: borne.by for name, borne in stacks_of(problem, grounding).items()}
    supports = supports_of(problem, stacks)
    for name in problem.object_names:
        if why := why_not_there(problem, name, "object", table, may_be_in=_pile(name, stacks)):
            found[f"object {name}"] = why
        if name in problem.goals:
            upon = above(name, supports)
            why = why_not_there(problem, name, "goal", table, ghosts=ghosts, may_be_in=upon)
            why = _unless_dropped(why, problem, name, grounding) or why_beyond(
                problem, name, find_reach(name)
            )
            if why:
                found[f"goal {name}"] = why
    return found | {f"goal {name}": why for name, why in why_not_related(problem, grounding).items()}


def _pile(name: str, stacks: Mapping[str, str]) -> tuple[str, ...]:
    """Name all that stands in one pile with an object, itself included."""
    lowest = name
    while lowest in stacks:
        lowest = stacks[lowest]
    return lowest, *above(lowest, stacks)


def _unless_dropped(why: str, problem: Problem, name: str, grounding: Grounding) -> str:
    """Return why a goal cannot be on the table there, or nothing if it may be dropped on what is there."""
    if not why or not grounding.table.contains(np.array(problem.goals[name])):
        return why
    if grounding.relations is None:
        on = under(problem, name, problem.goals)
        return f"{why}; this domain knows no goals like {name} on {on[0]}" if on else why
    return "" if relation_of_drop(problem, grounding, name) else why


def free_spot(
    problem: Problem | None, features: tuple[float, ...], table: Table, middle: tuple[float, float]
) -> tuple[float, float]:
    """Find room for an object, nearest to the middle of the table [m].

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
    xs, ys = (
        [low + _SPOTS * step for step in range(1, round((high - low) / _SPOTS))]
        for low, high in (table.x, table.y)
    )
    spots = sorted(
        ((x, y) for x in xs for y in ys),
        key=lambda at: (at[0] - middle[0]) ** 2 + (at[1] - middle[1]) ** 2,
    )
    for x, y in spots:
        trial = setting.with_object(problem, features, x, y, lambda rows: ("0",) * len(rows))
        if not why_not_there(trial, trial.objects[-1].name, "object", table):
            return x, y
    raise InvalidValue("There is no room for another object; take one away, or make one smaller.")
