"""The toy worlds keep the rules written at their heads."""

import numpy as np
import pytest
from standing import boxes

from neurosym.errors import InvalidValue
from neurosym.world import OtherObject, Place, Scene
from neurosym.worlds.toy import ToyConfig, make_world
from neurosym.worlds.toy_relations import WALL, ToyRelations, let_down, loads_on

SMALL, WIDE, HOLLOW, LONG, LONG_WIDE = (
    (0.05, 0.05, 0.04, 0.0),
    (0.05, 0.15, 0.04, 0.0),
    (0.05, 0.15, 0.04, 1.0),
    (0.15, 0.05, 0.04, 0.0),
    (0.15, 0.15, 0.04, 0.0),
)
WORLD = make_world()


def scene_of(features, x=0.7, y=0.0):
    return boxes((*features, x, y))


def action_of(first=(0, 0, 0, 1.0), middle=(0, 0, 0, 1.0), last=(0, 0, 0, 1.0)):
    return np.array([*first, *middle, *last], dtype=float)


GRASP, PUSH = action_of(last=(0, 0, 0, 0.0)), action_of(last=(0.05, 0, 0, 1.0))
CARRY = action_of(middle=(0.01, 0, 0, 0.0), last=(0.02, -0.03, 0, 1.0))


@pytest.mark.parametrize(
    ("features", "action", "effect"),
    [
        (SMALL, GRASP, (0, 0, 0.2)),
        (HOLLOW, GRASP, (0, 0, 0.2)),
        (LONG, GRASP, (0, 0, 0.2)),
        (WIDE, GRASP, (0, 0, 0)),
        (LONG_WIDE, GRASP, (0, 0, 0)),
        (WIDE, action_of(last=(0.03, 0, 0, 0.0)), (0.08, 0, 0)),  # what cannot be grasped is pushed
        (LONG, PUSH, (0, 0, 0)),
        (SMALL, action_of(last=(0.03, 0.01, 0, 1.0)), (0.08, 0, 0)),
        (SMALL, action_of(last=(-0.03, 0.01, 0, 1.0)), (-0.08, 0, 0)),
        (SMALL, action_of(last=(0.01, 0.03, 0, 1.0)), (0, 0.08, 0)),
        (SMALL, action_of(last=(0.01, -0.03, 0, 1.0)), (0, -0.08, 0)),
        (SMALL, action_of(last=(0.015, 0.019, 0, 1.0)), (0, 0, 0)),
    ],
)
def test_narrow_or_hollow_objects_are_lifted_and_short_ones_pushed_the_way_of_the_travel(
    features, action, effect
):
    outcome = WORLD.interact(scene_of(features), action, 0)
    assert outcome.held is (effect[2] > 0)
    np.testing.assert_allclose(outcome.effect, effect, atol=1e-12)
    np.testing.assert_allclose(outcome.resting_effect, [*effect[:2], 0], atol=1e-12)
    aloft = WORLD.interact(scene_of(features), action, 0, put_down=False)
    np.testing.assert_allclose(aloft.resting_effect, effect, atol=1e-12)


def test_an_object_pushed_over_the_edge_is_lost_and_only_the_target_moves():
    assert WORLD.interact(scene_of(SMALL, x=0.95), PUSH, 0).lost
    assert not WORLD.interact(scene_of(SMALL, x=0.7), PUSH, 0).lost
    scene = WORLD.sample_scene(np.random.default_rng(0), 4)
    outcome, others = WORLD.interact(scene, PUSH, 2), [0, 1, 3]
    np.testing.assert_array_equal(outcome.end.positions[others], scene.positions[others])


