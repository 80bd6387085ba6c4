"""Meeting: one try of an object, from where it stands in a scene, with the other objects taken aside."""

from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.execution.performance import perform
from neurosym.grounding import Grounding
from neurosym.planners.registry import plan
from neurosym.problems import Problem, SceneObject, Trial
from neurosym.tasks.pasts import keeps, past_of, trial_of
from neurosym.tasks.transition import PlanStep
from neurosym.tasks.tries import next_try
from neurosym.world import Table, World

_STREAM = 0x6D656574  # keeps the randomness of tries apart from any other
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
    (item,) = scene.objects
    steps = plan(scene, grounding).steps if scene.unmet else ()
    chosen = next_try(item, grounding, [step.base for step in steps])
    if chosen is None:
        return None
    operator, promise = chosen
    aim = None
    if operator.frame == "place":
        x, y = _place(item, grounding.table)
        aim = grounding.table.nearest(x - promise.resting_effect[0], y - promise.resting_effect[1])
    step = PlanStep(operator.name, item.name)
    outcome = perform(world, scene, grounding, step, scene.scene(), put_down=True, reference=aim)
    if outcome is None:
        raise InvalidValue(f"{item.name} is out of the arm's reach; move it nearer to the table's middle.")
    trial = trial_of(outcome, operator, grounding)
    return Tried(operator.name, trial, keeps(promise, trial))


def _place(item: SceneObject, table: Table) -> tuple[float, float]:
    """Draw where to carry an object, away from where it stands, all of it on the table."""
    rng = np.random.default_rng([_STREAM, len(past_of(item)), *item.name.encode()])
    half = np.array(item.features[:2]) / 2
    low, high = np.array([table.x, table.y]).T
    while True:
        spot = rng.uniform(low + half, high - half)
        if np.linalg.norm(spot - item.position[:2]) >= _NEAR:
            return float(spot[0]), float(spot[1])
