"""The tabletop as a camera sees it: what is seen is near the truth, and the truth is read by nobody else."""

import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.perception.eye import NUMBERS, Eye, _shapes
from neurosym.sim.camera_world import CameraTableConfig, CameraWorld, truth_of
from neurosym.sim.depth_camera import DepthCamera
from neurosym.world import OtherObject, Place, Scene
from neurosym.worlds.own_world import check_world
from tools.benchmarks.world.hand_written import carry_to

NOISY = DepthCamera(depth_step=0.001, dropout=0.3, offset=0.001)


@pytest.fixture(scope="module")
def eye(tmp_path_factory: pytest.TempPathFactory) -> Path:
    rng = np.random.default_rng(0)
    path = tmp_path_factory.mktemp("eye") / "eye.safetensors"
    weights = {name: rng.normal(0, 0.2, shape) for name, shape in _shapes().items()}
    Eye({**weights, "variance": np.ones(NUMBERS)}).save(path)
    return path


def test_it_is_a_world(eye: Path):
    check_world(CameraWorld(eye=eye))


@pytest.mark.parametrize(("camera", "near", "size"), [(DepthCamera(), 0.003, 0.012), (NOISY, 0.006, 0.025)])
def test_objects_are_seen_near_to_where_they_are(eye: Path, camera: DepthCamera, near: float, size: float):
    world, rng = CameraWorld(CameraTableConfig(camera=camera), eye), np.random.default_rng(4)
    for objects in (1, 3, 5):
        scene = world.sample_scene(rng, objects)
        truth = truth_of(scene)
        assert scene.positions == pytest.approx(truth.positions, abs=near)
        assert scene.features[:, :3] == pytest.approx(truth.features[:, :3], abs=size)
        assert np.all(truth.features[:, :2] >= 0.03)


def test_actions_do_what_they_do_on_the_tabletop_and_their_ends_are_seen(eye: Path):
    world, rng, moved = CameraWorld(eye=eye), np.random.default_rng(7), 0
    for _ in range(12):
        scene, action = world.sample_scene(rng, 1), world.action_box.sample(rng, 1)[0]
        outcome, truth = (
            world.interact(scene, action, 0),
            world.table_world.interact(truth_of(scene), action, 0),
        )
        assert outcome.kind == truth.kind
        assert truth_of(outcome.end).positions == pytest.approx(truth.end.positions, abs=1e-9)
        assert outcome.resting_effect == pytest.approx(truth.resting_effect, abs=0.006)
        moved += bool(np.linalg.norm(truth.resting_effect) > 0.01)
    assert moved >= 3


def test_an_object_that_is_moved_by_hand_takes_what_it_is_along(eye: Path):
    world = CameraWorld(eye=eye)
    scene = world.sample_scene(np.random.default_rng(1), 1)
    away = truth_of(scene).positions - scene.positions
    turn = Rotation.from_euler("z", 90, degrees=True)
    turned = (turn * Rotation.from_quat(scene.orientations)).as_quat()
    there = replace(scene, positions=scene.positions + np.array([0.05, -0.03, 0.0]), orientations=turned)
    truth = truth_of(there)
    assert truth.positions - there.positions == pytest.approx(turn.apply(away), abs=1e-12)
    assert np.linalg.norm(away) > 1e-5
    ways = Rotation.from_quat(truth.orientations) * Rotation.from_quat(truth_of(scene).orientations).inv()
    assert np.degrees(ways.magnitude()) == pytest.approx([90], abs=1e-6)


def test_noise_is_drawn_from_what_is_seen(eye: Path):
    one, two = (CameraWorld(CameraTableConfig(camera=NOISY), eye) for _ in range(2))
    scenes = [world.sample_scene(np.random.default_rng(5), 2) for world in (one, two)]
    assert scenes[0].features.tobytes() == scenes[1].features.tobytes()
    still = CameraWorld(eye=eye).sample_scene(np.random.default_rng(5), 2)
    assert still.features.tobytes() != scenes[0].features.tobytes()


def test_it_goes_to_another_process(eye: Path):
    world = pickle.loads(pickle.dumps(CameraWorld(eye=eye)))
    assert world.sample_scene(np.random.default_rng(2), 1).features.shape == (1, 3 + NUMBERS)


def test_it_draws_pictures_by_what_is_seen(eye: Path):
    world, asked = CameraWorld(eye=eye), []
    world.painter = lambda features: (
        asked.append(features) or np.full((len(features), 3), 200, dtype=np.uint8)
    )
    scene = world.sample_scene(np.random.default_rng(2), 2)
    assert world.picture(scene).shape[2] == 3
    assert asked[0].tobytes() == scene.features.tobytes()
    (known,) = world.object_parts(scene.features[0], scene.unseen[0].tolist())[:1]
    (guessed,) = world.object_parts(scene.features[0])
    assert max(guessed.size) == pytest.approx(max(scene.features[0, :3]))
    assert known.kind == "box"


