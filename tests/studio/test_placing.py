"""What cannot be is said of the thing that it is about, and nothing else is complained of."""

import numpy as np
import pytest
from toy_domain import grounding, problem

from neurosym.studio import setting
from neurosym.studio.placing import REACH_CELL, reach_of, why_beyond, why_not_there
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import validate

TABLE = grounding().table
SCENE = problem({"item-01": (0.6, 0.16, 0.025)})


def test_scene_that_can_be_has_no_complaints():
    assert why_not_there(SCENE, "item-01", "object", TABLE) == ""
    assert why_not_there(SCENE, "item-01", "goal", TABLE) == ""


@pytest.mark.parametrize("at", [(0.39, 0.0), (1.01, 0.0), (0.6, 0.31), (0.6, -0.31)])
def test_off_the_table_is_said(at):
    assert (
        why_not_there(setting.moved(SCENE, "item-01", *at), "item-01", "object", TABLE)
        == "item-01 is off the table"
    )
    goal = setting.with_goal(SCENE, "item-01", *at)
    assert why_not_there(goal, "item-01", "goal", TABLE) == "the goal of item-01 is off the table"


def test_object_in_another_is_said_of_both():
    after = setting.moved(SCENE, "item-01", 0.79, 0.1)
    assert why_not_there(after, "item-01", "object", TABLE) == "item-01 is in item-02"
    assert why_not_there(after, "item-02", "object", TABLE) == "item-02 is in item-01"


def test_goal_may_lie_where_an_object_leaves_and_not_where_one_stays():
    there = setting.with_goal(SCENE, "item-01", 0.8, 0.1)
    assert why_not_there(there, "item-01", "goal", TABLE) == "the goal of item-01 is in item-02"
    leaves = setting.with_goal(there, "item-02", 0.5, -0.2)
    assert why_not_there(leaves, "item-01", "goal", TABLE) == ""


def test_goal_above_an_object_is_not_in_it():
    above = setting.with_goal(SCENE, "item-01", 0.8, 0.1, 0.225)
    assert why_not_there(above, "item-01", "goal", TABLE) == ""


@pytest.mark.parametrize("steps", [0, 1, 2, 3])
def test_reach_is_all_that_so_many_steps_lead_to(steps):
    learned, scene = grounding(), setting.without_object(problem({}), "item-02")
    reach = reach_of(scene.objects[0], learned, steps)
    found = {scene.objects[0].position[:2]}
    names = ("push-left-001-cube", "push-forward-010-cube")
    plans = [[]]
    for _ in range(steps):
        plans = [[*plan, PlanStep(name, "item-01")] for plan in plans for name in names]
        for plan in plans:
            replayed = validate(plan, scene, learned)
            if replayed.possible:
                found.add(tuple(replayed.positions[-1][0, :2].round(6)))
    assert reach.cells.sum() == len(found)
    for x, y in found:
        assert reach.distance(x, y) == 0.0
    assert not reach.is_everywhere


def test_reach_is_drawn_on_the_table_only():
    reach = reach_of(problem({}).objects[1], grounding(), 9)
    centres = reach.centres()
    low, high = np.array([TABLE.x, TABLE.y]).T
    assert np.all((centres > low) & (centres < high))
    assert reach.cells.shape == (round(0.6 / REACH_CELL), round(0.6 / REACH_CELL))


def test_goal_beyond_reach_is_a_warning_with_a_distance():
    reach = reach_of(SCENE.objects[0], grounding(), 2)
    assert why_beyond(SCENE, "item-01", reach) == ""
    behind = setting.with_goal(SCENE, "item-01", 0.45, 0.0)
    assert "mm beyond what 2 steps reach" in why_beyond(behind, "item-01", reach)


def test_goal_in_the_air_is_not_asked_about():
    high = setting.with_goal(SCENE, "item-01", 0.45, 0.0, 0.225)
    assert why_beyond(high, "item-01", reach_of(SCENE.objects[0], grounding(), 1)) == ""
