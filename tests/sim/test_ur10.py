"""The closed-form kinematics against themselves and against PyBullet's reading of the URDF."""

from importlib.resources import files

import numpy as np
import pybullet
import pytest

from neurosym.errors import InvalidValue
from neurosym.sim.config import TOOL_DOWN
from neurosym.sim.robot import BASE_HEIGHT, joints_for, tool_in_world


def test_inverse_undoes_forward_all_over_the_table():
    points = np.random.default_rng(0).uniform([0.3, -0.35, 0.013], [1.0, 0.35, 0.36], (20_000, 3))
    pose = tool_in_world(joints_for(points))
    assert np.abs(pose[:, :3, 3] - points).max() < 1e-12
    assert np.abs(pose[:, :3, :3] - TOOL_DOWN).max() < 1e-12


def test_joints_do_not_jump_along_a_straight_line():
    path = np.linspace([0.3, -0.35, 0.02], [1.0, 0.35, 0.3], 400)
    assert np.abs(np.diff(joints_for(path), axis=0)).max() < 0.05


def test_point_out_of_reach_is_refused_with_its_coordinates():
    with pytest.raises(InvalidValue, match=r"1\.500, 0\.000, 0\.100"):
        joints_for(np.array([[1.5, 0.0, 0.1]]))


def test_urdf_has_the_same_forward_kinematics():
    client = pybullet.connect(pybullet.DIRECT)
    try:
        urdf = str(files("neurosym.sim") / "ur10.urdf")
        arm = pybullet.loadURDF(urdf, [0, 0, BASE_HEIGHT], useFixedBase=True, physicsClientId=client)
        for joints in np.random.default_rng(1).uniform(-3, 3, (50, 6)):
            for joint, angle in enumerate(joints):
                pybullet.resetJointState(arm, joint, angle, physicsClientId=client)
            state = pybullet.getLinkState(arm, 9, computeForwardKinematics=1, physicsClientId=client)
            assert np.abs(np.array(state[4]) - tool_in_world(joints[None])[0, :3, 3]).max() < 2e-6
    finally:
        pybullet.disconnect(client)
