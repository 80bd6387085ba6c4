"""Poses tell where everything is during a motion, and change nothing in it."""

import numpy as np
import pytest

from neurosym.contract import POSE_SECONDS, Pose, Posed
from neurosym.sim.robot import UR10
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Outcome


def interaction(world: Tabletop) -> Outcome:
    rng = np.random.default_rng(3)
    scene = world.sample_scene(rng, 2)
    return world.interact(scene, world.action_box.sample(rng, 1)[0], 0)


@pytest.fixture(scope="module")
def poses() -> list[Pose]:
    world, found = Tabletop(), []
    world.on_pose = found.append
    interaction(world)
    return found


def test_tabletop_knows_poses():
    assert isinstance(Tabletop(), Posed)


def test_poses_change_no_bit_of_the_outcome(poses):
    world = Tabletop()
    plain = interaction(world)
    world.on_pose = poses.copy().append
    watched = interaction(world)
    assert plain.end.positions.tobytes() == watched.end.positions.tobytes()
    assert plain.lifted.orientations.tobytes() == watched.lifted.orientations.tobytes()


def test_poses_come_at_an_even_pace(poses):
    gaps = np.diff([pose.seconds for pose in poses])
    assert np.allclose(gaps, POSE_SECONDS)
    assert {pose.phase for pose in poses} >= {"start", "waypoint 1", "waypoint 3", "rise"}


def test_there_is_a_row_for_each_link_and_each_object(poses):
    assert {pose.links.shape for pose in poses} == {(UR10.tool + 2, 7)}
    assert {pose.positions.shape for pose in poses} == {(2, 3)}
    assert np.allclose(poses[0].links[0, :3], UR10.base)


def test_tool_point_stands_between_the_fingertips(poses):
    left, right = (poses[0].links[finger + 1, :3] for finger in UR10.fingers)
    tool = poses[0].links[UR10.tool + 1, :3]
    assert np.allclose((left + right)[:2] / 2, tool[:2], atol=1e-3)


def test_parts_of_the_robot_hang_on_links_that_it_has(poses):
    parts = Tabletop().robot_parts()
    assert len(parts) > 10
    assert {part.link for part in parts} <= set(range(len(poses[0].links)))
    assert all(len(part.size) == {"box": 3, "cylinder": 2, "sphere": 1}[part.kind] for part in parts)


def test_parts_of_an_object_fill_its_size():
    for kind, count in ((0.0, 1), (1.0, 5), (2.0, 12)):
        parts = Tabletop().object_parts(np.array([0.1, 0.08, 0.05, kind]))
        assert len(parts) == count
        assert max(part.position[2] + part.size[2] / 2 for part in parts) == pytest.approx(0.025)
