"""A robot of one's own: the documented Franka Panda, and the inverse kinematics of any arm."""

import importlib
import pickle
import re
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pybullet
import pytest
from places import DOCS

from neurosym import check_world
from neurosym.errors import InvalidValue
from neurosym.sim.config import TOOL_DOWN
from neurosym.sim.numeric_inverse import NumericInverse
from neurosym.sim.robot import UR10, joints_for
from neurosym.world import Place, Scene

DOCUMENT = DOCS / "own-robot.md"
CODE, LOOK = re.findall(r"```python\n(.*?)```", DOCUMENT.read_text(), flags=re.DOTALL)
LOW = -0.025
OPEN, CLOSED = 1.0, 0.0
BODY = """<link name="{name}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0"
iyz="0"/></inertial></link>"""
SLIDE = (
    BODY
    + """<joint name="slide_{name}" type="prismatic"><parent link="{parent}"/>
<child link="{name}"/><origin rpy="{rpy}"/><axis xyz="{axis}"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>"""
)


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


def box(size: float, height: float, x: float = 0.5, y: float = 0.0) -> Scene:
    upright = np.array([[0.0, 0.0, 0.0, 1.0]])
    return Scene(np.array([[size, size, height, 0.0]]), np.array([[x, y, height / 2]]), upright)


def act(*waypoints: tuple[float, float, float, float]) -> np.ndarray:
    return np.array(waypoints, dtype=float).ravel()


def test_documented_action_by_hand_lifts_the_box_and_draws_it(panda):
    said = subprocess.run([sys.executable, "-c", LOOK], capture_output=True, text=True).stdout
    assert said.startswith("held ")
    assert Path("panda.png").stat().st_size > 10_000


def test_panda_carries_a_box_to_a_place(panda):
    world, carry = panda.make(), act((0, 0, 0, OPEN), (0, 0, 0, CLOSED), (0, 0, 0, CLOSED))
    assert "place" in world.references
    x, y = world.table.x, world.table.y
    place = Place(x[0] + 0.15, y[1] - 0.15)
    outcome = world.interact(box(0.05, 0.08), carry, 0, reference=place)
    assert outcome.kind == "carried"
    assert np.linalg.norm(outcome.resting_effect) < 0.01, "relative to the place"


def test_documented_robot_is_short():
    assert len(CODE.splitlines()) < 60


def test_inverse_is_exact_wherever_the_hand_may_go_as_pybullet_sees_it(panda):
    x, y = panda.TABLE.table_x, panda.TABLE.table_y
    low, high = [x[0] - 0.05, y[0] - 0.05, 0.013], [x[1] + 0.05, y[1] + 0.05, 0.36]
    corners = np.stack(np.meshgrid(*zip(low, high, strict=True)), axis=-1).reshape(-1, 3)
    points = np.vstack([corners, np.random.default_rng(0).uniform(low, high, (300, 3))])
    client = pybullet.connect(pybullet.DIRECT)
    try:
        arm = pybullet.loadURDF(panda.URDF, panda.BASE, useFixedBase=True, physicsClientId=client)
        for point, angles in zip(points, panda.PANDA.inverse_kinematics(points), strict=True):
            for joint, angle in zip(panda.JOINTS, angles, strict=True):
                pybullet.resetJointState(arm, joint, angle, physicsClientId=client)
            state = pybullet.getLinkState(arm, panda.TOOL, computeForwardKinematics=1, physicsClientId=client)
            turn = np.array(pybullet.getMatrixFromQuaternion(state[5])).reshape(3, 3)
            assert np.abs(np.array(state[4]) - point).max() < 1e-5
            assert np.abs(turn - TOOL_DOWN).max() < 1e-5
    finally:
        pybullet.disconnect(client)


def test_angles_depend_on_the_point_alone_and_change_smoothly(panda):
    inverse = panda.PANDA.inverse_kinematics
    path = np.linspace([0.3, -0.3, 0.02], [0.7, 0.3, 0.3], 250)
    angles = inverse(path)
    assert np.abs(np.diff(angles, axis=0)).max() < 0.03
    assert np.abs(np.diff(angles, 2, axis=0)).max() < 0.002
    assert np.array_equal(inverse(path), angles)
    assert np.abs(inverse(path[::-1]) - angles[::-1]).max() < 1e-9
    assert np.abs(np.vstack([inverse(point[None]) for point in path[::50]]) - angles[::50]).max() < 1e-9


@pytest.mark.parametrize("point", [[1.2, 0.0, 0.1], [0.5, 0.0, 1.5], [0.05, 0.0, 0.1]])
def test_point_out_of_reach_is_refused_with_its_coordinates(panda, point):
    said = f"The point \\({point[0]:.3f}, {point[1]:.3f}, {point[2]:.3f}\\) m is out of the arm's reach"
    with pytest.raises(InvalidValue, match=said):
        panda.PANDA.inverse_kinematics(np.array([[0.5, 0.0, 0.1], point]))