def test_what_cannot_be_seen_is_refused(eye: Path):
    world = CameraWorld(eye=eye)
    scene = world.sample_scene(np.random.default_rng(2), 1)
    flat, odd, huge, still = (scene.unseen.copy() for _ in range(4))
    flat[0, 1], odd[0, 3], huge[0, 0], still[0, 7:11] = -0.1, 99.0, 5.0, 0.0
    for unseen, said in (
        (np.zeros((1, 0)), "there are 0 `unseen` numbers; valid: 11 or"),
        (np.zeros((1, 11)), "Object 1 is in truth 0 x 0 x 0 m large"),
        (flat, "Object 1 is in truth .* valid: over 0 and at most 1 m"),
        (huge, "Object 1 is in truth 5 x"),
        (odd, "Object 1 has the true type 99; valid: 0, 1, 2"),
        (still, "Object 1 is turned by a quaternion of length 0; valid: 1"),
    ):
        with pytest.raises(InvalidWorld, match=said):
            world.interact(replace(scene, unseen=unseen), world.action_box.low, 0)
    with pytest.raises(InvalidValue, match="has not learned to see yet"):
        CameraWorld().sample_scene(np.random.default_rng(2), 1)
    for options, said in (
        ({"position": (0.65, 0.0, 0.6)}, "does not see the whole table"),
        ({"position": (0.65, 0.0, 0.1)}, "is too near"),
        ({"pixels": 8}, "camera.pixels = 8"),
        ({"pixels": 40}, "show an object of 0.03 m in 1 pixels; valid: at least 12"),
        ({"position": (0.65, 0.0, -1.3)}, "looks past the table"),
        ({"position": (0.65, 0.9, 1.0), "field_of_view": 60.0}, "looks past the table"),
        ({"roll": float("nan")}, "must be finite"),
        ({"field_of_view": 179.0}, "camera.field_of_view"),
        ({"dropout": 2.0}, "camera.dropout"),
    ):
        with pytest.raises(InvalidValue, match=said):
            DepthCamera(**options).check_sees(CameraTableConfig())


def two(world: CameraWorld, small: list[float], large: list[float], *at: tuple[float, float]) -> Scene:
    """See two objects at places."""
    positions = np.array([[*place, one[2] / 2] for place, one in zip(at, (small, large), strict=True)])
    scene = world.seen(Scene(np.array([small, large]), positions, np.array([[0.0, 0.0, 0.0, 1.0]] * 2)))
    assert scene is not None
    return scene


def test_what_touches_or_stands_on_another_is_seen(eye: Path):
    world, small, large = CameraWorld(eye=eye), [0.05, 0.06, 0.05, 0.0], [0.15, 0.16, 0.03, 0.0]
    scene = two(world, small, large, (0.5, -0.2), (0.75, 0.1))
    action = carry_to(np.array(small))
    assert action is not None
    for aim in (OtherObject(1), Place(0.75, 0.1 - 0.08 - 0.03)):  # onto it, and close beside it
        outcome = world.interact(scene, action, 0, reference=aim)
        assert outcome.carried
        truth = truth_of(outcome.end)
        assert outcome.end.positions == pytest.approx(truth.positions, abs=0.005)
        assert (outcome.end.positions[0, 2] > 0.05) == isinstance(aim, OtherObject)
        if isinstance(aim, Place):  # it is seen there, and not only believed to be where it was carried
            done = replace(outcome, start=truth_of(scene), end=truth, carried=False)
            assert world._seen_again(scene, done).positions == pytest.approx(truth.positions, abs=0.005)


def test_what_is_pushed_against_another_of_other_height_is_told_apart(eye: Path):
    world, small, large = CameraWorld(eye=eye), [0.06, 0.06, 0.05, 0.0], [0.08, 0.08, 0.08, 0.0]
    scene = two(world, small, large, (0.6, 0.0), (0.6, 0.1))
    action = np.array([0, -0.05, -0.005, 0, 0, 0.03, -0.005, 0, 0, 0.05, -0.005, 0.0])
    outcome = world.interact(scene, action, 0)
    truth = truth_of(outcome.end)
    assert np.linalg.norm(truth.positions - truth_of(scene).positions, axis=1).min() > 0.03, "both moved"
    assert outcome.end.positions == pytest.approx(truth.positions, abs=0.006)
