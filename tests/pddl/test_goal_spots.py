"""Objects are carried to where there is room for the hand, and never out of their goals."""

import math

import msgspec
import numpy as np
import pytest
from toy_domain import WORLD
from toy_places import CUBE, NAME, grounding, scene

from neurosym.execution.executor import execute
from neurosym.planners import plan
from neurosym.problems import Problem
from neurosym.tasks.task import ROOM, SHARE, goal_spots
from neurosym.tasks.transition import PlanStep

EDGE = CUBE[0]
TABLE = grounding().table
NAMES = ("item-01", "item-02")


def side_by_side(gap: float, tolerance: float = 0.05) -> Problem:
    """Two cubes whose goals lie side by side along y, so far apart [m]."""
    goals = {"item-01": (0.7, 0.0, 0.025), "item-02": (0.7, EDGE + gap, 0.025)}
    return Problem("pair", scene(("cube", 0.5, -0.2), ("cube", 0.5, 0.2)), goals, tolerance)


def test_goals_with_room_between_them_are_the_spots():
    spots = goal_spots(side_by_side(2 * ROOM[1]), TABLE, NAMES)
    assert spots["item-01"] == (0.7, 0.0)
    assert spots["item-02"] == pytest.approx((0.7, EDGE + 2 * ROOM[1]))


def test_goals_that_nearly_touch_make_room_for_the_hand():
    spots = goal_spots(side_by_side(0.01), TABLE, NAMES)
    gap = spots["item-02"][1] - spots["item-01"][1] - EDGE
    assert gap == pytest.approx(ROOM[1], abs=0.002)


def test_less_room_is_made_where_the_goals_allow_less():
    problem = side_by_side(0.0, tolerance=0.01)
    spots = goal_spots(problem, TABLE, NAMES)
    beside = [math.dist(spots[name], problem.goals[name][:2]) for name in NAMES]
    assert beside == pytest.approx([SHARE * 0.01] * 2, abs=1e-4)


def test_what_stands_at_its_goal_stays_and_the_other_makes_room():
    problem = side_by_side(0.01)
    stands = msgspec.structs.replace(problem.objects[0], position=(0.7, 0.01, 0.025))
    spots = goal_spots(
        msgspec.structs.replace(problem, objects=(stands, problem.objects[1])), TABLE, ("item-02",)
    )
    assert spots["item-02"] == pytest.approx((0.7, EDGE + 0.01 + SHARE * 0.05), abs=1e-4)


@pytest.mark.parametrize("seed", range(30))
def test_every_spot_is_in_its_goal_and_on_the_table(seed):
    rng = np.random.default_rng(seed)
    low, high = np.array([TABLE.x, TABLE.y]).T
    goals = {f"item-{n:02d}": (*rng.uniform(low, high).tolist(), 0.025) for n in range(1, 7)}
    cubes = scene(*(("cube", 0.4 + 0.08 * n, -0.2) for n in range(6)))
    problem = Problem("many", cubes, goals, 0.05)
    spots = goal_spots(problem, TABLE, tuple(goals))
    assert spots == goal_spots(problem, TABLE, tuple(goals))
    for name, (x, y, _) in goals.items():
        there = math.dist(problem.object_named(name).position[:2], (x, y)) <= 0.05
        assert math.dist(spots[name], (x, y)) <= (1.0 if there else SHARE) * 0.05 + 1e-4
        assert TABLE.contains(np.array([*spots[name], 0.025]))


def test_run_asks_for_places_anew_when_something_stands_otherwise():
    """Who was set down beside its place is kept clear of by the next."""
    problem = side_by_side(0.0)
    off = msgspec.structs.replace(problem.objects[0], position=(0.7, 0.02, 0.025))
    problem = msgspec.structs.replace(problem, objects=(off, problem.objects[1]))
    steps = [PlanStep(NAME, "item-01", place="goal-item-01")]
    run = execute(WORLD, problem, grounding(), steps, replanner=plan)
    assert run.reached, run.reason
