"""Worlds in which every action is aimed at a place: they draw one, and explore with it."""

from functools import partial

import numpy as np
import pytest

from neurosym.data.interactions import Interactions
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Place, Scene
from neurosym.worlds.aims import PLACE_AXES, Aimed, AimedFactory, AimedScene
from neurosym.worlds.own_world import make_own_world
from neurosym.worlds.toy import make_world

GRASP = np.array([0, 0, 0, 1.0, 0, 0, 0, 0.0, 0, 0, 0, 0.0])
PUCK = (0.05, 0.05, 0.04, 0.0)


def explored(workers=1, steps=96, strategy="disagreement", factory=make_world) -> Interactions:
    config = ExplorationConfig(candidates=20, block=64)
    return explore(
        AimedFactory(factory), steps=steps, strategy=strategy, seed=3, workers=workers, config=config
    )


@pytest.mark.parametrize("world", [make_world(), Tabletop()])
def test_places_lie_anywhere_on_the_table_as_far_from_its_edge_as_asked(world):
    for margin in (0.0, 0.1):
        drawn = [Aimed(world, margin).sample_scene(np.random.default_rng(n), 1) for n in range(300)]
        spots = np.array([scene.reference.centre[:2] for scene in drawn])
        low, high = np.array([world.table.x, world.table.y]).T
        assert np.all((spots >= low + margin) & (spots <= high - margin))
        assert np.all(np.ptp(spots, axis=0) > 0.9 * (high - low - 2 * margin))


def test_objects_are_those_that_the_world_draws():
    aimed, plain = (
        world.sample_scene(np.random.default_rng(1), 2) for world in (Aimed(make_world()), make_world())
    )
    np.testing.assert_array_equal(aimed.positions, plain.positions)


def test_actions_are_aimed_at_the_place_of_their_scene():
    upright = np.array([[0, 0, 0, 1.0]])
    scene = AimedScene(np.array([PUCK]), np.array([[0.7, 0.0, 0.02]]), upright, Place(0.5, 0.2))
    outcome = Aimed(make_world()).interact(scene, GRASP, 0)
    assert outcome.reference == scene.reference
    assert outcome.kind == "carried"
    plain = Scene(scene.features, scene.positions, upright)
    assert Aimed(make_world()).interact(plain, GRASP, 0).reference is None


def test_data_say_where_objects_end_relative_to_the_place_and_whether_they_were_carried():
    data = explored()
    assert data.effects.shape == (96, PLACE_AXES)
    carried = data.effects[:, 3] == 1
    assert 0 < carried.sum() < len(data)
    assert not data.effects[~carried].any()
    graspable = (data.features[:, 3] >= 0.5) | (data.features[:, 1] <= 0.08)
    is_grasp = (data.actions[:, 3] >= 0.5) & (data.actions[:, 7] < 0.5)
    np.testing.assert_array_equal(carried, graspable & is_grasp)
    by = data.actions[:, 8:10] - data.actions[:, 4:6]  # from the second waypoint to the third
    np.testing.assert_allclose(data.effects[carried, :2], by[carried], atol=1e-6)


def test_any_number_of_workers_gives_the_same_bytes():
    one, two = (explored(workers) for workers in (1, 2))
    assert all(one.columns[name].tobytes() == two.columns[name].tobytes() for name in one.columns)


def test_worlds_of_ones_own_are_aimed_in_their_processes(tmp_path, monkeypatch):
    (tmp_path / "carries.py").write_text(
        "from neurosym.worlds.toy import ToyConfig, ToyWorld\n"
        "class Own(ToyWorld):\n    name = 'own'\n"
        "def make() -> Own:\n    return Own(ToyConfig())\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    world = make_own_world("carries:make", {})
    assert world.references == ("place",)
    own, ours = (
        explored(steps=20, strategy="random", factory=f)
        for f in (partial(make_own_world, "carries:make", {}), make_world)
    )
    assert own.effects.tobytes() == ours.effects.tobytes()
