"""The toy world with relations keeps the rules written at its head."""

import numpy as np
import pytest

from neurosym.world import OtherObject, Place, Scene
from neurosym.worlds.toy_relations import WALL, let_down, loads_on, make_world

CARRY = np.array([0, 0, 0, 1.0, 0, 0, 0, 0.0, 0, 0, 0, 0.0])
FORWARD = np.array([-0.05, 0, 0, 0.1, 0, 0, 0, 0.1, 0.05, 0, 0, 0.1])
CUBE, SLAB, TRAY = (0.05, 0.05, 0.05, 0.0), (0.10, 0.05, 0.04, 0.0), (0.18, 0.18, 0.06, 1.0)
WIDE = (0.1, 0.1, 0.04, 0.0)
WORLD, ON, PLACE = make_world(), OtherObject(1), Place(0.5, -0.1)


def scene(*rows: tuple[tuple[float, ...], float, float, float]) -> Scene:
    """Objects, each given as its features, where it stands, and at which height."""
    return Scene(
        np.array([features for features, *_ in rows]),
        np.array([(x, y, under + features[2] / 2) for features, x, y, under in rows]),
        np.tile([0.0, 0.0, 0.0, 1.0], (len(rows), 1)),
    )


def put(before: Scene, target: int, reference: OtherObject | Place = ON, action=CARRY):
    return WORLD.interact(before, action, target, reference=reference)


@pytest.mark.parametrize(
    ("before", "reference", "kind", "end", "contacts"),
    [
        (scene((CUBE, 0.5, 0, 0), (SLAB, 0.8, 0.1, 0)), ON, "carried", (0.8, 0.1, 0.065), ((0, 1),)),
        # a tray does not fit into one of its size, and stands on its rim
        (scene((TRAY, 0.5, 0, 0), (TRAY, 0.8, 0.1, 0)), ON, "carried", (0.8, 0.1, 0.09), ((0, 1),)),
        # what is taken from another comes down
        (
            scene((CUBE, 0.8, 0.1, 0.04), (SLAB, 0.8, 0.1, 0)),
            Place(0.5, -0.1),
            "carried",
            (0.5, -0.1, 0.025),
            (),
        ),
        (scene((WIDE, 0.5, 0, 0), (SLAB, 0.8, 0.1, 0)), ON, "missed", (0.5, 0, 0.02), ()),
    ],
)
def test_object_is_put_on_another_or_taken_from_it(before, reference, kind, end, contacts):
    outcome = put(before, 0, reference)
    assert (outcome.kind, outcome.contacts) == (kind, contacts)
    np.testing.assert_allclose(outcome.end.positions[0], end)


def test_cube_is_put_on_the_floor_of_a_tray_and_the_next_one_on_it_or_beside_it():
    outcome = put(scene((CUBE, 0.5, 0.0, 0), (TRAY, 0.8, 0.1, 0), (CUBE, 0.5, 0.2, 0)), 0)
    assert outcome.end.positions[0, 2] == pytest.approx(WALL + 0.025)
    assert put(outcome.end, 2).end.positions[2, 2] == pytest.approx(WALL + 0.075)
    aside = CARRY.copy()
    aside[9] = 0.05
    assert put(outcome.end, 2, ON, aside).end.positions[2, 2] == pytest.approx(WALL + 0.025)


def test_what_rests_on_the_target_goes_along_and_is_said_to_have_moved():
    before = scene((CUBE, 0.5, 0.0, 0.05), (CUBE, 0.5, 0.0, 0.10), (CUBE, 0.5, 0.0, 0), (SLAB, 0.8, 0.1, 0))
    assert loads_on(before, 2) == (0, 1)
    outcome = put(before, 2, OtherObject(3))
    np.testing.assert_allclose(outcome.end.positions[:3, 2], [0.115, 0.165, 0.065])
    np.testing.assert_allclose(outcome.end.positions[:3, :2], [[0.8, 0.1]] * 3)
    assert dict(outcome.disturbed) == {0: "moved", 1: "moved"}
    pushed = WORLD.interact(before, FORWARD, 2)
    np.testing.assert_allclose(pushed.displacements[:3], [[0.08, 0, 0]] * 3, atol=1e-12)


def test_what_is_let_down_over_an_edge_slides_off_and_stands_beside():
    after = let_down(scene((CUBE, 0.5, 0.0, 0), (CUBE, 0.8, 0.1, 0)), 0, np.array([0.84, 0.1]))
    np.testing.assert_allclose(after.positions[0], [0.851, 0.1, 0.025])
