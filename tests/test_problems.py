"""Problems: what they refuse, when they are met, and that they survive their file."""

from pathlib import Path

import msgspec
import numpy as np
import pytest
from tables import BOUNDS, item, problem

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.problems import Problem, check_goals


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


@pytest.mark.parametrize(
    "content", ["{}", "not json", '{"name": "p", "objects": [], "goals": {"a": [1, 2, 3]}}']
)
def test_file_that_is_no_problem_is_refused(tmp_path: Path, content: str):
    path = tmp_path / "bad.scene.json"
    path.write_text(content)
    with pytest.raises(InvalidFile, match=r"bad\.scene\.json"):
        Problem.load(path)
