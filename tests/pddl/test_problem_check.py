"""Scenes that somebody wrote: what the world can be in passes, all else is refused before anything runs."""

import json
import math
from contextlib import nullcontext

import numpy as np
import pytest
import toy_domain
from command_line import refusal
from msgspec.structs import replace
from places import SHIPPED

from neurosym.contract import ObjectLimits, limits_of
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.pddl.problem_check import check_problem
from neurosym.problems import Problem, SceneObject
from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import UNSEEN
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
    ("objects", {"features": [9, 9, 9, 0]}, "item-01 has s_x = 9 m; valid: 0.03 to 0.18 m"),
    ("objects", {"features": [0.05, -0.05, 0.05, 0]}, "item-01 has s_y = -0.05 m; valid"),
    ("objects", {"features": [0.05, 0.05, 0.05, 7]}, "item-01 has t = 7; valid: 0, 1"),
    ("objects", {"features": [0.05, 0.05, 0.05]}, "item-01 has 3 features; valid: s_x, s_y, d, t"),
    ("objects", {"position": [5, 5, 5]}, "item-01 stands at x = 5, y = 5 m, off the table"),
    ("objects", {"position": [1e308, 0, 0.025]}, "Expected `float` <= 1000000000.0"),
    ("objects", {"position": [0.6, 0, 0.035]}, "is at z = 0.035 m, where it does not rest; valid: 0.020"),
    ("objects", {"orientation": [0, 0, 0, 0]}, "item-01 has an orientation of length 0; valid: a quaternion"),
    ("objects", {"orientation": [0, 0, 1e308, 1e308]}, "item-01 has an orientation of length"),
    ("objects", {"category": "1111"}, "There is no category '1111'"),
    ("objects", {"category": "99"}, "Expected bits, like '10' - at `$.objects[0].category`"),
    ("goals", {}, "has no goal; give at least one object a goal"),
    ("goals", {"item-01": [50, 50, 0]}, "The goal of item-01 has x = 50 m, out of reach; valid: x 0.4 to 1"),
    ("goals", {"item-01": [0.6, 0.0, 5]}, "The goal of item-01 has z = 5 m, out of reach"),
    ("goals", {"item-09": [0.6, 0.0, 0.03]}, "goal for item-09, which is not in the scene; objects: item-01"),
    ("tolerance", 0, "tolerance"),
    ("objects", [], "needs one object or more"),
    ("colour", "red", "colour"),
]


def plank(name: str, x: float, y: float, **changes: object) -> SceneObject:
    return replace(SceneObject(name, "00", PLANK, (x, y, 0.01)), **changes)


def check(*items: SceneObject, limits: ObjectLimits | None = LIMITS) -> None:
    goals = {items[0].name: items[0].position}
    check_problem(Problem("p", items, goals), toy_domain.grounding(), limits)


@pytest.mark.parametrize(("key", "changes", "message"), WRONG)
def test_what_cannot_be_is_refused_before_anything_is_done(folder, capsys, key, changes, message):
    scene = folder / "problems/task-01.scene.json"
    task = json.loads(scene.read_text())
    cube = {"features": [0.05, 0.05, 0.05, 0], "position": [0.6, 0.0, 0.025]}
    task["objects"][0] |= cube
    one = key == "objects" and changes
    changed = [task["objects"][0] | one, *task["objects"][1:]] if one else changes
    scene.write_text(json.dumps(task | {key: changed}))
    (folder / "empty.plan").write_text("")
    before = sorted(folder.rglob("*"))
    for command, more in (("plan", ()), ("execute", (folder / "empty.plan", "--replans", 0))):
        said = refusal(capsys, command, folder, "task-01", *more)
        assert message in said
        assert f"{scene} cannot be used" in said
    assert message in refusal(capsys, "new-problem", folder, "--scene", scene, "--name", "mine")
    if one:
        assert message in refusal(capsys, "show", folder, "--problem", "task-01")
    assert sorted(folder.rglob("*")) == before


ONE, OTHER = plank("item-01", 0.6, 0.0), plank("item-02", 0.66, 0.0)
OFF = 0.045 * math.sqrt(0.5)
TURNED = plank("item-01", 0.6, 0.0, orientation=DIAGONAL)


@pytest.mark.parametrize(
    ("items", "said"),
    [
        ((ONE, plank("item-02", 0.6, 0.0)), "item-01 and item-02 stand in one place: the centre of"),
        ((ONE, plank("item-02", 0.6, 0.01)), "put them side by side"),
        ((ONE, plank("item-02", 0.66, 0.0, orientation=ACROSS)), "the centre of item-02 lies within item-01"),
        ((TURNED, plank("item-02", 0.6 + OFF, OFF, orientation=DIAGONAL)), "stand in one place"),
        ((TURNED, plank("item-02", 0.6 - OFF, OFF, orientation=DIAGONAL)), ""),
        ((ONE, plank("item-02", 0.6, 0.025)), ""),
        ((ONE, plank("item-02", 1.05, 0.0)), ""),  # a push left it a little off the table
        ((plank("item-01", 0.6, 0.0, orientation=STANDING, position=(0.6, 0.0, 0.08)),), ""),
        ((plank("item-01", 0.6, 0.0, orientation=STANDING),), "it does not rest; valid: 0.075 to 0.085"),
    ],
)
def test_objects_may_touch_and_stand_on_any_face_and_not_stand_in_each_other(items, said):
    with pytest.raises(InvalidValue, match=said) if said else nullcontext():
        check(*items)


def test_world_that_does_not_say_what_it_makes_is_asked_for_goals_and_categories_only():
    odd = plank("item-01", 0.6, 0.0, features=(9.0, -1.0, 0.0, 7.0), orientation=(0.0, 0.0, 0.0, 0.0))
    check(odd, replace(odd, name="item-02"), limits=None)
    with pytest.raises(UnknownChoice, match="no category '7'"):
        check(replace(odd, category="7"), limits=None)

    class Odd(type(toy_domain.WORLD)):
        object_limits = "none"

    assert limits_of(Odd(toy_domain.WORLD.config)) is None
    assert limits_of(toy_domain.WORLD) == toy_domain.WORLD.config.object_limits


def test_limits_are_read_without_making_the_world(tmp_path):
    assert read_limits(SHIPPED / "world.toml") == LIMITS
    file = tmp_path / "world.toml"
    file.write_text('world = "tabletop"\n[options]\nsize = [0.05, 0.1]\nshapes = { ring = 1.0, box = 0.0 }\n')
    sizes = ((0.05, 0.1), (0.05, 0.1), (0.02, 0.1))
    assert read_limits(file) == ObjectLimits(("s_x", "s_y", "d", "t"), sizes, (2.0,), 8, UNSEEN)
    file.write_text('world = "nowhere:make"\n')
    assert read_limits(file) is None


def test_shipped_and_drawn_problems_pass():
    folder = DomainFolder(SHIPPED)
    assert all(load_problem(folder, name).goals for name in folder.problem_names())
    for seed in range(8):
        task = draw_problem(
            toy_domain.WORLD, lambda rows: ("00",) * len(np.array(rows)), name="t", objects=3, seed=seed
        )
        check_problem(task, toy_domain.grounding(), limits_of(toy_domain.WORLD))
