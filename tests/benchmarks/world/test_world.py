"""The six primitives can be done by hand on every shape; what docs/world.md claims, on small samples."""

import json
from functools import cache

import numpy as np
import pytest
from places import ROOT

from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import LEARNED_SHAPES as SHAPES
from neurosym.sim.tabletop import Tabletop
from neurosym.world import three_waypoints
from neurosym.worlds.workers import perform_all
from tools.benchmarks.world import measures
from tools.benchmarks.world.hand_written import HAND_WRITTEN
from tools.benchmarks.world.tables import page

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


# What takes minutes of physics is run by `make evaluate`, each figure printed with -s

RESULTS = ROOT / "docs" / "results"


def test_results_that_are_committed_are_whole_and_stand_in_the_page():
    found = json.loads((RESULTS / "world.json").read_text())
    assert {"predictability", "put_down_within_1cm", "hand_written", "machine"} <= found.keys()
    assert found["command"] == "make evaluate-world"
    assert (RESULTS / "world.md").read_text() == page(found)


@pytest.mark.evaluation
def test_most_of_the_effect_survives_a_tenth_of_a_millimetre():
    found = measures.predictability(1000, 77, 2)
    print(found)
    assert found["share"] > 0.97


@pytest.mark.evaluation
def test_held_objects_are_put_down_where_they_hung_and_object_and_hand_decide_who_is_held():
    tasks = measures.random_tasks(3000, 78)
    found = measures.random_outcomes([*perform_all(Tabletop, tasks, 2)])
    print(found)
    assert found["put_down_within_1cm"] >= 0.98
    assert found["held_by_kind"]["open, too wide"] > 10 * found["held_by_kind"]["solid, too wide"]
    assert found["below_the_table"] == 0
