"""What is made up for measuring scale is what it says, and the page tells it."""

import numpy as np

from neurosym.data.interactions import examine
from neurosym.data.origin import training_problems
from neurosym.planners import plan
from tools.benchmarks.scale.made import made_domain, made_problem, write_data


def test_made_data_can_be_trained_on(tmp_path):
    write_data(tmp_path / "interactions.npz", 200)
    found = examine(tmp_path / "interactions.npz")
    assert not [*found.problems, *training_problems(found.columns, found.origin)]
    assert len(found.interactions) == 200
    assert np.any(found.interactions.held)


def test_made_problem_has_a_plan_for_each_object():
    grounding = made_domain(3, 9)
    problem = made_problem(grounding, 9)
    assert {step.object for step in plan(problem, grounding, planner="counting").steps} == set(problem.goals)