def test_inverse_agrees_with_the_closed_form_of_the_ur10():
    home = tuple(joints_for(np.array([[0.6, 0.0, 0.2]]))[0].tolist())
    inverse = NumericInverse(UR10.urdf, UR10.base, UR10.joints, UR10.tool, home)
    points = np.random.default_rng(0).uniform([0.3, -0.35, 0.013], [1.0, 0.35, 0.36], (500, 3))
    assert np.abs(inverse(points) - joints_for(points)).max() < 1e-5


def test_joints_that_slide_are_solved_for_too(tmp_path):
    rows = [
        ("a", "base", "0 0 0", "1 0 0"),
        ("b", "a", "0 0 0", "0 1 0"),
        ("c", "b", f"{np.pi} 0 0", "0 0 1"),
    ]
    parts = [SLIDE.format(name=n, parent=p, rpy=r, axis=axis) for n, p, r, axis in rows]
    urdf = "".join(['<robot name="gantry">', BODY.format(name="base"), *parts, "</robot>"])
    (tmp_path / "gantry.urdf").write_text(urdf)
    inverse = NumericInverse(str(tmp_path / "gantry.urdf"), (0.0, 0.0, 0.5), (0, 1, 2), 2, (0.0, 0.0, 0.0))
    assert np.allclose(inverse(np.array([[0.3, -0.2, 0.1]])), [[0.3, -0.2, 0.4]], atol=1e-6)
    with pytest.raises(InvalidValue, match="out of the arm's reach"):
        inverse(np.array([[1.3, 0.0, 0.1]]))


def test_what_is_no_arm_is_refused():
    with pytest.raises(InvalidValue, match="home has 2 angles; the arm has 6 joints"):
        NumericInverse(UR10.urdf, UR10.base, UR10.joints, UR10.tool, (0.0, 0.0))
    with pytest.raises(InvalidValue, match="neither turns nor slides"):
        NumericInverse(UR10.urdf, UR10.base, (0, 9), 9, (0.0, 0.0))(np.zeros((1, 3)))
    with pytest.raises(InvalidValue, match=r"cannot be read from nowhere\.urdf"):
        NumericInverse("nowhere.urdf", (0.0, 0.0, 0.0), (0,), 1, (0.0,))(np.zeros((1, 3)))


def test_panda_lifts_a_box_and_puts_it_back(panda):
    outcome = panda.make().interact(
        box(0.05, 0.05, 0.55, 0.15), act((0, 0, 0, OPEN), (0, 0, 0, CLOSED), (0, 0, 0.05, CLOSED)), 0
    )
    assert outcome.kind == "held"
    assert np.allclose(outcome.effect, [0, 0, 0.25], atol=0.005)
    assert np.linalg.norm(outcome.resting_effect) < 0.003


def test_panda_carries_a_box_to_another_place(panda):
    there = (0.05, -0.05)
    action = act((0, 0, 0, OPEN), (*there, 0.018, CLOSED), (*there, 0.05, OPEN))
    outcome = panda.make().interact(box(0.04, 0.05), action, 0)
    assert outcome.kind == "resting"
    assert outcome.peak_height > 0.01
    assert np.allclose(outcome.resting_effect, [*there, 0], atol=0.003)


@pytest.mark.parametrize("sign", [-1, 1])
def test_panda_pushes_a_box_forth_and_back(panda, sign):
    behind = -sign * 0.044
    action = act((behind, 0, LOW, CLOSED), (0, 0, LOW, CLOSED), (sign * 0.05, 0, LOW, CLOSED))
    outcome = panda.make().interact(box(0.06, 0.03), action, 0)
    assert outcome.kind == "resting"
    assert sign * outcome.resting_effect[0] > 0.07
    assert abs(outcome.resting_effect[1]) < 0.005


def test_panda_makes_a_world_without_a_memory(panda):
    check_world(panda.make())


def test_panda_acts_the_same_in_another_process(panda):
    world = panda.make()
    action = world.action_box.sample(np.random.default_rng(0), 1)[0]
    scene = world.sample_scene(np.random.default_rng(0), 2)
    outcome = world.interact(scene, action, 1)
    again = pickle.loads(pickle.dumps(world)).interact(scene, action, 1)
    assert again.end.positions.tobytes() == outcome.end.positions.tobytes()


def installed(*typed: str) -> None:
    """Type something after `neurosym`, as the installed command takes it."""
    command = [sys.executable, "-P", "-c", "from neurosym.commands.cli import main; main()", *typed]
    ended = subprocess.run(command, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr


def test_panda_goes_the_whole_way_at_small_scale(panda):
    """Stage by stage, because auditions, of `run` too, take a thousand interactions."""
    installed("init", "tiny", "--world", "panda:make")
    installed("explore", "tiny", "--strategy", "random", "--steps", "32", "--workers", "1")
    installed("train", "tiny", "--regime", "paper")  # soon done with so little data
    installed("distill", "tiny", "--objects", "2", "--workers", "1", "--choice", "lowest-error")
    installed("compile-domain", "tiny")
    assert "(define (domain panda)" in Path("tiny/domain.pddl").read_text()


@pytest.mark.evaluation
def test_panda_learns_a_domain_with_actions(panda):
    learn = ("--regime", "quick", "--steps", "512", "--rehearsals", "24", "--problems", "0")
    installed("run", "panda-domain", "--world", "panda:make", *learn)
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
