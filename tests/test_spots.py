"""Spots are places whose names say where they lie."""

import numpy as np
import pytest
from toy_domain import WORLD
from toy_places import NAME, grounding, scene, swap

from neurosym.errors import UnknownChoice
from neurosym.execution.executor import execute
from neurosym.execution.performance import rerun
from neurosym.pddl.plan_reading import read_plan
from neurosym.planners import PlanStatus
from neurosym.planners.planner import Planner, PlanResult, Query
from neurosym.planners.registry import solve_checked
from neurosym.problems import Problem, spot_name, spot_named
from neurosym.tasks.transition import PlanStep, print_plan, validate


def test_names_tell_where_spots_lie_to_a_twentieth_of_a_millimetre():
    assert spot_name(0.55, -0.12) == "spot-5500-m1200"
    for x, y in np.random.default_rng(0).uniform(-1, 1, size=(200, 2)).tolist():
        there = spot_named(spot_name(x, y))
        assert there is not None
        assert np.allclose(there, (x, y), rtol=0, atol=5.1e-5)


@pytest.mark.parametrize(
    "name", ["spot", "spot-1", "spot-1-2-3", "spot-m-1", "spot-1-x", "goal-item-01", "spot-1-1\n"]
)
def test_other_names_are_no_spots(name: str):
    assert spot_named(name) is None
    with pytest.raises(UnknownChoice):
        swap().place_named(name)


def by_a_spot() -> tuple[Problem, tuple[PlanStep, ...]]:
    """A cube that is carried to a spot, and from there to its goal."""
    problem = Problem("detour", scene(("cube", 0.5, -0.1)), {"item-01": (0.8, 0.1, 0.025)}, 0.02)
    return problem, (PlanStep(NAME, "item-01", "spot-6000-m2000"), PlanStep(NAME, "item-01", "goal-item-01"))


def test_plan_leads_over_a_spot_that_the_problem_does_not_name(tmp_path):
    problem, steps = by_a_spot()
    learned = grounding()
    file = tmp_path / "detour.plan"
    file.write_text(print_plan(steps))
    assert read_plan(file, learned, problem) == steps
    checked = validate(steps, problem, learned)
    assert checked.valid, checked.reason
    assert np.allclose(checked.positions[1], [(0.6, -0.2, 0.025)])
    run = execute(WORLD, problem, learned, steps)
    assert run.reached
    assert np.allclose(run.steps[0].positions["item-01"], (0.6, -0.2, 0.025), atol=1e-6)
    assert rerun(WORLD, problem, learned, run) == run


@pytest.mark.parametrize(
    ("spot", "said"),
    [("spot-6000-m2000", ""), ("spot-90000-0", "leaves the table"), ("spot", "no place 'spot'")],
)
def test_planner_of_ones_own_may_carry_to_spots_on_the_table(spot, said):
    problem, steps = by_a_spot()
    steps = (PlanStep(NAME, "item-01", spot), *steps[1:])
    mine = Planner("mine", "Mine", lambda _: PlanResult(PlanStatus.SOLVED, steps, 0.0))
    result = solve_checked(mine, Query(problem, grounding()))
    assert (result.status is PlanStatus.SOLVED) == (not said)
    assert said in result.reason
