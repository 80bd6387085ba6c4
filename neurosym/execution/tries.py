"""Tries of an object: what a plan would do first is performed from where the object stands."""

from collections.abc import Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidValue, counted
from neurosym.execution.performance import perform
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.planners.registry import plan
from neurosym.problems import Problem, SceneObject, Trial
from neurosym.tasks.lying import as_it_shows
from neurosym.tasks.options import puts_of
from neurosym.tasks.pasts import GRASPED, as_it_lies, keeps, motion_of, never_seen, past_of, trial_of
from neurosym.tasks.promises import promised
from neurosym.tasks.transition import PlanStep
from neurosym.world import Table, World

_STREAM = 0x6D656574  # keeps the randomness of tries apart from any other
SURELY = 0.5
"""An object that is carried more rarely than that is tried to be carried as those of other categories are."""
_DRAWS = 100
_NEAR = 0.1  # nothing is carried to a place that is nearer to where it stands [m]


@dataclass(frozen=True, slots=True)
class Tried:
    """What was tried with an object, and what came of it."""

    operator: str  # name of the operator
    trial: Trial
    kept: bool  # whether it did as was believed it would


def alone(problem: Problem, name: str) -> Problem:
    """Return the scene of one object of a problem, with its goal if it has one."""
    items, goals = (problem.object_named(name),), {name: problem.goals[name]} if name in problem.goals else {}
    return msgspec.structs.replace(
        problem,
        objects=items,
        goals=goals,
        relations=(),
        conditions=(),
        upright=(),
        headings={},
        touching=None,
    )


def try_once(world: World, scene: Problem, grounding: Grounding) -> Tried | None:
    """Try with the one object of a scene what a plan for it would do first; None if nothing can be tried.

    What is carried goes to a place that the object's name and the length of its past decide.

    Raises:
        InvalidValue: If the object is out of the arm's reach.
    """
    item = as_it_shows(scene.objects[0], grounding)
    steps = plan(scene, grounding).steps if scene.unmet else ()
    operator, aim = _next(item, grounding, [step.base for step in steps], _way(scene)), None
    if operator is None or (promise := operator.promise) is None:
        return None
    if operator.frame == "place":
        x, y = _place(item, grounding.table)
        aim = grounding.table.nearest(x - promise.resting_effect[0], y - promise.resting_effect[1])
    step = PlanStep(operator.name, item.name)
    outcome = perform(world, scene, grounding, step, scene.scene(), put_down=True, reference=aim)
    if outcome is None:
        raise InvalidValue(f"{item.name} is out of the arm's reach; move it nearer to the table's middle.")
    kept = keeps(promise, trial_of(outcome, operator, turned=False))  # both as seen from the world
    return Tried(operator.name, trial_of(outcome, operator, grounding.turned), kept)


def _way(scene: Problem) -> Float[np.ndarray, "2"]:
    """Return how far the goal of the one object of a scene is along x and y [m]; 0 if it needs no way."""
    (item,) = scene.objects
    goal = scene.goals[item.name] if scene.unmet else item.position
    return np.subtract(goal, item.position)[:2]


def _next(
    item: SceneObject, grounding: Grounding, planned: Sequence[str], way: Float[np.ndarray, "2"]
) -> Operator | None:
    """Choose what to try with an object that may have a past, as it promises; None if there is nothing.

    That is the first motion of a plan that was not tried; then what carries, first of all by motions that put
    things on others, too; and then what probably leads it farthest towards its goal, or the surest if it has
    none. The same motion mostly does the same again, so that others tell more. Every second try is of what
    carries other categories, if nothing carries this object surely.
    """
    past = past_of(item)
    known = promised(grounding, msgspec.structs.replace(item, past=past)).values()
    tried = {one.motion for one in past}
    promising = [one for one in known if one.promise]
    untried = {one.name: one for one in promising if motion_of(one) not in tried}
    own = [one.chance for one in promising if one.frame == "place" and one.subject == item.category]
    others = [one for one in untried.values() if one.frame == "place" and one.subject != item.category]
    puts = {grounding.primitive_of(one.operator).action for one in puts_of(grounding)}

    def rank(one: Operator) -> tuple[bool, bool, float, str]:
        is_placed = one.frame == "place"
        return is_placed, grounding.primitive_of(one).action in puts, _worth(one, way), one.name

    if others and len(past) % 2 and max(own, default=0.0) < SURELY:
        return max(others, key=rank)
    if first := next((untried[name] for name in planned if name in untried), None):
        return first
    return max(untried.values() or promising, key=rank, default=None)


def _worth(operator: Operator, way: Float[np.ndarray, "2"]) -> float:
    """Return how likely what carries does so; of what pushes, how far it probably leads that way [m]."""
    if operator.frame == "place" or operator.promise is None or not way.any():
        return operator.chance
    led = float(np.dot(operator.promise.resting_effect[:2], way) / np.linalg.norm(way))
    return operator.chance * min(led, float(np.linalg.norm(way)))


def _place(item: SceneObject, table: Table) -> tuple[float, float]:
    """Draw where to carry an object, away from where it stands, and on the table as far as it has room."""
    rng = np.random.default_rng([_STREAM, len(past_of(item)), *item.name.encode()])
    low, high = np.array([table.x, table.y]).T
    half = np.minimum(np.array(item.features[:2]) / 2, (high - low) / 2)
    spots = rng.uniform(low + half, high - half, size=(_DRAWS, 2))
    away = np.linalg.norm(spots - item.position[:2], axis=1)
    x, y = spots[int(np.argmax(away >= _NEAR)) if away.max() >= _NEAR else int(away.argmax())].tolist()
    return x, y


def said_of(item: SceneObject, grounding: Grounding) -> str:
    """Say what an object of some past looks like, whether it does as it looks, and how it is best handled."""
    known = promised(grounding, msgspec.structs.replace(item, past=past_of(item)))
    usual = promised(grounding, never_seen(item)).values()
    promises = {motion_of(one): one.promise for one in usual if one.promise}
    shown = [one for one in as_it_lies(item, grounding.turned) if one.motion in promises and not one.crowded]
    kept = sum(keeps(promises[one.motion], one) for one in shown)
    does = f", and did as such objects do {kept} of {counted(len(shown), 'time')}" if shown else ""
    said = f"{item.name} looks like {grounding.category(item.category).name}{does}"
    grasping = [one for one in known.values() if one.promise and one.promise.kind in GRASPED]
    if not grasping:
        return f"{said}; nothing grasps such objects"
    surest = max(grasping, key=lambda one: (one.chance, one.name))
    handled = "so" if surest.subject == item.category else f"like {grounding.category(surest.subject).name}"
    return f"{said}; it is best grasped {handled}: {surest.name}, {surest.chance:.0%} likely"
