"""Actions with a place or an object as reference, in the robot's world: carried there, put on, put in."""

import numpy as np
import pytest
from standing import CARRY, CLOSED, FAR, boxes

from neurosym.errors import InvalidValue
from neurosym.sim.tabletop import Tabletop
from neurosym.world import OtherObject, Place, Scene
from neurosym.worlds.toy import make_world
from neurosym.worlds.workers import Task, perform_all

pytestmark = pytest.mark.usefixtures("engine")
MISS = np.array([0, 0, 0.025, CLOSED, 0, 0, 0.025, CLOSED, 0, 0, 0, CLOSED])
CORNERS = [Place(0.37, -0.28), Place(0.93, 0.28)]
BOX = (0.05, 0.05, 0.06, 0, 0.5, -0.1)
WIDE = (0.17, 0.17, 0.06, 0, 0.5, -0.1)
THERE = (0.05, 0.05, 0.06, 0, FAR.x, FAR.y)


@pytest.mark.parametrize("place", CORNERS)
def test_grasped_box_is_set_down_at_a_place_anywhere_on_the_table(place):
    outcome = Tabletop().interact(boxes(BOX), CARRY, 0, reference=place)
    assert outcome.carried
    assert outcome.kind == "carried"
    assert outcome.reference == place
    np.testing.assert_allclose(outcome.resting_effect, [0, 0, 0], atol=0.004)
    assert outcome.end is outcome.lifted


def test_third_waypoint_is_relative_to_the_place():
    action = CARRY + np.array([0] * 8 + [0.04, -0.03, 0, 0])
    outcome = Tabletop().interact(boxes(BOX), action, 0, reference=FAR)
    np.testing.assert_allclose(outcome.resting_effect[:2], [0.04, -0.03], atol=0.004)


@pytest.mark.parametrize(("scene", "action"), [(boxes(WIDE, THERE), CARRY), (boxes(BOX, THERE), MISS)])
def test_what_does_not_hang_from_the_hand_stays_and_the_hand_does_not_go_there(scene, action):
    outcome = Tabletop().interact(scene, action, 0, reference=FAR)
    assert not outcome.carried
    assert not outcome.held
    assert not outcome.touched
    assert np.linalg.norm(outcome.resting_effect) < 0.05


def test_what_is_carried_passes_over_what_stands_in_the_way():
    wall = (0.03, 0.18, 0.10, 0, 0.675, 0.05)
    outcome = Tabletop().interact(boxes(BOX, wall), CARRY, 0, reference=FAR)
    assert outcome.carried
    assert not outcome.touched
    assert not outcome.disturbed
    assert outcome.peak_height > wall[2]


@pytest.mark.parametrize(
    ("x", "y", "is_far"), [(0.5, -0.17, False), (0.5, -0.03, False), (FAR.x, FAR.y - 0.09, True)]
)
def test_neighbours_of_the_target_and_of_the_place_stay_where_they_are(x, y, is_far):
    """The hand opens along y to 14 cm where it need not heed them."""
    scene = boxes(BOX, (0.05, 0.05, 0.06, 0, x, y))
    narrow = Tabletop().interact(scene, CARRY, 0, reference=FAR)
    assert narrow.carried
    assert not narrow.disturbed
    assert is_far or Tabletop().interact(scene, CARRY, 0).touched == (1,)


def test_place_off_the_table_is_refused_in_one_sentence():
    message = r"\(1.2, 0\) lies at x = 1.2, y = 0 m, off the table; valid: x 0.35 to 0.95, y -0.3 to 0.3 m"
    with pytest.raises(InvalidValue, match=message):
        Tabletop().interact(boxes(BOX), CARRY, 0, reference=Place(1.2, 0.0))
    for values in ((np.nan, 0.0), (0.0, np.inf)):
        with pytest.raises(InvalidValue, match=r"Place\.[xy] = .* must be finite"):
            Place(*values)


def test_what_the_hand_would_take_along_by_mistake_is_not_carried_away():
    """Two narrow boxes side by side, gripped together: neither is carried."""
    pair = ((0.05, 0.03, 0.06, 0, 0.5, 0.0), (0.05, 0.03, 0.06, 0, 0.5, 0.031))
    between = CARRY + np.array([0, 0.0155, 0, 0] * 2 + [0] * 4)
    outcome = Tabletop().interact(boxes(*pair), between, 0, reference=FAR)
    assert 1 in outcome.touched
    assert not outcome.carried
    assert outcome.kind == "missed"
    assert np.all(outcome.end.positions[:, 0] < 0.6)


# With another object as reference

SMALL = (0.05, 0.05, 0.06, 0, 0.5, -0.1)
PLATE = (0.12, 0.12, 0.04, 0, 0.7, 0.1)
TRAY = (0.17, 0.17, 0.05, 1, 0.7, 0.1)
ON = OtherObject(1)


def put(scene: Scene, reference: OtherObject = ON) -> Scene:
    return Tabletop().interact(scene, CARRY, 0, reference=reference).end


def test_box_is_put_into_a_tray_stands_on_its_floor_and_is_taken_out_again():
    end = put(boxes(SMALL, TRAY))
    np.testing.assert_allclose(end.positions[0][:2], [0.7, 0.1], atol=0.01)
    assert end.positions[0][2] < 0.03 + 0.01
    outcome = Tabletop().interact(end, CARRY, 0, reference=FAR)
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
        np.testing.assert_allclose(outcomes[0].resting_effect[:2], [0, 0], atol=0.006)
        scene = outcomes[0].end
    np.testing.assert_allclose(scene.positions[:, 2], [0.21, 0.15, 0.09, 0.03], atol=0.004)
    assert outcomes[0].contacts == ((0, 1), (1, 2), (2, 3))
    still = Tabletop().interact(scene, np.tile([0.0, 0.0, 0.3, 0.0], 3), 0).end
    np.testing.assert_allclose(still.positions, scene.positions, atol=0.001)


def test_object_that_cannot_be_the_reference_is_refused():
    for index, message in ((0, "Object 0 is the target"), (2, "the scene has objects 0 to 1"), (-1, "-1")):
        with pytest.raises(InvalidValue, match=message):
            put(boxes(SMALL, PLATE), OtherObject(index))
    with pytest.raises(InvalidValue, match="toy world takes no object as a reference"):
        make_world().interact(boxes(SMALL, PLATE), CARRY, 0, reference=ON)
