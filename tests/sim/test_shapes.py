"""Objects of every shape are built as their features say, and scenes hold many of them."""

import numpy as np
import pytest

from neurosym.errors import InvalidValue, NeurosymError
from neurosym.sim.config import MOST_OBJECTS, OPEN_THROUGH, OPEN_TOP, SHAPES, SOLID, TabletopConfig, boxes_of
from neurosym.sim.interaction import _landing_shift
from neurosym.sim.simulation import sample_features, sample_scene

WALL = 0.006


def extent(boxes):
    """Sizes of the smallest box around turned boxes, along x, y, z."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for (x, y, z), centre, turn in boxes:
        half_x = abs(x * np.cos(turn)) + abs(y * np.sin(turn))
        half_y = abs(x * np.sin(turn)) + abs(y * np.cos(turn))
        half = np.array([half_x, half_y, z])
        low, high = np.minimum(low, centre - half), np.maximum(high, centre + half)
    return high - low


@pytest.mark.parametrize(("kind", "parts"), [(SOLID, 1), (OPEN_TOP, 5), (OPEN_THROUGH, 12)])
def test_object_is_as_large_as_its_features_say(kind, parts):
    boxes = boxes_of(np.array([0.12, 0.12, 0.05, kind]), WALL)
    assert len(boxes) == parts
    assert extent(boxes) == pytest.approx([0.12, 0.12, 0.05], abs=0.004)


@pytest.mark.parametrize("shape", SHAPES)
def test_every_shape_keeps_to_the_ranges_of_the_world(shape):
    config = TabletopConfig(shapes={shape: 1.0})
    features = sample_features(config, np.random.default_rng(0), 200)
    assert features[:, :2].min() >= config.size[0]
    assert features[:, :2].max() <= config.size[1]
    assert features[:, 2].min() >= config.height[0]
    assert features[:, 2].max() <= config.height[1]
    assert len(set(features[:, 3])) == 1


def test_planks_are_flat_and_long_and_rings_are_round_and_drawn_as_often_as_asked():
    planks = sample_features(TabletopConfig(shapes={"plank": 1.0}), np.random.default_rng(0), 200)
    rings = sample_features(TabletopConfig(shapes={"ring": 1.0}), np.random.default_rng(0), 200)
    assert planks[:, 2].max() <= 0.04
    assert (planks[:, :2].max(axis=1) / planks[:, :2].min(axis=1)).min() > 1.5
    assert np.array_equal(rings[:, 0], rings[:, 1])
    config = TabletopConfig(shapes={"box": 3.0, "ring": 1.0})
    rings = sample_features(config, np.random.default_rng(0), 2000)[:, 3] == OPEN_THROUGH
    assert rings.mean() == pytest.approx(0.25, abs=0.03)


def test_eight_objects_stand_on_the_table_apart_from_one_another():
    config = TabletopConfig()
    with pytest.raises(InvalidValue, match="40 objects do not fit"):
        sample_scene(config, np.random.default_rng(0), 40)
    for seed in range(20):
        scene = sample_scene(config, np.random.default_rng(seed), MOST_OBJECTS)
        np.testing.assert_array_equal(scene.positions[:, 2], scene.features[:, 2] / 2)  # on the table
        half = scene.features[:, :2] / 2
        apart = np.abs(scene.positions[:, None, :2] - scene.positions[:, :2]) - (half[:, None] + half)
        others = ~np.eye(MOST_OBJECTS, dtype=bool)
        assert apart.max(axis=-1)[others].min() >= config.spawn_gap
        assert (np.abs(scene.positions[:, 1]) + half[:, 1]).max() <= 0.3


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"shapes": {"sphere": 1.0}}, "no shape 'sphere'; valid: box, open-box, plank, ring"),
        ({"shapes": {"box": 0.0}}, "a share greater than 0"),
        ({"size": (30.0, 180.0)}, "lengths are in metres"),
        ({"table_x": (0.4, 0.5)}, "shorter than the 0.24 m"),
        ({"size": (0.2, 0.1)}, "put the smaller number first"),
        ({"mass": -1.0}, "mass = -1.0 must be greater than 0"),
        ({"spawn_gap": -0.1}, "must not be negative"),
        ({"wall": 0.05}, "leaves no room inside"),
        ({"time_step": 1 / 60}, "between 1/2000 and 1/120"),
    ],
)
def test_impossible_world_is_refused_in_one_sentence(options, message):
    with pytest.raises(NeurosymError, match=message):
        TabletopConfig(**options)


def tilted_about_x(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


@pytest.mark.parametrize(("degrees", "lands"), [(0, False), (10, True), (30, True), (90, False)])
def test_tilted_object_shifts_as_it_turns_about_its_lowest_corner_and_one_on_a_face_does_not(degrees, lands):
    half_y, half_z, angle = 0.05, 0.02, np.radians(degrees)
    expected = half_y * (1 - np.cos(angle)) + half_z * np.sin(angle)
    shift = _landing_shift(np.array([0.08, 0.1, 0.04, 0.0]), tilted_about_x(degrees))
    assert shift == pytest.approx([0.0, expected * lands], abs=1e-9)  # its -y side is low and stays there
