"""Worlds in which every action is aimed: at places, at other objects, and among neighbours."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
import toy_places
import toy_relations

from neurosym.exploration.curiosity import LearningConfig
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.sim.tabletop import Tabletop
from neurosym.world import OtherObject
from neurosym.worlds import aims
from neurosym.worlds.toy import make_world
from neurosym.worlds.toy_relations import ToyRelations

GRASP = np.array([0, 0, 0, 1.0, 0, 0, 0, 0.0, 0, 0, 0, 0.0])


@pytest.mark.parametrize("world", [make_world(), Tabletop()])
def test_places_lie_anywhere_on_the_table_as_far_from_its_edge_as_asked(world):
    for margin in (0.0, 0.1):
        drawn = [aims.Aimed(world, margin).sample_scene(np.random.default_rng(n), 1) for n in range(100)]
        spots = np.array([scene.reference.centre[:2] for scene in drawn])
        low, high = np.array([world.table.x, world.table.y]).T
        assert np.all((spots >= low + margin) & (spots <= high - margin))
        assert np.all(np.ptp(spots, axis=0) > 0.9 * (high - low - 2 * margin))


def test_data_say_where_objects_end_relative_to_the_place_and_whether_they_were_carried():
    options = {"steps": 96, "strategy": "random", "seed": 3, "config": SMALL}
    data, other = (explore(aims.AimedFactory(make_world), workers=workers, **options) for workers in (1, 2))
    assert all(data.columns[name].tobytes() == other.columns[name].tobytes() for name in data.columns)
    assert data.effects.shape == (96, aims.PLACE_AXES)
    carried = data.effects[:, 3] == 1
    assert 0 < carried.sum() < len(data)
    assert not data.effects[~carried].any()
    graspable = (data.features[:, 3] >= 0.5) | (data.features[:, 1] <= 0.08)
    is_grasp = (data.actions[:, 3] >= 0.5) & (data.actions[:, 7] < 0.5)
    np.testing.assert_array_equal(carried, graspable & is_grasp)
    by = data.actions[:, 8:10] - data.actions[:, 4:6]  # from the second waypoint to the third
    np.testing.assert_allclose(data.effects[carried, :2], by[carried], atol=1e-6)


FACTORY = aims.RelatedFactory(ToyRelations)
CARRY = np.array(toy_relations.CARRY, dtype=float)
SMALL = ExplorationConfig(
    candidates=8, block=16, learning=LearningConfig(epochs=1, ensemble=2, ensemble_hidden=16)
)


def stacked() -> aims.RelatedScene:
    """A cube and a block apart, and a cube as a bystander."""
    return aims.as_pair(toy_relations.tower().scene())


def test_pair_is_shown_as_one_thing_and_actions_are_aimed_at_its_second_object():
    pair = stacked()
    np.testing.assert_array_equal(pair.features, [[*toy_relations.CUBE, *toy_relations.BLOCK]])
    assert (len(pair), len(pair.whole)) == (1, 4)
    assert len(FACTORY().feature_names) == 8
    outcome = FACTORY().interact(stacked(), CARRY, 0)
    assert outcome.reference == OtherObject(1)
    assert outcome.carried
    np.testing.assert_allclose(outcome.end.positions[0], (0.5, 0.1, 0.075), atol=1e-6)


def test_scenes_have_two_to_four_objects_and_are_the_same_for_the_same_seed():
    scenes = [FACTORY().sample_scene(np.random.default_rng(seed), 1) for seed in range(100)]
    assert {len(scene.whole) for scene in scenes} == {2, 3, 4}
    pairs = [scene.features[0] for scene in scenes]
    assert 0.65 < np.mean([pair[4] * pair[5] > pair[0] * pair[1] for pair in pairs]) < 0.85, (
        "a wider one below"
    )
    again = FACTORY().sample_scene(np.random.default_rng(3), 1)
    np.testing.assert_array_equal(again.whole.positions, scenes[3].whole.positions)


def test_archive_keeps_ends_in_which_objects_touch_and_stand_and_scenes_begin_from_them():
    world = FACTORY()
    apart = world.interact(stacked(), np.zeros(12), 0)
    put = world.interact(stacked(), CARRY, 0)
    lost, leaning = (aims.taken(put.end, range(4)) for _ in range(2))
    lost.positions[2] = (5.0, 5.0, 0.0)
    leaning.orientations[2] = (np.sin(0.1), 0.0, 0.0, np.cos(0.1))
    world.remember([apart, put, *(replace(put, end=end) for end in (lost, leaning))])
    assert len(world.archive) == 1
    begun = [world.sample_scene(np.random.default_rng(seed), 1).whole for seed in range(60)]
    share = np.mean([len(scene) == 4 and 0.075 in np.round(scene.positions[:, 2], 6) for scene in begun])
    assert 0.15 < share < 0.55


def test_explored_pairs_are_the_same_after_an_interruption_and_with_any_number_of_workers(tmp_path):
    options = {"strategy": "disagreement", "seed": 4, "config": SMALL}
    whole = explore(FACTORY, steps=48, workers=2, **options)
    explore(FACTORY, steps=16, checkpoint=tmp_path, **options)
    resumed = explore(FACTORY, steps=48, checkpoint=tmp_path, **options)
    assert whole.effects.shape == (48, aims.PAIR_AXES)
    for name, column in whole.columns.items():
        np.testing.assert_array_equal(resumed.columns[name], column)


def scenes(factory, count=60) -> list[aims.CrowdedScene]:
    world = aims.CrowdedFactory(factory, 0.06)()
    return [world.sample_scene(np.random.default_rng(n), 1) for n in range(count)]


def gaps(scene, centre, others) -> np.ndarray:
    """How far apart an object at a centre and others are along x and y, negative where they overlap."""
    reach = (scene.features[0, :2] + others.features[:, :2]) / 2
    return np.abs(others.positions[:, :2] - centre) - reach


@pytest.mark.parametrize("factory", [make_world, Tabletop])
def test_neighbours_stand_close_to_the_target_and_clear_of_the_place(factory):
    drawn = scenes(factory)
    counts = [len(scene.neighbours) for scene in drawn]
    assert 1.5 <= np.mean(counts) <= 4
    for scene in drawn:
        assert len(scene) == 1
        near = gaps(scene, scene.positions[0, :2], scene.neighbours).max(1)
        assert np.all((near >= aims.GAPS[0] - 1e-9) & (near <= aims.GAPS[1] + 1e-9))
        assert np.all(gaps(scene, scene.reference.centre[:2], scene.neighbours).max(1) >= aims.ROOM)
        others = scene.neighbours
        for row in range(1, len(others)):
            reach = (others.features[row, :2] + others.features[:row, :2]) / 2
            away = np.abs(others.positions[row, :2] - others.positions[:row, :2]) - reach
            assert np.all(away.max(1) > 0), "neighbours do not overlap"


def test_target_comes_first_and_neighbours_are_acted_among():
    scene = next(one for one in scenes(Tabletop) if len(one.neighbours) >= 3)
    scene, factory = pickle.loads(pickle.dumps((scene, aims.CrowdedFactory(Tabletop, 0.06))))
    outcome = factory().interact(scene, GRASP, 0)
    assert len(outcome.start) == 1 + len(scene.neighbours)
    np.testing.assert_array_equal(outcome.start.features[0], scene.features[0])
    assert outcome.reference == scene.reference


BOX, CUBE = make_world().action_box, np.array(toy_places.CUBE)


def drawn(category: str) -> np.ndarray:
    motions = aims.KnownMotions(
        toy_places.grounding().places, lambda features: [category] * len(features), BOX
    )
    return motions(np.random.default_rng(0), CUBE, 400)


def test_motions_grasp_as_it_is_known_and_bring_to_the_middle_of_the_reference_or_anywhere():
    found, middle = drawn("00"), np.array(toy_places.CARRY[8:10]) - toy_places.OFFSET[:2]
    assert np.abs(found[:, :8] - toy_places.CARRY[:8]).max() < 4 * aims.JITTER
    assert np.all((found >= BOX.low) & (found <= BOX.high))
    near = np.all(np.abs(found[:, 8:10] - middle) < 4 * aims.JITTER, axis=1)
    assert abs(near.mean() - aims.TO_THE_MIDDLE) < 0.1
    assert np.ptp(found[~near, 8:10], axis=0).min() > 0.08
    assert drawn("11").shape == (0, len(BOX.low)), "nothing carries those"