def test_sampled_objects_do_not_overlap_stand_on_the_table_and_are_those_of_their_seed():
    for seed in range(20):
        scene, again = (WORLD.sample_scene(np.random.default_rng(seed), 5) for _ in range(2))
        assert scene.positions.tobytes() == again.positions.tobytes()
        assert scene.features.tobytes() == again.features.tobytes()
        assert all(WORLD.table.contains(position) for position in scene.positions)
        for i in range(5):
            for j in range(i):
                distance = np.abs(scene.positions[i, :2] - scene.positions[j, :2])
                assert np.any(distance >= (scene.features[i, :2] + scene.features[j, :2]) / 2)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: WORLD.sample_scene(np.random.default_rng(0), 200), "do not fit"),
        (lambda: WORLD.interact(scene_of(SMALL), CARRY, 0, reference=Place(0.0, 0.0)), "off the table"),
        (lambda: ToyConfig(sizes=(0.1, 0.05)), "sizes"),
    ],
)
def test_what_cannot_be_is_refused(call, said):
    with pytest.raises(InvalidValue, match=said):
        call()


# With relations

CARRY_TO = action_of(middle=(0, 0, 0, 0.0), last=(0, 0, 0, 0.0))
CUBE, SLAB, TRAY = (0.05, 0.05, 0.05, 0.0), (0.10, 0.05, 0.04, 0.0), (0.18, 0.18, 0.06, 1.0)
RELATIONS, ON = ToyRelations(), OtherObject(1)


def scene(*rows: tuple[tuple[float, ...], float, float, float]) -> Scene:
    """Objects, each given as its features, where it stands, and at which height."""
    made = boxes(*((*features, x, y) for features, x, y, _ in rows))
    made.positions[:, 2] += [under for *_, under in rows]
    return made


def put(before: Scene, target: int, reference: OtherObject = ON, action=CARRY_TO):
    return RELATIONS.interact(before, action, target, reference=reference)


def test_cube_is_put_on_the_floor_of_a_tray_and_the_next_one_on_it_or_beside_it():
    outcome = put(scene((CUBE, 0.5, 0.0, 0), (TRAY, 0.8, 0.1, 0), (CUBE, 0.5, 0.2, 0)), 0)
    assert outcome.end.positions[0, 2] == pytest.approx(WALL + 0.025)
    assert put(outcome.end, 2).end.positions[2, 2] == pytest.approx(WALL + 0.075)
    aside = CARRY_TO.copy()
    aside[9] = 0.05
    assert put(outcome.end, 2, ON, aside).end.positions[2, 2] == pytest.approx(WALL + 0.025)
    after = let_down(scene((CUBE, 0.5, 0.0, 0), (CUBE, 0.8, 0.1, 0)), 0, np.array([0.84, 0.1]))
    np.testing.assert_allclose(after.positions[0], [0.851, 0.1, 0.025])
    rim = put(scene((TRAY, 0.5, 0, 0), (TRAY, 0.8, 0.1, 0)), 0).end  # it does not fit into one of its size
    np.testing.assert_allclose(rim.positions[0], [0.8, 0.1, 0.09])
    assert put(scene(((0.1, 0.1, 0.04, 0.0), 0.5, 0, 0), (SLAB, 0.8, 0.1, 0)), 0).kind == "missed"


def test_what_rests_on_the_target_goes_along_and_is_said_to_have_moved():
    before = scene((CUBE, 0.5, 0.0, 0.05), (CUBE, 0.5, 0.0, 0.10), (CUBE, 0.5, 0.0, 0), (SLAB, 0.8, 0.1, 0))
    assert loads_on(before, 2) == (0, 1)
    outcome = put(before, 2, OtherObject(3))
    np.testing.assert_allclose(outcome.end.positions[:3, 2], [0.115, 0.165, 0.065])
    np.testing.assert_allclose(outcome.end.positions[:3, :2], [[0.8, 0.1]] * 3)
    assert dict(outcome.disturbed) == {0: "moved", 1: "moved"}
    pushed = RELATIONS.interact(before, PUSH, 2)
    moved = pushed.end.positions - pushed.start.positions
    np.testing.assert_allclose(moved[:3], [[0.08, 0, 0]] * 3, atol=1e-12)
