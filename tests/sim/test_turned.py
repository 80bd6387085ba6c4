"""As it lies: motions turn with the object that they are aimed at, and what was learned of it turns along."""

import math
from dataclasses import replace

import numpy as np
import pytest
from standing import CARRY, CLOSED, FAR, boxes

from neurosym.sim.robot import UR10
from neurosym.sim.tabletop import Tabletop
from neurosym.world import OtherObject, Place, Scene, heading, heading_to, turned_by, turns

BAR = (0.16, 0.05, 0.06, 0, 0.6, 0.0)
PUSH = np.array([-0.13, 0, 0.02, CLOSED, 0, 0, 0.02, CLOSED, 0.03, 0, 0.02, CLOSED])


def lying(angle: float, *rows: tuple[float, ...]) -> Scene:
    """Boxes of which the first lies turned."""
    scene = boxes(*rows)
    orientations = scene.orientations.copy()
    orientations[0] = [0, 0, math.sin(angle / 2), math.cos(angle / 2)]
    return Scene(scene.features, scene.positions, orientations)


def heading_of(scene: Scene, index: int = 0) -> float:
    return heading_to(scene.orientations[index], 0.0)


@pytest.mark.parametrize(
    ("angle", "turned"),
    [(0.0, 0.0), (0.5, 0.5), (-0.7, -0.7), (math.pi / 2, 0.0), (2.0, 2.0 - math.pi / 2), (0.015, 0.0)],
)
def test_a_heading_is_counted_from_the_nearest_quarter(angle: float, turned: float):
    quaternion = np.array([0, 0, math.sin(angle / 2), math.cos(angle / 2)])
    assert heading(quaternion) == pytest.approx(turned, abs=1e-9)
    assert heading(-2 * quaternion) == pytest.approx(turned, abs=1e-9)


def test_what_lies_on_another_side_has_a_heading_too():
    half = math.sqrt(0.5)
    on_its_side = np.array([half, 0, 0, half])
    assert heading(on_its_side) == 0.0
    c, s = math.cos(0.2), math.sin(0.2)  # turned by 0.4 about the vertical
    assert heading(np.array([half * c, half * s, half * s, half * c])) == pytest.approx(0.4)


def test_what_is_turned_comes_to_a_heading_the_nearer_way():
    quaternion = np.array([0, 0, math.sin(0.2), math.cos(0.2)])  # by 0.4
    assert heading_to(quaternion, 0.4) == pytest.approx(0.0, abs=1e-12)
    assert heading_to(quaternion, 0.4 + math.pi) == pytest.approx(0.0, abs=1e-9)
    assert heading_to(quaternion, math.pi / 2) == pytest.approx(math.pi / 2 - 0.4)
    np.testing.assert_allclose(turned_by(math.pi / 2, np.array([[1.0, 0.0, 5.0]])), [[0, 1, 5]], atol=1e-12)


@pytest.mark.parametrize("angle", [0.4, -0.6])
def test_a_push_moves_what_lies_turned_as_it_moves_what_lies_straight(angle: float):
    world = Tabletop()
    straight = world.interact(boxes(BAR), PUSH, 0)
    turned = world.interact(lying(angle, BAR), PUSH, 0)
    assert straight.resting_effect[0] > 0.05
    np.testing.assert_allclose(turned_by(-angle, turned.resting_effect), straight.resting_effect, atol=0.015)


@pytest.mark.parametrize("angle", [0.0, 0.5, -0.7])
def test_what_is_carried_is_set_down_straight_or_as_is_asked_for(angle: float):
    world = Tabletop()
    straight = world.interact(lying(angle, BAR), CARRY, 0, reference=FAR)
    asked = world.interact(lying(angle, BAR), CARRY, 0, reference=Place(FAR.x, FAR.y, heading=1.0))
    for outcome, wanted in ((straight, 0.0), (asked, -1.0)):
        assert outcome.carried
        assert heading_of(outcome.end) == pytest.approx(wanted, abs=0.05)
        np.testing.assert_allclose(outcome.end.positions[0][:2], [FAR.x, FAR.y], atol=0.006)


def test_what_is_put_on_another_lies_as_that_does():
    below = (0.16, 0.1, 0.05, 0, 0.75, 0.15)
    scene = lying(0.3, BAR, below)
    orientations = scene.orientations.copy()
    orientations[1] = [0, 0, math.sin(-0.2), math.cos(-0.2)]  # by -0.4
    action = CARRY + np.array([0] * 8 + [0, 0, 0.06, 0])
    outcome = Tabletop().interact(
        Scene(scene.features, scene.positions, orientations), action, 0, reference=OtherObject(1)
    )
    assert outcome.carried
    assert heading_of(outcome.end) == pytest.approx(0.4, abs=0.06)


def test_an_arm_without_such_a_wrist_moves_along_the_axes_of_the_world():
    fixed = Tabletop(arm=replace(UR10, wrist=None))
    assert (turns(Tabletop()), turns(fixed)) == (True, False)
    outcome = fixed.interact(lying(0.5, BAR), PUSH, 0)
    turned = Tabletop().interact(lying(0.5, BAR), PUSH, 0)
    assert np.linalg.norm(outcome.resting_effect - turned.resting_effect) > 0.02
