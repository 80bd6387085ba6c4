"""What cannot be is said of the thing that it is about, and nothing else is complained of."""

import numpy as np
import pytest
from toy_domain import grounding, problem

from neurosym.errors import InvalidValue
from neurosym.problems import Problem
from neurosym.studio import scene_editor
from neurosym.studio.scene_editor import free_spot, why_not_there

TABLE = grounding().table
SCENE = problem({"item-01": (0.6, 0.16, 0.025)})
OFF = [(0.39, 0.0), (1.01, 0.0), (0.6, 0.31), (0.6, -0.31)]


def moved(x: float, y: float) -> Problem:
    return scene_editor.moved(SCENE, "item-01", x, y)


def aimed(x: float, y: float, z: float | None = None) -> Problem:
    return scene_editor.with_goal(SCENE, "item-01", x, y, z)


@pytest.mark.parametrize(
    ("scene", "name", "kind", "said"),
    [
        (SCENE, "item-01", "object", ""),
        (SCENE, "item-01", "goal", ""),
        *((moved(*at), "item-01", "object", "item-01 is off the table") for at in OFF),
        *((aimed(*at), "item-01", "goal", "the goal of item-01 is off the table") for at in OFF),
        (moved(0.79, 0.1), "item-01", "object", "item-01 is in item-02"),
        (moved(0.79, 0.1), "item-02", "object", "item-02 is in item-01"),
        (aimed(0.8, 0.1), "item-01", "goal", "the goal of item-01 is in item-02"),
        (scene_editor.with_goal(aimed(0.8, 0.1), "item-02", 0.5, -0.2), "item-01", "goal", ""),  # it leaves
        (aimed(0.8, 0.1, 0.225), "item-01", "goal", ""),  # above it
    ],
)
def test_what_cannot_be_where_it_is_is_said(scene, name, kind, said):
    assert why_not_there(scene, name, kind, TABLE) == said


def test_room_for_another_object_is_beside_those_that_are_there():
    for middle in ((0.6, 0.0), (0.8, 0.1)):
        x, y = free_spot(SCENE, (0.05, 0.05, 0.05, 0.0), TABLE, middle)
        there = scene_editor.with_object(
            SCENE, (0.05, 0.05, 0.05, 0.0), x, y, lambda rows: ("0",) * len(rows)
        )
        assert why_not_there(there, there.object_names[-1], "object", TABLE) == ""
        assert np.hypot(x - middle[0], y - middle[1]) < 0.11
    with pytest.raises(InvalidValue, match="no room"):
        free_spot(SCENE, (1.5, 1.5, 0.05, 0.0), TABLE, (0.6, 0.0))
