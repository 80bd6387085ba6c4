"""The toy world keeps the rules written at its head."""

import pickle

import numpy as np
import pytest

from neurosym.errors import InvalidValue
from neurosym.world import Place, Scene, Table
from neurosym.worlds.toy import ToyConfig, ToyWorld, make_world

SMALL = (0.05, 0.05, 0.04, 0.0)
WIDE = (0.05, 0.15, 0.04, 0.0)
HOLLOW = (0.05, 0.15, 0.04, 1.0)
LONG = (0.15, 0.05, 0.04, 0.0)
LONG_WIDE = (0.15, 0.15, 0.04, 0.0)


def scene_of(features, x=0.7, y=0.0):
    return Scene(np.array([features]), np.array([[x, y, features[2] / 2]]), np.array([[0.0, 0.0, 0.0, 1.0]]))


def action_of(first=(0, 0, 0, 1.0), middle=(0, 0, 0, 1.0), last=(0, 0, 0, 1.0)):
    return np.array([*first, *middle, *last], dtype=float)


GRASP = action_of(last=(0, 0, 0, 0.0))


@pytest.mark.parametrize(("features", "held"), [(SMALL, True), (HOLLOW, True), (WIDE, False)])
def test_only_narrow_or_hollow_objects_are_lifted(features, held):
    outcome = make_world().interact(scene_of(features), GRASP, 0)
    assert outcome.held is held
    np.testing.assert_allclose(outcome.effect, [0, 0, 0.2 if held else 0], atol=1e-12)
    np.testing.assert_allclose(outcome.resting_effect, 0, atol=1e-12)


def test_without_put_down_a_held_object_ends_in_mid_air():
    outcome = make_world().interact(scene_of(SMALL), GRASP, 0, put_down=False)
    np.testing.assert_allclose(outcome.resting_effect, [0, 0, 0.2])


@pytest.mark.parametrize(
    ("travel", "effect"),
    [
        ((0.03, 0.01), (0.08, 0, 0)),
        ((-0.03, 0.01), (-0.08, 0, 0)),
        ((0.01, 0.03), (0, 0.08, 0)),
        ((0.01, -0.03), (0, -0.08, 0)),
        ((0.015, 0.019), (0, 0, 0)),
    ],
)
def test_travel_decides_the_direction_of_a_push(travel, effect):
    outcome = make_world().interact(scene_of(SMALL), action_of(last=(*travel, 0, 1.0)), 0)
    np.testing.assert_allclose(outcome.effect, effect, atol=1e-12)


def test_a_grasp_on_what_cannot_be_grasped_pushes_it():
    action = action_of(last=(0.03, 0, 0, 0.0))
    np.testing.assert_allclose(make_world().interact(scene_of(WIDE), action, 0).effect, [0.08, 0, 0])


def test_long_objects_do_not_budge_but_can_be_lifted():
    push = action_of(last=(0.05, 0, 0, 1.0))
    assert np.all(make_world().interact(scene_of(LONG), push, 0).effect == 0)
    assert make_world().interact(scene_of(LONG), GRASP, 0).held
    assert not make_world().interact(scene_of(LONG_WIDE), GRASP, 0).held


def test_an_object_pushed_over_the_edge_is_lost():
    push = action_of(last=(0.05, 0, 0, 1.0))
    assert make_world().interact(scene_of(SMALL, x=0.95), push, 0).lost
    assert not make_world().interact(scene_of(SMALL, x=0.7), push, 0).lost


CARRY = action_of(middle=(0.01, 0, 0, 0.0), last=(0.02, -0.03, 0, 1.0))


@pytest.mark.parametrize(("features", "carried"), [(SMALL, True), (HOLLOW, True), (WIDE, False)])
def test_with_a_place_what_can_be_grasped_is_carried_there(features, carried):
    scene = scene_of(features)
    outcome = make_world().interact(scene, CARRY, 0, reference=Place(0.5, 0.2))
    assert outcome.carried is carried
    assert not outcome.held
    end = [0.51, 0.17, features[2] / 2] if carried else scene.positions[0]
    np.testing.assert_allclose(outcome.end.positions[0], end, atol=1e-12)


def test_with_a_place_nothing_is_pushed_and_a_closed_hand_carries_nothing():
    for action in (action_of(last=(0.03, 0, 0, 1.0)), action_of((0, 0, 0, 0.0), (0, 0, 0, 0.0))):
        outcome = make_world().interact(scene_of(SMALL), action, 0, reference=Place(0.5, 0.2))
        assert not outcome.carried
        np.testing.assert_array_equal(outcome.resting_effect, 0)


def test_a_place_off_the_table_is_refused():
    with pytest.raises(InvalidValue, match="lies off the table"):
        make_world().interact(scene_of(SMALL), CARRY, 0, reference=Place(0.0, 0.0))


def test_only_the_target_moves():
    world = make_world()
    scene = world.sample_scene(np.random.default_rng(0), 4)
    outcome = world.interact(scene, action_of(last=(0.05, 0, 0, 1.0)), 2)
    others = [0, 1, 3]
    np.testing.assert_array_equal(outcome.end.positions[others], scene.positions[others])


def test_sampled_objects_do_not_overlap_and_stand_on_the_table():
    world = make_world()
    for seed in range(20):
        scene = world.sample_scene(np.random.default_rng(seed), 5)
        assert all(world.table.contains(position) for position in scene.positions)
        for i in range(5):
            for j in range(i):
                distance = np.abs(scene.positions[i, :2] - scene.positions[j, :2])
                assert np.any(distance >= (scene.features[i, :2] + scene.features[j, :2]) / 2)


def test_too_many_objects_are_refused_in_a_sentence():
    with pytest.raises(InvalidValue, match="do not fit"):
        make_world().sample_scene(np.random.default_rng(0), 200)


def test_the_same_seed_draws_the_same_scene():
    first, second = (make_world().sample_scene(np.random.default_rng(7), 3) for _ in range(2))
    np.testing.assert_array_equal(first.positions, second.positions)
    np.testing.assert_array_equal(first.features, second.features)


def test_actions_of_another_shape_are_refused():
    with pytest.raises(InvalidValue, match="shape"):
        make_world().interact(scene_of(SMALL), np.zeros(5), 0)


def test_frames_show_the_object_moving():
    frames = []
    make_world().interact(
        scene_of(SMALL),
        action_of(last=(0.05, 0, 0, 1.0)),
        0,
        on_frame=lambda frame, _phase: frames.append(frame),
    )
    assert frames[0].shape == (480, 640, 3)
    assert not np.array_equal(frames[0], frames[-1])


def test_a_world_survives_pickling():
    world = make_world(ToyConfig(table=Table(x=(0.0, 2.0), y=(-1.0, 1.0))))
    copy = pickle.loads(pickle.dumps(world))
    assert isinstance(copy, ToyWorld)
    assert copy.config == world.config


def test_impossible_sizes_are_refused():
    with pytest.raises(InvalidValue, match="sizes"):
        ToyConfig(sizes=(0.1, 0.05))
