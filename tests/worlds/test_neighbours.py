"""Worlds with neighbours: what stands around a target is as near as said, and what it does is judged."""

import pickle

import numpy as np
import pytest

from neurosym.sim.tabletop import Tabletop
from neurosym.worlds.aims import GAPS, ROOM, CrowdedFactory, CrowdedScene
from neurosym.worlds.toy import make_world

GRASP = np.array([0, 0, 0, 1.0, 0, 0, 0, 0.0, 0, 0, 0, 0.0])


def scenes(factory, count=60) -> list[CrowdedScene]:
    world = CrowdedFactory(factory, 0.06)()
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
        assert np.all((near >= GAPS[0] - 1e-9) & (near <= GAPS[1] + 1e-9))
        assert np.all(gaps(scene, scene.reference.centre[:2], scene.neighbours).max(1) >= ROOM)


def test_neighbours_do_not_overlap():
    for scene in scenes(Tabletop):
        others = scene.neighbours
        for row in range(1, len(others)):
            reach = (others.features[row, :2] + others.features[:row, :2]) / 2
            away = np.abs(others.positions[row, :2] - others.positions[:row, :2]) - reach
            assert np.all(away.max(1) > 0)


def test_target_comes_first_and_neighbours_are_acted_among():
    factory = CrowdedFactory(Tabletop, 0.06)
    scene = next(one for one in scenes(Tabletop) if len(one.neighbours) >= 3)
    outcome = factory().interact(scene, GRASP, 0)
    assert len(outcome.start) == 1 + len(scene.neighbours)
    np.testing.assert_array_equal(outcome.start.features[0], scene.features[0])
    assert outcome.reference == scene.reference


def test_scenes_and_factories_go_to_other_processes():
    scene, factory = pickle.loads(pickle.dumps((scenes(Tabletop, 1)[0], CrowdedFactory(Tabletop, 0.06))))
    assert factory().interact(scene, GRASP, 0).end.positions.shape == (1 + len(scene.neighbours), 3)
