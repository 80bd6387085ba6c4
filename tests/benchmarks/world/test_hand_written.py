"""The six primitives can be done by hand on every shape: the world does what it is asked."""

from functools import cache

import numpy as np
import pytest

from neurosym.sim.config import SHAPES, TabletopConfig
from neurosym.sim.tabletop import Tabletop
from neurosym.world import three_waypoints
from tools.benchmarks.world.hand_written import HAND_WRITTEN

SOLID_TOO_WIDE = np.array([0.17, 0.17, 0.06, 0.0])
OPEN_TOO_WIDE = np.array([0.1, 0.17, 0.06, 1.0])


WORLD = Tabletop()


@cache
def scenes_of(shape, count=30):
    world = Tabletop(TabletopConfig(shapes={shape: 1.0}))
    return [world.sample_scene(np.random.default_rng([21, number]), 1) for number in range(count)]


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("name", HAND_WRITTEN)
def test_primitive_succeeds_on_objects_that_afford_it(name, shape):
    primitive = HAND_WRITTEN[name]
    tried = [(scene, primitive.action(scene.features[0])) for scene in scenes_of(shape)]
    afforded = [(scene, action) for scene, action in tried if action is not None]
    assert [primitive.failure(WORLD.interact(*one, 0)) for one in afforded[:1]] == [""]
    assert all(three_waypoints().contains(action) for _, action in afforded)


def test_solid_object_too_wide_to_span_affords_nothing_and_an_open_one_is_grasped_by_a_wall():
    assert all(primitive.action(SOLID_TOO_WIDE) is None for primitive in HAND_WRITTEN.values())
    assert HAND_WRITTEN["grasp"].action(OPEN_TOO_WIDE)[1] == pytest.approx(0.05)


def test_a_primitive_that_is_not_done_is_not_called_a_success():
    outcome = WORLD.interact(scenes_of("box")[0], np.tile([0.0, 0.0, 0.02, 0.0], 3), 0)
    assert all(primitive.failure(outcome) for primitive in HAND_WRITTEN.values())
