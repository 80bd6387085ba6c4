"""Scenes that somebody wrote: what the world can be in passes, all else is refused before anything runs."""

import json
import math

import msgspec
import numpy as np
import pytest
import toy_domain
from command_line import refusal
from places import SHIPPED

from neurosym.contract import ObjectLimits, limits_of
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.pddl.problem_check import check_problem
from neurosym.problems import Problem, SceneObject
from neurosym.sim.config import TabletopConfig
from neurosym.stages.folder import DomainFolder
from neurosym.stages.planning import load_problem
from neurosym.worlds.task_drawing import draw_problem
from neurosym.worlds.world_file import read_limits

PLANK = (0.16, 0.04, 0.02, 0.0)
LIMITS = TabletopConfig().object_limits
STANDING = (0.0, math.sqrt(0.5), 0.0, math.sqrt(0.5))
ACROSS = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
DIAGONAL = (0.0, 0.0, math.sin(math.pi / 8), math.cos(math.pi / 8))
WRONG = [
    ({"features": [9, 9, 9, 0]}, "item-01 has s_x = 9 m; valid: 0.03 to 0.18 m"),
    ({"features": [0.05, -0.05, 0.05, 0]}, "item-01 has s_y = -0.05 m; valid"),
    ({"features": [0.05, 0.05, 0.5, 0]}, "item-01 has d = 0.5 m; valid: 0.02 to 0.1 m"),
    ({"features": [0.05, 0.05, 0.05, 7]}, "item-01 has t = 7; valid: 0, 1"),
    ({"features": [0.05, 0.05, 0.05]}, "item-01 has 3 features; valid: s_x, s_y, d, t"),
    ({"position": [5, 5, 5]}, "item-01 stands at x = 5, y = 5 m, off the table"),
    ({"position": [1e8, 0, 0.025]}, "item-01 stands at x = 1e+08, y = 0 m, off the table"),
    ({"position": [1e308, 0, 0.025]}, "Expected `float` <= 1000000000.0"),
    (
        {"position": [0.6, 0.0, -0.5]},
        "item-01 is at z = -0.5 m, where it does not rest; valid: 0.020 to 0.030",
    ),
    ({"position": [0.6, 0.0, 0.035]}, "item-01 is at z = 0.035 m, where it does not rest"),
    ({"orientation": [0, 0, 0, 0]}, "item-01 has an orientation of length 0; valid: a quaternion"),
    ({"orientation": [0, 0, 1e308, 1e308]}, "item-01 has an orientation of length"),
    ({"category": "1111"}, "There is no category '1111'"),
    ({"category": "99"}, "Expected bits, like '10' - at `$.objects[0].category`"),
]
WRONG_GOALS = [
    ({}, "has no goal; give at least one object a goal"),
    ({"item-01": [50, 50, 0]}, "The goal of item-01 has x = 50 m, out of reach; valid: x 0.4 to 1"),
    ({"item-01": [0.6, 0.0, 5]}, "The goal of item-01 has z = 5 m, out of reach"),
    ({"item-09": [0.6, 0.0, 0.03]}, "goal for item-09, which is not in the scene; objects: item-01"),
]


def plank(name: str, x: float, y: float, **changes: object) -> SceneObject:
    return msgspec.structs.replace(SceneObject(name, "00", PLANK, (x, y, 0.01)), **changes)


def check(*items: SceneObject, limits: ObjectLimits | None = LIMITS) -> None:
    goals = {items[0].name: items[0].position}
    check_problem(Problem("p", items, goals), toy_domain.grounding(), limits)


@pytest.mark.parametrize("command", ["plan", "execute"])
@pytest.mark.parametrize(("changes", "message"), WRONG)
def test_object_that_cannot_be_is_refused(folder, capsys, command, changes, message):
    scene = folder / "problems/task-01.scene.json"
    task = json.loads(scene.read_text())
    cube = {"features": [0.05, 0.05, 0.05, 0], "position": [0.6, 0.0, 0.025]}
    task["objects"][0] |= cube | changes
    scene.write_text(json.dumps(task))
    assert_refused(folder, capsys, command, message)


@pytest.mark.parametrize("command", ["plan", "execute"])
@pytest.mark.parametrize(("goals", "message"), WRONG_GOALS)
def test_goals_that_cannot_be_are_refused(folder, capsys, command, goals, message):
    scene = folder / "problems/task-01.scene.json"
    scene.write_text(json.dumps(json.loads(scene.read_text()) | {"goals": goals}))
    assert_refused(folder, capsys, command, message)


