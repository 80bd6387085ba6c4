"""A tower is planned and built in the robot's world, by the action that a person wrote to carry things."""

import numpy as np
import pytest
import toy_relations
from toy_relations import LIE, REST, scene

from neurosym.execution.executor import execute
from neurosym.execution.performance import compare_runs, rerun
from neurosym.planners import plan
from neurosym.problems import Problem
from neurosym.sim.tabletop import Tabletop
from tools.benchmarks.world.hand_written import carry_to

WORLD = Tabletop()
LEARNED = toy_relations.grounding(WORLD)


def run_of(problem: Problem):
    result = plan(problem, LEARNED)
    assert result.has_plan, result.reason
    return execute(WORLD, problem, LEARNED, result.steps, replanner=plan)


def test_tower_of_three_is_built_at_a_place_by_the_hand_written_action():
    np.testing.assert_array_equal(carry_to(np.array(toy_relations.CUBE)), toy_relations.CARRY)
    objects = scene(("cube", 0.5, -0.2), ("block", 0.75, 0.1), ("cube", 0.7, -0.1))
    relations = (("item-01", "item-03", REST), ("item-03", "item-02", REST))
    problem = Problem("tower", objects, {"item-02": (0.45, 0.2, 0.025)}, 0.03, relations=relations)
    run = run_of(problem)
    assert run.reached, run.reason
    assert run.steps[-1].relations == {"item-01": f"{REST} item-03", "item-03": f"{REST} item-02"}
    assert run.steps[-1].positions["item-01"][2] == pytest.approx(0.125, abs=0.003)
    assert compare_runs(run, rerun(WORLD, problem, LEARNED, run)).course == "same bytes"


def test_what_is_in_a_tray_is_taken_out_and_put_into_another():
    objects = scene(("cube", 0.5, -0.15, 0.006), ("tray", 0.5, -0.15), ("tray", 0.7, 0.15))
    problem = Problem("move", objects, {}, 0.03, relations=(("item-01", "item-03", LIE),))
    run = run_of(problem)
    assert run.reached, run.reason
