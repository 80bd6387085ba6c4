"""Worlds in which every action is aimed at another object: pairs, the archive, and what is known."""

import numpy as np
import toy_relations

from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.world import OtherObject
from neurosym.worlds.aims import PAIR_AXES, Related, RelatedFactory, RelatedScene, as_pair, taken
from neurosym.worlds.toy_relations import make_world

FACTORY = RelatedFactory(make_world)
CARRY = np.array(toy_relations.CARRY, dtype=float)
SMALL = ExplorationConfig(candidates=8, block=16)


def stacked() -> RelatedScene:
    """A cube and a block apart, and a cube as a bystander."""
    return as_pair(toy_relations.tower().scene())


def test_pair_is_shown_as_one_thing_with_the_features_of_both():
    pair = stacked()
    np.testing.assert_array_equal(pair.features, [[*toy_relations.CUBE, *toy_relations.BLOCK]])
    assert (len(pair), len(pair.whole)) == (1, 4)
    assert len(FACTORY().feature_names) == 8


def test_actions_are_aimed_at_the_second_object_of_a_pair():
    outcome = FACTORY().interact(stacked(), CARRY, 0)
    assert outcome.reference == OtherObject(1)
    assert outcome.carried
    np.testing.assert_allclose(outcome.end.positions[0], (0.5, 0.1, 0.075), atol=1e-6)


def test_scenes_have_two_to_four_objects_and_are_the_same_for_the_same_seed():
    scenes = [FACTORY().sample_scene(np.random.default_rng(seed), 1) for seed in range(30)]
    assert {len(scene.whole) for scene in scenes} == {2, 3, 4}
    again = FACTORY().sample_scene(np.random.default_rng(3), 1)
    np.testing.assert_array_equal(again.whole.positions, scenes[3].whole.positions)


def test_wider_one_is_below_more_often_than_not():
    pairs = [FACTORY().sample_scene(np.random.default_rng(seed), 1).features[0] for seed in range(200)]
    below = np.mean([pair[4] * pair[5] > pair[0] * pair[1] for pair in pairs])
    assert 0.65 < below < 0.85


def test_archive_keeps_ends_in_which_objects_touch_and_scenes_begin_from_them():
    world = FACTORY()
    apart = world.interact(stacked(), np.zeros(12), 0)
    put = world.interact(stacked(), CARRY, 0)
    world.remember([apart, put])
    assert len(world.archive) == 1
    begun = [world.sample_scene(np.random.default_rng(seed), 1).whole for seed in range(60)]
    share = np.mean([len(scene) == 4 and 0.075 in np.round(scene.positions[:, 2], 6) for scene in begun])
    assert 0.15 < share < 0.55


def test_lost_and_leaning_objects_are_not_archived():
    world = FACTORY()
    put = world.interact(stacked(), CARRY, 0)
    for change in ("lost", "leaning"):
        end = taken(put.end, range(4))
        if change == "lost":
            end.positions[2] = (5.0, 5.0, 0.0)
        else:
            end.orientations[2] = (np.sin(0.1), 0.0, 0.0, np.cos(0.1))
        world.remember([type(put)(**{**{f: getattr(put, f) for f in put.__slots__}, "end": end})])
    assert world.archive == []


def test_memory_is_recalled_as_it_was():
    world, other = FACTORY(), FACTORY()
    world.remember([world.interact(stacked(), CARRY, 0)])
    other.recall(world.memory())
    np.testing.assert_array_equal(other.archive[0].positions, world.archive[0].positions)
    other.recall({})
    assert len(other.archive) == 1


def test_half_of_the_actions_are_those_that_are_known():
    def propose(rng: np.random.Generator, features: np.ndarray, count: int) -> np.ndarray:
        del rng, features
        return np.tile(CARRY, (count, 1))

    world = Related(make_world(), propose)
    drawn = world.draw_actions(np.random.default_rng(0), stacked(), 10)
    assert np.sum(np.all(drawn == CARRY, axis=1)) == 5
    assert drawn.shape == (10, 12)


def test_explored_pairs_are_the_same_after_an_interruption(tmp_path):
    options = {"strategy": "random", "seed": 4, "config": SMALL}
    whole = explore(FACTORY, steps=48, **options)
    explore(FACTORY, steps=16, checkpoint=tmp_path, **options)
    resumed = explore(FACTORY, steps=48, checkpoint=tmp_path, **options)
    assert whole.effects.shape == (48, PAIR_AXES)
    for name, column in whole.columns.items():
        np.testing.assert_array_equal(resumed.columns[name], column)


def test_number_of_workers_does_not_change_what_is_explored():
    one, two = (
        explore(FACTORY, steps=32, strategy="disagreement", seed=5, config=SMALL, workers=workers)
        for workers in (1, 2)
    )
    np.testing.assert_array_equal(one.effects, two.effects)
    np.testing.assert_array_equal(one.features, two.features)