def assert_refused(folder, capsys, command, message):
    (folder / "empty.plan").write_text("")
    before = sorted(folder.rglob("*"))
    more = [folder / "empty.plan", "--replans", 0] if command == "execute" else []
    said = refusal(capsys, command, folder, "task-01", *more)
    assert message in said
    assert f"{folder}/problems/task-01.scene.json cannot be used" in said
    assert sorted(folder.rglob("*")) == before


def test_scene_that_cannot_be_is_not_shown(folder, capsys):
    scene = folder / "problems/task-01.scene.json"
    task = json.loads(scene.read_text())
    task["objects"][0]["orientation"] = [0, 0, 0, 0]
    scene.write_text(json.dumps(task))
    assert "item-01 has an orientation of length 0" in refusal(capsys, "show", folder, "--problem", "task-01")


def test_objects_in_one_place_are_refused():
    with pytest.raises(InvalidValue, match=r"item-01 and item-02 stand in one place: the centre of"):
        check(plank("item-01", 0.6, 0.0), plank("item-02", 0.6, 0.0))
    with pytest.raises(InvalidValue, match="put them side by side"):
        check(plank("item-01", 0.6, 0.0), plank("item-02", 0.6, 0.01))
    with pytest.raises(InvalidValue, match="the centre of item-02 lies within item-01"):
        check(plank("item-01", 0.6, 0.0), plank("item-02", 0.66, 0.0, orientation=ACROSS))


def test_objects_that_touch_or_lie_side_by_side_at_an_angle_pass():
    check(plank("item-01", 0.6, 0.0), plank("item-02", 0.6, 0.025))
    off = 0.045 * math.sqrt(0.5)
    turned = plank("item-01", 0.6, 0.0, orientation=DIAGONAL)
    check(turned, plank("item-02", 0.6 - off, off, orientation=DIAGONAL))
    with pytest.raises(InvalidValue, match="stand in one place"):
        check(turned, plank("item-02", 0.6 + off, off, orientation=DIAGONAL))


def test_object_on_another_face_rests_higher():
    check(plank("item-01", 0.6, 0.0, orientation=STANDING, position=(0.6, 0.0, 0.08)))
    with pytest.raises(InvalidValue, match=r"z = 0.01 m, where it does not rest; valid: 0.075 to 0.085"):
        check(plank("item-01", 0.6, 0.0, orientation=STANDING))


def test_object_that_a_push_left_a_little_off_the_table_passes():
    check(plank("item-01", 0.6, 0.0), plank("item-02", 1.05, 0.0))


def test_world_that_does_not_say_what_it_makes_is_asked_for_goals_and_categories_only():
    odd = plank("item-01", 0.6, 0.0, features=(9.0, -1.0), orientation=(0.0, 0.0, 0.0, 0.0))
    check(odd, msgspec.structs.replace(odd, name="item-02"), limits=None)
    with pytest.raises(UnknownChoice, match="no category '7'"):
        check(msgspec.structs.replace(odd, category="7"), limits=None)


def test_world_that_says_something_else_by_that_name_does_not_say_what_it_makes():
    class Odd(type(toy_domain.WORLD)):
        object_limits = "none"

    assert limits_of(Odd(toy_domain.WORLD.config)) is None
    assert limits_of(toy_domain.WORLD) == toy_domain.WORLD.config.object_limits


def test_limits_are_read_without_making_the_world(tmp_path):
    assert read_limits(SHIPPED / "world.toml") == LIMITS
    file = tmp_path / "world.toml"
    file.write_text('world = "tabletop"\n[options]\nsize = [0.05, 0.1]\nshapes = { ring = 1.0, box = 0.0 }\n')
    assert read_limits(file) == ObjectLimits(
        ("s_x", "s_y", "d", "t"), ((0.05, 0.1), (0.05, 0.1), (0.02, 0.1)), (2.0,), 8
    )
    file.write_text('world = "nowhere:make"\n')
    assert read_limits(file) is None


def test_shipped_and_drawn_problems_pass():
    folder = DomainFolder(SHIPPED)
    assert all(load_problem(folder, name).goals for name in folder.problem_names())
    for seed in range(20):
        task = draw_problem(
            toy_domain.WORLD, lambda rows: ("00",) * len(np.array(rows)), name="t", objects=3, seed=seed
        )
        check_problem(task, toy_domain.grounding(), limits_of(toy_domain.WORLD))
