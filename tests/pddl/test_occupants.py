"""Who may be carried where: to goals, to places to park on, and if these are few to goals of others."""

import msgspec
import numpy as np
import pytest
from toy_places import CUBE, grounding, scene, swap

from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem
from neurosym.tasks.task import footprints_apart, occupants, parks_wanted, with_places
from neurosym.tasks.transition import validate


def test_where_there_are_enough_parks_nobody_waits_on_a_goal():
    problem = with_places(swap(), grounding())
    assert occupants(problem, problem.object_names) == {
        "goal-item-01": ("item-01",),
        "goal-item-02": ("item-02",),
        "park-01": problem.object_names,
        "park-02": problem.object_names,
    }


def ring() -> Problem:
    """Three cubes, each to go where the next one stands, and one place to wait: the goal of a fourth."""
    spots = [(0.5, -0.2), (0.5, 0.0), (0.5, 0.2), (0.8, 0.2)]
    goals = {f"item-{n + 1:02d}": (*spots[(n + 1) % 3], 0.025) for n in range(3)}
    goals["item-04"] = (0.8, -0.2, 0.025)
    places = {f"goal-{name}": goal[:2] for name, goal in goals.items()}
    cubes = scene(*(("cube", *spot) for spot in spots))
    return msgspec.structs.replace(Problem("ring", cubes, goals, 0.02), places=places)


def test_where_there_are_no_parks_objects_wait_on_goals_of_others():
    problem = ring()
    assert occupants(problem, problem.object_names)["goal-item-04"] == problem.object_names
    result = plan(problem, grounding())
    assert result.status is PlanStatus.SOLVED, result.reason
    assert all(step.place for step in result.steps)
    assert validate(result.steps, problem, grounding()).valid


@pytest.mark.parametrize("seed", range(20))
def test_no_two_that_may_stand_at_places_stand_in_each_other(seed):
    rng = np.random.default_rng(seed)
    cubes = tuple(
        msgspec.structs.replace(one, features=(*rng.uniform(0.03, 0.2, 2).tolist(), *CUBE[2:]))
        for one in scene(*(("cube", x, y) for x in (0.4, 0.6, 0.8) for y in (-0.2, 0.2)))
    )
    goals = {f"item-{n:02d}": (*rng.uniform((0.4, -0.25), (0.9, 0.25)).tolist(), 0.025) for n in (1, 3, 5)}
    problem = with_places(Problem("full", cubes, goals, 0.02), grounding())
    apart, names = footprints_apart(problem), problem.object_names
    may = occupants(problem, names)
    assert parks_wanted(problem) == len(names)
    assert all(name in may[f"goal-{name}"] for name in goals)
    for here, mine in may.items():
        for there, its in may.items():
            away = np.abs(np.subtract(problem.place_named(here), problem.place_named(there)))
            clash = [
                (one, other)
                for one in mine
                for other in its
                if here != there
                and one != other
                and np.all(away < apart[names.index(one), names.index(other)])
            ]
            assert all(f"goal-{one}" == here and f"goal-{other}" == there for one, other in clash)
