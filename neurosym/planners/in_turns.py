"""Planning in turns for what can be carried and for what must be led over cells.

What is led then keeps clear of what was carried, which a plan for all at once does not know.
"""

import dataclasses
from collections.abc import Callable, Iterator, Mapping, Sequence

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.grounding import Grounding
from neurosym.operators import Vector, vector
from neurosym.pddl.footprints import footprints_apart
from neurosym.pddl.place_problem import carried_objects
from neurosym.pddl.places import PARK, with_places
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.validation import validate
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem, SceneObject

BESIDE = 0.02
"""Room for the hand beside the way of what is led [m]."""

_Solve = Callable[[Problem], PlanResult]
_Goals = Mapping[str, Vector]


def plan_in_turns(problem: Problem, grounding: Grounding, carry: _Solve, lead: _Solve) -> PlanResult:
    """Carry what stands in the way of what must be led, then lead this, and then carry the rest.

    A way is looked for as if there were nothing that can be carried. What has its goal beside that way is
    carried there first. What stands in the way and has its goal in it is put aside before. If that
    fails, what must be led is led first, around everything.

    Args:
        problem: The problem.
        grounding: The learned domain.
        carry: Plans for objects that can be carried.
        lead: Plans for others.
    """
    problem = with_places(problem, grounding)
    can_be = carried_objects(problem, grounding)
    carried = {name: goal for name, goal in problem.goals.items() if name in can_be}
    led = {name: goal for name, goal in problem.goals.items() if name not in can_be}
    result = PlanResult(PlanStatus.FAILED, (), 0.0, "everything that has a goal can be carried")
    if not led:
        return result
    for before in _carried_before(problem, grounding, can_be, carried, led, lead):
        now, steps = problem, list[PlanStep]()
        for solve, goals in ((carry, before), (lead, led), (carry, carried)):
            task = msgspec.structs.replace(now, goals=dict(goals))
            if not goals or task.is_met(task.scene().positions):
                continue
            result = solve(task)
            if result.status is not PlanStatus.SOLVED:
                break
            steps += result.steps
            now = _after(result.steps, task, grounding)
        else:
            checked = validate(steps, problem, grounding)
            if checked.valid:
                return dataclasses.replace(result, steps=tuple(steps))
            result = dataclasses.replace(result, status=PlanStatus.FAILED, steps=(), reason=checked.reason)
    return result


def _carried_before(
    problem: Problem,
    grounding: Grounding,
    can_be: Sequence[str],
    carried: _Goals,
    led: _Goals,
    lead: _Solve,
) -> Iterator[_Goals]:
    """List to where things may be carried before anything is led."""
    others = tuple(item for item in problem.objects if item.name not in can_be)
    alone = msgspec.structs.replace(problem, objects=others, goals=dict(led))
    way = lead(alone)
    if way.status is PlanStatus.SOLVED:
        yield _out_of_the_way(
            validate(way.steps, alone, grounding).positions, others, problem, can_be, carried
        )
    yield {}


def _out_of_the_way(
    way: Float[np.ndarray, "steps M 3"],
    led: Sequence[SceneObject],
    problem: Problem,
    can_be: Sequence[str],
    carried: _Goals,
) -> _Goals:
    """Return the goals that lie beside a way, and places aside for the others that stand in it."""
    apart = footprints_apart(problem) + BESIDE
    rows = {name: row for row, name in enumerate(problem.object_names)}
    columns = [rows[item.name] for item in led]

    def is_in_it(name: str, spot: Sequence[float]) -> bool:
        away = np.abs(way[..., :2] - np.array(spot[:2]))  # (steps, M, 2)
        return bool(np.any(np.all(away < apart[rows[name], columns], axis=-1)))

    places = problem.places if isinstance(problem.places, dict) else {}
    parks = [spot for name, spot in places.items() if name.startswith(PARK)]
    before = dict[str, Vector]()
    for name in can_be:
        stands = problem.object_named(name).position
        if name in carried and not is_in_it(name, carried[name]):
            before[name] = carried[name]
        elif is_in_it(name, stands):
            free = [spot for spot in parks if not is_in_it(name, spot)]
            if free:
                parks.remove(free[0])
                before[name] = (*free[0], stands[2])
    return before


def _after(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with the objects where a plan leads them."""
    ends = validate(steps, problem, grounding).positions[-1]
    moved = zip(problem.objects, map(vector, ends), strict=True)
    objects = tuple(msgspec.structs.replace(item, position=end) for item, end in moved)
    return msgspec.structs.replace(problem, objects=objects)
