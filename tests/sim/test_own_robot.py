"""A robot of one's own: the documented Franka Panda, and the inverse kinematics of any arm."""

import importlib
import re
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command_line import neurosym
from documents import python_blocks
from standing import CARRY, boxes

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidArm, InvalidValue
from neurosym.sim.config import TOOL_DOWN, Arm, loaded, pybullet
from neurosym.sim.numeric_inverse import NumericInverse
from neurosym.sim.robot import UR10, joints_for
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Place
from neurosym.worlds import own_world

CODE, LOOK = python_blocks("own-robot.md")
UR10_REACHES = [0.3, -0.35, 0.013], [1.0, 0.35, 0.36]


@pytest.fixture(scope="module")
def panda(tmp_path_factory):
    """The documented module, imported from a folder of its own that is the current one."""
    folder = tmp_path_factory.mktemp("robot")
    (folder / "panda.py").write_text(CODE)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.syspath_prepend(str(folder))
        yield importlib.import_module("panda")
    del sys.modules["panda"]


def test_documented_action_by_hand_lifts_the_box_and_draws_it(panda):
    said = subprocess.run([sys.executable, "-c", LOOK], capture_output=True, text=True).stdout
    assert said.startswith("held ")
    assert Path("panda.png").stat().st_size > 10_000


def test_panda_carries_a_box_to_a_place(panda):
    world = panda.make()
    assert "place" in world.references
    x, y = world.table.x, world.table.y
    place = Place(x[0] + 0.15, y[1] - 0.15)
    outcome = world.interact(boxes((0.05, 0.05, 0.08, 0, 0.5, 0.0)), CARRY, 0, reference=place)
    assert outcome.kind == "carried"
    assert np.linalg.norm(outcome.resting_effect) < 0.01, "relative to the place"


def test_meshes_that_mujoco_does_not_find_are_told_of_in_one_sentence(panda):
    world = Tabletop(replace(panda.TABLE, engine="mujoco"), "panda", arm=panda.PANDA)
    with pytest.raises(InvalidArm, match=r"cannot be simulated by MuJoCo, which says: .*link0\.obj"):
        world.interact(boxes((0.05, 0.05, 0.08, 0, 0.5, 0.0)), CARRY, 0)


def assert_exact(arm: Arm, inverse, points: np.ndarray, within: float) -> None:
    """Check that an inverse brings the tool to points, pointing down."""
    with loaded(arm.urdf, arm.base) as (client, body):
        for point, angles in zip(points, inverse(points), strict=True):
            for joint, angle in zip(arm.joints, angles, strict=True):
                client.resetJointState(body, joint, angle)
            place, turn = client.getLinkState(body, arm.tool, computeForwardKinematics=1)[4:6]
            assert np.abs(np.array(place) - point).max() < within
            down = np.reshape(pybullet.getMatrixFromQuaternion(turn), (3, 3))
            assert np.abs(down - TOOL_DOWN).max() < 1e-5


def test_inverse_is_exact_wherever_the_hand_may_go_as_pybullet_sees_it(panda):
    x, y = panda.TABLE.table_x, panda.TABLE.table_y
    low, high = [x[0] - 0.05, y[0] - 0.05, 0.013], [x[1] + 0.05, y[1] + 0.05, 0.36]
    corners = np.stack(np.meshgrid(*zip(low, high, strict=True)), axis=-1).reshape(-1, 3)
    points = np.vstack([corners, np.random.default_rng(0).uniform(low, high, (300, 3))])
    assert_exact(panda.PANDA, panda.PANDA.inverse_kinematics, points, 1e-5)
    assert_exact(UR10, joints_for, np.random.default_rng(0).uniform(*UR10_REACHES, (300, 3)), 2e-6)


