"""Problems: what they refuse and when they are met; spots are places whose names say where they lie."""

import msgspec
import numpy as np
import pytest
from tables import BOUNDS, item, problem
from toy_domain import WORLD
from toy_places import NAME, grounding, scene, swap

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.execution.performance import rerun
from neurosym.pddl.plan_reading import read_plan
from neurosym.planners import PlanStatus
from neurosym.planners.planner import Planner, PlanResult, Query
from neurosym.planners.registry import solve_checked
from neurosym.problems import Problem, check_goals, spot_name, spot_named
from neurosym.tasks.transition import PlanStep, print_plan, validate


def test_problem_is_met_only_if_every_goal_is():
    there = np.array([problem().goals["item-01"], problem().goals["item-02"]])
    assert problem().is_met(there)
    assert problem().is_met(there + np.array([[0.0, 0.03, 0.039], [0, 0, 0]]))
    assert not problem().is_met(there + np.array([[0.0, 0.03, 0.041], [0, 0, 0]]))
    assert not problem().is_met(there + np.array([[0, 0, 0], [0.06, 0, 0]]))


ONE = item("item-01", 0.5, 0.0)
ODD = msgspec.structs.replace(item("item-02", 0.6, 0.0), features=(0.05, 0.05))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        *(
            ({"objects": (item(name, 0.5, 0.0),)}, "legal name")
            for name in ("Item-01", "1st", "item_01", "", "item 1", "über")
        ),
        ({"objects": (ONE, ONE)}, "Two objects are called item-01"),
        ({"objects": (ONE, ODD)}, "item-02 has 2 features, item-01 has 4; give all as many"),
        ({"objects": (), "goals": {"item-01": (0.5, 0.0, 0.0)}}, "A scene needs one object or more"),
        ({"goals": {"item-9": (0.5, 0.0, 0.0)}}, r"goal for item-9.*objects: item-01"),
        ({"name": "a" * 300}, r"aaa\.\.\. has 300 characters; valid: at most 100"),
        ({"tolerance": 0.0}, "tolerance"),
    ],
)
def test_problem_that_cannot_be_is_refused(change, said):
    with pytest.raises(InvalidValue, match=said):
        Problem(**{"name": "p", "objects": (ONE,), "goals": {}, **change})


@pytest.mark.parametrize(
    ("goal", "axis"), [((0.2, 0, 0.1), "x"), ((0.5, 0.31, 0.1), "y"), ((0.5, 0, 0.5), "z")]
)
def test_goal_off_the_table_is_refused_with_the_valid_ranges(goal: tuple[float, float, float], axis: str):
    astray = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": goal})
    with pytest.raises(
        InvalidValue, match=rf"item-01 has {axis} = .*x 0.3 to 0.9, y -0.3 to 0.3, z 0 to 0.4"
    ):
        check_goals(astray, BOUNDS, (0.0, 0.4))
    check_goals(problem(), BOUNDS, (0.0, 0.4))
    with pytest.raises(InvalidValue, match="no goal"):
        check_goals(Problem("p", (ONE,), {}), BOUNDS, (0.0, 0.4))


# Spots


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
