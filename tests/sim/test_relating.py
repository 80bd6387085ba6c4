"""Actions with another object as reference, in the robot's world: put on, put in, take off, take out."""

import numpy as np
import pytest
from standing import CARRY, FAR, boxes

from neurosym.errors import InvalidValue
from neurosym.sim.tabletop import Tabletop
from neurosym.world import OtherObject, Scene
from neurosym.worlds.toy import make_world
from neurosym.worlds.workers import Task, perform_all

SMALL = (0.05, 0.05, 0.06, 0, 0.5, -0.1)
PLATE = (0.12, 0.12, 0.04, 0, 0.7, 0.1)
TRAY = (0.17, 0.17, 0.05, 1, 0.7, 0.1)
ON = OtherObject(1)


def put(scene: Scene, reference: OtherObject = ON) -> Scene:
    return Tabletop().interact(scene, CARRY, 0, reference=reference).end


def test_box_is_put_on_another_and_touches_it():
    outcome = Tabletop().interact(boxes(SMALL, PLATE), CARRY, 0, reference=ON)
    assert outcome.kind == "carried"
    assert outcome.contacts == ((0, 1),)
    np.testing.assert_allclose(outcome.end.positions[0], [0.7, 0.1, 0.04 + 0.03], atol=0.004)
    np.testing.assert_allclose(outcome.resting_effect, [0, 0, 0.04], atol=0.004)
    assert not outcome.disturbed


def test_box_is_put_into_a_tray_and_stands_on_its_floor():
    end = put(boxes(SMALL, TRAY))
    np.testing.assert_allclose(end.positions[0][:2], [0.7, 0.1], atol=0.01)
    assert end.positions[0][2] < 0.03 + 0.01


@pytest.mark.parametrize("under", [PLATE, TRAY])
def test_what_was_put_on_or_in_is_taken_to_a_place(under):
    outcome = Tabletop().interact(put(boxes(SMALL, under)), CARRY, 0, reference=FAR)
    assert outcome.kind == "carried"
    np.testing.assert_allclose(outcome.end.positions[0], [FAR.x, FAR.y, 0.03], atol=0.006)
    assert outcome.contacts == ()


def test_what_stands_on_the_target_is_carried_along():
    end = put(boxes(SMALL, (0.06, 0.06, 0.05, 0, 0.7, 0.1), (*TRAY[:4], 0.45, 0.15)))
    outcome = Tabletop().interact(end, CARRY, 1, reference=FAR)
    assert outcome.kind == "carried"
    np.testing.assert_allclose(outcome.end.positions[0], [FAR.x, FAR.y, 0.05 + 0.03], atol=0.01)
    assert dict(outcome.disturbed) == {0: "moved"}


def test_towers_of_four_stand_still_and_have_the_same_bytes_in_any_process():
    scene = boxes(*((0.05 + 0.01 * n, 0.05 + 0.01 * n, 0.06, 0, 0.42 + 0.13 * n, 0.0) for n in range(4)))
    for target, reference in ((2, 3), (1, 2), (0, 1)):
        tasks = [Task(scene, CARRY, target, reference=OtherObject(reference))] * 3
        outcomes = [*perform_all(Tabletop, tasks, workers=2)]
        assert len({outcome.end.positions.tobytes() for outcome in outcomes}) == 1
        assert outcomes[0].kind == "carried"
        scene = outcomes[0].end
    np.testing.assert_allclose(scene.positions[:, 2], [0.21, 0.15, 0.09, 0.03], atol=0.004)
    assert outcomes[0].contacts == ((0, 1), (1, 2), (2, 3))
    still = Tabletop().interact(scene, np.tile([0.0, 0.0, 0.3, 0.0], 3), 0).end
    np.testing.assert_allclose(still.positions, scene.positions, atol=0.001)


@pytest.mark.parametrize(
    ("index", "message"),
    [(0, "Object 0 is the target"), (2, "no object 2 to aim at; the scene has objects 0 to 1"), (-1, "-1")],
)
def test_object_that_cannot_be_the_reference_is_refused(index, message):
    with pytest.raises(InvalidValue, match=message):
        put(boxes(SMALL, PLATE), OtherObject(index))


def test_what_is_no_number_of_an_object_is_refused():
    with pytest.raises(InvalidValue, match="must be the number of an object"):
        OtherObject(True)


def test_toy_world_takes_places_only():
    with pytest.raises(InvalidValue, match="toy world takes no object as a reference"):
        make_world().interact(boxes(SMALL, PLATE), CARRY, 0, reference=ON)
