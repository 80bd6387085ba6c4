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
from neurosym.pddl.validation import validate
from neurosym.planners.result import PlanResult, PlanStatus
from neurosym.problems import Problem, SceneObject

BESIDE = 0.02
"""Room for the hand beside the way of what is led [m]."""

NEARER = 0.5
"""What is led is to come so near to its goal if others have no room else, as a share of the tolerance."""

_Solve = Callable[[Problem], PlanResult]
_Goals = Mapping[str, Vector]


def plan_in_turns(problem: Problem, grounding: Grounding, carry: _Solve, lead: _Solve) -> PlanResult:
    """Carry what stands in the way of what must be led, then lead this, and then carry the rest.

    A way is looked for as if there were nothing that can be carried. What has its goal beside that way is
    carried there first, and what stands in it and has its goal there is put aside. If that fails, only what
    stands in the way is carried first; and if that fails, nothing is.

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
        first, begun = _turn(carry, problem, before, problem.tolerance, grounding)
        if first.status is not PlanStatus.SOLVED:
            result = first
            continue
        for near in (1.0, NEARER):
            second, now = _turn(lead, begun, led, near * problem.tolerance, grounding)
            if second.status is not PlanStatus.SOLVED:
                result = second
                continue
            third, _ = _turn(carry, now, carried, problem.tolerance, grounding)
            if third.status is not PlanStatus.SOLVED:
                result = third
                continue
            steps = (*first.steps, *second.steps, *third.steps)
            checked = validate(steps, problem, grounding)
            if checked.valid:
                return dataclasses.replace(third, steps=steps)
            result = dataclasses.replace(third, status=PlanStatus.FAILED, steps=(), reason=checked.reason)
    return result


def _turn(
    solve: _Solve, problem: Problem, goals: _Goals, tolerance: float, grounding: Grounding
) -> tuple[PlanResult, Problem]:
    """Plan for some goals, and return the plan and the problem with the objects where it leads them."""
    task = msgspec.structs.replace(problem, goals=dict(goals), tolerance=tolerance)
    if not goals or not task.unmet:
        return PlanResult(PlanStatus.SOLVED, (), 0.0), problem
    result = solve(task)
    if result.status is not PlanStatus.SOLVED:
        return result, problem
    ends = validate(result.steps, task, grounding).positions[-1]
    moved = zip(problem.objects, map(vector, ends), strict=True)
    objects = tuple(msgspec.structs.replace(item, position=end) for item, end in moved)
    return result, msgspec.structs.replace(problem, objects=objects)


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
        positions = validate(way.steps, alone, grounding).positions
        everything, needed = _out_of_the_way(positions, others, problem, can_be, carried)
        yield everything
        if needed.keys() < everything.keys():
            yield needed
    yield {}


def _out_of_the_way(
    way: Float[np.ndarray, "steps M 3"],
    led: Sequence[SceneObject],
    problem: Problem,
    can_be: Sequence[str],
    carried: _Goals,
) -> tuple[_Goals, _Goals]:
    """Return goals that lie beside a way, with places aside for others that stand in it; and what must go."""
    apart = footprints_apart(problem) + BESIDE
    rows = {name: row for row, name in enumerate(problem.object_names)}
    columns = [rows[item.name] for item in led]

    def is_in_it(name: str, spot: Sequence[float]) -> bool:
        away = np.abs(way[..., :2] - np.array(spot[:2]))  # (steps, M, 2)
        return bool(np.any(np.all(away < apart[rows[name], columns], axis=-1)))

    places = problem.places if isinstance(problem.places, dict) else {}
    parks = [spot for name, spot in places.items() if name.startswith(PARK)]
    before = dict[str, Vector]()
    in_it = [name for name in can_be if is_in_it(name, problem.object_named(name).position)]
    for name in can_be:
        if name in carried and not is_in_it(name, carried[name]):
            before[name] = carried[name]
        elif name in in_it:
            free = [spot for spot in parks if not is_in_it(name, spot)]
            if free:
                parks.remove(free[0])
                before[name] = (*free[0], problem.object_named(name).position[2])
    return before, {name: goal for name, goal in before.items() if name in in_it}
