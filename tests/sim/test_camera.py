"""Pictures and poses of the tabletop: ghosts, dots and shapes are seen, and seeing changes nothing."""

import os

import numpy as np
import pytest
from standing import boxes

from neurosym.contract import POSE_SECONDS, Pose, Posed
from neurosym.errors import InvalidValue
from neurosym.sim.camera import BLANK, HEIGHT, WIDTH, Lens
from neurosym.sim.config import TabletopConfig
from neurosym.sim.robot import UR10
from neurosym.sim.tabletop import Tabletop
from neurosym.world import DOT_COLOURS, Frame, Outcome

pytestmark = pytest.mark.usefixtures("engine")
PUSH = np.array([0, -0.05, 0.02, 0, 0, 0, 0.02, 0, 0, 0.05, 0.02, 0], dtype=float)
CUBE, OPEN_BOX, PLANK, RING = (
    (0.1, 0.1, 0.06, 0.0),
    (0.1, 0.1, 0.06, 1.0),
    (0.1, 0.04, 0.02, 0.0),
    (0.1, 0.1, 0.06, 2.0),
)


def pixel(frame: Frame, point: tuple[float, float, float]) -> np.ndarray:
    (place,) = Lens(TabletopConfig()).pixels(np.array([point]))
    column, row = np.floor(place).astype(int)
    return frame[row, column].astype(int)


def bytes_of(outcome: Outcome) -> bytes:
    scenes = (outcome.start, outcome.lifted, outcome.end)
    return b"".join(array.tobytes() for scene in scenes for array in (scene.positions, scene.orientations))


def test_table_and_all_that_can_stand_on_it_are_in_view():
    config = TabletopConfig()
    corners = [(x, y, z) for x in config.table_x for y in config.table_y for z in (0.0, 0.1)]
    places = Lens(config).pixels(np.array(corners))
    assert np.all((places > 0) & (places < [WIDTH, HEIGHT]))


def test_ghost_lets_the_table_show_through():
    world, scene, goal = Tabletop(), boxes((*CUBE, 0.65, 0.0)), (0.8, -0.1, 0.03)
    plain = world.picture(scene)
    ghostly = world.picture(scene, np.array([goal]))
    solid = world.picture(boxes((*CUBE, *goal[:2])))
    top = (0.8, -0.1, 0.06)
    table, ghost, cube = (pixel(frame, top) for frame in (plain, ghostly, solid))
    assert np.all(np.minimum(table, cube) <= ghost)
    assert np.all(ghost <= np.maximum(table, cube))
    assert np.abs(ghost - table).max() > 20
    assert np.abs(ghost - cube).max() > 20
    assert (pixel(plain, (0.65, 0.0, 0.06)) == pixel(ghostly, (0.65, 0.0, 0.06))).all()


def test_ghost_behind_an_object_is_hidden_by_it_and_one_without_a_place_is_not_drawn():
    world, scene = Tabletop(), boxes((*CUBE, 0.65, 0.0))
    plain = world.picture(scene)
    inside = world.picture(boxes((*CUBE, 0.65, 0.0)), np.array([[0.65, 0.0, 0.0]]))
    assert (pixel(inside, (0.65, 0.0, 0.06)) == pixel(plain, (0.65, 0.0, 0.06))).all()
    assert (world.picture(scene, np.full((1, 3), np.nan)) == plain).all()


def test_dots_mark_the_waypoints_in_blue_green_and_red():
    frames: list[Frame] = []
    world = Tabletop()
    world.wanted_pictures = range(60, 61)
    outcome = world.interact(
        boxes((*CUBE, 0.65, 0.0)),
        PUSH,
        0,
        on_frame=lambda frame, _phase: frames.append(frame) if frame is not BLANK else None,
    )
    (frame,) = frames
    centre = outcome.start.positions[0]
    for waypoint, colour in zip(PUSH.reshape(3, 4), DOT_COLOURS, strict=True):
        assert (pixel(frame, tuple(centre + waypoint[:3])) == colour).all()


def test_interaction_with_pictures_ghosts_and_dots_has_the_bytes_of_one_without():
    world, scene = Tabletop(TabletopConfig(frame_every=150)), boxes((*RING, 0.65, 0.0))
    lift = np.array([0, 0.05, 0, 1, 0, 0.05, 0, 0, 0, 0.05, 0.03, 0])
    for action in (PUSH, lift):
        frames: list[Frame] = []
        seen = world.interact(
            scene,
            action,
            0,
            on_frame=lambda frame, _phase, kept=frames: kept.append(frame),
            ghosts=np.array([[0.8, 0.1, 0.2]]),
        )
        assert frames
        assert bytes_of(seen) == bytes_of(Tabletop().interact(scene, action, 0))


def test_shapes_look_different():
    frames = [Tabletop().picture(boxes((*features, 0.65, 0.0))) for features in (CUBE, OPEN_BOX, PLANK, RING)]
    for index, frame in enumerate(frames):
        for other in frames[:index]:
            assert np.count_nonzero(np.any(frame != other, axis=2)) > 1000


def test_window_without_a_screen_is_refused_in_one_sentence(monkeypatch):
    for display in (None, ":4077"):
        monkeypatch.delenv("DISPLAY", raising=False)
        if display:
            monkeypatch.setitem(os.environ, "DISPLAY", display)
        with pytest.raises(InvalidValue, match="for want of a screen"):
            Tabletop().open_window()


# Poses tell where everything is during a motion


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


def test_poses_change_no_bit_of_the_outcome(poses):
    world = Tabletop()
    assert isinstance(world, Posed)
    plain = interaction(world)
    world.on_pose = poses.copy().append
    watched = interaction(world)
    assert bytes_of(plain) == bytes_of(watched)


def test_poses_come_at_an_even_pace_with_a_row_for_each_link_and_each_object(poses):
    gaps = np.diff([pose.seconds for pose in poses])
    assert np.allclose(gaps, POSE_SECONDS)
    assert {pose.phase for pose in poses} >= {"start", "waypoint 1", "waypoint 3", "rise"}
    assert {pose.links.shape for pose in poses} == {(UR10.tool + 2, 7)}
    assert {pose.positions.shape for pose in poses} == {(2, 3)}
    assert np.allclose(poses[0].links[0, :3], UR10.base)
    left, right = (poses[0].links[finger + 1, :3] for finger in UR10.fingers)
    tool = poses[0].links[UR10.tool + 1, :3]
    assert np.allclose((left + right)[:2] / 2, tool[:2], atol=1e-3)


def test_parts_of_the_robot_hang_on_links_that_it_has_and_those_of_an_object_fill_its_size(poses):
    parts = Tabletop().robot_parts()
    assert len(parts) > 10
    assert {part.link for part in parts} <= set(range(len(poses[0].links)))
    assert all(len(part.size) == {"box": 3, "cylinder": 2, "sphere": 1}[part.kind] for part in parts)
    for kind, count in ((0.0, 1), (1.0, 5), (2.0, 12)):
        parts = Tabletop().object_parts(np.array([0.1, 0.08, 0.05, kind]))
        assert len(parts) == count
        assert max(part.position[2] + part.size[2] / 2 for part in parts) == pytest.approx(0.025)
