"""Problems: what they refuse, when they are met, and that they survive their file."""

from pathlib import Path

import msgspec
import numpy as np
import pytest
from tables import BOUNDS, item, problem

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.problems import Problem, check_goals


def test_problem_survives_its_file(tmp_path: Path):
    problem().save(tmp_path / "errand.scene.json")
    assert Problem.load(tmp_path / "errand.scene.json") == problem()


def test_scene_has_the_objects_in_order():
    scene = problem().scene()
    assert scene.positions.tolist() == [[0.4512, 0.0133, 0.025], [0.6, -0.1, 0.02]]
    assert scene.features.shape == (2, 4)
    assert scene.orientations[0].tolist() == [0, 0, 0, 1]


def test_problem_is_met_only_if_every_goal_is():
    there = np.array([problem().goals["item-01"], problem().goals["item-02"]])
    assert problem().is_met(there)
    assert problem().is_met(there + np.array([[0.0, 0.03, 0.039], [0, 0, 0]]))
    assert not problem().is_met(there + np.array([[0.0, 0.03, 0.041], [0, 0, 0]]))
    assert not problem().is_met(there + np.array([[0, 0, 0], [0.06, 0, 0]]))


def test_object_without_a_goal_may_be_anywhere():
    free = msgspec.structs.replace(problem(), goals={"item-02": (0.545, -0.087, 0.02)})
    assert free.is_met(np.array([[9.0, 9.0, 9.0], [0.545, -0.087, 0.02]]))


@pytest.mark.parametrize("name", ["Item-01", "1st", "item_01", "", "item 1", "über"])
def test_name_that_pddl_would_not_take_is_refused(name: str):
    with pytest.raises(InvalidValue, match="legal name"):
        Problem("p", (item(name, 0.5, 0.0),), {})


def test_two_objects_of_one_name_are_refused():
    with pytest.raises(InvalidValue, match="Two objects are called item-01"):
        Problem("p", (item("item-01", 0.5, 0.0), item("item-01", 0.6, 0.0)), {})


def test_goal_for_an_unknown_object_is_refused_with_the_known_ones():
    with pytest.raises(InvalidValue, match=r"goal for item-9.*objects: item-01"):
        Problem("p", (item("item-01", 0.5, 0.0),), {"item-9": (0.5, 0.0, 0.0)})


def test_objects_with_other_features_than_the_first_are_named():
    odd = msgspec.structs.replace(item("item-02", 0.6, 0.0), features=(0.05, 0.05))
    with pytest.raises(InvalidValue, match="item-02 has 2 features, item-01 has 4; give all as many"):
        Problem("p", (item("item-01", 0.5, 0.0), odd), {})


def test_scene_without_objects_is_refused_whatever_its_goals():
    with pytest.raises(InvalidValue, match="A scene needs one object or more"):
        Problem("p", (), {"item-01": (0.5, 0.0, 0.0)})


def test_name_too_long_for_a_file_is_refused():
    with pytest.raises(InvalidValue, match=r"aaa\.\.\. has 300 characters; valid: at most 100"):
        Problem("a" * 300, (item("item-01", 0.5, 0.0),), {})


def test_tolerance_of_nothing_is_refused():
    with pytest.raises(InvalidValue, match="tolerance"):
        Problem("p", (item("item-01", 0.5, 0.0),), {}, tolerance=0.0)


@pytest.mark.parametrize(
    ("goal", "axis"), [((0.2, 0, 0.1), "x"), ((0.5, 0.31, 0.1), "y"), ((0.5, 0, 0.5), "z")]
)
def test_goal_off_the_table_is_refused_with_the_valid_ranges(goal: tuple[float, float, float], axis: str):
    astray = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": goal})
    with pytest.raises(
        InvalidValue, match=rf"item-01 has {axis} = .*x 0.3 to 0.9, y -0.3 to 0.3, z 0 to 0.4"
    ):
        check_goals(astray, BOUNDS, (0.0, 0.4))


def test_goals_on_the_table_pass():
    check_goals(problem(), BOUNDS, (0.0, 0.4))


def test_problem_without_goals_is_refused_when_checked():
    with pytest.raises(InvalidValue, match="no goal"):
        check_goals(Problem("p", (item("item-01", 0.5, 0.0),), {}), BOUNDS, (0.0, 0.4))


@pytest.mark.parametrize(
    "content", ["{}", "not json", '{"name": "p", "objects": [], "goals": {"a": [1, 2, 3]}}']
)
def test_file_that_is_no_problem_is_refused(tmp_path: Path, content: str):
    path = tmp_path / "bad.scene.json"
    path.write_text(content)
    with pytest.raises(InvalidFile, match=r"bad\.scene\.json"):
        Problem.load(path)