@pytest.mark.parametrize("point", [[1.5, 0.0, 0.1], [0.5, 0.0, 1.5], [0.05, 0.0, 0.1]])
def test_point_out_of_reach_is_refused_with_its_coordinates(panda, point):
    said = f"\\({point[0]:.3f}, {point[1]:.3f}, {point[2]:.3f}\\) m is out of the arm's reach"
    for inverse in (panda.PANDA.inverse_kinematics, joints_for):
        with pytest.raises(InvalidValue, match=said):
            inverse(np.array([[0.5, 0.0, 0.1], point]))


def test_angles_depend_on_the_point_alone_and_change_smoothly(panda):
    inverse = panda.PANDA.inverse_kinematics
    path = np.linspace([0.3, -0.3, 0.02], [0.7, 0.3, 0.3], 250)
    angles = inverse(path)
    assert np.abs(np.diff(angles, axis=0)).max() < 0.03
    assert np.abs(np.diff(angles, 2, axis=0)).max() < 0.002
    assert np.abs(np.diff(joints_for(path), axis=0)).max() < 0.05
    assert np.array_equal(inverse(path), angles)
    assert np.abs(inverse(path[::-1]) - angles[::-1]).max() < 1e-9
    assert np.abs(np.vstack([inverse(point[None]) for point in path[::50]]) - angles[::50]).max() < 1e-9


def test_what_is_no_arm_is_refused():
    with pytest.raises(InvalidValue, match="home has 2 angles; the arm has 6 joints"):
        NumericInverse(UR10.urdf, UR10.base, UR10.joints, UR10.tool, (0.0, 0.0))
    with pytest.raises(InvalidValue, match="neither turns nor slides"):
        NumericInverse(UR10.urdf, UR10.base, (0, 9), 9, (0.0, 0.0))(np.zeros((1, 3)))
    with pytest.raises(InvalidValue, match=r"cannot be read from nowhere\.urdf"):
        NumericInverse("nowhere.urdf", (0.0, 0.0, 0.0), (0,), 1, (0.0,))(np.zeros((1, 3)))


def test_panda_explores_for_a_domain_of_its_own(panda, monkeypatch):
    """How a domain comes of that does not depend on the arm; `init` checks the world."""
    monkeypatch.setattr(own_world, "_INTERACTIONS", 2)  # that are looked at through each mirror
    assert neurosym("init", "tiny", "--world", "panda:make") == 0
    assert neurosym("explore", "tiny", "--strategy", "random", "--steps", 4, "--workers", 1) == 0
    assert Interactions.load(Path("tiny/interactions.npz")).origin["world"] == "panda:make"


@pytest.mark.evaluation
def test_panda_learns_a_domain_with_actions(panda):
    learn = ("--regime", "quick", "--steps", "512", "--rehearsals", "24", "--problems", "0")
    assert neurosym("run", "panda-domain", "--world", "panda:make", *learn) == 0
    assert re.search(r"\(:action (?!reach-goal)", Path("panda-domain/domain.pddl").read_text())


@pytest.mark.evaluation
def test_panda_does_nearly_the_same_when_an_action_is_nudged(panda, capsys):
    world, rng = panda.make(), np.random.default_rng(0)
    effects = np.zeros((2, 200, 3))
    start = time.process_time()
    for row in range(200):
        scene, action = world.sample_scene(rng, 1), world.action_box.sample(rng, 1)[0]
        nudge = np.where(world.action_box.gripper, 0.0, rng.normal(size=12))
        nudged = np.clip(
            action + 1e-4 * nudge / np.linalg.norm(nudge), world.action_box.low, world.action_box.high
        )
        effects[:, row] = [world.interact(scene, a, 0).effect for a in (action, nudged)]
    cost = (time.process_time() - start) / 400
    lost = ((effects[0] - effects[1]) ** 2).sum() / 2 / ((effects[0] - effects[0].mean(0)) ** 2).sum()
    with capsys.disabled():
        print(
            f"\n{1 - lost:.3f} of the effects' variance survives 0.1 mm; {1000 * cost:.0f} ms an interaction"
        )
    assert lost < 0.1
